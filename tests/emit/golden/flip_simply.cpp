#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace hedgerow {
inline namespace ve6f71ec2 {

#ifndef HEDGEROW_prev
#define HEDGEROW_prev
/// The halfedge before h in its loop.
inline Mesh::HalfedgeRef prev(Mesh::HalfedgeRef h) {
  Mesh::HalfedgeRef p = h;
  while (p->next != h) p = p->next;
  return p;
}
#endif

#ifndef HEDGEROW_Preview
#define HEDGEROW_Preview
/// A preview of the mesh after an operation: the changes noted here, on top of the mesh. The
/// operation tests its result on it before anything is written.
class Preview {
 public:
  /// An element of the mesh, or a new one by its number.
  template <class T>
  struct Seen {
    T element{};
    int number = 0;
    Seen() = default;
    Seen(T one) : element(one) {}
    bool operator==(const Seen& other) const {
      return number == other.number && (number != 0 || element == other.element);
    }
    bool operator!=(const Seen& other) const { return !(*this == other); }
  };
  using SeenVertex = Seen<Mesh::VertexRef>;
  using SeenHalfedge = Seen<Mesh::HalfedgeRef>;
  using SeenFace = Seen<Mesh::FaceRef>;

  SeenVertex new_vertex() { return numbered(SeenVertex()); }
  SeenHalfedge new_halfedge() { return numbered(SeenHalfedge()); }
  SeenFace new_face() { return numbered(SeenFace()); }
  void set_next(SeenHalfedge h, SeenHalfedge to) { note(nexts_, h, to); }
  void set_twin(SeenHalfedge h, SeenHalfedge to) { note(twins_, h, to); }
  void set_vertex(SeenHalfedge h, SeenVertex to) { note(origins_, h, to); }
  void set_face(SeenHalfedge h, SeenFace to) { note(faces_, h, to); }
  void set_vertex_halfedge(SeenVertex v, SeenHalfedge to) { note(firsts_of_vertices_, v, to); }
  void set_face_halfedge(SeenFace f, SeenHalfedge to) { note(firsts_of_faces_, f, to); }
  void set_hole(SeenFace f, bool hole) { note(holes_, f, hole); }

  SeenHalfedge next(SeenHalfedge h) const {
    const SeenHalfedge* to = noted(nexts_, h);
    if (to) return *to;
    Mesh::HalfedgeRef at = h.element;
    return at->next;
  }
  SeenHalfedge twin(SeenHalfedge h) const {
    const SeenHalfedge* to = noted(twins_, h);
    if (to) return *to;
    Mesh::HalfedgeRef at = h.element;
    return at->twin;
  }
  SeenVertex vertex(SeenHalfedge h) const {
    const SeenVertex* to = noted(origins_, h);
    if (to) return *to;
    Mesh::HalfedgeRef at = h.element;
    return at->vertex;
  }
  SeenFace face(SeenHalfedge h) const {
    const SeenFace* to = noted(faces_, h);
    if (to) return *to;
    Mesh::HalfedgeRef at = h.element;
    return at->face;
  }
  bool is_hole(SeenFace f) const {
    const bool* hole = noted(holes_, f);
    if (hole || f.number != 0) return hole && *hole;
    Mesh::FaceRef at = f.element;
    return at->boundary;
  }

  /// Whether a face or hole has three sides or more.
  bool three_sides(SeenFace f) const {
    SeenHalfedge first = first_of(f), second = next(first);
    return second != first && next(second) != first;
  }
  /// Whether no vertex is two corners of f.
  bool meets_once(SeenFace f) const { return differ(corners(f)); }
  /// Whether f has no more than one corner at v.
  bool corner_once(SeenFace f, SeenVertex v) const {
    int met = 0;
    for (SeenHalfedge h : star(v)) met += face(h) == f;
    return met <= 1;
  }
  /// Whether v has two edges or more.
  bool two_spokes(SeenVertex v) const {
    SeenHalfedge first = first_of(v);
    return next(twin(first)) != first;
  }
  /// Whether no more than one corner of v lies in a hole.
  bool one_hole(SeenVertex v) const {
    int met = 0;
    for (SeenHalfedge h : star(v)) met += is_hole(face(h));
    return met <= 1;
  }
  /// Whether one_hole is true where the halfedges of the mesh from first up to until start; of
  /// the whole loop if these are the same.
  bool one_hole_along(Mesh::HalfedgeRef first, Mesh::HalfedgeRef until) const {
    Mesh::HalfedgeRef h = first;
    do {
      if (!one_hole(vertex(h))) return false;
      h = h->next;
    } while (h != until);
    return true;
  }
  /// Whether no face has two corners at v.
  bool faces_differ(SeenVertex v) const {
    std::vector<SeenFace> around;
    for (SeenHalfedge h : star(v)) around.push_back(face(h));
    return differ(around);
  }
  /// Whether no two edges lead from v to one neighbor.
  bool neighbors_differ(SeenVertex v) const {
    std::vector<SeenVertex> around;
    for (SeenHalfedge h : star(v)) around.push_back(vertex(twin(h)));
    return differ(around);
  }
  /// Whether no other edge joins the ends of h.
  bool single_edge(SeenHalfedge h) const {
    int met = 0;
    for (SeenHalfedge other : star(vertex(h))) met += vertex(twin(other)) == vertex(twin(h));
    return met <= 1;
  }
  /// Whether no two faces around v have the same corners.
  bool corners_differ(SeenVertex v) const {
    std::vector<std::vector<SeenVertex>> around;
    for (SeenHalfedge h : star(v)) {
      if (is_hole(face(h))) continue;
      around.push_back(corners(face(h)));
      for (std::size_t at = 0; at + 1 < around.size(); ++at) {
        if (alike(around[at], around.back())) return false;
      }
    }
    return true;
  }
  /// Whether no other face around v has the same corners as f.
  bool corners_own(SeenFace f, SeenVertex v) const {
    if (is_hole(f)) return true;
    for (SeenHalfedge h : star(v)) {
      SeenFace other = face(h);
      if (other != f && !is_hole(other) && alike(corners(f), corners(other))) return false;
    }
    return true;
  }

 private:
  template <class K, class V>
  using Notes = std::vector<std::pair<K, V>>;

  template <class K, class V>
  static void note(Notes<K, V>& notes, K of, V value) {
    for (auto& known : notes) {
      if (known.first == of) {
        known.second = value;
        return;
      }
    }
    notes.emplace_back(of, value);
  }
  template <class K, class V>
  static const V* noted(const Notes<K, V>& notes, K of) {
    for (const auto& known : notes) {
      if (known.first == of) return &known.second;
    }
    return nullptr;
  }
  template <class T>
  T numbered(T seen) {
    seen.number = ++count_;
    return seen;
  }
  SeenHalfedge first_of(SeenVertex v) const {
    const SeenHalfedge* to = noted(firsts_of_vertices_, v);
    if (to) return *to;
    Mesh::VertexRef at = v.element;
    return at->halfedge;
  }
  SeenHalfedge first_of(SeenFace f) const {
    const SeenHalfedge* to = noted(firsts_of_faces_, f);
    if (to) return *to;
    Mesh::FaceRef at = f.element;
    return at->halfedge;
  }
  /// The halfedges that start at v; kept, since all changes are noted before the first test.
  const std::vector<SeenHalfedge>& star(SeenVertex v) const {
    if (!star_.empty() && star_of_ == v) return star_;
    star_of_ = v;
    star_.clear();
    SeenHalfedge first = first_of(v);
    SeenHalfedge h = first;
    do {
      star_.push_back(h);
      h = next(twin(h));
    } while (h != first);
    return star_;
  }
  std::vector<SeenVertex> corners(SeenFace f) const {
    SeenHalfedge first = first_of(f);
    std::vector<SeenVertex> around;
    SeenHalfedge h = first;
    do {
      around.push_back(vertex(h));
      h = next(h);
    } while (h != first);
    return around;
  }
  template <class T>
  static bool differ(const std::vector<T>& seen) {
    for (auto it = seen.begin(); it != seen.end(); ++it) {
      if (std::find(seen.begin(), it, *it) != it) return false;
    }
    return true;
  }
  static bool alike(const std::vector<SeenVertex>& a, const std::vector<SeenVertex>& b) {
    return a.size() == b.size() && std::is_permutation(a.begin(), a.end(), b.begin());
  }

  Notes<SeenHalfedge, SeenHalfedge> nexts_, twins_;
  Notes<SeenHalfedge, SeenVertex> origins_;
  Notes<SeenHalfedge, SeenFace> faces_;
  Notes<SeenVertex, SeenHalfedge> firsts_of_vertices_;
  Notes<SeenFace, SeenHalfedge> firsts_of_faces_;
  Notes<SeenFace, bool> holes_;
  mutable SeenVertex star_of_;
  mutable std::vector<SeenHalfedge> star_;
  int count_ = 0;
};
#endif

}
}  // namespace hedgerow

