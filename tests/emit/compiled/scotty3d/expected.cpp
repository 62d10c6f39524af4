// What the course expects of its local operations, on meshes of our own.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <set>

#include "halfedge.h"

using Mesh = Halfedge_Mesh;
using Faces = std::vector<std::vector<int>>;

static int checks = 0;

static void expect(bool holds, const char* op, const std::string& what) {
  ++checks;
  if (holds) return;
  std::printf("%s: %s\n", op, what.c_str());
  std::exit(1);
}

using Place = std::vector<long>;
static Place place(Vec3 v) {
  auto rounded = [](float x) { return std::lround(x * 1000.0f); };
  return {rounded(v.x), rounded(v.y), rounded(v.z)};
}

// The faces by the places of their corners, each from the least on: a mesh up to its order.
static std::multiset<std::vector<Place>> shape(Mesh& mesh) {
  std::multiset<std::vector<Place>> all;
  for (auto f = mesh.faces.begin(); f != mesh.faces.end(); ++f) {
    std::vector<Place> corners;
    auto h = f->halfedge;
    do {
      corners.push_back(place(h->vertex->position));
      h = h->next;
    } while (h != f->halfedge);
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    corners.push_back({f->boundary});
    all.insert(corners);
  }
  return all;
}

static void valid(Mesh& mesh, const char* op) {
  auto fault = mesh.fault();
  expect(!fault, op, "the mesh is broken: " + fault.value_or(""));
}
static void becomes(Mesh& mesh, const char* op, Mesh after) {
  valid(mesh, op);
  expect(shape(mesh) == shape(after), op, "the mesh has another shape");
  expect(mesh.edges.size() == after.edges.size(), op, "another number of edges");
}

// A quad 0 3 4 1 with a triangle 1 4 2 at its right side.
static const std::vector<Vec3> house = {Vec3(-1, 1.5f, 0), Vec3(1, 1, 0), Vec3(2, 0.25f, 0),
                                        Vec3(-1.5f, -1, 0), Vec3(1.5f, -1, 0)};
static Mesh a_house() { return made(house, {{0, 3, 4, 1}, {1, 4, 2}}); }

// The edge between two corners.
static Mesh::EdgeRef edge(Mesh& mesh, Vec3 a, Vec3 b) {
  for (auto e = mesh.edges.begin(); e != mesh.edges.end(); ++e) {
    Vec3 p = e->halfedge->vertex->position, q = e->halfedge->twin->vertex->position;
    if ((p == a && q == b) || (p == b && q == a)) return e;
  }
  std::abort();
}
static Mesh::FaceRef face(Mesh& mesh, int at) { return std::next(mesh.faces.begin(), at); }
static Mesh::VertexRef vertex(Mesh& mesh, int at) { return std::next(mesh.vertices.begin(), at); }
static Mesh::FaceRef hole(Mesh& mesh) {
  auto f = mesh.faces.begin();
  while (!f->boundary) ++f;
  return f;
}

template <class Op>
static void refuses(Mesh mesh, const char* op, Op apply) {
  auto before = shape(mesh);
  expect(!apply(mesh), op, "is not refused");
  expect(shape(mesh) == before, op, "is refused, and leaves a trace");
  valid(mesh, op);
}

static void flips() {
  Mesh mesh = a_house();
  auto e = edge(mesh, house[1], house[4]);
  auto done = mesh.flip_edge(e);
  expect(done && *done == e, "flip_edge", "gives back its edge");
  becomes(mesh, "flip_edge", made(house, {{0, 3, 4, 2}, {0, 2, 1}}));
  refuses(a_house(), "flip_edge", [](Mesh& m) { return m.flip_edge(edge(m, house[3], house[4])); });
}

static void splits() {
  Mesh mesh = a_house();
  auto e = edge(mesh, house[1], house[4]);
  auto m = mesh.split_edge(e);
  expect(m.has_value(), "split_edge", "is refused");
  Vec3 far = (*m)->halfedge->twin->vertex->position;
  expect(far == house[1] || far == house[4], "split_edge", "the new vertex looks along the edge");
  auto corners = house;
  corners.push_back((house[1] + house[4]) / 2);
  becomes(mesh, "split_edge", made(corners, {{0, 3, 4, 5}, {0, 5, 1}, {1, 5, 2}, {5, 4, 2}}));

  Mesh other = a_house();
  expect(other.split_edge(edge(other, house[0], house[1])).has_value(), "split_edge", "is refused");
  corners.back() = (house[0] + house[1]) / 2;
  becomes(other, "split_edge", made(corners, {{0, 3, 5}, {5, 3, 4, 1}, {1, 4, 2}}));

  Mesh third = a_house();
  auto b = third.bisect_edge(edge(third, house[0], house[1]));
  expect(b && (*b)->degree() == 2, "bisect_edge", "gives a vertex between two edges");
  becomes(third, "bisect_edge", made(corners, {{0, 3, 4, 1, 5}, {1, 4, 2}}));
}

