#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace hedgerow {
inline namespace ve6f71ec2 {

#ifndef HEDGEROW_spokes
#define HEDGEROW_spokes
/// The halfedges that start at v, counterclockwise.
inline std::vector<Mesh::HalfedgeRef> spokes(Mesh::VertexRef v) {
  std::vector<Mesh::HalfedgeRef> all;
  Mesh::HalfedgeRef h = v->halfedge;
  do {
    all.push_back(h);
    h = h->twin->next;  // clockwise: no halfedge knows the one before it
  } while (h != v->halfedge);
  std::reverse(all.begin() + 1, all.end());
  return all;
}
#endif

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

#ifndef HEDGEROW_neighbors
#define HEDGEROW_neighbors
/// The vertices at the other ends of the edges of v.
inline std::vector<Mesh::VertexRef> neighbors(Mesh::VertexRef v) {
  std::vector<Mesh::VertexRef> all;
  for (Mesh::HalfedgeRef h : hedgerow::spokes(v)) all.push_back(h->twin->vertex);
  return all;
}
#endif

#ifndef HEDGEROW_faces_of_vertex
#define HEDGEROW_faces_of_vertex
/// The faces around v, without holes.
inline std::vector<Mesh::FaceRef> faces_of_vertex(Mesh::VertexRef v) {
  std::vector<Mesh::FaceRef> all;
  for (Mesh::HalfedgeRef h : hedgerow::spokes(v)) {
    if (!h->face->boundary) all.push_back(h->face);
  }
  return all;
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

#ifndef HEDGEROW_on_boundary
#define HEDGEROW_on_boundary
/// Whether a hole is among the faces around v.
inline bool on_boundary(Mesh::VertexRef v) {
  Mesh::HalfedgeRef h = v->halfedge;
  do {
    if (h->face->boundary) return true;
    h = h->twin->next;
  } while (h != v->halfedge);
  return false;
}
#endif

#ifndef HEDGEROW_holds
#define HEDGEROW_holds
/// Whether all contains x.
template <class T>
bool holds(const std::vector<T>& all, T x) {
  return std::find(all.begin(), all.end(), x) != all.end();
}
#endif

#ifndef HEDGEROW_same_elements
#define HEDGEROW_same_elements
/// Whether a and b have the same elements, in any order.
template <class T>
bool same_elements(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::is_permutation(a.begin(), a.end(), b.begin());
}
#endif

#ifndef HEDGEROW_link_condition
#define HEDGEROW_link_condition
/// Whether contracting e, and the triangles at it, leaves a simple mesh simple: its ends share
/// the tips of the triangles at e and no other neighbor, and no face that is not at e; both are
/// on the boundary only if e is, and then its hole has more than three sides; and no two faces
/// would have the same corners.
inline bool link_condition(Mesh::EdgeRef e) {
  Mesh::HalfedgeRef h = e->halfedge;
  Mesh::VertexRef a = h->vertex;
  Mesh::VertexRef b = h->twin->vertex;
  Mesh::FaceRef left = h->face;
  Mesh::FaceRef right = h->twin->face;
  if (a == b || left == right) return false;
  std::vector<Mesh::VertexRef> tips;
  std::vector<Mesh::FaceRef> polygons;
  bool open = false;
  for (Mesh::HalfedgeRef side : {h, h->twin}) {
    bool triangle = side->next->next->next == side;
    if (side->face->boundary) {
      if (open || triangle) return false;
      open = true;
    } else if (triangle) {
      tips.push_back(side->next->next->vertex);
    } else {
      polygons.push_back(side->face);
    }
  }
  if (tips.size() == 2 && tips[0] == tips[1]) return false;
  if (!open && hedgerow::on_boundary(a) && hedgerow::on_boundary(b)) return false;
  std::vector<Mesh::VertexRef> around = hedgerow::neighbors(a);
  std::size_t common = 0;
  for (Mesh::VertexRef v : hedgerow::neighbors(b)) common += hedgerow::holds(around, v);
  if (common != tips.size()) return false;
  auto others = [&a, &b](Mesh::FaceRef f) {
    std::vector<Mesh::VertexRef> all;
    for (Mesh::VertexRef v : hedgerow::vertices(f)) {
      if (v != a && v != b) all.push_back(v);
    }
    return all;
  };
  auto apart = [&left, &right](std::vector<Mesh::FaceRef> all) {
    std::vector<Mesh::FaceRef> some;
    for (Mesh::FaceRef f : all) {
      if (f != left && f != right) some.push_back(f);
    }
    return some;
  };
  std::vector<Mesh::FaceRef> at_a = apart(hedgerow::faces_of_vertex(a));
  std::vector<Mesh::FaceRef> at_b = apart(hedgerow::faces_of_vertex(b));
  for (Mesh::FaceRef f : at_a) {
    if (hedgerow::holds(hedgerow::vertices(f), b)) return false;
  }
  for (Mesh::FaceRef f : at_b) {
    if (hedgerow::holds(hedgerow::vertices(f), a)) return false;
  }
  for (Mesh::FaceRef f : polygons) {
    at_a.push_back(f);
    at_b.push_back(f);
  }
  for (Mesh::FaceRef f : at_a) {
    std::vector<Mesh::VertexRef> corners = others(f);
    for (Mesh::FaceRef g : at_b) {
      if (f != g && hedgerow::same_elements(corners, others(g))) return false;
    }
  }
  return true;
}
#endif

}
}  // namespace hedgerow

