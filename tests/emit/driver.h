// Reads meshes and calls, carries each call out on a fresh copy of the mesh, and prints what
// has become of it. Numbers are those of the tables that were read; what is new counts on.
#pragma once
#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#if ACCESSORS
#define HALFEDGE half_edge
#else
#define HALFEDGE halfedge
#endif

struct Table {
  int vertices, halfedges, edges, faces;
  std::vector<std::vector<int>> half;  // next twin vertex edge face
  std::vector<int> vertex, edge, face, hole;
  std::vector<Vector> position, tint;
  std::vector<double> mark, weight, fresh, group;
  std::vector<std::array<double, 16>> quadric, uv, plane, frame;
};

using VRef = decltype(Mesh().new_vertex());
using HRef = decltype(Mesh().new_halfedge());
using ERef = decltype(Mesh().new_edge());
using FRef = decltype(Mesh().new_face());

struct Built {
  Mesh mesh;
  std::vector<VRef> v;
  std::vector<HRef> h;
  std::vector<ERef> e;
  std::vector<FRef> f;
};

inline int number() {
  int n;
  if (std::scanf("%d", &n) != 1) std::exit(3);
  return n;
}

inline double real() {
  double x;
  if (std::scanf("%lf", &x) != 1) std::exit(3);
  return x;
}

// So many reals, in the first places.
inline std::array<double, 16> reals(int count) {
  std::array<double, 16> all{};
  for (int i = 0; i < count; ++i) all[i] = real();
  return all;
}

inline Table read_table() {
  Table t;
  t.vertices = number();
  t.halfedges = number();
  t.edges = number();
  t.faces = number();
  for (int i = 0; i < t.halfedges; ++i) {
    t.half.push_back({});
    for (int k = 0; k < 5; ++k) t.half.back().push_back(number());
    t.mark.push_back(real());
    t.uv.push_back(reals(2));
  }
  for (int i = 0; i < t.vertices; ++i) {
    t.vertex.push_back(number());
    double x = real(), y = real(), z = real();
    t.position.push_back(Vector(x, y, z));
    t.weight.push_back(real());
    x = real(), y = real(), z = real();
    t.tint.push_back(Vector(x, y, z));
    t.quadric.push_back(reals(16));
  }
  for (int i = 0; i < t.edges; ++i) {
    t.edge.push_back(number());
    t.fresh.push_back(real());
  }
  for (int i = 0; i < t.faces; ++i) {
    t.face.push_back(number());
    t.hole.push_back(number());
    t.group.push_back(real());
    t.plane.push_back(reals(4));
    t.frame.push_back(reals(9));
  }
  return t;
}

inline void build(const Table& t, Built& b) {
  for (int i = 0; i < t.vertices; ++i) b.v.push_back(b.mesh.new_vertex());
  for (int i = 0; i < t.halfedges; ++i) b.h.push_back(b.mesh.new_halfedge());
  for (int i = 0; i < t.edges; ++i) b.e.push_back(b.mesh.new_edge());
  for (int i = 0; i < t.faces; ++i) b.f.push_back(b.mesh.new_face());
  for (int i = 0; i < t.halfedges; ++i) {
    SET(b.h[i], next, b.h[t.half[i][0]]);
#if ACCESSORS
    SET(b.h[t.half[i][0]], prev, b.h[i]);
#endif
    SET(b.h[i], twin, b.h[t.half[i][1]]);
    SET(b.h[i], vertex, b.v[t.half[i][2]]);
    SET(b.h[i], edge, b.e[t.half[i][3]]);
    SET(b.h[i], face, b.f[t.half[i][4]]);
    b.h[i]->mark = t.mark[i];
    for (int k = 0; k < 2; ++k) b.h[i]->uv[k] = t.uv[i][k];
  }
  for (int i = 0; i < t.vertices; ++i) {
    SET(b.v[i], HALFEDGE, b.h[t.vertex[i]]);
    POSITION(b.v[i]) = t.position[i];
    b.v[i]->weight = t.weight[i];
    b.v[i]->tint = t.tint[i];
    for (int k = 0; k < 16; ++k) b.v[i]->quadric[k / 4][k % 4] = t.quadric[i][k];
  }
  for (int i = 0; i < t.edges; ++i) {
    SET(b.e[i], HALFEDGE, b.h[t.edge[i]]);
    b.e[i]->fresh = t.fresh[i] != 0;
  }
  for (int i = 0; i < t.faces; ++i) {
    SET(b.f[i], HALFEDGE, b.h[t.face[i]]);
    BOUNDARY(b.f[i]) = t.hole[i];
    b.f[i]->class_ = static_cast<long long>(t.group[i]);
    for (int k = 0; k < 4; ++k) b.f[i]->plane[k] = t.plane[i][k];
    for (int k = 0; k < 9; ++k) b.f[i]->frame[k / 3][k % 3] = t.frame[i][k];
  }
}