static void collapses() {
  // Two quads on the left, two triangles on the right.
  std::vector<Vec3> fan = {Vec3(-1, 1, 0), Vec3(1, 1, 0),   Vec3(-1.25f, 0, 0), Vec3(1.25f, 0, 0),
                           Vec3(2, 0, 0),  Vec3(-1, -1, 0), Vec3(1.5f, -1, 0)};
  Faces all = {{0, 2, 3, 1}, {2, 5, 6, 3}, {1, 3, 4}, {3, 6, 4}};
  Mesh mesh = made(fan, all);
  auto v = mesh.collapse_edge(edge(mesh, fan[2], fan[3]));
  expect(v && (*v)->position == (fan[2] + fan[3]) / 2, "collapse_edge", "gives its midpoint");
  auto after = fan;
  after[2] = after[3] = (fan[2] + fan[3]) / 2;
  after.erase(after.begin() + 3);
  becomes(mesh, "collapse_edge", made(after, {{0, 2, 1}, {2, 4, 5}, {1, 2, 3}, {2, 5, 3}}));

  // Triangles at the edge vanish.
  Mesh other = made(fan, all);
  expect(other.collapse_edge(edge(other, fan[3], fan[4])).has_value(), "collapse_edge", "refused");
  after = fan;
  after[3] = (fan[3] + fan[4]) / 2;
  after.erase(after.begin() + 4);
  becomes(other, "collapse_edge", made(after, {{0, 2, 3, 1}, {2, 4, 5, 3}}));

  Faces one = {{0, 1, 2}};
  std::vector<Vec3> corners = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  refuses(made(corners, one), "collapse_edge",
          [](Mesh& m) { return m.collapse_edge(m.edges.begin()); });
}

static void extrudes() {
  Mesh mesh = a_house();
  auto f = face(mesh, 0);
  auto done = mesh.extrude_face(f);
  expect(done && *done == f, "extrude_face", "gives back its face");
  valid(mesh, "extrude_face");
  expect(mesh.vertices.size() == 5 + 4 && mesh.edges.size() == 6 + 8, "extrude_face", "counts");
  // The new corners come last, where the old ones are.
  std::set<Place> old_corners, new_corners;
  for (int i : {0, 3, 4, 1}) old_corners.insert(place(house[i]));
  for (int i = 5; i < 9; ++i) new_corners.insert(place(vertex(mesh, i)->position));
  expect(old_corners == new_corners, "extrude_face", "places");
  // The way back to the old corner over the quads.
  auto h = f->halfedge;
  expect(place(h->twin->next->next->vertex->position) == place(h->vertex->position),
         "extrude_face", "the quad leads back");
  refuses(a_house(), "extrude_face", [](Mesh& m) { return m.extrude_face(hole(m)); });

  Mesh other = a_house();
  auto v = other.inset_vertex(face(other, 1));
  Vec3 center = (house[1] + house[2] + house[4]) / 3;
  expect(v && place((*v)->position) == place(center), "inset_vertex", "gives the centroid");
  auto corners = house;
  corners.push_back(center);
  becomes(other, "inset_vertex", made(corners, {{0, 3, 4, 1}, {1, 4, 5}, {4, 2, 5}, {2, 1, 5}}));
  refuses(a_house(), "inset_vertex", [](Mesh& m) { return m.inset_vertex(hole(m)); });
}

