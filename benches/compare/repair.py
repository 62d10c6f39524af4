"""Repairs broken meshes with hedgerow, CGAL and MeshLab, and prints what each makes of them.

    cargo build --release
    pip install pymeshlab; apt-get install libcgal-dev
    python benches/compare/repair.py [--count 200] [--seed 1] [--keep DIR] [--hedgerow PROGRAM]

A generator makes closed and open triangle meshes and breaks them: faces are doubled, turned over,
given a vertex twice, glued at edges and at vertices. For each tool the table has how many results
are manifold (no edge of three faces, one fan at each vertex, neighbors that run alike), the faces
that are left, and the boundary edges: fewer cuts leave fewer.

hedgerow: `run --repair` with a script that does nothing. CGAL: `repair_polygon_soup`,
`orient_polygon_soup`, `duplicate_non_manifold_vertices`. MeshLab: duplicate faces, null
faces, `meshing_repair_non_manifold_edges` (both methods), `meshing_repair_non_manifold_vertices`,
`meshing_re_orient_faces_coherently`.
"""

import argparse
import collections
import functools
import pathlib
import random
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def grid(width, height, rng):
    """A triangulated rectangle, wound up to a tube half of the time."""
    wound = rng.random() < 0.5
    columns = width if wound else width + 1
    at = lambda i, j: (i % columns) + columns * j
    points = [(i, j, rng.random() * 0.1 + 0.3 * ((i * j) % 3)) for j in range(height + 1) for i in range(columns)]
    faces = []
    for j in range(height):
        for i in range(width):
            a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
            faces += [[a, b, c], [a, c, d]]
    return points, faces


def broken(rng):
    """A mesh with some faults."""
    points, faces = grid(rng.randint(3, 8), rng.randint(2, 6), rng)
    for _ in range(rng.randint(1, 6)):
        fault = rng.randrange(6)
        face = rng.choice(faces)
        if fault == 0:
            faces.append(list(face))  # doubled
        elif fault == 1:
            face.reverse()  # turned over
        elif fault == 2:
            faces.append([face[0], face[0], face[1]])  # a vertex twice
        elif fault == 3:
            points.append((rng.random(), rng.random(), 2.0))  # a fin at an edge
            faces.append([face[0], face[1], len(points) - 1])
        elif fault == 4:
            n = len(points)  # a flap at a vertex
            points += [(rng.random(), rng.random(), 3.0), (rng.random(), rng.random(), 4.0)]
            faces.append([face[0], n, n + 1])
        else:
            faces.append([face[1], face[0], face[2]])  # the back
    rng.shuffle(faces)
    return points, faces


def write_obj(path, points, faces):
    lines = ["v {} {} {}".format(*p) for p in points]
    lines += ["f " + " ".join(str(v + 1) for v in face) for face in faces]
    path.write_text("\n".join(lines) + "\n")


def read_obj(path):
    points, faces = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(map(float, words[1:4])))
        elif words[:1] == ["f"]:
            faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
    return points, faces


def is_manifold(faces):
    """Whether faces are a mesh, and how many boundary edges it has."""
    sides = {}
    for f, face in enumerate(faces):
        if len(set(face)) < len(face):
            return False, 0
        for a, b in zip(face, face[1:] + face[:1]):
            if (a, b) in sides:
                return False, 0
            sides[a, b] = f
    boundary = sum((b, a) not in sides for a, b in sides)
    # One fan at each vertex: its faces hang together across edges.
    around = collections.defaultdict(list)
    for f, face in enumerate(faces):
        for v in face:
            around[v].append(f)
    for v, fan in around.items():
        seen, todo = {fan[0]}, [fan[0]]
        while todo:
            face = faces[todo.pop()]
            i = face.index(v)
            for a, b in ((face[i], face[(i + 1) % len(face)]), (face[i - 1], face[i])):
                other = sides.get((b, a))
                if other is not None and other not in seen:
                    seen.add(other)
                    todo.append(other)
        if len(seen) < len(set(fan)):
            return False, 0
    return True, boundary


