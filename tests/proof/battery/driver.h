// Reads meshes, each with a call, carries the call out, and prints what has become of the mesh.
// Numbers are those of the tables that were read; what is new counts on.
#pragma once
#include <cstdio>
#include <cstdlib>
#include <vector>

struct Built {
  Mesh mesh;
  std::vector<Mesh::VertexRef> v;
  std::vector<Mesh::HalfedgeRef> h;
  std::vector<Mesh::EdgeRef> e;
  std::vector<Mesh::FaceRef> f;
};

inline int number() {
  int n;
  if (std::scanf("%d", &n) != 1) std::exit(3);
  return n;
}

inline void build(Built& b, int vertices) {
  int halfedges = number(), edges = number(), faces = number();
  for (int i = 0; i < vertices; ++i) b.v.push_back(b.mesh.new_vertex());
  for (int i = 0; i < halfedges; ++i) b.h.push_back(b.mesh.new_halfedge());
  for (int i = 0; i < edges; ++i) b.e.push_back(b.mesh.new_edge());
  for (int i = 0; i < faces; ++i) b.f.push_back(b.mesh.new_face());
  for (auto h : b.h) {
    h->next = b.h[number()];
    h->twin = b.h[number()];
    h->vertex = b.v[number()];
    h->edge = b.e[number()];
    h->face = b.f[number()];
  }
  for (auto v : b.v) v->halfedge = b.h[number()];
  for (auto e : b.e) e->halfedge = b.h[number()];
  for (auto f : b.f) {
    f->halfedge = b.h[number()];
    f->boundary = number() != 0;
  }
}

template <class L>
int count(L& list) {
  int n = 0;
  for (auto& x : list) x.number = n++;
  return n;
}

inline void print(Mesh& mesh) {
  int v = count(mesh.vertices), h = count(mesh.halfedges);
  int e = count(mesh.edges), f = count(mesh.faces);
  std::printf("applied %d %d %d %d\n", v, h, e, f);
  for (auto& x : mesh.halfedges) {
    std::printf("%d %d %d %d %d\n", x.next->number, x.twin->number, x.vertex->number,
                x.edge->number, x.face->number);
  }
  for (auto& x : mesh.vertices) std::printf("%d ", x.halfedge->number);
  for (auto& x : mesh.edges) std::printf("%d ", x.halfedge->number);
  for (auto& x : mesh.faces) std::printf("%d %d ", x.halfedge->number, int(x.boundary));
  std::printf("\n");
}

bool call(int op, Built& built);

int main() {
  int vertices;
  while (std::scanf("%d", &vertices) == 1) {
    Built built;
    build(built, vertices);
    if (call(number(), built)) print(built.mesh);
    else std::printf("refused\n");
    std::fflush(stdout);
  }
}
