"""Remeshes a folder of meshes, on Ray or on the processors of this machine.

    python batch.py meshes remeshed --set target=0.02
    python batch.py meshes remeshed --runner ray --workers 16
    python batch.py meshes written --program ops.hedge --script simplify --set ratio=0.5

Each mesh is read here, goes to a worker with the program, and comes back; so workers need neither
the files nor the disk, and Ray's may be other machines (`ray start --address=...`, then
`--address auto`). A worker compiles the program when it meets it first, and keeps it. What fails is
told by name with its message, and keeps nothing else from being done: a file that is not a mesh, a mesh
that the script refuses, or one at which the worker dies.

The runners are `ray`, `processes`, `threads` (a script releases the interpreter's lock while it
runs), and `auto`: Ray if it is installed, else processes. A mesh that goes to another process loses
what its file says besides the mesh and its attributes, as materials and groups; with `threads` it is
kept.
"""

from __future__ import annotations

import argparse
import concurrent.futures
import importlib.util
import multiprocessing
import os
import pathlib
import sys
import time
from typing import NamedTuple

import hedgerow

SUFFIXES = (".obj", ".ply", ".stl", ".off", ".msh", ".halfedges")


class Outcome(NamedTuple):
    """What became of a mesh."""

    #: The name of the file.
    name: str
    #: What the script did, or `None` if it failed.
    report: hedgerow.Report | None
    #: Why it failed, or `None`.
    error: str | None
    #: How long the script ran, in seconds.
    seconds: float


def work(script, name, mesh, arguments):
    """Runs a script on a mesh, in a worker: the mesh, or `None` if it failed, and what became of it."""
    begun = time.perf_counter()
    try:
        report = script(mesh, **arguments)
    except Exception as error:
        return None, Outcome(name, None, told(error), time.perf_counter() - begun)
    return mesh, Outcome(name, report, None, time.perf_counter() - begun)


def told(error):
    """What an error says; of one that says nothing, its name."""
    return str(error) or type(error).__name__


class Ray:
    """Workers of a Ray cluster: of the one at `address`, or of one on this machine."""

    def __init__(self, function, workers=None, address=None):
        import ray

        self._ray = ray
        self._is_own = not ray.is_initialized()
        if self._is_own:
            cpus = None if address else workers
            ray.init(address, num_cpus=cpus, include_dashboard=False, log_to_driver=False)
        # A worker elsewhere does not have this file.
        ray.cloudpickle.register_pickle_by_value(sys.modules[function.__module__])
        self._remote = ray.remote(max_retries=0)(function)
        self._sent = {}
        self.workers = workers or max(1, int(ray.cluster_resources().get("CPU", 1)))

    def submit(self, script, *arguments):
        # A program goes to each machine once.
        if script not in self._sent:
            self._sent[script] = self._ray.put(script)
        return self._remote.remote(self._sent[script], *arguments)

    def wait(self, running):
        return self._ray.wait(list(running))[0]

    def result(self, task, call):
        return self._ray.get(task)

    def close(self):
        if self._is_own:
            self._ray.shutdown()


class Local:
    """Workers on this machine: `processes` or `threads`."""

    def __init__(self, function, workers=None, kind="processes"):
        self._function, self._kind = function, kind
        self.workers = workers or os.cpu_count() or 1
        self._pool = self._made(self.workers)

    def _made(self, workers):
        if self._kind == "threads":
            return concurrent.futures.ThreadPoolExecutor(workers)
        # A forked process would have the locks of threads, but not the threads.
        context = multiprocessing.get_context("spawn")
        return concurrent.futures.ProcessPoolExecutor(workers, mp_context=context)

    def submit(self, *call):
        try:
            return self._pool.submit(self._function, *call)
        except concurrent.futures.process.BrokenProcessPool:
            self._pool = self._made(self.workers)
            return self._pool.submit(self._function, *call)

    def wait(self, running):
        return concurrent.futures.wait(running, return_when="FIRST_COMPLETED").done

    def result(self, task, call):
        try:
            return task.result()
        except concurrent.futures.process.BrokenProcessPool:
            # A worker has died, and all that ran was given up: what of it does so alone is at fault.
            with self._made(1) as pool:
                return pool.submit(self._function, *call).result()

    def close(self):
        self._pool.shutdown(cancel_futures=True)