CGAL = r"""
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/IO/OBJ.h>
namespace PMP = CGAL::Polygon_mesh_processing;
using Point = CGAL::Simple_cartesian<double>::Point_3;
int main(int, char** argv) {
  for (char** pair = argv + 1; pair[0] && pair[1]; pair += 2) {
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> polygons;
    CGAL::IO::read_OBJ(pair[0], points, polygons);
    PMP::repair_polygon_soup(points, polygons);
    PMP::orient_polygon_soup(points, polygons);
    CGAL::Surface_mesh<Point> mesh;
    PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
    PMP::duplicate_non_manifold_vertices(mesh);
    CGAL::IO::write_OBJ(pair[1], mesh);
  }
}
"""


def run_cgal(folder, names):
    source, program = folder / "cgal.cpp", folder / "cgal"
    source.write_text(CGAL)
    subprocess.run(["g++", "-O1", "-w", "-DCGAL_USE_CORE=0", str(source), "-o", str(program), "-lgmp", "-lmpfr"], check=True)
    pairs = [str(folder / f"{name}{end}") for name in names for end in (".obj", ".cgal.obj")]
    subprocess.run([str(program), *pairs], check=True)


def run_meshlab(folder, names):
    import pymeshlab

    for name in names:
        for method in (0, 1):
            meshes = pymeshlab.MeshSet(verbose=False)
            meshes.load_new_mesh(str(folder / f"{name}.obj"))
            meshes.meshing_remove_duplicate_faces()
            meshes.meshing_remove_null_faces()
            meshes.meshing_repair_non_manifold_edges(method=method)
            try:
                meshes.meshing_re_orient_faces_coherently()
            except pymeshlab.PyMeshLabException:
                pass  # it refuses what cannot be oriented
            meshes.meshing_repair_non_manifold_vertices(vertdispratio=0)
            end = f".meshlab{method}.obj"
            meshes.save_current_mesh(str(folder / f"{name}{end}"), save_vertex_normal=False, save_wedge_texcoord=False)


def run_hedgerow(folder, names, program):
    script = folder / "nothing.hedge"
    script.write_text("script nothing() { }\n")
    for name in names:
        mesh, out = folder / f"{name}.obj", folder / f"{name}.hedgerow.obj"
        subprocess.run([program, "run", script, mesh, "--repair", "-o", out], check=True, capture_output=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--hedgerow", type=pathlib.Path, default=ROOT / "target" / "release" / "hedgerow")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        rng = random.Random(arguments.seed)
        names = [f"m{i}" for i in range(arguments.count)]
        faces = 0
        for name in names:
            points, polygons = broken(rng)
            faces += len(polygons)
            write_obj(folder / f"{name}.obj", points, polygons)
        hedgerow = functools.partial(run_hedgerow, program=arguments.hedgerow)
        tools = [("hedgerow", hedgerow, ["hedgerow"]), ("CGAL", run_cgal, ["cgal"])]
        tools.append(("MeshLab", run_meshlab, ["meshlab0", "meshlab1"]))
        print(f"{arguments.count} meshes of {faces} faces")
        print(f"{'':<12}{'manifold':>10}{'faces':>10}{'boundary edges':>16}")
        for tool, run, ends in tools:
            try:
                run(folder, names)
            except (ImportError, OSError, subprocess.CalledProcessError) as error:
                print(f"{tool:<12}not run: {error}")
                continue
            for end in ends:
                manifold = left = boundary = 0
                for name in names:
                    _, polygons = read_obj(folder / f"{name}.{end}.obj")
                    good, edges = is_manifold(polygons)
                    manifold += good
                    left += len(polygons)
                    boundary += edges
                print(f"{end:<12}{manifold:>10}{left:>10}{boundary:>16}")


if __name__ == "__main__":
    main()
