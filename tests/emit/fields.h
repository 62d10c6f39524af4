// A small pointer mesh as courses have it: elements in lists, references that stay good.
// Halfedges know no prev; a hole is a face with a flag.
#pragma once
#include <array>
#include <list>

struct Vec3 {
  double x, y, z;
  Vec3() : x(0), y(0), z(0) {}
  Vec3(double x, double y, double z) : x(x), y(y), z(z) {}
};
inline Vec3 operator+(Vec3 a, Vec3 b) { return Vec3(a.x + b.x, a.y + b.y, a.z + b.z); }
inline Vec3 operator-(Vec3 a, Vec3 b) { return Vec3(a.x - b.x, a.y - b.y, a.z - b.z); }
inline Vec3 operator-(Vec3 a) { return Vec3(-a.x, -a.y, -a.z); }
inline Vec3 operator*(Vec3 a, double t) { return Vec3(a.x * t, a.y * t, a.z * t); }
inline Vec3 operator/(Vec3 a, double t) { return Vec3(a.x / t, a.y / t, a.z / t); }
// Courses have these at hand; emitted code must get along with them.
inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double length(Vec3) { throw 0; }

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
    VertexRef vertex;
    EdgeRef edge;
    FaceRef face;
    double mark = 0;
    std::array<double, 2> uv{};
    int number = -1;
  };
  struct Vertex {
    HalfedgeRef halfedge;
    Vec3 position;
    double weight = 0;
    Vec3 tint;
    std::array<std::array<double, 4>, 4> quadric{};
    int number = -1;
  };
  struct Edge {
    HalfedgeRef halfedge;
    bool fresh = false;
    int number = -1;
  };
  struct Face {
    HalfedgeRef halfedge;
    bool boundary = false;
    long long class_ = 0;
    std::array<double, 4> plane{};
    std::array<std::array<double, 3>, 3> frame{};
    int number = -1;
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
};

#define GET(of, pointer) ((of)->pointer)
#define SET(of, pointer, value) ((of)->pointer = (value))
#define BOUNDARY(f) ((f)->boundary)
#define POSITION(v) ((v)->position)
#define OPERATION(name, ...) name(mesh, __VA_ARGS__)
using Vector = Vec3;
