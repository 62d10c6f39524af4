// The work of `peers.py` by CGAL's Surface_mesh, for comparison:
//   cgal JOB ORDER IN.off [OUT.off]
// where JOB is flip, split, collapse, loop, catmull-clark, remesh or simplify and ORDER is
// `in-order` or `random` (of the edges; the last four have none). Prints the processor seconds of
// the job alone.
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Edge = Mesh::Edge_index;
using Halfedge = Mesh::Halfedge_index;

static Kernel::Point_3 middle(const Mesh& mesh, Halfedge h) {
  return CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
}

// As `guard simple`: refuses where the new edge would have the ends of another.
static bool flip(Mesh& mesh, Edge e) {
  const Halfedge h = mesh.halfedge(e);
  if (mesh.is_border(e)) return false;
  const auto left = mesh.target(mesh.next(h));
  const auto right = mesh.target(mesh.next(mesh.opposite(h)));
  if (left == right || mesh.halfedge(left, right).is_valid()) return false;
  CGAL::Euler::flip_edge(h, mesh);
  return true;
}

static bool split(Mesh& mesh, Edge e) {
  if (mesh.is_border(e)) return false;
  const Halfedge h = mesh.halfedge(e);
  const auto place = middle(mesh, h);
  const Halfedge half = CGAL::Euler::split_edge(h, mesh);
  mesh.point(mesh.target(half)) = place;
  CGAL::Euler::split_face(half, mesh.next(mesh.next(half)), mesh);
  const Halfedge other = mesh.prev(mesh.opposite(half));
  CGAL::Euler::split_face(other, mesh.next(mesh.next(other)), mesh);
  return true;
}

static bool collapse(Mesh& mesh, Edge e) {
  if (!CGAL::Euler::does_satisfy_link_condition(e, mesh)) return false;
  const auto place = middle(mesh, mesh.halfedge(e));
  mesh.point(CGAL::Euler::collapse_edge(e, mesh)) = place;
  return true;
}

static double mean_length(const Mesh& mesh) {
  double sum = 0;
  for (Edge e : mesh.edges()) {
    const Halfedge h = mesh.halfedge(e);
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
  }
  return sum / mesh.number_of_edges();
}

int main(int count, char** words) {
  if (count < 4) return 2;
  const std::string job = words[1];
  Mesh mesh;
  std::ifstream(words[3]) >> mesh;
  std::vector<Edge> edges(mesh.edges().begin(), mesh.edges().end());
  if (std::string(words[2]) == "random") std::shuffle(edges.begin(), edges.end(), std::mt19937(1));
  const auto each = [&](auto operation) {
    std::size_t applied = 0;
    for (Edge e : edges) {
      if (!mesh.is_removed(e)) applied += operation(mesh, e);
    }
    return applied;
  };
  std::size_t applied = 0;
  const std::clock_t start = std::clock();
  if (job == "flip") applied = each(flip);
  else if (job == "split") applied = each(split);
  else if (job == "collapse") applied = each(collapse);
  else if (job == "loop")
    CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
  else if (job == "catmull-clark")
    CGAL::Subdivision_method_3::CatmullClark_subdivision(
        mesh, CGAL::parameters::number_of_iterations(1));
  else if (job == "remesh")
    CGAL::Polygon_mesh_processing::isotropic_remeshing(
        mesh.faces(), mean_length(mesh), mesh, CGAL::parameters::number_of_iterations(5));
  else if (job == "simplify") {
    namespace Simplification = CGAL::Surface_mesh_simplification;
    using Policies = Simplification::GarlandHeckbert_plane_policies<Mesh, Kernel>;
    Simplification::Count_ratio_stop_predicate<Mesh> stop(0.1);
    const Policies policies(mesh);
    Simplification::edge_collapse(
        mesh, stop,
        CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
  } else return 2;
  const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  std::cout << seconds << ' ' << applied << '\n';
  if (count > 4) {
    mesh.collect_garbage();
    std::ofstream out(words[4]);
    out.precision(17);
    out << mesh;
    return out ? 0 : 1;
  }
  return 0;
}