static Mesh cube() {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(Vec3(float(i & 1), float(i >> 1 & 1), float(i >> 2)));
  return made(corners, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

static void bevels() {
  // A vertex: inside, and on the boundary.
  auto bevel = [](Mesh mesh, int at) {
    std::set<uint32_t> old_faces;
    for (auto& f : mesh.faces) old_faces.insert(f.id);
    auto v = vertex(mesh, at);
    Vec3 start = v->position;
    const std::size_t degree = v->degree();
    const auto vs = mesh.vertices.size(), es = mesh.edges.size(), fs = mesh.faces.size();
    auto f = mesh.bevel_vertex(v);
    expect(f.has_value(), "bevel_vertex", "is refused");
    valid(mesh, "bevel_vertex");
    expect(!old_faces.count((*f)->id) && !(*f)->boundary, "bevel_vertex", "gives a new face");
    expect((*f)->degree() == degree, "bevel_vertex", "sides");
    expect(mesh.vertices.size() == vs + degree - 1 && mesh.edges.size() == es + degree &&
               mesh.faces.size() == fs + 1, "bevel_vertex", "counts");
    auto h = (*f)->halfedge;
    do {
      expect(h->vertex->position == start, "bevel_vertex", "starts where the vertex was");
      h = h->next;
    } while (h != (*f)->halfedge);
  };
  bevel(cube(), 7);
  bevel(a_house(), 1);

  Mesh mesh = cube();
  auto e = mesh.edges.begin();
  std::set<Place> ends = {place(e->halfedge->vertex->position),
                          place(e->halfedge->twin->vertex->position)};
  auto f = mesh.bevel_edge(e);
  expect(f.has_value(), "bevel_edge", "is refused");
  valid(mesh, "bevel_edge");
  expect(mesh.vertices.size() == 10 && mesh.edges.size() == 15 && mesh.faces.size() == 7,
         "bevel_edge", "counts");
  std::set<Place> places;
  auto h = (*f)->halfedge;
  do {
    places.insert(place(h->vertex->position));
    h = h->next;
  } while (h != (*f)->halfedge);
  expect(places == ends, "bevel_edge", "starts where the ends were");
  Mesh open = a_house();
  expect(open.bevel_edge(edge(open, house[1], house[4])).has_value(), "bevel_edge", "is refused");
  valid(open, "bevel_edge");
  refuses(a_house(), "bevel_edge", [](Mesh& m) { return m.bevel_edge(edge(m, house[0], house[1])); });
}

// n by n quads.
static Mesh grid(int n) {
  std::vector<Vec3> corners;
  Faces all;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) corners.push_back(Vec3(float(x), float(y), 0.25f * x * y));
  }
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      int a = y * (n + 1) + x;
      all.push_back({a, a + 1, a + n + 2, a + n + 1});
    }
  }
  return made(corners, all);
}

static void dissolves() {
  auto corners = house;
  corners.push_back(Vec3(0, 0, 0));
  Mesh mesh = made(corners, {{0, 3, 5}, {3, 4, 5}, {4, 1, 5}, {1, 0, 5}, {1, 4, 2}});
  auto f = mesh.dissolve_vertex(vertex(mesh, 5));
  expect(f && (*f)->degree() == 4 && !(*f)->boundary, "dissolve_vertex", "gives the merged face");
  becomes(mesh, "dissolve_vertex", a_house());
  refuses(grid(1), "dissolve_vertex",
          [](Mesh& m) { return m.dissolve_vertex(vertex(m, 0)); });

  Mesh other = a_house();
  auto g = other.dissolve_edge(edge(other, house[1], house[4]));
  expect(g && (*g)->degree() == 5 && !(*g)->boundary, "dissolve_edge", "gives the merged face");
  becomes(other, "dissolve_edge", made(house, {{0, 3, 4, 2, 1}}));
  refuses(grid(1), "dissolve_edge",
          [](Mesh& m) { return m.dissolve_edge(m.edges.begin()); });
}

static void collapses_faces() {
  Mesh mesh = grid(4);
  auto f = face(mesh, 5);
  Vec3 center = Vec3(0);
  auto h = f->halfedge;
  do {
    center = center + h->vertex->position / 4;
    h = h->next;
  } while (h != f->halfedge);
  auto v = mesh.collapse_face(f);
  expect(v && place((*v)->position) == place(center), "collapse_face", "gives the centroid");
  valid(mesh, "collapse_face");
  expect(mesh.vertices.size() == 25 - 3 && mesh.faces.size() == 17 - 1, "collapse_face", "counts");
  refuses(grid(1), "collapse_face", [](Mesh& m) { return m.collapse_face(hole(m)); });
}

