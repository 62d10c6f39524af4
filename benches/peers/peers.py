#!/usr/bin/env python3
"""Holds operations and algorithms of the library against CGAL and scipy, in one run.

    cargo build --release
    apt-get install g++ libcgal-dev libeigen3-dev
    python3 -m venv /tmp/compare && /tmp/compare/bin/pip install numpy==2.4.6 libigl==2.6.3 scipy==1.17.1
    /tmp/compare/bin/python benches/peers/peers.py [ROUNDS OF LOOP SUBDIVISION OF THE BUNNY]

Three rounds (235,136 triangles) are the default; four make 940,544. Each job runs on every contender
in turn, three times; the least processor time counts, without reading the program and the mesh, but
with what `--reorder` takes for that. Operations are tried at every edge that is still there, in the
order of the mesh and in a random one. Of remeshed surfaces the spread of the edge lengths is told
(standard deviation over mean), of simplified ones the root mean square distance to the original in
millionths of the diagonal of the box, ours first. Smoothing is held against products with a sparse
matrix by scipy, which is built from the faces first; of it the greatest difference of a coordinate is
told.
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "compare"))
from measures import HEDGEROW, HOUSE, distances, edges, read, write  # noqa: E402

import numpy as np  # noqa: E402
import scipy.sparse  # noqa: E402

TIMES = 3
OPERATIONS = ["flip", "split", "collapse"]
ALGORITHMS = {
    "loop": 'use "std/subdivide.hedge" script main() { loop_subdivide() }',
    "catmull-clark": 'use "std/subdivide.hedge" script main() { catmull_clark() }',
    "remesh": 'use "std/remesh.hedge" script main() { remesh() }',
    "simplify": 'use "std/simplify.hedge" script main() { simplify(-1, 1, 0.1) }',
    "smooth": 'use "std/smooth.hedge" script main() { laplacian(10, 0.5) }',
}


def processor_seconds(command):
    """The processor time of a command, and what it prints."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    out = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        raise SystemExit(f"{command} failed")
    return usage.ru_utime + usage.ru_stime, out


class Contest:
    def __init__(self, folder, surface):
        self.folder, self.surface = folder, surface
        write(folder / "in.obj", surface)
        points, faces = surface
        with open(folder / "in.off", "w") as out:
            out.write(f"OFF\n{len(points)} {len(faces)} 0\n")
            out.writelines("%r %r %r\n" % tuple(map(float, point)) for point in points)
            out.writelines("3 %d %d %d\n" % tuple(face) for face in faces)
        self.cgal = folder / "cgal"
        source = pathlib.Path(__file__).with_name("cgal.cpp")
        include = "-I/usr/include/eigen3"
        build = ["g++", "-std=c++17", "-O3", "-DNDEBUG", include, "-o", self.cgal, source]
        subprocess.run(build, check=True)

    def hedgerow(self, options, program, empty, out=None):
        """The seconds of a program beyond those of an empty one without options."""
        seconds = []
        for text, out, options in [(program, out, options), (empty, None, [])]:
            (self.folder / "job.hedge").write_text(text)
            command = [HEDGEROW, "run", self.folder / "job.hedge", self.folder / "in.obj", *options]
            least = min(processor_seconds(command)[0] for _ in range(1 if out else 2))
            seconds.append(least)
            if out:
                subprocess.run([*command, "-o", out], check=True, capture_output=True)
        return seconds[0] - seconds[1]

    def peer(self, job, order, *out):
        _, told = processor_seconds([self.cgal, job, order, self.folder / "in.off", *out])
        return float(told.split()[0])

    def measure(self, job, order, program, empty):
        """The least seconds of each contender."""
        peer = (lambda: smooth(self.surface)[0]) if job == "smooth" else lambda: self.peer(job, order)
        contenders = {
            "by default": lambda: self.hedgerow([], program, empty),
            "reordered": lambda: self.hedgerow(["--reorder"], program, empty),
            "machine": lambda: self.hedgerow(["--engine", "machine"], program, empty),
            "peer": peer,
        }
        least = dict.fromkeys(contenders, float("inf"))
        for _ in range(TIMES):
            for name, run in contenders.items():
                least[name] = min(least[name], run())
        return least

    def operation(self, job, order):
        loop = "edges" if order == "in-order" else "shuffle(edges)"
        uses = 'use "std/triangle.hedge" script main() '
        program = f"{uses}{{ for e in {loop} {{ {job}(e) }} }}"
        empty = f"{uses}{{ for e in {loop} {{ }} }}"
        least = self.measure(job, order, program, empty)
        count = len(edges(self.surface[1])[0])
        row(f"{job}, {order}", {name: 1e9 * least[name] / count for name in least}, "ns")

    def algorithm(self, job):
        uses, _ = ALGORITHMS[job].split("script")
        least = self.measure(job, "in-order", ALGORITHMS[job], f"{uses}script main() {{ }}")
        row(job, least, "s", self.quality(job))

    def quality(self, job):
        if job in ("loop", "catmull-clark"):
            return ""
        ours, theirs = self.folder / "ours.obj", self.folder / "theirs.off"
        self.hedgerow([], ALGORITHMS[job], "script main() { }", ours)
        if job == "smooth":
            return f"{np.abs(read(ours)[0] - smooth(self.surface)[1]).max():.0e}"
        self.peer(job, "in-order", theirs)
        measure = {"remesh": self.spread, "simplify": self.distance}[job]
        return f"{measure(read(ours))} / {measure(read_off(theirs))}"

    def spread(self, surface):
        points, faces = surface
        pairs, _ = edges(faces)
        lengths = np.linalg.norm(points[pairs[:, 0]] - points[pairs[:, 1]], axis=1)
        return f"{100 * lengths.std() / lengths.mean():.1f} %"

    def distance(self, surface):
        diagonal = np.linalg.norm(np.ptp(self.surface[0], axis=0))
        return f"{1e6 * distances(surface, self.surface)[0] / diagonal:.1f}"


