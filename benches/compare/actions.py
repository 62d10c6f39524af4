"""Actions a second on meshes of 512 triangles, on one core, by processor time.

    pip install ./python
    python benches/compare/actions.py

A flip in the plane (convexity is asked) and one on a torus (that no two edges join the same vertices
is asked): called from Python; with a mask of all edges, asked anew or kept current; and from a script,
at each edge in order, or at edges by chance where it is asked first. An action is a call, whether it
applies or not; with a mask it always does. Times are the least of several runs.
"""

import random
import time

import numpy as np

import hedgerow
from hedgerow import Mesh, std

SCRIPT = """
use "std/{file}.hedge"
script visit(rounds: int) {{ repeat rounds {{ for e in edges {{ flip(e) }} }} }}
script wander(rounds: int) {{
  repeat rounds {{ for e in shuffle(edges) {{ if can flip(e) {{ must flip(e) }} }} }}
}}
"""

RUNS = 5


def timed(job):
    start = time.process_time()
    done = job()
    return (time.process_time() - start) / done


def row(what, job):
    seconds = min(timed(job) for _ in range(RUNS))
    print(f"| {what} | {1 / seconds:,.0f} | {1e6 * seconds:.2f} |", flush=True)


def main():
    for file, make in (("planar_triangle", lambda: Mesh.grid(16, triangles=True)), ("triangle", lambda: Mesh.torus(16, 16, triangles=True))):
        program = hedgerow.program(SCRIPT.format(file=file))
        library, mesh = getattr(std, file), make()
        if file == "planar_triangle":
            library.measure(mesh)
        flip, ids, dice = library.flip, mesh.edges.ids, random.Random(1).random
        print(f"\n{mesh}, `std/{file}::flip`\n\n| what | a second | µs |\n| --- | ---: | ---: |")

        def called(count=20_000):
            for edge in np.random.default_rng(1).choice(ids, count).tolist():
                flip(mesh, edge)
            return count

        def at_once(count=200_000):
            flip.each(mesh, np.random.default_rng(1).choice(ids, count))
            return count

        def anew(count=100):
            for _ in range(count):
                flip(mesh, int(dice() * len(ids)))
                flip.can(mesh)
            return count

        def followed(count=10_000):
            live = flip.live(mesh)
            for _ in range(count):
                flip(mesh, live.pick(dice()))
            return count

        def scripted():
            report = program.visit(mesh, 200)
            return report.applied + report.refused

        def wandered(rounds=200):
            program.wander(mesh, rounds)
            return rounds * len(ids)

        def nothing(count=100_000):
            for _ in range(count):
                dice()
            return count

        row("turns of a loop in Python that do nothing", nothing)
        row("calls from Python", called)
        row("calls with an array of edges", at_once)
        row("actions with a mask that is asked anew", anew)
        row("actions with a live mask", followed)
        row("calls from a script", scripted)
        row("edges by chance from a script, asked and flipped", wandered)


if __name__ == "__main__":
    main()
