// One step of subdivision by CGAL, for comparison with std/subdivide.hedge:
//   subdivide loop|catmull-clark|sqrt3|doo-sabin IN.off OUT.off
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <fstream>
#include <string>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int count, char** words) {
  if (count != 4) return 2;
  Mesh mesh;
  std::ifstream(words[2]) >> mesh;
  const auto one = CGAL::parameters::number_of_iterations(1);
  const std::string scheme = words[1];
  if (scheme == "loop") CGAL::Subdivision_method_3::Loop_subdivision(mesh, one);
  else if (scheme == "catmull-clark") CGAL::Subdivision_method_3::CatmullClark_subdivision(mesh, one);
  else if (scheme == "sqrt3") CGAL::Subdivision_method_3::Sqrt3_subdivision(mesh, one);
  else if (scheme == "doo-sabin") CGAL::Subdivision_method_3::DooSabin_subdivision(mesh, one);
  else return 2;
  std::ofstream out(words[3]);
  out.precision(17);
  out << mesh;
  return out ? 0 : 1;
}
