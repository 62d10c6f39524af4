"""A million triangles into a mesh and out again, and two meshes on two threads.

    pip install ./python
    python benches/compare/arrays.py

Times of arrays are processor time, the least of several runs; times of threads are by the clock, since
it is the clock that two processors gain against.
"""

import threading
import time

import numpy as np

from hedgerow import Mesh, std

RUNS = 5


def row(what, job, clock=time.process_time, runs=RUNS):
    times = []
    for _ in range(runs):
        start = clock()
        job()
        times.append(clock() - start)
    print(f"| {what} | {1e3 * min(times):.0f} |", flush=True)
    return min(times)


def main():
    side = 708
    x, y = np.meshgrid(np.arange(side), np.arange(side))
    vertices = np.column_stack([x.ravel(), y.ravel(), np.zeros(side * side)]).astype(float)
    corner = (np.arange(side - 1) + side * np.arange(side - 1)[:, None]).ravel()
    quads = np.stack([corner, corner + 1, corner + side + 1, corner + side], axis=1)
    faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    mesh = Mesh(vertices, faces)
    print(f"{mesh}\n\n| what | ms |\n| --- | ---: |")
    row("arrays to a mesh", lambda: Mesh(vertices, faces))
    row("arrays of int32 in Fortran order to a mesh", lambda: Mesh(np.asfortranarray(vertices), faces.astype(np.int32, order="F")))
    row("a mesh to arrays", lambda: (mesh.vertices, mesh.faces))
    row("six pointers of each halfedge", lambda: [getattr(mesh.halfedges, name) for name in ("next", "prev", "twin", "vertex", "edge", "face")])
    row("a copy", mesh.copy)
    row("bytes, and a mesh of them", lambda: Mesh.from_bytes(mesh.to_bytes()))

    start = Mesh.icosphere(5)

    def remesh(mesh):
        std.remesh.remesh(mesh, target=0.03, iterations=2)

    def one_after_the_other():
        for _ in range(2):
            remesh(start.copy())

    def at_once():
        threads = [threading.Thread(target=remesh, args=(start.copy(),)) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()

    print("\n| what | ms by the clock |\n| --- | ---: |")
    single = row("two meshes remeshed one after the other", one_after_the_other, time.perf_counter)
    both = row("two meshes on two threads", at_once, time.perf_counter)
    print(f"\nTwo threads take {both / single:.2f} of the time.")


if __name__ == "__main__":
    main()