#if ACCESSORS
template <class L>
bool lives(const Mesh& mesh, L x) { return !mesh.gone.count(x); }
#define EACH(x, list) for (auto& x##_ : mesh.list) if (auto x = &x##_; lives(mesh, x))
#else
#define EACH(x, list) for (auto x = mesh.list.begin(); x != mesh.list.end(); ++x)
#endif

struct Counts {
  int v = 0, h = 0, e = 0, f = 0;
};

inline Counts numbered(Mesh& mesh) {
  Counts n;
  EACH(v, vertices) v->number = n.v++;
  EACH(h, halfedges) h->number = n.h++;
  EACH(e, edges) e->number = n.e++;
  EACH(f, faces) f->number = n.f++;
  return n;
}

template <class T>
void print(const T& parts, int count) {
  for (int k = 0; k < count; ++k) std::printf(" %.17g", double(parts[k]));
}

// Whether halfedges that know the one before them know it well.
#if ACCESSORS
inline bool is_linked(Mesh& mesh) {
  EACH(h, halfedges) if (GET(GET(h, next), prev) != h) return false;
  return true;
}
#else
inline bool is_linked(Mesh&) { return true; }
#endif

inline void print(Mesh& mesh) {
  Counts n = numbered(mesh);
  if (!is_linked(mesh)) std::exit(4);
  std::printf("%d %d %d %d\n", n.v, n.h, n.e, n.f);
  EACH(h, halfedges) {
    std::printf("%d %d %d %d %d %.17g", GET(h, next)->number, GET(h, twin)->number,
                GET(h, vertex)->number, GET(h, edge)->number, GET(h, face)->number,
                double(h->mark));
    print(h->uv, 2);
    std::printf("\n");
  }
  EACH(v, vertices) {
    Vector p = POSITION(v);
    std::printf("%d %.17g %.17g %.17g", GET(v, HALFEDGE)->number, double(p.x), double(p.y), double(p.z));
    Vector q = v->tint;
    std::printf(" %.17g %.17g %.17g %.17g", double(v->weight), double(q.x), double(q.y), double(q.z));
    for (int k = 0; k < 4; ++k) print(v->quadric[k], 4);
    std::printf("\n");
  }
  EACH(e, edges) std::printf("%d %d\n", GET(e, HALFEDGE)->number, int(e->fresh));
  EACH(f, faces) {
    std::printf("%d %d %lld", GET(f, HALFEDGE)->number, int(BOUNDARY(f)), f->class_);
    print(f->plane, 4);
    for (int k = 0; k < 3; ++k) print(f->frame[k], 3);
    std::printf("\n");
  }
}

// Whether the mesh is as it was built.
inline bool unchanged(const Table& t, Mesh& mesh) {
  Counts n = numbered(mesh);
  bool same = is_linked(mesh) && n.v == t.vertices && n.h == t.halfedges && n.e == t.edges && n.f == t.faces;
  if (!same) return false;
  auto alike = [](Vector a, Vector b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
  int at = 0;
  EACH(h, halfedges) {
    std::vector<int> now = {GET(h, next)->number, GET(h, twin)->number, GET(h, vertex)->number,
                            GET(h, edge)->number, GET(h, face)->number};
    same = same && now == t.half[at] && double(h->mark) == t.mark[at];
    ++at;
  }
  at = 0;
  EACH(v, vertices) {
    same = same && GET(v, HALFEDGE)->number == t.vertex[at] && alike(POSITION(v), t.position[at]) &&
           double(v->weight) == t.weight[at] && alike(v->tint, t.tint[at]);
    ++at;
  }
  at = 0;
  EACH(e, edges) {
    same = same && GET(e, HALFEDGE)->number == t.edge[at] && e->fresh == (t.fresh[at] != 0);
    ++at;
  }
  at = 0;
  EACH(f, faces) {
    same = same && GET(f, HALFEDGE)->number == t.face[at] && BOUNDARY(f) == (t.hole[at] != 0) &&
           f->class_ == static_cast<long long>(t.group[at]);
    ++at;
  }
  return same;
}

// What an operation without a result, and one with a result, have done.
inline bool applied(Mesh&, bool done) {
  if (done) std::printf("applied -1\n");
  return done;
}
template <class T>
bool applied(Mesh& mesh, const std::optional<T>& result) {
  if (!result) return false;
  numbered(mesh);
  std::printf("applied %d\n", (*result)->number);
  return true;
}

bool call(int op, Built& built);

int main() {
  Table table;
  char word[16];
  while (std::scanf("%15s", word) == 1) {
    if (std::string(word) == "mesh") {
      table = read_table();
    } else {
      Built built;
      build(table, built);
      const char* done = "refused\n";
      try {
        if (call(number(), built)) done = nullptr;
      } catch (const std::logic_error&) {
        done = "stopped\n";
      }
      if (!done) print(built.mesh);
      else std::printf(unchanged(table, built.mesh) ? done : "changed\n");
    }
  }
}
