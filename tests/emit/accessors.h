// The same mesh with other ways: pointers behind accessors, other names, half_edge in two
// words, plain pointers as references, and operations that are members.
#pragma once
#include <deque>
#include <optional>
#include <set>

namespace course {
struct Vec {
  float x, y, z;
  Vec() : x(0), y(0), z(0) {}
  Vec(float x, float y, float z) : x(x), y(y), z(z) {}
};
inline Vec operator+(Vec a, Vec b) { return Vec(a.x + b.x, a.y + b.y, a.z + b.z); }
inline Vec operator-(Vec a, Vec b) { return Vec(a.x - b.x, a.y - b.y, a.z - b.z); }
inline Vec operator-(Vec a) { return Vec(-a.x, -a.y, -a.z); }
inline Vec operator*(Vec a, float t) { return Vec(a.x * t, a.y * t, a.z * t); }
inline Vec operator/(Vec a, float t) { return Vec(a.x / t, a.y / t, a.z / t); }
}  // namespace course

class HalfEdgeMesh {
 public:
  struct Vertex;
  struct Edge;
  struct Face;
  struct HalfEdge;
  using V = Vertex*;
  using E = Edge*;
  using F = Face*;
  using H = HalfEdge*;

#include "declared.h"

  struct HalfEdge {
    H& next() { return next_; }
    H& twin() { return twin_; }
    V& vertex() { return vertex_; }
    E& edge() { return edge_; }
    F& face() { return face_; }
    float mark = 0;
    int number = -1;

   private:
    H next_ = nullptr, twin_ = nullptr;
    V vertex_ = nullptr;
    E edge_ = nullptr;
    F face_ = nullptr;
  };
  struct Vertex {
    H& half_edge() { return half_edge_; }
    course::Vec pos;
    float weight = 0;
    course::Vec tint;
    int number = -1;

   private:
    H half_edge_ = nullptr;
  };
  struct Edge {
    H& half_edge() { return half_edge_; }
    bool fresh = false;
    int number = -1;

   private:
    H half_edge_ = nullptr;
  };
  struct Face {
    H& half_edge() { return half_edge_; }
    bool is_boundary() { return boundary; }
    bool boundary = false;
    long long class_ = 0;
    int number = -1;

   private:
    H half_edge_ = nullptr;
  };

  // Elements stay where they are; what is deleted is noted.
  std::deque<Vertex> vertices;
  std::deque<HalfEdge> halfedges;
  std::deque<Edge> edges;
  std::deque<Face> faces;
  std::set<void*> gone;

  V new_vertex() { return &vertices.emplace_back(); }
  H new_halfedge() { return &halfedges.emplace_back(); }
  E new_edge() { return &edges.emplace_back(); }
  F new_face() { return &faces.emplace_back(); }
  void delete_vertex(V v) { gone.insert(v); }
  void delete_halfedge(H h) { gone.insert(h); }
  void delete_edge(E e) { gone.insert(e); }
  void delete_face(F f) { gone.insert(f); }
};

#define ACCESSORS 1
#define GET(of, pointer) ((of)->pointer())
#define SET(of, pointer, value) ((of)->pointer() = (value))
#define BOUNDARY(f) ((f)->boundary)
#define POSITION(v) ((v)->pos)
#define OPERATION(name, ...) mesh.name(__VA_ARGS__)
using Mesh = HalfEdgeMesh;
using Vector = course::Vec;