/// The same, and edges stay told by their ends.
bool flip_simply(Mesh& /*mesh*/, Mesh::EdgeRef e) {
  using VertexRef = Mesh::VertexRef;
  using HalfedgeRef = Mesh::HalfedgeRef;
  using FaceRef = Mesh::FaceRef;

  // 1. Collect: nothing is written before all of this has passed.
  // Both directions of e are tried.
  for (HalfedgeRef a : {e->halfedge, e->halfedge->twin}) {
    HalfedgeRef b = a->next;
    HalfedgeRef d = a->twin;
    HalfedgeRef g = d->next;
    FaceRef f0 = a->face;
    VertexRef v0 = a->vertex;
    VertexRef v1 = d->vertex;
    VertexRef v2 = b->next->vertex;
    FaceRef f1 = d->face;
    VertexRef v3 = g->next->vertex;
    HalfedgeRef P_first = b->next;
    HalfedgeRef P_last = hedgerow::prev(a);
    HalfedgeRef Q_first = g->next;
    HalfedgeRef Q_last = hedgerow::prev(d);
    if (f0->boundary) continue;  // `f0` is a hole
    if (f1->boundary) continue;  // `f1` is a hole
    if (v0 == v1) continue;  // `v0` and `v1` are one vertex
    if (v0 == v2) continue;  // `v0` and `v2` are one vertex
    if (v0 == v3) continue;  // `v0` and `v3` are one vertex
    if (v1 == v2) continue;  // `v1` and `v2` are one vertex
    if (v1 == v3) continue;  // `v1` and `v3` are one vertex
    if (f0 == f1) continue;  // `f0` and `f1` are one face

    // The guard looks at what there would be, on a preview of the mesh.
    {
      hedgerow::Preview preview;
      preview.set_next(a, P_first);
      preview.set_vertex(a, v3);
      preview.set_next(b, d);
      preview.set_face(b, f1);
      preview.set_next(P_last, g);
      preview.set_next(d, Q_first);
      preview.set_vertex(d, v2);
      preview.set_next(g, a);
      preview.set_face(g, f0);
      preview.set_next(Q_last, b);
      preview.set_vertex_halfedge(v0, g);
      preview.set_vertex_halfedge(v1, b);
      preview.set_face_halfedge(f0, a);
      preview.set_face_halfedge(f1, d);
      if (!preview.two_spokes(v0)) continue;  // `v0` would keep a single edge
      if (!preview.two_spokes(v1)) continue;  // `v1` would keep a single edge
      if (!preview.corner_once(f0, v3)) continue;  // `f0` would meet `v3` twice
      if (!preview.corner_once(f1, v2)) continue;  // `f1` would meet `v2` twice
      if (!preview.single_edge(a)) continue;  // two edges would join `v2` and `v3`
      // Refused: another face has the corners that `f0` would have.
      if (!preview.corners_own(f0, v3)) continue;
      // Refused: another face has the corners that `f1` would have.
      if (!preview.corners_own(f1, v2)) continue;
      if (!preview.meets_once(f0)) continue;  // `f0` would meet a vertex twice
      if (!preview.meets_once(f1)) continue;  // `f1` would meet a vertex twice
      // Refused: another face has the corners that `f0` would have.
      if (!preview.corners_own(f0, v2)) continue;
    }

    // 3. Reassign every pointer that changes.
    a->next = P_first;
    a->vertex = v3;
    b->next = d;
    b->face = f1;
    P_last->next = g;
    d->next = Q_first;
    d->vertex = v2;
    g->next = a;
    g->face = f0;
    Q_last->next = b;
    v0->halfedge = g;
    v1->halfedge = b;
    f0->halfedge = a;
    f1->halfedge = d;
    return true;
  }
  return false;
}
