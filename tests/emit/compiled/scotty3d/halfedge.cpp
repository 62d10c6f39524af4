#include "halfedge.h"

#include <map>
#include <set>

using Mesh = Halfedge_Mesh;
using VertexRef = Mesh::VertexRef;
using EdgeRef = Mesh::EdgeRef;
using FaceRef = Mesh::FaceRef;
using HalfedgeRef = Mesh::HalfedgeRef;

VertexRef Mesh::emplace_vertex() {
  VertexRef v = vertices.insert(vertices.end(), Vertex(next_id++));
  v->halfedge = halfedges.end();
  return v;
}
EdgeRef Mesh::emplace_edge(bool sharp) {
  EdgeRef e = edges.insert(edges.end(), Edge(next_id++, sharp));
  e->halfedge = halfedges.end();
  return e;
}
FaceRef Mesh::emplace_face(bool boundary) {
  FaceRef f = faces.insert(faces.end(), Face(next_id++, boundary));
  f->halfedge = halfedges.end();
  return f;
}
HalfedgeRef Mesh::emplace_halfedge() {
  HalfedgeRef h = halfedges.insert(halfedges.end(), Halfedge(next_id++));
  h->twin = h->next = halfedges.end();
  h->vertex = vertices.end();
  h->edge = edges.end();
  h->face = faces.end();
  return h;
}
void Mesh::erase_vertex(VertexRef v) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  v->position = Vec3(nan, nan, nan);
  v->halfedge = halfedges.end();
  free_vertices.splice(free_vertices.end(), vertices, v);
}
void Mesh::erase_edge(EdgeRef e) {
  e->halfedge = halfedges.end();
  free_edges.splice(free_edges.end(), edges, e);
}
void Mesh::erase_face(FaceRef f) {
  f->halfedge = halfedges.end();
  free_faces.splice(free_faces.end(), faces, f);
}
void Mesh::erase_halfedge(HalfedgeRef h) {
  h->twin = h->next = halfedges.end();
  h->vertex = vertices.end();
  h->edge = edges.end();
  h->face = faces.end();
  free_halfedges.splice(free_halfedges.end(), halfedges, h);
}

bool Mesh::Vertex::on_boundary() const {
  HalfedgeRef h = halfedge;
  do {
    if (h->face->boundary) return true;
    h = h->twin->next;
  } while (h != halfedge);
  return false;
}
uint32_t Mesh::Vertex::degree() const {
  uint32_t count = 0;
  HalfedgeRef h = halfedge;
  do {
    ++count;
    h = h->twin->next;
  } while (h != halfedge);
  return count;
}
bool Mesh::Edge::on_boundary() const {
  return halfedge->face->boundary || halfedge->twin->face->boundary;
}
uint32_t Mesh::Face::degree() const {
  uint32_t count = 0;
  HalfedgeRef h = halfedge;
  do {
    ++count;
    h = h->next;
  } while (h != halfedge);
  return count;
}

template <class T>
static std::set<const T*> all_of(const std::list<T>& list) {
  std::set<const T*> all;
  for (const T& x : list) all.insert(&x);
  return all;
}

