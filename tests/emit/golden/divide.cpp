// Elements have these attributes:
//   vertex: double weight, by default 0

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <variant>
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

#ifndef HEDGEROW_vertices
#define HEDGEROW_vertices
/// The corners of f.
inline std::vector<Mesh::VertexRef> vertices(Mesh::FaceRef f) {
  std::vector<Mesh::VertexRef> all;
  for (Mesh::HalfedgeRef h : hedgerow::halfedges(f)) all.push_back(h->vertex);
  return all;
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

#ifndef HEDGEROW_same_elements
#define HEDGEROW_same_elements
/// Whether a and b have the same elements, in any order.
template <class T>
bool same_elements(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::is_permutation(a.begin(), a.end(), b.begin());
}
#endif

#ifndef HEDGEROW_is_finite
#define HEDGEROW_is_finite
inline bool is_finite(Vec3 a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
#endif

#ifndef HEDGEROW_floor_div
#define HEDGEROW_floor_div
/// a / b, rounded down.
inline long long floor_div(long long a, long long b) {
  if (b == 0) throw std::domain_error("division by zero");
  if (b == -1 && a == std::numeric_limits<long long>::min()) {
    throw std::overflow_error("the quotient does not fit");
  }
  return a / b - (a % b != 0 && (a < 0) != (b < 0));
}
#endif

#ifndef HEDGEROW_floor_mod
#define HEDGEROW_floor_mod
/// The remainder of a / b, with the sign of b.
inline long long floor_mod(long long a, long long b) {
  if (b == 0) throw std::domain_error("division by zero");
  if (b == -1) return 0;
  const long long rest = a % b;
  return rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest;
}
#endif

#ifndef HEDGEROW_Refused
#define HEDGEROW_Refused
/// Thrown by a step that must be done and refuses.
struct Refused {};
#endif

#ifndef HEDGEROW_must
#define HEDGEROW_must
/// The result of a step that must be done.
template <class T>
T must(const std::optional<T>& done) {
  if (!done) throw hedgerow::Refused();
  return *done;
}
inline void must(bool done) {
  if (!done) throw hedgerow::Refused();
}
#endif

#ifndef HEDGEROW_Journal
#define HEDGEROW_Journal
/// The level of a mesh, as in the language reference.
enum class Level { map, surface, simple };

/// A mesh, and a record of what steps have done to it, so that it can be undone. Elements that
/// they erase are noted as gone, and removed from the mesh when all steps are done.
class Journal {
 public:
  explicit Journal(Mesh& mesh) : mesh_(mesh) {}
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Runs the steps; undoes them if one refuses, or the mesh does not have the level in the end.
  template <class Steps>
  auto whole(Level level, Steps steps) -> decltype(steps()) {
    const std::size_t begin = undo_.size();
    const std::size_t outer = written_.size();
    const auto tested = tested_;
    ++depth_;
    decltype(steps()) done{};
    try {
      done = steps();
      if (done && !has(level, outer)) done = {};
    } catch (const Refused&) {
    } catch (...) {
      undo_since(begin);
      throw;
    }
    --depth_;
    if (!done) {
      undo_since(begin);
      written_.erase(written_.begin() + static_cast<std::ptrdiff_t>(outer), written_.end());
      tested_ = tested;
    } else if (depth_ == 0) {
      erase_gone();
    }
    return done;
  }

  /// To be called before a step that requires a level, if steps before it may have lowered that.
  void expect(Level level) {
    std::size_t& tested = tested_[static_cast<std::size_t>(level)];
    if (!has(level, tested)) throw std::logic_error("the mesh is below the level of a step");
    tested = written_.size();
  }

  /// To be called before elements are written to.
  template <class... T>
  void keep(T... elements) {
    (note(elements), ...);
  }
  /// Records how the next change is undone.
  template <class Back>
  void undone_by(Back back) {
    undo_.push_back(back);
  }
  void set_position(Mesh::VertexRef v, Vec3 position) {
    if (!hedgerow::is_finite(position)) throw hedgerow::Refused();
    keep(v);
    v->position = position;
  }

  Mesh::VertexRef new_vertex() { return made(mesh_.new_vertex()); }
  Mesh::HalfedgeRef new_halfedge() { return made(mesh_.new_halfedge()); }
  Mesh::EdgeRef new_edge() { return made(mesh_.new_edge()); }
  Mesh::FaceRef new_face() { return made(mesh_.new_face()); }
  template <class T>
  void erase(T x) {
    std::get<std::vector<T>>(gone_).push_back(x);
    undone_by([this] { std::get<std::vector<T>>(gone_).pop_back(); });
  }
  /// Whether no step has erased x.
  template <class T>
  bool lives(T x) const {
    return !hedgerow::holds(std::get<std::vector<T>>(gone_), x);
  }

 private:
  using Elements = std::tuple<std::vector<Mesh::VertexRef>, std::vector<Mesh::HalfedgeRef>, std::vector<Mesh::EdgeRef>,
                              std::vector<Mesh::FaceRef>>;

  void note(Mesh::VertexRef v) {
    written_.push_back(v);
    auto halfedge = v->halfedge;
    auto position = v->position;
    undone_by([v, halfedge, position] {
      v->halfedge = halfedge;
      v->position = position;
    });
  }
  void note(Mesh::HalfedgeRef h) {
    written_.push_back(h);
    auto next = h->next;
    auto twin = h->twin;
    auto vertex = h->vertex;
    auto edge = h->edge;
    auto face = h->face;
    undone_by([h, next, twin, vertex, edge, face] {
      h->next = next;
      h->twin = twin;
      h->vertex = vertex;
      h->edge = edge;
      h->face = face;
    });
  }
  void note(Mesh::EdgeRef e) {
    written_.push_back(e);
    auto halfedge = e->halfedge;
    undone_by([e, halfedge] { e->halfedge = halfedge; });
  }
  void note(Mesh::FaceRef f) {
    written_.push_back(f);
    auto halfedge = f->halfedge;
    bool boundary = f->boundary;
    undone_by([f, halfedge, boundary] {
      f->halfedge = halfedge;
      f->boundary = boundary;
    });
  }

  template <class T>
  T made(T x) {
    written_.push_back(x);
    undone_by([this, x] { discard(x); });
    return x;
  }
  void discard(Mesh::VertexRef v) { mesh_.erase(v); }
  void discard(Mesh::HalfedgeRef h) { mesh_.erase(h); }
  void discard(Mesh::EdgeRef e) { mesh_.erase(e); }
  void discard(Mesh::FaceRef f) { mesh_.erase(f); }

  void undo_since(std::size_t begin) {
    while (undo_.size() > begin) {
      undo_.back()();
      undo_.pop_back();
    }
  }
  void erase_gone() {
    for (Mesh::EdgeRef e : std::get<std::vector<Mesh::EdgeRef>>(gone_)) discard(e);
    for (Mesh::HalfedgeRef h : std::get<std::vector<Mesh::HalfedgeRef>>(gone_)) discard(h);
    for (Mesh::VertexRef v : std::get<std::vector<Mesh::VertexRef>>(gone_)) discard(v);
    for (Mesh::FaceRef f : std::get<std::vector<Mesh::FaceRef>>(gone_)) discard(f);
    undo_.clear();
    gone_ = Elements();
    written_.clear();
    tested_ = {};
  }

  /// The elements that no step has erased; most of those that occur several times occur close
  /// together, and are taken once.
  template <class T>
  std::vector<T> living(const std::vector<T>& all) const {
    std::vector<T> found;
    for (T x : all) {
      auto count = static_cast<std::ptrdiff_t>(found.size());
      auto close = found.end() - (count < 16 ? count : 16);
      if (lives(x) && std::find(close, found.end(), x) == found.end()) found.push_back(x);
    }
    return found;
  }
  /// Whether the mesh still has a level that it had; only the elements near those that were written
  /// since then are tested.
  bool has(Level level, std::size_t since) const {
    if (level == Level::map) return true;
    Elements written;
    for (std::size_t at = since; at < written_.size(); ++at) {
      std::visit([&](auto x) { std::get<std::vector<decltype(x)>>(written).push_back(x); },
                 written_[at]);
    }
    auto& [vs, hs, es, fs] = written;
    // A face that becomes a hole affects all elements at it.
    for (Mesh::FaceRef f : living(fs)) {
      for (Mesh::HalfedgeRef h : hedgerow::halfedges(f)) hs.push_back(h);
    }
    for (Mesh::HalfedgeRef h : living(hs)) {
      vs.push_back(h->vertex);
      vs.push_back(h->twin->vertex);
      es.push_back(h->edge);
      fs.push_back(h->face);
      fs.push_back(h->twin->face);
    }
    for (Mesh::FaceRef f : living(fs)) {
      std::vector<Mesh::VertexRef> corners = hedgerow::vertices(f);
      if (!hedgerow::all_differ(corners)) return false;
      if (corners.size() < 3) return false;
    }
    for (Mesh::VertexRef v : living(vs)) {
      int count = 0;
      int holes = 0;
      for (Mesh::HalfedgeRef h : hedgerow::spokes(v)) {
        ++count;
        if (h->face->boundary) ++holes;
      }
      if (count < 2 || holes > 1) return false;
    }
    for (Mesh::EdgeRef e : living(es)) {
      if (e->halfedge->face->boundary && e->halfedge->twin->face->boundary) return false;
    }
    if (level == Level::surface) return true;
    for (Mesh::VertexRef v : living(vs)) {
      std::vector<Mesh::VertexRef> around = hedgerow::neighbors(v);
      if (hedgerow::holds(around, v) || !hedgerow::all_differ(around)) return false;
    }
    for (Mesh::FaceRef f : living(fs)) {
      if (f->boundary) continue;
      std::vector<Mesh::VertexRef> corners = hedgerow::vertices(f);
      for (Mesh::HalfedgeRef h : hedgerow::spokes(corners.front())) {
        if (h->face == f || h->face->boundary) continue;
        if (hedgerow::same_elements(corners, hedgerow::vertices(h->face))) return false;
      }
    }
    return true;
  }

  Mesh& mesh_;
  Elements gone_;
  std::vector<std::variant<Mesh::VertexRef, Mesh::HalfedgeRef, Mesh::EdgeRef, Mesh::FaceRef>> written_;
  /// For each level, how many of the writes are known to have kept it.
  std::array<std::size_t, 3> tested_{};
  std::vector<std::function<void()>> undo_;
  int depth_ = 0;
};
#endif

#ifndef HEDGEROW_p5a7752d3
#define HEDGEROW_p5a7752d3
namespace p5a7752d3 {

/// How often 2 divides a number.
inline long long twos(long long n) {
  long long rest = n;
  long long count = 0;
  while (hedgerow::floor_mod(rest, 2) == 0) {
    if (rest == 0) break;
    rest = hedgerow::floor_div(rest, 2);
    count = count + 1;
  }
  return count;
}

/// Cuts an edge in two at its midpoint; returns the new vertex.
///
/// ```text
///      .---P---.               .---P---.
///      |  f0   |               |  f0   |
///      |       |               |       |
///      v0--e--v1     ->        v0--m--v1
///      |       |               |       |
///      |  f1   |               |  f1   |
///      '---Q---'               '---Q---'
/// ```
///
/// The loops at the edge, faces or holes, gain a side. Each of the two halfedges is followed by a
/// new one, and its twin is now the new one on the other side. Never refused.
inline std::optional<Mesh::VertexRef> bisect(Journal& journal, Mesh::EdgeRef e) {
  using VertexRef = Mesh::VertexRef;
  using HalfedgeRef = Mesh::HalfedgeRef;
  using EdgeRef = Mesh::EdgeRef;
  using FaceRef = Mesh::FaceRef;

  // 1. Collect: nothing is written before all of this has passed.
  HalfedgeRef a = e->halfedge;
  HalfedgeRef d = a->twin;
  FaceRef f0 = a->face;
  VertexRef v0 = a->vertex;
  VertexRef v1 = d->vertex;
  FaceRef f1 = d->face;
  HalfedgeRef P_first = a->next;
  HalfedgeRef Q_first = d->next;
  if (v0 == v1) return std::nullopt;  // `v0` and `v1` are one vertex
  if (f0 == f1) return std::nullopt;  // `f0` and `f1` are one face
  Vec3 m_position = (v0->position + v1->position) / 2.0;

  // 2. Allocate what is new.
  VertexRef m = journal.new_vertex();
  HalfedgeRef p = journal.new_halfedge();
  HalfedgeRef q = journal.new_halfedge();
  EdgeRef e1 = journal.new_edge();

  // 3. Reassign every pointer that changes.
  journal.keep(a, d, e);
  a->next = p;
  a->twin = q;
  d->next = q;
  d->twin = p;
  d->edge = e1;
  p->next = P_first;
  p->twin = d;
  p->vertex = m;
  p->edge = e1;
  p->face = f0;
  q->next = Q_first;
  q->twin = a;
  q->vertex = m;
  q->edge = e;
  q->face = f1;
  m->halfedge = p;
  e->halfedge = a;
  e1->halfedge = p;
  m->position = m_position;
  return m;
}
}
#endif

}
}  // namespace hedgerow

/// Bisects an edge several times, always beside the last new vertex.
///
/// All or nothing: if a step refuses, what was done is undone.
std::optional<Mesh::VertexRef> divide(Mesh& mesh, Mesh::EdgeRef e, long long n) {
  using VertexRef = Mesh::VertexRef;

  if (12 <= n) return std::nullopt;  // that is too often
  hedgerow::Journal journal(mesh);
  return journal.whole(hedgerow::Level::surface, [&]() -> std::optional<VertexRef> {
    VertexRef m = hedgerow::must(hedgerow::p5a7752d3::bisect(journal, e));
    for (long long i = hedgerow::p5a7752d3::twos(n) + 1; i > 0; --i) {
      journal.undone_by([m, was = m->weight] { m->weight = was; });
      m->weight = m->weight + 1.0;
      m = hedgerow::must(hedgerow::p5a7752d3::bisect(journal, m->halfedge->edge));
    }
    long long i = 0;
    for (long long i_2 = n - 1; i_2 > 0; --i_2) {
      i = i + 1;
      if (i != 2) {
        journal.undone_by([m, was = m->weight] { m->weight = was; });
        m->weight = m->weight + static_cast<double>(i);
      }
    }
    return m;
  });
}
