// Cases of a table, read from standard input: a mesh, an element, and what has to come of an
// operation there. Each is tried with elements that name other halfedges, too.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <set>

#include "halfedge.h"

using Mesh = Halfedge_Mesh;
using Place = std::vector<long>;
using Cycle = std::vector<Place>;

struct Polygons {
  std::vector<Vec3> corners;
  std::vector<std::vector<int>> faces;
};
struct Case {
  std::string name, op, expect;
  Polygons before, after;
  std::vector<std::vector<int>> elements;
  size_t edges = 0;
};

static Polygons polygons() {
  Polygons all;
  size_t corners, faces, size;
  std::cin >> corners >> faces;
  all.corners.resize(corners);
  for (auto& p : all.corners) std::cin >> p.x >> p.y >> p.z;
  all.faces.resize(faces);
  for (auto& face : all.faces) {
    std::cin >> size;
    face.resize(size);
    for (auto& corner : face) std::cin >> corner;
  }
  return all;
}

static Place place(Vec3 v) {
  auto rounded = [](float x) { return std::lround(x * 10000.0f); };
  return {rounded(v.x), rounded(v.y), rounded(v.z)};
}

// The least of all turns: corners may lie in one place.
static Cycle canonical(Cycle cycle) {
  Cycle least = cycle;
  for (size_t turn = 0; turn < cycle.size(); ++turn) {
    std::rotate(cycle.begin(), cycle.begin() + 1, cycle.end());
    least = std::min(least, cycle);
  }
  return least;
}

struct Shape {
  std::multiset<Place> corners;
  std::multiset<Cycle> faces;
  bool operator==(const Shape& other) const {
    return corners == other.corners && faces == other.faces;
  }
};
static Shape shape(const Polygons& all) {
  Shape shape;
  for (auto p : all.corners) shape.corners.insert(place(p));
  for (auto& face : all.faces) {
    Cycle cycle;
    for (int corner : face) cycle.push_back(place(all.corners[corner]));
    shape.faces.insert(canonical(cycle));
  }
  return shape;
}
static Shape shape(Mesh& mesh) {
  Shape shape;
  for (auto& v : mesh.vertices) shape.corners.insert(place(v.position));
  for (auto f = mesh.faces.begin(); f != mesh.faces.end(); ++f) {
    Cycle cycle;
    auto h = f->halfedge;
    do {
      cycle.push_back(place(h->vertex->position));
      h = h->next;
    } while (h != f->halfedge);
    if (!f->boundary) shape.faces.insert(canonical(cycle));
  }
  return shape;
}

// Lets each element name the halfedge that many further.
static void turn(Mesh& mesh, int by) {
  for (int i = 0; i < by; ++i) {
    for (auto& v : mesh.vertices) v.halfedge = v.halfedge->twin->next;
    for (auto& e : mesh.edges) e.halfedge = e.halfedge->twin;
    for (auto& f : mesh.faces) f.halfedge = f.halfedge->next;
  }
}

static Mesh::HalfedgeRef between(Mesh& mesh, int from, int to) {
  auto a = std::next(mesh.vertices.begin(), from), b = std::next(mesh.vertices.begin(), to);
  for (auto h = mesh.halfedges.begin(); h != mesh.halfedges.end(); ++h) {
    if (h->vertex == a && h->twin->vertex == b) return h;
  }
  std::abort();
}

// Whether it was done.
static bool apply(Mesh& mesh, const Case& c) {
  auto& at = c.elements[0];
  auto vertex = [&] { return std::next(mesh.vertices.begin(), at[0]); };
  auto edge = [&](size_t number) {
    return between(mesh, c.elements[number][0], c.elements[number][1])->edge;
  };
  auto face = [&] { return between(mesh, at[0], at[1])->face; };
  if (c.op == "flip_edge") {
    auto e = edge(0);
    auto done = mesh.flip_edge(e);
    if (done && *done != e) std::abort();
    return done.has_value();
  }
  if (c.op == "split_edge") {
    auto ends = c.elements[0];
    auto a = std::next(mesh.vertices.begin(), ends[0]), b = std::next(mesh.vertices.begin(), ends[1]);
    auto m = mesh.split_edge(edge(0));
    if (!m) return false;
    auto far = (*m)->halfedge->twin->vertex;
    if (far != a && far != b) std::abort();
    return true;
  }
  if (c.op == "collapse_edge") return mesh.collapse_edge(edge(0)).has_value();
  if (c.op == "dissolve_edge") return mesh.dissolve_edge(edge(0)).has_value();
  if (c.op == "bevel_edge") return mesh.bevel_edge(edge(0)).has_value();
  if (c.op == "weld_edges") return mesh.weld_edges(edge(0), edge(1)).has_value();
  if (c.op == "dissolve_vertex") return mesh.dissolve_vertex(vertex()).has_value();
  if (c.op == "bevel_vertex") return mesh.bevel_vertex(vertex()).has_value();
  if (c.op == "extrude_face") return mesh.extrude_face(face()).has_value();
  if (c.op == "inset_vertex") return mesh.inset_vertex(face()).has_value();
  if (c.op == "collapse_face") return mesh.collapse_face(face()).has_value();
  if (c.op == "make_boundary") {
    auto f = face();
    auto done = mesh.make_boundary(f);
    if (done && (*done != f || !f->boundary)) std::abort();
    return done.has_value();
  }
  std::abort();
}

int main() {
  Case c;
  size_t elements, numbers, failed = 0;
  std::map<std::string, std::pair<size_t, size_t>> counts;
  while (std::cin >> c.name >> c.op >> elements) {
    c.elements.resize(elements);
    for (auto& element : c.elements) {
      std::cin >> numbers;
      element.resize(numbers);
      for (auto& number : element) std::cin >> number;
    }
    c.before = polygons();
    std::cin >> c.expect;
    bool refuse = c.expect == "refuse";
    if (!refuse) {
      std::cin >> c.edges;
      c.after = polygons();
    }
    for (int by = 0; by < 3; ++by) {
      Mesh mesh = made(c.before.corners, c.before.faces);
      turn(mesh, by);
      std::string wrong;
      bool done = apply(mesh, c);
      if (auto fault = mesh.fault()) wrong = "broken: " + *fault;
      else if (done == refuse) wrong = done ? "is not refused" : "is refused";
      else if (!(shape(mesh) == shape(refuse ? c.before : c.after))) wrong = "has another shape";
      else if (done && mesh.edges.size() != c.edges) wrong = "has another number of edges";
      if (wrong.empty()) continue;
      ++failed;
      std::printf("%s: %s\n", c.name.c_str(), wrong.c_str());
    }
    auto& count = counts[c.op];
    ++(refuse ? count.second : count.first);
  }
  for (auto& [op, count] : counts)
    std::printf("%s %zu %zu\n", op.c_str(), count.first, count.second);
  return failed > 0;
}