std::optional<std::string> Mesh::fault() const {
  const auto vs = all_of(vertices);
  const auto es = all_of(edges);
  const auto fs = all_of(faces);
  const auto hs = all_of(halfedges);
  std::map<const Vertex*, std::set<const Halfedge*>> at_vertex;
  std::map<const Edge*, std::set<const Halfedge*>> of_edge;
  std::map<const Face*, std::set<const Halfedge*>> of_face;
  for (const Halfedge& h : halfedges) {
    if (h.twin == halfedges.end() || h.next == halfedges.end()) return "a pointer is not set";
    if (h.vertex == vertices.end() || h.edge == edges.end() || h.face == faces.end()) {
      return "a pointer is not set";
    }
    if (!hs.count(&*h.twin) || !hs.count(&*h.next)) return "a pointer to what is erased";
    if (!vs.count(&*h.vertex) || !es.count(&*h.edge) || !fs.count(&*h.face)) {
      return "a pointer to what is erased";
    }
    if (&*h.twin == &h || &*h.twin->twin != &h) return "twins do not agree";
    at_vertex[&*h.vertex].insert(&h);
    of_edge[&*h.edge].insert(&h);
    of_face[&*h.face].insert(&h);
    if (h.face->boundary && h.twin->face->boundary) return "an edge without a face";
  }
  auto cycle = [&](HalfedgeRef h, auto step) {
    std::set<const Halfedge*> seen;
    if (h == const_cast<Mesh*>(this)->halfedges.end() || !hs.count(&*h)) return seen;
    while (seen.insert(&*h).second) h = step(h);
    return seen;
  };
  for (const Vertex& v : vertices) {
    if (!std::isfinite(v.position.x + v.position.y + v.position.z)) return "no finite position";
    auto seen = cycle(v.halfedge, [](HalfedgeRef h) { return h->twin->next; });
    if (seen != at_vertex[&v]) return "the spokes of a vertex are not one ring";
    if (seen.size() < 2) return "a vertex with fewer than two edges";
    int holes = 0;
    for (const Halfedge* h : seen) holes += h->face->boundary;
    if (holes > 1) return "two boundaries at a vertex";
  }
  for (const Edge& e : edges) {
    auto seen = cycle(e.halfedge, [](HalfedgeRef h) { return h->twin; });
    if (seen != of_edge[&e] || seen.size() != 2) return "an edge has not its two halfedges";
  }
  for (const Face& f : faces) {
    auto seen = cycle(f.halfedge, [](HalfedgeRef h) { return h->next; });
    if (seen != of_face[&f]) return "the sides of a face are not one loop";
    if (seen.size() < 3) return "a face with fewer than three sides";
    std::set<const Vertex*> corners;
    std::set<const Edge*> sides;
    for (const Halfedge* h : seen) {
      corners.insert(&*h->vertex);
      sides.insert(&*h->edge);
    }
    if (corners.size() != seen.size() || sides.size() != seen.size()) {
      return "a face meets a vertex or an edge twice";
    }
  }
  return std::nullopt;
}

Halfedge_Mesh made(const std::vector<Vec3>& corners, const std::vector<std::vector<int>>& faces) {
  Mesh mesh;
  std::vector<VertexRef> vs;
  for (Vec3 corner : corners) {
    vs.push_back(mesh.emplace_vertex());
    vs.back()->position = corner;
  }
  std::map<std::pair<int, int>, HalfedgeRef> sides;
  for (const auto& ids : faces) {
    FaceRef f = mesh.emplace_face();
    HalfedgeRef first, last;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const int a = ids[i], b = ids[(i + 1) % ids.size()];
      HalfedgeRef h = mesh.emplace_halfedge();
      sides[{a, b}] = h;
      h->vertex = vs[a];
      h->face = f;
      vs[a]->halfedge = h;
      if (i == 0) first = f->halfedge = h;
      else last->next = h;
      last = h;
      auto twin = sides.find({b, a});
      if (twin == sides.end()) {
        h->edge = mesh.emplace_edge();
        h->edge->halfedge = h;
      } else {
        h->twin = twin->second;
        h->twin->twin = h;
        h->edge = h->twin->edge;
      }
    }
    last->next = first;
  }
  std::map<int, HalfedgeRef> border;
  for (auto& [ends, h] : sides) {
    if (sides.count({ends.second, ends.first})) continue;
    HalfedgeRef t = mesh.emplace_halfedge();
    t->vertex = vs[ends.second];
    t->edge = h->edge;
    t->twin = h;
    h->twin = t;
    border[ends.second] = t;
  }
  for (auto& [end, t] : border) {
    for (auto& [other, next] : border) {
      if (vs[other] == t->twin->vertex) t->next = next;
    }
  }
  for (auto& [end, t] : border) {
    if (t->face != mesh.faces.end()) continue;
    FaceRef hole = mesh.emplace_face(true);
    hole->halfedge = t;
    for (HalfedgeRef h = t; h->face == mesh.faces.end(); h = h->next) h->face = hole;
  }
  return mesh;
}
