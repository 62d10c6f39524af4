#!/usr/bin/env python3
"""Holds std/simplify.hedge and std/remesh.hedge against other libraries, on the bunny and on the
bunny after three rounds of Loop subdivision (235,136 triangles).

    cargo build --release
    python3 -m venv /tmp/compare
    /tmp/compare/bin/pip install numpy==2.4.6 libigl==2.6.3 pymeshlab==2025.7.post1 \
        fast_simplification==0.2.0 gpytoolbox==0.3.8
    /tmp/compare/bin/python benches/compare/surfaces.py

For a simplified mesh: the distance between the two surfaces in millionths of the diagonal of the
box, root mean square and largest, both ways, from 200,000 points spread over each. For a remeshed
one: the spread of the edge lengths (standard deviation over mean) and of the angles, and the same
distance. `closed` tells whether the result is a closed surface of the same genus. Seconds are
whole calls, without reading and writing files but for hedgerow, whose own report is taken.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import time

import fast_simplification
import gpytoolbox
import igl
import numpy as np
import pymeshlab
from measures import HEDGEROW, HOUSE, distances, edges, read, write


def hedgerow(folder, surface, script, **settings):
    """The result of a script, and the seconds that it ran."""
    write(folder / "in.obj", surface)
    command = [HEDGEROW, "run", script, folder / "in.obj", "-o", folder / "out.obj"]
    for name, value in settings.items():
        command += ["--set", f"{name}={value}"]
    done = subprocess.run(command + ["--format", "json"], check=True, capture_output=True, text=True)
    return read(folder / "out.obj"), json.loads(done.stdout)["seconds"]["run"]


def timed(call):
    start = time.perf_counter()
    result = call()
    return result, time.perf_counter() - start


def meshlab(surface, step):
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(*surface))
    _, seconds = timed(lambda: step(meshes))
    mesh = meshes.current_mesh()
    return (mesh.vertex_matrix(), mesh.face_matrix().astype(np.int64)), seconds


def closed(surface, genus=0):
    points, faces = surface
    pairs, uses = edges(faces)
    used = len(np.unique(faces))
    return bool((uses == 2).all()) and used - len(pairs) + len(faces) == 2 - 2 * genus


def relative_distances(surface, original):
    diagonal = np.linalg.norm(np.ptp(original[0], axis=0))
    mean, largest = distances(surface, original)
    return f"{1e6 * mean / diagonal:8.1f} {1e6 * largest / diagonal:8.0f}"


def spread(surface):
    points, faces = surface
    pairs, _ = edges(faces)
    lengths = np.linalg.norm(points[pairs[:, 0]] - points[pairs[:, 1]], axis=1)
    angles = np.degrees(igl.internal_angles(points, faces))
    least = np.percentile(angles.min(axis=1), 1)
    return f"{100 * lengths.std() / lengths.mean():6.1f} % {angles.std():8.1f} {least:8.1f}"


def simplify(folder, surface, left):
    print(f"{'':24} {'faces':>7} {'rms':>8} {'largest':>8}  closed  seconds")
    ratio = 1 - left / len(surface[1])

    def with_meshlab(**options):
        return meshlab(
            surface,
            lambda meshes: meshes.meshing_decimation_quadric_edge_collapse(
                targetfacenum=left, preservetopology=True, **options
            ),
        )

    def with_fast():
        points, faces = np.float32(surface[0]), np.int32(surface[1])
        (points, faces), seconds = timed(
            lambda: fast_simplification.simplify(points, faces, target_reduction=ratio)
        )
        return (points.astype(float), faces.astype(np.int64)), seconds

    def with_igl():
        result, seconds = timed(lambda: igl.qslim(*surface, left, False))
        arrays = [part for part in result if isinstance(part, np.ndarray) and part.ndim == 2]
        return (arrays[0], arrays[1]), seconds

    tools = {
        "hedgerow": lambda: hedgerow(folder, surface, "std/simplify.hedge", faces_left=left),
        "MeshLab": with_meshlab,
        "MeshLab, planar quadric": lambda: with_meshlab(planarquadric=True, preservenormal=True),
        "fast-simplification": with_fast,
        "libigl qslim": with_igl,
    }
    for name, tool in tools.items():
        result, seconds = tool()
        print(
            f"{name:24} {len(result[1]):7} {relative_distances(result, surface)}"
            f"  {closed(result)!s:6} {seconds:8.2f}",
            flush=True,
        )


def remesh(folder, surface, length):
    print(
        f"{'':24} {'faces':>7} {'lengths':>8} {'angles':>8} {'least':>8}"
        f" {'rms':>8} {'largest':>8}  closed  seconds"
    )

    def with_meshlab():
        return meshlab(
            surface,
            lambda meshes: meshes.meshing_isotropic_explicit_remeshing(
                iterations=10, targetlen=pymeshlab.PureValue(length), featuredeg=180
            ),
        )

    def with_gpytoolbox():
        points, faces = surface
        return timed(lambda: gpytoolbox.remesh_botsch(points, faces, i=10, h=length, project=True))

    tools = {
        "before": lambda: (surface, 0.0),
        "hedgerow": lambda: hedgerow(
            folder, surface, "std/remesh.hedge", target=length, iterations=10
        ),
        "MeshLab": with_meshlab,
        "gpytoolbox": with_gpytoolbox,
    }
    for name, tool in tools.items():
        result, seconds = tool()
        print(
            f"{name:24} {len(result[1]):7} {spread(result)} {relative_distances(result, surface)}"
            f"  {closed(result)!s:6} {seconds:8.2f}",
            flush=True,
        )


def main():
    bunny = read(HOUSE / "examples/meshes/bunny.obj")
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        fine, _ = hedgerow(folder, bunny, "std/subdivide.hedge::loop_subdivide", iterations=3)
        for name, surface, left in (("bunny", bunny, 1000), ("fine bunny", fine, 20_000)):
            print(f"\nsimplify: {name}, {len(surface[1])} triangles")
            simplify(folder, surface, left)
        for name, surface, share in (("bunny", bunny, 1.0), ("fine bunny", fine, 1.0)):
            pairs, _ = edges(surface[1])
            lengths = np.linalg.norm(surface[0][pairs[:, 0]] - surface[0][pairs[:, 1]], axis=1)
            print(f"\nremesh: {name}, {len(surface[1])} triangles")
            remesh(folder, surface, share * lengths.mean())


if __name__ == "__main__":
    sys.exit(main())
