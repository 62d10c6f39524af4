// The same mesh with other ways: pointers behind accessors, other names, half_edge in two
// words, prev stored, plain pointers as references, and operations that are members.
#pragma once
#include <array>
#include <cstddef>
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

// Other vectors and matrices: what is counted begins with zeros.
struct Two {
  float u = 0, v = 0;
  float& operator[](std::size_t at) { return at == 0 ? u : v; }
  float operator[](std::size_t at) const { return at == 0 ? u : v; }
};
struct Four {
  float parts[4] = {0, 0, 0, 0};
  float& operator[](std::size_t at) { return parts[at]; }
  float operator[](std::size_t at) const { return parts[at]; }
};
struct Matrix {
  Four columns[4];
  Four& operator[](std::size_t at) { return columns[at]; }
  const Four& operator[](std::size_t at) const { return columns[at]; }
};
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
    H& prev() { return prev_; }
    H& twin() { return twin_; }
    V& vertex() { return vertex_; }
    E& edge() { return edge_; }
    F& face() { return face_; }
    float mark = 0;
    course::Two uv;
    int number = -1;

   private:
    H next_ = nullptr, prev_ = nullptr, twin_ = nullptr;
    V vertex_ = nullptr;
    E edge_ = nullptr;
    F face_ = nullptr;
  };
  struct Vertex {
    H& half_edge() { return half_edge_; }
    course::Vec pos;
    float weight = 0;
    course::Vec tint;
    course::Matrix quadric;
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
    course::Four plane;
    std::array<std::array<float, 3>, 3> frame{};
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
