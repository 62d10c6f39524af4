#!/usr/bin/env python3
"""Holds std/subdivide.hedge against CGAL: the same vertices to 1e-12 of the size of the mesh.

Debian 12: apt-get install g++ libcgal-dev (5.5.1); cargo build --release; then run this file
anywhere. Needs nothing but Python 3.
"""

import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
HOUSE = HERE.parent.parent
SCHEMES = {
    "loop": "loop_subdivide",
    "catmull-clark": "catmull_clark",
    "sqrt3": "sqrt3",
    "doo-sabin": "doo_sabin",
}
MESHES = {
    "loop": ["bunny", "teapot"],
    "catmull-clark": ["bunny", "teapot"],
    "sqrt3": ["bunny"],
    "doo-sabin": ["bunny"],
}


def read_obj(path):
    points, faces = [], []
    for line in open(path):
        words = line.split()
        if words[:1] == ["v"]:
            points.append([float(word) for word in words[1:4]])
        elif words[:1] == ["f"]:
            faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
    return points, faces


def write_off(path, points, faces):
    with open(path, "w") as out:
        out.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        out.writelines(" ".join(map(repr, point)) + "\n" for point in points)
        out.writelines(f"{len(face)} {' '.join(map(str, face))}\n" for face in faces)


def read_off(path):
    numbers = open(path).read().split()
    count = int(numbers[1])
    values = [float(number) for number in numbers[4 : 4 + 3 * count]]
    return [values[at : at + 3] for at in range(0, 3 * count, 3)], int(numbers[2])


def farthest(ours, theirs):
    """The largest distance from one of ours to the nearest of theirs, by a grid of cells."""
    cell = 1e-6 * max(abs(x) for point in theirs for x in point)
    grid = {}
    for point in theirs:
        grid.setdefault(tuple(round(x / cell) for x in point), []).append(point)
    worst = 0.0
    for point in ours:
        home = [round(x / cell) for x in point]
        near = (
            other
            for i in (-1, 0, 1)
            for j in (-1, 0, 1)
            for k in (-1, 0, 1)
            for other in grid.get((home[0] + i, home[1] + j, home[2] + k), [])
        )
        squares = (sum((x - y) ** 2 for x, y in zip(point, other)) for other in near)
        worst = max(worst, min(squares, default=float("inf")) ** 0.5)
    return worst


def main():
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        tool = folder / "subdivide"
        subprocess.run(["g++", "-O1", "-std=c++17", HERE / "subdivide.cpp", "-o", tool], check=True)
        for scheme, script in SCHEMES.items():
            for mesh in MESHES[scheme]:
                source = HOUSE / f"examples/meshes/{mesh}.obj"
                ours = folder / "ours.obj"
                hedgerow = HOUSE / "target/release/hedgerow"
                program = f"std/subdivide.hedge::{script}"
                subprocess.run([hedgerow, "run", program, source, "-o", ours], check=True, capture_output=True)
                points, faces = read_obj(source)
                write_off(folder / "in.off", points, faces)
                subprocess.run([tool, scheme, folder / "in.off", folder / "out.off"], check=True)
                theirs, their_faces = read_off(folder / "out.off")
                mine, my_faces = read_obj(ours)
                size = max(abs(x) for point in theirs for x in point)
                worst = farthest(mine, theirs) / size
                same = len(mine) == len(theirs) and len(my_faces) == their_faces and worst < 1e-12
                failed |= not same
                print(f"{scheme:14} {mesh:8} {len(mine):6} vertices (CGAL {len(theirs)})  off by {worst:.1e}  {'ok' if same else 'DIFFERENT'}")
    sys.exit(failed)


if __name__ == "__main__":
    main()
