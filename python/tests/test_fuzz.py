"""Random calls, with arguments that fit and that do not: exceptions are of the package, the mesh
stays valid, what raises leaves it as it was, and live masks are what is asked anew.

`HEDGEROW_FUZZ=100000` makes so many calls, `HEDGEROW_FUZZ_SEED` begins elsewhere.
"""

import os
import pickle
import random

import numpy as np

import hedgerow
from hedgerow import Mesh

CALLS = int(os.environ.get("HEDGEROW_FUZZ", "1000"))
SEED = int(os.environ.get("HEDGEROW_FUZZ_SEED", "1"))
EXPECTED = (hedgerow.Error, LookupError, TypeError, ValueError, KeyError, IndexError, AttributeError, OverflowError)

ODD = [
    None, True, False, 0, 1, 4, -1, 2**31, 2**32, 2**63, 2**64, -(2**70), 0.5, float("nan"),
    float("inf"), 1e308, "", "x", "position", b"bytes", [], [1], [1, 2, 3], [0.0, 0.0, 1.0], (1, "a"),
    [[1, 2], [3]], {}, {"a": 1}, np.int8(3), np.float32(2), np.bool_(True), np.zeros(3), np.zeros((2, 2)),
    np.zeros((3, 3), order="F"), np.array(3), np.array([1, 2, 3], np.uint8), np.array(["a"]),
    np.array([None]), np.datetime64("2020-01-01"), object(), 1j, np.arange(10)[::3],
]  # fmt: skip


def stop(done, total):
    raise LookupError("enough")


def answer(ask):
    """What is answered, or the kind of the exception."""
    try:
        return ask().tolist()
    except EXPECTED as error:
        return type(error)


