#include <optional>

namespace hedgerow {
inline namespace ve6f71ec2 {

#ifndef HEDGEROW_adjacent
#define HEDGEROW_adjacent
/// Whether an edge joins v and w.
inline bool adjacent(Mesh::VertexRef v, Mesh::VertexRef w) {
  Mesh::HalfedgeRef h = v->halfedge;
  do {
    if (h->twin->vertex == w) return true;
    h = h->twin->next;
  } while (h != v->halfedge);
  return false;
}
#endif

}
}  // namespace hedgerow

/// Rotates an edge between two triangles by one corner.
///
/// ```text
///        v2                 v2
///       /  \               /|\ .
///     c/ f0 \b           c/ | \b
///     /  a-> \           /  |  \ .
///   v0 ------ v1   =>  v0   |   v1
///     \ <-d  /           \ a|d /
///     g\ f1 /h           g\ | /h
///       \  /               \|/
///        v3                 v3
/// ```
bool flip(Mesh& /*mesh*/, Mesh::EdgeRef e) {
  using VertexRef = Mesh::VertexRef;
  using HalfedgeRef = Mesh::HalfedgeRef;
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
    if (hedgerow::adjacent(v2, v3)) continue;  // the edge v2 v3 is already there

    // 3. Reassign every pointer that changes.
    a->next = c;
    a->vertex = v3;
    b->next = d;
    b->face = f1;
    c->next = g;
    d->next = h;
    d->vertex = v2;
    g->next = a;
    g->face = f0;
    h->next = b;
    v0->halfedge = g;
    v1->halfedge = b;
    f0->halfedge = a;
    f1->halfedge = d;
    return true;
  }
  return false;
}
