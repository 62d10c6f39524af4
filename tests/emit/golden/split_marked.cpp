// Elements have these attributes:
//   edge: bool fresh, by default false
//   face: long long class_, by default 0
//   halfedge: double mark, by default 0
//   vertex: Vec3 tint, by default vec3(0)
//   vertex: double weight, by default 0

#include <cmath>
#include <optional>
#include <type_traits>

namespace hedgerow {
inline namespace ve6f71ec2 {

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

}
}  // namespace hedgerow

/// Splits an edge between two triangles, and marks what is new, as remeshers do.
std::optional<Mesh::VertexRef> split_marked(Mesh& mesh, Mesh::EdgeRef e, double t) {
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
    HalfedgeRef g = d->next;
    HalfedgeRef h = g->next;
    FaceRef f0 = a->face;
    VertexRef v0 = a->vertex;
    VertexRef v1 = d->vertex;
    VertexRef v2 = c->vertex;
    FaceRef f1 = d->face;
    VertexRef v3 = h->vertex;
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
    if (e->fresh) continue;  // the edge is new
    // Refused: it lies between classes.
    if (f0->class_ != f1->class_ && !(v0->weight < v1->weight + a->mark)) continue;
    Vec3 m_position = hedgerow::mix(v0->position, v1->position, t);
    if (!hedgerow::is_finite(m_position)) continue;  // the new position of `m` is not finite
    double m_weight = (v0->weight + v1->weight) / 2.0;
    Vec3 m_tint = hedgerow::mix(v0->tint, v1->tint, t) + hedgerow::vector(a->mark, 0.0, 1.0);
    double p_mark = a->mark + 1.0;
    double q_mark = std::fmax(b->mark, c->mark);
    bool eq_fresh = true;
    bool er_fresh = !e->fresh;
    long long g0_class_ = f0->class_;
    long long f1_class_ = f1->class_ + 2;

    // 2. Allocate what is new.
    VertexRef m = mesh.new_vertex();
    HalfedgeRef p = mesh.new_halfedge();
    HalfedgeRef p_ = mesh.new_halfedge();
    HalfedgeRef q = mesh.new_halfedge();
    HalfedgeRef q_ = mesh.new_halfedge();
    HalfedgeRef r = mesh.new_halfedge();
    HalfedgeRef r_ = mesh.new_halfedge();
    EdgeRef ep = mesh.new_edge();
    EdgeRef eq = mesh.new_edge();
    EdgeRef er = mesh.new_edge();
    FaceRef g0 = mesh.new_face();
    FaceRef g1 = mesh.new_face();

    // 3. Reassign every pointer that changes.
    a->next = q;
    b->next = q_;
    b->face = g0;
    d->vertex = m;
    g->next = r;
    h->next = p_;
    h->face = g1;
    p->next = b;
    p->twin = p_;
    p->vertex = m;
    p->edge = ep;
    p->face = g0;
    p_->next = r_;
    p_->twin = p;
    p_->vertex = v1;
    p_->edge = ep;
    p_->face = g1;
    q->next = c;
    q->twin = q_;
    q->vertex = m;
    q->edge = eq;
    q->face = f0;
    q_->next = p;
    q_->twin = q;
    q_->vertex = v2;
    q_->edge = eq;
    q_->face = g0;
    r->next = d;
    r->twin = r_;
    r->vertex = v3;
    r->edge = er;
    r->face = f1;
    r_->next = h;
    r_->twin = r;
    r_->vertex = m;
    r_->edge = er;
    r_->face = g1;
    v1->halfedge = b;
    m->halfedge = d;
    ep->halfedge = p;
    eq->halfedge = q;
    er->halfedge = r;
    f0->halfedge = a;
    f1->halfedge = d;
    g0->halfedge = p;
    g1->halfedge = p_;
    m->position = m_position;
    m->weight = m_weight;
    m->tint = m_tint;
    p->mark = p_mark;
    q->mark = q_mark;
    eq->fresh = eq_fresh;
    er->fresh = er_fresh;
    g0->class_ = g0_class_;
    f1->class_ = f1_class_;
    return m;
  }
  return std::nullopt;
}