static void opens() {
  // A strip of three: without its middle it falls in two.
  std::vector<Vec3> strip;
  for (int x = 0; x < 4; ++x) strip.insert(strip.end(), {Vec3(float(x), 0, 0), Vec3(float(x), 1, 0)});
  Mesh mesh = made(strip, {{0, 2, 3, 1}, {2, 4, 5, 3}, {4, 6, 7, 5}});
  auto f = face(mesh, 1);
  auto done = mesh.make_boundary(f);
  expect(done && *done == f && f->boundary, "make_boundary", "gives back its face");
  valid(mesh, "make_boundary");
  becomes(mesh, "make_boundary", made(strip, {{0, 2, 3, 1}, {4, 6, 7, 5}}));

  Mesh other = a_house();
  auto g = face(other, 1);
  done = other.make_boundary(g);
  expect(done && *done == g && g->boundary, "make_boundary", "gives back its face");
  becomes(other, "make_boundary", made({house[0], house[3], house[4], house[1]}, {{0, 1, 2, 3}}));

  // Two pieces, welded.
  auto apart = house;
  apart.push_back(Vec3(1.25f, 1, 0));
  apart.push_back(Vec3(1.75f, -1, 0));
  Mesh pieces = made(apart, {{0, 3, 4, 1}, {5, 6, 2}});
  auto e = edge(pieces, apart[1], apart[4]);
  auto welded = pieces.weld_edges(e, edge(pieces, apart[5], apart[6]));
  expect(welded && *welded == e && !e->on_boundary(), "weld_edges", "gives back its first edge");
  auto after = house;
  after[1] = (apart[1] + apart[5]) / 2;
  after[4] = (apart[4] + apart[6]) / 2;
  becomes(pieces, "weld_edges", made(after, {{0, 3, 4, 1}, {1, 4, 2}}));
  refuses(a_house(), "weld_edges", [](Mesh& m) {
    return m.weld_edges(edge(m, house[1], house[4]), edge(m, house[4], house[2]));
  });
}

// Operations at random places leave valid meshes, whatever was done before.
static void mixed() {
  std::mt19937 dice(7);
  std::map<std::string, int> applied;
  for (int round = 0; round < 60; ++round) {
    Mesh mesh = round % 2 ? grid(4) : cube();
    for (int step = 0; step < 25 && mesh.faces.size() > 3; ++step) {
      auto e = std::next(mesh.edges.begin(), dice() % mesh.edges.size());
      auto e2 = std::next(mesh.edges.begin(), dice() % mesh.edges.size());
      auto f = std::next(mesh.faces.begin(), dice() % mesh.faces.size());
      auto v = std::next(mesh.vertices.begin(), dice() % mesh.vertices.size());
      auto did = [&](const char* op, bool done) {
        applied[op] += done;
        valid(mesh, op);
      };
      switch (dice() % 13) {
        case 0: did("bisect_edge", mesh.bisect_edge(e).has_value()); break;
        case 1: did("split_edge", mesh.split_edge(e).has_value()); break;
        case 2: did("inset_vertex", mesh.inset_vertex(f).has_value()); break;
        case 3: did("bevel_vertex", mesh.bevel_vertex(v).has_value()); break;
        case 4: did("bevel_edge", mesh.bevel_edge(e).has_value()); break;
        case 5: did("extrude_face", mesh.extrude_face(f).has_value()); break;
        case 6: did("flip_edge", mesh.flip_edge(e).has_value()); break;
        case 7: did("make_boundary", mesh.make_boundary(f).has_value()); break;
        case 8: did("dissolve_vertex", mesh.dissolve_vertex(v).has_value()); break;
        case 9: did("dissolve_edge", mesh.dissolve_edge(e).has_value()); break;
        case 10: did("collapse_edge", mesh.collapse_edge(e).has_value()); break;
        case 11: did("collapse_face", mesh.collapse_face(f).has_value()); break;
        default: did("weld_edges", mesh.weld_edges(e, e2).has_value()); break;
      }
    }
  }
  for (auto& [op, count] : applied) {
    // Edges that can be welded are seldom drawn.
    expect(count > 10 || op == "weld_edges", op.c_str(), "has hardly ever applied");
  }
  expect(applied.size() == 13, "all", "are tried");
}

int main() {
  flips();
  splits();
  collapses();
  extrudes();
  bevels();
  dissolves();
  collapses_faces();
  opens();
  mixed();
  std::printf("%d checks\n", checks);
}
