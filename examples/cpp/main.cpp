// Operations that were drawn, in C++:
//   hedgerow plan std/triangle.hedge --as cpp -o triangle.h
//   g++ -std=c++17 main.cpp -o main && ./main
#include <iostream>

#include "mesh.h"
#include "triangle.h"

int main() {
  // Two triangles of a square.
  Mesh mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const auto inner = [&] {
    for (auto e = mesh.edges.begin(); e != mesh.edges.end(); ++e) {
      if (!e->halfedge->face->boundary && !e->halfedge->twin->face->boundary) return e;
    }
    return mesh.edges.end();
  };
  const auto faces = [&] {
    std::size_t count = 0;
    for (const Mesh::Face& f : mesh.faces) count += f.boundary ? 0 : 1;
    return count;
  };
  std::cout << "flipped: " << static_cast<bool>(flip(mesh, inner())) << '\n';
  const auto middle = split(mesh, inner());
  if (!middle) return 1;
  const Vec3 at = (*middle)->position;
  std::cout << "split at " << at.x << ' ' << at.y << ' ' << at.z << ": " << faces() << " faces, "
            << mesh.vertices.size() << " vertices\n";
  std::cout << "collapsed: " << static_cast<bool>(collapse(mesh, (*middle)->halfedge->edge)) << ": "
            << faces() << " faces, " << mesh.vertices.size() << " vertices\n";
}