def runner(name, function, workers=None, address=None):
    """The workers of a name: `ray`, `processes`, `threads` or `auto`."""
    if workers is not None and workers < 1:
        advice = "leave it out for as many as there are processors"
        raise ValueError(f"`workers` is a whole number from 1, not {workers}: {advice}")
    if name == "auto":
        name = "ray" if importlib.util.find_spec("ray") else "processes"
    if name == "ray":
        return Ray(function, workers, address)
    if name in ("processes", "threads"):
        return Local(function, workers, name)
    raise ValueError(f"`runner` is auto, ray, processes or threads, not {name!r}")


def run_folder(
    source, target, script, arguments=None, *, run="auto", workers=None, address=None, function=work
):
    """Runs a script on each mesh of a folder, and writes what comes of it into another, under the same
    name. Yields an :class:`Outcome` for each, in the order in which they are done.

    No more meshes are held than there are workers, and as many again.
    """
    source, target = pathlib.Path(source), pathlib.Path(target)
    if not source.is_dir():
        raise NotADirectoryError(f"there is no folder `{source}`")
    if target.exists() and target.samefile(source):
        message = f"the results would replace the meshes in `{source}`: name another folder for them"
        raise FileExistsError(message)
    names = sorted(path.name for path in source.iterdir() if path.suffix.lower() in SUFFIXES)
    pool = runner(run, function, workers, address)
    running = {}

    def done():
        for task in pool.wait(running):
            name, call = running.pop(task)
            try:
                mesh, outcome = pool.result(task, call)
                if mesh is not None:
                    mesh.save(target / name)
            except Exception as error:
                outcome = Outcome(name, None, told(error), 0.0)
            yield outcome

    try:
        target.mkdir(parents=True, exist_ok=True)
        for name in names:
            try:
                mesh = hedgerow.Mesh.load(source / name)
            except Exception as error:
                yield Outcome(name, None, told(error), 0.0)
                continue
            call = (script, name, mesh, arguments or {})
            running[pool.submit(*call)] = name, call
            if len(running) >= 2 * pool.workers:
                yield from done()
        while running:
            yield from done()
    finally:
        pool.close()


def value(text):
    """`name=value`, the value a truth value or a number."""
    name, equals, word = text.partition("=")
    if not (name and equals):
        raise argparse.ArgumentTypeError(f"`{text}` is not name=value")
    if word in ("true", "false"):
        return name, word == "true"
    for kind in (int, float):
        try:
            return name, kind(word)
        except ValueError:
            pass
    raise argparse.ArgumentTypeError(f"`{word}` is not a number, nor true or false")


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("source", help="the folder of the meshes")
    parser.add_argument("target", help="the folder for what comes of them")
    parser.add_argument("--program", default="std/remesh.hedge", help="a file, or one of the library")
    parser.add_argument("--script", default="remesh", help="which of its scripts")
    parser.add_argument("--set", action="append", type=value, default=[], metavar="NAME=VALUE")
    parser.add_argument("--runner", default="auto", choices=["auto", "ray", "processes", "threads"])
    parser.add_argument("--workers", type=int, help="how many, from 1; else as there are processors")
    parser.add_argument("--address", help="of a Ray cluster that runs")
    given = parser.parse_args(arguments)
    begun, failed, count = time.perf_counter(), 0, 0
    try:
        script = hedgerow.load(given.program)[given.script]
        outcomes = run_folder(
            given.source, given.target, script, dict(given.set),
            run=given.runner, workers=given.workers, address=given.address,
        )  # fmt: skip
        for outcome in outcomes:
            count += 1
            failed += outcome.error is not None
            applied = "" if outcome.report is None else f"{outcome.report.applied} applied"
            print(f"{outcome.name}: {outcome.error or applied} ({outcome.seconds:.2f} s)", flush=True)
    except (hedgerow.Error, OSError, KeyError, ImportError, ValueError) as error:
        parser.exit(2, f"{told(error)}\n")
    print(f"{count} meshes, {failed} failed, in {time.perf_counter() - begun:.2f} s")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
