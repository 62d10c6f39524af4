// A stand-in for the mesh class of Scotty3D: what its header promises to the local operations, and
// no more. Elements lie in lists, references are iterators, what is erased is spoilt and kept.
#pragma once
#include <cmath>
#include <cstdint>
#include <limits>
#include <list>
#include <optional>
#include <string>
#include <vector>

struct Vec2 {
  Vec2() = default;
  explicit Vec2(float x_, float y_) : x(x_), y(y_) {}
  float x = 0.0f, y = 0.0f;
};

struct Vec3 {
  Vec3() = default;
  explicit Vec3(float f) : x(f), y(f), z(f) {}
  explicit Vec3(float x_, float y_, float z_) : x(x_), y(y_), z(z_) {}
  Vec3 operator+(Vec3 v) const { return Vec3(x + v.x, y + v.y, z + v.z); }
  Vec3 operator-(Vec3 v) const { return Vec3(x - v.x, y - v.y, z - v.z); }
  Vec3 operator*(Vec3 v) const { return Vec3(x * v.x, y * v.y, z * v.z); }
  Vec3 operator+(float s) const { return Vec3(x + s, y + s, z + s); }
  Vec3 operator*(float s) const { return Vec3(x * s, y * s, z * s); }
  Vec3 operator/(float s) const { return Vec3(x / s, y / s, z / s); }
  Vec3 operator-() const { return Vec3(-x, -y, -z); }
  bool operator==(const Vec3& v) const { return x == v.x && y == v.y && z == v.z; }
  float x = 0.0f, y = 0.0f, z = 0.0f;
};
inline Vec3 operator*(float s, Vec3 v) { return v * s; }
// Courses have such names in sight; emitted code must get along with them.
inline float dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) {
  return Vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

class Halfedge_Mesh {
 public:
  Halfedge_Mesh() = default;
  // Elements know each other by where they are: a mesh is moved, and never copied.
  Halfedge_Mesh(Halfedge_Mesh&&) = default;

  class Vertex;
  class Edge;
  class Face;
  class Halfedge;
  using VertexRef = std::list<Vertex>::iterator;
  using EdgeRef = std::list<Edge>::iterator;
  using FaceRef = std::list<Face>::iterator;
  using HalfedgeRef = std::list<Halfedge>::iterator;

  std::optional<VertexRef> bisect_edge(EdgeRef e);
  std::optional<VertexRef> split_edge(EdgeRef e);
  std::optional<VertexRef> inset_vertex(FaceRef f);
  std::optional<FaceRef> bevel_vertex(VertexRef v);
  std::optional<FaceRef> bevel_edge(EdgeRef e);
  std::optional<FaceRef> extrude_face(FaceRef f);
  std::optional<EdgeRef> flip_edge(EdgeRef e);
  std::optional<FaceRef> make_boundary(FaceRef f);
  std::optional<FaceRef> dissolve_vertex(VertexRef v);
  std::optional<FaceRef> dissolve_edge(EdgeRef e);
  std::optional<VertexRef> collapse_edge(EdgeRef e);
  std::optional<VertexRef> collapse_face(FaceRef f);
  std::optional<EdgeRef> weld_edges(EdgeRef e, EdgeRef e2);

  class Vertex {
   public:
    HalfedgeRef halfedge;
    uint32_t id;
    Vec3 position;
    bool on_boundary() const;
    uint32_t degree() const;

   private:
    explicit Vertex(uint32_t id_) : id(id_) {}
    friend class Halfedge_Mesh;
  };
  class Edge {
   public:
    HalfedgeRef halfedge;
    uint32_t id;
    bool sharp = false;
    bool on_boundary() const;

   private:
    Edge(uint32_t id_, bool sharp_) : id(id_), sharp(sharp_) {}
    friend class Halfedge_Mesh;
  };
  class Face {
   public:
    HalfedgeRef halfedge;
    uint32_t id;
    bool boundary = false;
    uint32_t degree() const;

   private:
    Face(uint32_t id_, bool boundary_) : id(id_), boundary(boundary_) {}
    friend class Halfedge_Mesh;
  };
  class Halfedge {
   public:
    HalfedgeRef twin, next;
    VertexRef vertex;
    EdgeRef edge;
    FaceRef face;
    uint32_t id;
    Vec2 corner_uv;
    Vec3 corner_normal;

   private:
    explicit Halfedge(uint32_t id_) : id(id_) {}
    friend class Halfedge_Mesh;
  };

  VertexRef emplace_vertex();
  EdgeRef emplace_edge(bool sharp = false);
  FaceRef emplace_face(bool boundary = false);
  HalfedgeRef emplace_halfedge();
  void erase_vertex(VertexRef v);
  void erase_edge(EdgeRef e);
  void erase_face(FaceRef f);
  void erase_halfedge(HalfedgeRef h);

  // What is wrong with the mesh, in words.
  std::optional<std::string> fault() const;

  std::list<Vertex> vertices;
  std::list<Edge> edges;
  std::list<Face> faces;
  std::list<Halfedge> halfedges;

 private:
  std::list<Vertex> free_vertices;
  std::list<Edge> free_edges;
  std::list<Face> free_faces;
  std::list<Halfedge> free_halfedges;
  uint32_t next_id = 0;
};

// A mesh by the corners of its faces; holes are closed with boundary faces.
Halfedge_Mesh made(const std::vector<Vec3>& corners, const std::vector<std::vector<int>>& faces);
