// A halfedge mesh on which C++ runs that `hedgerow plan FILE::OP --as cpp` writes: all that such code
// asks of a mesh class in the style `fields`. A pointer has the name that it has in a drawing; a hole is a
// face with a flag; a reference stays good until its element is erased.
#pragma once
#include <cstddef>
#include <list>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

struct Vec3 {
  double x = 0, y = 0, z = 0;
  Vec3() = default;
  Vec3(double x_, double y_, double z_) : x(x_), y(y_), z(z_) {}
};
inline Vec3 operator+(Vec3 a, Vec3 b) { return Vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
inline Vec3 operator-(Vec3 a, Vec3 b) { return Vec3(a.x - b.x, a.y - b.y, a.z - b.z); }
inline Vec3 operator-(Vec3 a) { return Vec3(-a.x, -a.y, -a.z); }
inline Vec3 operator*(Vec3 a, double t) { return Vec3(a.x * t, a.y * t, a.z * t); }
inline Vec3 operator*(double t, Vec3 a) { return a * t; }
inline Vec3 operator/(Vec3 a, double t) { return Vec3(a.x / t, a.y / t, a.z / t); }

class Mesh {
 public:
  struct Vertex;
  struct Edge;
  struct Face;
  struct Halfedge;
  using VertexRef = std::list<Vertex>::iterator;
  using EdgeRef = std::list<Edge>::iterator;
  using FaceRef = std::list<Face>::iterator;
  using HalfedgeRef = std::list<Halfedge>::iterator;

  struct Halfedge {
    HalfedgeRef next, twin;
    VertexRef vertex;  // where it starts
    EdgeRef edge;
    FaceRef face;
  };
  struct Vertex {
    HalfedgeRef halfedge;  // one that starts here
    Vec3 position;
  };
  struct Edge {
    HalfedgeRef halfedge;
  };
  struct Face {
    HalfedgeRef halfedge;
    bool boundary = false;  // whether it is a hole
  };

  std::list<Vertex> vertices;
  std::list<Halfedge> halfedges;
  std::list<Edge> edges;
  std::list<Face> faces;

  VertexRef new_vertex() { return vertices.emplace(vertices.end()); }
  HalfedgeRef new_halfedge() { return halfedges.emplace(halfedges.end()); }
  EdgeRef new_edge() { return edges.emplace(edges.end()); }
  FaceRef new_face() { return faces.emplace(faces.end()); }
  void erase(VertexRef v) { vertices.erase(v); }
  void erase(HalfedgeRef h) { halfedges.erase(h); }
  void erase(EdgeRef e) { edges.erase(e); }
  void erase(FaceRef f) { faces.erase(f); }

  Mesh() = default;

  // The mesh of polygons by the numbers of their corners, counterclockwise. Throws where two of them run
  // along an edge the same way, and where the boundary meets a vertex twice.
  Mesh(const std::vector<Vec3>& positions, const std::vector<std::vector<std::size_t>>& polygons) {
    std::vector<VertexRef> at;
    for (Vec3 position : positions) {
      at.push_back(new_vertex());
      at.back()->position = position;
    }
    using Ends = std::pair<std::size_t, std::size_t>;
    std::map<Ends, HalfedgeRef> between;
    for (const auto& polygon : polygons) {
      const FaceRef face = new_face();
      std::vector<HalfedgeRef> sides;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const HalfedgeRef h = new_halfedge();
        h->face = face;
        h->vertex = at.at(polygon[i]);
        h->vertex->halfedge = h;
        if (!between.emplace(Ends(polygon[i], polygon[(i + 1) % polygon.size()]), h).second) {
          throw std::invalid_argument("two polygons run along an edge the same way");
        }
        sides.push_back(h);
      }
      face->halfedge = sides.at(0);
      for (std::size_t i = 0; i < sides.size(); ++i) sides[i]->next = sides[(i + 1) % sides.size()];
    }
    const std::map<Ends, HalfedgeRef> inner = between;
    std::map<std::size_t, HalfedgeRef> outer;  // by where it starts
    for (const auto& [ends, h] : inner) {
      const auto other = inner.find(Ends(ends.second, ends.first));
      if (other == inner.end()) {
        const HalfedgeRef twin = new_halfedge();
        twin->vertex = at[ends.second];
        if (!outer.emplace(ends.second, twin).second) {
          throw std::invalid_argument("the surface is pinched at a vertex");
        }
        pair(h, twin);
      } else if (ends.first < ends.second) {
        pair(h, other->second);
      }
    }
    for (const auto& [ends, h] : inner) {
      if (inner.count(Ends(ends.second, ends.first)) == 0) h->twin->next = outer.at(ends.first);
    }
    std::set<const Halfedge*> walked;
    for (const auto& [from, first] : outer) {
      if (walked.count(&*first) != 0) continue;
      const FaceRef hole = new_face();
      hole->boundary = true;
      hole->halfedge = first;
      HalfedgeRef h = first;
      do {
        h->face = hole;
        walked.insert(&*h);
        h = h->next;
      } while (h != first);
    }
  }

 private:
  void pair(HalfedgeRef a, HalfedgeRef b) {
    const EdgeRef edge = new_edge();
    edge->halfedge = a;
    a->twin = b;
    b->twin = a;
    a->edge = b->edge = edge;
  }
};