class Fuzz:
    def __init__(self, ops, seed):
        self.ops = ops
        self.dice = random.Random(seed)
        self.meshes = [self.new_mesh() for _ in range(3)]
        self.live = []
        self.trials = []

    def new_mesh(self):
        make = self.dice.choice(
            [lambda: Mesh.icosphere(1), lambda: Mesh.grid(3, 3, triangles=True), Mesh.cube, Mesh]
        )
        return make()

    def odd(self):
        return self.dice.choice(ODD)

    def number(self, mesh):
        return self.dice.choice([self.odd(), self.dice.randrange(mesh.edges.size + 2)])

    def arguments(self, mesh):
        some = [self.number(mesh) for _ in range(self.dice.choice([0, 1, 1, 1, 2, 3]))]
        names = ["e", "v", "by", "times", "scale", "near", "progress", "seed", "far", "most", "zz"]
        named = {name: self.odd() for name in self.dice.sample(names, self.dice.choice([0, 0, 0, 1, 2]))}
        return some, named

    def call(self):
        """One call; whether it may change the mesh although it raises."""
        dice, mesh = self.dice, self.dice.choice(self.meshes)
        kind = dice.choice(["vertex", "edge", "halfedge", "face", "faces", "x", None])
        name = dice.choice(["flip", "split", "collapse", "move", "shake", "fails", "say", "gain", "along",
                            "frame", "excess", "opposite", "total", "split_some", "count_hits"])  # fmt: skip
        item = self.ops[name]
        some, named = self.arguments(mesh)

        def operate():
            if type(item) is hedgerow.Script:
                # One with large numbers goes on for ever: it is stopped.
                if not callable(named.get("progress")):
                    named["progress"] = stop
            item(dice.choice([mesh] * 9 + [self.odd()]), *some, **named)

        def ask():
            getattr(item, dice.choice(["can", "why", "each"]))(mesh, *some, **named)

        def watch():
            self.live.append((item.live(mesh, *some), item, mesh, some))
            del self.live[:-6]

        def look():
            mask = dice.choice(self.live)[0] if self.live else []
            dice.choice([np.asarray, len, repr, lambda m: m[self.odd()], lambda m: m.pick(self.odd())])(mask)

        def build():
            arrays = [self.odd(), self.odd()]
            if dice.random() < 0.7:
                vertices = np.array([[dice.random() for _ in range(3)] for _ in range(8)])
                faces = [[dice.randrange(-1, 9) for _ in range(dice.choice([2, 3, 3, 4]))] for _ in range(dice.randrange(6))]
                arrays = [vertices, dice.choice([faces, np.asarray(faces, dtype=object)])]
            made = Mesh(*arrays, repair=dice.choice([False, True, 0.1, self.odd()]))
            self.meshes[dice.randrange(3)] = made

        def write():
            table = mesh.elements(kind)
            size = table.size
            values = dice.choice([self.odd(), np.zeros(size), np.arange(size), np.ones((size, 3)), np.ones((size, 2, 2)),
                                  np.full(size, np.nan), np.ones(size, bool)])  # fmt: skip
            table[dice.choice(["a", "b", "hits", "position", "1", self.odd()])] = values

        def read():
            table = mesh.elements(kind)
            getattr(table, dice.choice(["ids", "alive", "size", "next", "halfedge", "vertices", "is_hole", "zz"]))
            table[dice.choice(["a", "b", "hits", self.odd()])]

        def take_away():
            del mesh.elements(kind)[dice.choice(["a", "b", "hits", self.odd()])]

        def place():
            there = np.array(mesh.positions) * dice.choice([1.0, 1.01, float("nan")])
            mesh.positions = dice.choice([there, there[:-1], self.odd()])

        def begin():
            trial = mesh.trial()
            trial.__enter__()
            self.trials.append(trial)

        def end():
            trial = self.trials.pop(dice.randrange(len(self.trials))) if self.trials else mesh.trial()
            dice.choice([trial.keep, trial.undo, lambda: trial.__exit__(None, None, None)])()

        def again():
            data = bytearray(mesh.to_bytes())
            if dice.random() < 0.6:
                data[dice.randrange(len(data))] ^= 1 << dice.randrange(8)
            self.meshes[dice.randrange(3)] = Mesh.from_bytes(bytes(data))

        def program():
            text = "".join(dice.choice(["op ", "script s", "(", ")", "{", "}", " e: edge", "fn f", "before", " -a-> ", "\n"])
                           for _ in range(dice.randrange(12)))  # fmt: skip
            hedgerow.program(dice.choice([text, self.odd()]))

        def others():
            dice.choice([mesh.recycle, mesh.compact, mesh.copy, lambda: pickle.loads(pickle.dumps(item)),
                         lambda: mesh == dice.choice(self.meshes), lambda: mesh.is_same(self.odd(), self.odd()),
                         lambda: Mesh.icosphere(self.odd()), lambda: Mesh.grid(self.odd(), self.odd()),
                         lambda: Mesh.from_bytes(self.odd()), lambda: Mesh.load(str(self.odd())),
                         lambda: mesh.save(self.dice.choice(["/nowhere/x.obj", 3, "/tmp/x.zzz"]))])()  # fmt: skip

        what = dice.choice([operate] * 8 + [ask] * 3 + [watch, look, look, build, write, write, read, take_away,
                                                        place, begin, end, again, program, others, others])  # fmt: skip
        return mesh, what, what is operate and name in ("shake", "fails", "split_some", "move", "say", "count_hits")

    def run(self, calls):
        raised = done = 0
        for at in range(calls):
            mesh, what, may_change = self.call()
            before = mesh.to_bytes()
            try:
                what()
                done += 1
            except EXPECTED as error:
                raised += 1
                assert not isinstance(error, SystemError)
                # The columns of a program come to a mesh where it is used first.
                if not may_change and len(mesh.to_bytes()) == len(before):
                    assert mesh.to_bytes() == before, (at, what.__name__, error)
            if at % 10 == 0:
                for mask, item, mesh, some in self.live:
                    assert answer(lambda: mask.array) == answer(lambda: item.can(mesh, *some)), (at, item)
                for mesh in self.meshes:
                    mesh.check()
                    assert np.isfinite(mesh.vertices).all()
            if mesh.face_count > 600 or not np.isfinite(mesh.vertices).all():
                self.meshes = [self.new_mesh() for _ in range(3)]
                self.trials.clear()
        return done, raised


def test_calls_by_chance(ops, capsys):
    done, raised = Fuzz(ops, SEED).run(CALLS)
    assert done > CALLS // 5 and raised > CALLS // 5