/// Merges the two ends of an edge between triangles at its midpoint; v1 goes.
///
/// The two triangles vanish, and of each the two other edges become one. All other spokes
/// of `v1`, the fan `S`, move to `v0`.
std::optional<Mesh::VertexRef> collapse(Mesh& mesh, Mesh::EdgeRef e) {
  using VertexRef = Mesh::VertexRef;
  using HalfedgeRef = Mesh::HalfedgeRef;
  using EdgeRef = Mesh::EdgeRef;
  using FaceRef = Mesh::FaceRef;

  // 1. Collect: nothing is written before all of this has passed.
  // Both directions of e are tried.
  for (HalfedgeRef a : {e->halfedge, e->halfedge->twin}) {
    HalfedgeRef b = a->next;
    HalfedgeRef c = b->next;
    HalfedgeRef d = a->twin;
    HalfedgeRef b_ = b->twin;
    HalfedgeRef c_ = c->twin;
    HalfedgeRef g = d->next;
    HalfedgeRef h = g->next;
    HalfedgeRef g_ = g->twin;
    HalfedgeRef h_ = h->twin;
    FaceRef f0 = a->face;
    VertexRef v0 = c_->vertex;
    VertexRef v1 = h_->vertex;
    VertexRef v2 = b_->vertex;
    FaceRef f1 = d->face;
    VertexRef v3 = g_->vertex;
    EdgeRef eb = b->edge;
    EdgeRef ec = c->edge;
    EdgeRef eg = g->edge;
    EdgeRef eh = h->edge;
    if (f0->boundary) continue;  // `f0` is a hole
    if (f1->boundary) continue;  // `f1` is a hole
    if (c->next != a) continue;  // `f0` is not a triangle
    if (h->next != d) continue;  // `f1` is not a triangle
    if (v0 == v1) continue;  // `v0` and `v1` are one vertex
    if (v0 == v2) continue;  // `v0` and `v2` are one vertex
    if (v0 == v3) continue;  // `v0` and `v3` are one vertex
    if (v1 == v2) continue;  // `v1` and `v2` are one vertex
    if (v1 == v3) continue;  // `v1` and `v3` are one vertex
    if (v2 == v3) continue;  // `v2` and `v3` are one vertex
    if (!hedgerow::link_condition(e)) continue;  // the link condition does not hold
    Vec3 v0_position = (v0->position + v1->position) / 2.0;

    // 3. Reassign every pointer that changes.
    for (HalfedgeRef h_2 = b_->next; h_2 != h_; h_2 = h_2->twin->next) h_2->vertex = v0;
    b_->twin = c_;
    c_->twin = b_;
    c_->edge = eb;
    g_->twin = h_;
    h_->twin = g_;
    h_->vertex = v0;
    h_->edge = eg;
    v0->halfedge = h_;
    v2->halfedge = b_;
    v3->halfedge = g_;
    eb->halfedge = b_;
    eg->halfedge = g_;
    v0->position = v0_position;

    // 4. Erase what is gone.
    mesh.erase(v1);
    mesh.erase(e);
    mesh.erase(a);
    mesh.erase(d);
    mesh.erase(b);
    mesh.erase(c);
    mesh.erase(g);
    mesh.erase(h);
    mesh.erase(f0);
    mesh.erase(f1);
    mesh.erase(ec);
    mesh.erase(eh);
    return v0;
  }
  return std::nullopt;
}
