#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace hedgerow {
inline namespace ve6f71ec2 {

#ifndef HEDGEROW_halfedges
#define HEDGEROW_halfedges
/// The halfedges of f, counterclockwise.
inline std::vector<Mesh::HalfedgeRef> halfedges(Mesh::FaceRef f) {
  std::vector<Mesh::HalfedgeRef> all;
  Mesh::HalfedgeRef h = f->halfedge;
  do {
    all.push_back(h);
    h = h->next;
  } while (h != f->halfedge);
  return all;
}
#endif

#ifndef HEDGEROW_loop_from
#define HEDGEROW_loop_from
/// The halfedges of a loop, from h on.
inline std::vector<Mesh::HalfedgeRef> loop_from(Mesh::HalfedgeRef h) {
  std::vector<Mesh::HalfedgeRef> all;
  Mesh::HalfedgeRef at = h;
  do {
    all.push_back(at);
    at = at->next;
  } while (at != h);
  return all;
}
#endif

#ifndef HEDGEROW_some
#define HEDGEROW_some
/// Whether the condition holds for one of 0, ..., n - 1.
template <class C>
bool some(std::size_t n, C condition) {
  for (std::size_t at = 0; at < n; ++at) {
    if (condition(at)) return true;
  }
  return false;
}
#endif

#ifndef HEDGEROW_vertices
#define HEDGEROW_vertices
/// The corners of f.
inline std::vector<Mesh::VertexRef> vertices(Mesh::FaceRef f) {
  std::vector<Mesh::VertexRef> all;
  for (Mesh::HalfedgeRef h : hedgerow::halfedges(f)) all.push_back(h->vertex);
  return all;
}
#endif

#ifndef HEDGEROW_all_differ
#define HEDGEROW_all_differ
/// Whether all are different.
template <class T>
bool all_differ(const std::vector<T>& all) {
  for (auto it = all.begin(); it != all.end(); ++it) {
    if (std::find(all.begin(), it, *it) != it) return false;
  }
  return true;
}
#endif

#ifndef HEDGEROW_vector_as_n
#define HEDGEROW_vector_as_n
/// A vector by its parts, whether its type has a constructor or is an aggregate.
template <class V, class R>
V vector_as(R x, R y, R z) {
  if constexpr (std::is_constructible_v<V, R, R, R>) {
    return V(x, y, z);
  } else {
    V all{};
    all.x = x;
    all.y = y;
    all.z = z;
    return all;
  }
}
#endif

#ifndef HEDGEROW_vector
#define HEDGEROW_vector
inline Vec3 vector(double x, double y, double z) { return hedgerow::vector_as<Vec3>(x, y, z); }
#endif

#ifndef HEDGEROW_is_finite
#define HEDGEROW_is_finite
inline bool is_finite(Vec3 a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
#endif

#ifndef HEDGEROW_mix
#define HEDGEROW_mix
/// a for t = 0, b for t = 1.
template <class T>
T mix(T a, T b, double t) { return a * (1 - t) + b * t; }
#endif

#ifndef HEDGEROW_centroid
#define HEDGEROW_centroid
/// The mean of the corners of f.
inline Vec3 centroid(Mesh::FaceRef f) {
  Vec3 total = hedgerow::vector(0, 0, 0);
  std::vector<Mesh::VertexRef> corners = hedgerow::vertices(f);
  for (Mesh::VertexRef v : corners) total = total + v->position;
  return total / static_cast<double>(corners.size());
}
#endif

}
}  // namespace hedgerow

/// Shrinks a face inside its own boundary, and fills the gap with quads.
bool inset(Mesh& mesh, Mesh::FaceRef f, double t = 0.3) {
  using VertexRef = Mesh::VertexRef;
  using HalfedgeRef = Mesh::HalfedgeRef;
  using EdgeRef = Mesh::EdgeRef;
  using FaceRef = Mesh::FaceRef;

  // 1. Collect: nothing is written before all of this has passed.
  HalfedgeRef h_0 = f->halfedge;
  std::vector<HalfedgeRef> h = hedgerow::loop_from(h_0);
  std::size_t n = h.size();
  std::vector<VertexRef> v;
  for (std::size_t i = 0; i < n; ++i) v.push_back(h[i]->vertex);
  if (f->boundary) return false;  // `f` is a hole
  // Refused: `h[i]` does not lie in `f`.
  if (hedgerow::some(n, [&](std::size_t i) { return h[i]->face != f; })) return false;
  if (!hedgerow::all_differ(v)) return false;  // two of `v[i]` are one vertex
  Vec3 centroid = hedgerow::centroid(f);
  std::vector<Vec3> w_position;
  for (std::size_t i = 0; i < n; ++i) {
    w_position.push_back(hedgerow::mix(v[i]->position, centroid, t));
  }
  // Refused: the new position of `w[i]` is not finite.
  if (hedgerow::some(n, [&](std::size_t i) { return !hedgerow::is_finite(w_position[i]); })) return false;

  // 2. Allocate what is new.
  std::vector<VertexRef> w;
  for (std::size_t i = 0; i < n; ++i) w.push_back(mesh.new_vertex());
  std::vector<HalfedgeRef> s;
  for (std::size_t i = 0; i < n; ++i) s.push_back(mesh.new_halfedge());
  std::vector<HalfedgeRef> a;
  for (std::size_t i = 0; i < n; ++i) a.push_back(mesh.new_halfedge());
  std::vector<HalfedgeRef> b;
  for (std::size_t i = 0; i < n; ++i) b.push_back(mesh.new_halfedge());
  std::vector<HalfedgeRef> r;
  for (std::size_t i = 0; i < n; ++i) r.push_back(mesh.new_halfedge());
  std::vector<FaceRef> q;
  for (std::size_t i = 0; i < n; ++i) q.push_back(mesh.new_face());
  std::vector<EdgeRef> c;
  for (std::size_t i = 0; i < n; ++i) c.push_back(mesh.new_edge());
  std::vector<EdgeRef> d;
  for (std::size_t i = 0; i < n; ++i) d.push_back(mesh.new_edge());

  // 3. Reassign every pointer that changes.
  f->halfedge = s[0];
  for (std::size_t i = 0; i < n; ++i) {
    h[i]->next = a[i];
    h[i]->face = q[i];
    s[i]->next = s[(i + 1) % n];
    s[i]->twin = r[i];
    s[i]->vertex = w[i];
    s[i]->edge = c[i];
    s[i]->face = f;
    a[i]->next = r[i];
    a[i]->twin = b[(i + 1) % n];
    a[i]->vertex = v[(i + 1) % n];
    a[i]->edge = d[i];
    a[i]->face = q[i];
    b[i]->next = h[i];
    b[i]->vertex = w[i];
    b[i]->face = q[i];
    b[(i + 1) % n]->twin = a[i];
    b[(i + 1) % n]->edge = d[i];
    r[i]->next = b[i];
    r[i]->twin = s[i];
    r[i]->vertex = w[(i + 1) % n];
    r[i]->edge = c[i];
    r[i]->face = q[i];
    w[i]->halfedge = s[i];
    c[i]->halfedge = s[i];
    d[i]->halfedge = a[i];
    q[i]->halfedge = h[i];
  }
  for (std::size_t i = 0; i < n; ++i) w[i]->position = w_position[i];
  return true;
}