def smooth(surface):
    """The seconds of ten rounds of smoothing by scipy, and the points."""
    start = time.process_time()
    points, faces = surface
    ends = np.roll(faces, -1, axis=1)
    pairs = scipy.sparse.coo_array((np.ones(faces.size), (faces.ravel(), ends.ravel())))
    size = (len(points), len(points))
    pairs = scipy.sparse.csr_array(pairs.tocsr(), shape=size)
    one_sided = (pairs - pairs.T).tocoo()
    joined = pairs + pairs.T
    joined.data[:] = 1
    free = np.ones(len(points), dtype=bool)
    free[one_sided.row[one_sided.data != 0]] = False
    degrees = joined.sum(axis=1)
    share = np.where(free, 0.5 / np.maximum(degrees, 1), 0)[:, None]
    keep = np.where(free, 0.5, 1)[:, None]
    for _ in range(10):
        points = keep * points + share * (joined @ points)
    return time.process_time() - start, points


def read_off(path):
    words = pathlib.Path(path).read_text().split()
    vertices, faces = int(words[1]), int(words[2])
    numbers = np.array(words[4:], dtype=float)
    points = numbers[: 3 * vertices].reshape(-1, 3)
    rows = numbers[3 * vertices : 3 * vertices + 4 * faces].reshape(-1, 4)
    return points, rows[:, 1:].astype(np.int64)


def row(name, values, unit, quality=""):
    *ours, peer = values.values()
    seconds = " ".join(f"{each:9.2f}" for each in [*ours, peer])
    ratios = " ".join(f"{each / peer:9.2f}" for each in ours[:2])
    print(f"{name:20} {seconds} {unit:3} {ratios}   {quality}", flush=True)


def main():
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 3
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        command = [HEDGEROW, "run", "std/subdivide.hedge::loop_subdivide"]
        command += [HOUSE / "examples/meshes/bunny.obj", "--set", f"iterations={rounds}"]
        subprocess.run([*command, "-o", folder / "fine.obj"], check=True, capture_output=True)
        surface = read(folder / "fine.obj")
        contest = Contest(folder, surface)
        print(f"{len(surface[1])} triangles; processor time, least of {TIMES}")
        columns = ["hedgerow", "reordered", "machine", "peer", "   ", "to peer", "reordered"]
        print(" " * 20, *(f"{column:>9}" if column.strip() else column for column in columns), " quality")
        for order in ["in-order", "random"]:
            for job in OPERATIONS:
                contest.operation(job, order)
        for job in ALGORITHMS:
            contest.algorithm(job)


if __name__ == "__main__":
    sys.exit(main())
