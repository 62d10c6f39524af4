"""The planar actions against a table of verdicts, meshes and scores of a reference implementation,
through the package. The plain actions must agree to the letter."""

import gzip
import json
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

import hedgerow
from hedgerow import Mesh

TABLE = Path(__file__).parents[2] / "tests" / "run" / "data" / "planar_actions.json.gz"
pytestmark = pytest.mark.skipif(not TABLE.exists(), reason="the table lies in the repository")


@pytest.fixture(scope="module")
def table():
    with gzip.open(TABLE) as file:
        return json.load(file)


def actions(kind):
    std = hedgerow.std
    return {"tri": std.planar_triangle, "quad": std.planar_quad}[kind]


def halfedges(mesh):
    """The halfedges by their ends."""
    h = mesh.halfedges
    ids = h.ids
    ends = zip(h.vertex[ids].tolist(), h.vertex[h.twin[ids]].tolist())
    return dict(zip(ends, ids.tolist()))


def place(op, mesh, ends):
    halfedge = halfedges(mesh)[tuple(ends)]
    on_edges = op.parameters[0].type == "edge"
    return int(mesh.halfedges.edge[halfedge]) if on_edges else halfedge


def cycles(faces):
    """Faces from their least corner on, in order."""
    rolled = ([int(c) for c in np.roll(face, -int(np.argmin(face)))] for face in faces)
    return sorted(rolled)


def expect(mesh, after, scores, name):
    living = {at: node for at, node in enumerate(after["nodes"]) if node is not None}
    ids = mesh.vertex_ids.tolist()
    assert sorted(living) == ids, name
    there = np.array([living[v] for v in ids])
    assert np.abs(mesh.positions[ids][:, :2] - there).max() < 1e-10, name
    faces = [[ids[row] for row in face] for face in mesh.faces]
    assert cycles(faces) == after["faces"], name
    assert mesh["score"][ids].tolist() == [scores[v] for v in ids], name


def right_scores(case):
    return case.get("recomputed_scores") or case["stored_scores"]


def test_single_actions_agree(table):
    meshes = []
    for value in table["meshes"]:
        mesh = Mesh(np.array(value["nodes"]), value["faces"])
        actions(value["kind"]).measure(mesh)
        assert mesh["ideal"].tolist() == value["ideal"] and mesh["score"].tolist() == value["scores"]
        meshes.append((value["kind"], mesh))
    counted = Counter()
    can = {}
    for case in table["cases"]:
        result = case["result"]
        if result == "exception" or case.get("defects"):
            continue
        kind, original = meshes[case["mesh"]]
        op = actions(kind)[case["op"]]
        name = f"mesh {case['mesh']}: {case['op']} {case['edge']}"
        at = place(op, original, case["edge"])
        key = case["mesh"], case["op"]
        if key not in can:
            can[key] = op.can(original)
        assert can[key][at] == (result == "done"), name
        mesh = original.copy()
        done = op(mesh, at)
        assert bool(done) == (result == "done"), name
        if done:
            expect(mesh, case["after"], right_scores(case), name)
        else:
            assert mesh == original
        counted[kind, case["op"]] += 1
    assert sum(counted.values()) == 1412 and len(counted) == 7


def test_sequences_agree(table):
    steps = 0
    for number, sequence in enumerate(table["sequences"]):
        mesh = Mesh(np.array(sequence["nodes"]), sequence["faces"])
        ops = actions(sequence["kind"])
        ops.measure(mesh)
        live = {name: ops[name].live(mesh) for name in ("flip", "split", "collapse")}
        for op, start, end, result, *_ in sequence["steps"]:
            name = f"sequence {number}: {op} {start}-{end}"
            at = place(ops[op], mesh, (start, end))
            assert live[op][at] == (result == "done"), name
            assert bool(ops[op](mesh, at)) == (result == "done"), name
            mesh.recycle()
            steps += 1
        expect(mesh, sequence["final"], right_scores(sequence["final"]), f"sequence {number}")
    assert steps == 800


def test_a_row_goes_only_where_the_outline_is_straight():
    cleanup, measure = hedgerow.std.planar_cleanup.cleanup, hedgerow.std.planar_cleanup.measure
    for bend in (0.4, 1e-2, 1e-5, -1e-5, 0.0):
        mesh = Mesh.grid(2)
        positions = np.array(mesh.positions)
        below = int(np.flatnonzero((positions[:, 0] == 1) & (positions[:, 1] == 0))[0])
        positions[below] = [1, -bend, 0]
        mesh.positions = positions
        measure(mesh)
        assert mesh["ideal"][below] == 3
        h = mesh.halfedges
        ends = h.ids[(h.vertex[h.ids] == below) & mesh.elements("face").is_hole[h.face[h.twin[h.ids]]]]
        for end in ends:
            reason = cleanup.why(mesh, end)
            assert reason == (None if bend == 0 else "a corner of the boundary would go")
        gone = 0
        for halfedge in h.ids:
            other = mesh.copy()
            gone += bool(cleanup(other, halfedge))
            assert other.area == pytest.approx(mesh.area, abs=1e-12)
        assert gone


def test_a_slanted_outline_is_straight():
    turn = np.array([[np.cos(0.7), np.sin(0.7), 0], [-np.sin(0.7), np.cos(0.7), 0], [0, 0, 1]])
    for scale in (1e-3, 1, 1e6):
        mesh = Mesh.grid(7, 3)
        mesh.positions = scale * (mesh.positions + [1 / 3, 0.1, 0]) @ turn
        hedgerow.std.planar_cleanup.measure(mesh)
        while mesh.face_count > 1:
            can = hedgerow.std.planar_cleanup.cleanup.can(mesh)
            assert hedgerow.std.planar_cleanup.cleanup(mesh, can.argmax())
        assert mesh.area == pytest.approx(21 * scale**2)
