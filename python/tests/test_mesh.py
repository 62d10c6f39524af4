"""Meshes: arrays in and out, attributes, copies, trials."""

import copy
import pickle

import numpy as np
import pytest

import hedgerow
from hedgerow import Mesh

V = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)
F = np.array([[0, 1, 2], [0, 2, 3]])


@pytest.mark.parametrize("dtype", [np.int8, np.int32, np.int64, np.uint8, np.uint32, np.uint64])
@pytest.mark.parametrize("order", ["C", "F"])
def test_arrays_of_every_kind(dtype, order):
    mesh = Mesh(np.asarray(V, order=order), np.asarray(F, dtype, order=order))
    assert (mesh.vertices == V).all() and (mesh.faces == F).all()
    assert mesh.vertices.dtype == np.float64 and mesh.faces.dtype == np.int64
    for floats in (np.float32, np.float16, np.int32):
        assert (Mesh(np.asarray(V, floats, order=order), F).vertices == V).all()
    wide = np.zeros((8, 6))
    wide[::2, ::2] = V
    assert (Mesh(wide[::2, ::2], F[::-1]).faces == F[::-1]).all()


def test_lists_and_two_coordinates():
    mesh = Mesh(V[:, :2].tolist(), [[0, 1, 2, 3]])
    assert (mesh.vertices == V).all() and mesh.faces.shape == (1, 4)
    mixed = Mesh([*V.tolist(), [2, 0.5, 0]], [[0, 1, 2, 3], (1, 4, 2)])
    assert [face.tolist() for face in mixed.faces] == [[0, 1, 2, 3], [1, 4, 2]]
    assert mixed.hole_count == 1 and repr(mixed) == "<Mesh: 5 vertices, 6 edges, 2 faces, 1 hole>"
    assert repr(Mesh()) == "<Mesh: 0 vertices, 0 edges, 0 faces>"
    assert Mesh(V, []).vertex_count == 4 and Mesh().faces.shape == (0, 3)


def test_going_out_and_in_again(sphere):
    again = Mesh(sphere.vertices, sphere.faces)
    assert again == sphere and again.is_same(sphere)
    cube = Mesh.cube()
    assert cube.faces.shape == (6, 4)
    vertices, faces = cube.arrays()
    vertices += 1
    assert (Mesh(vertices, faces).vertices == cube.vertices + 1).all()


def test_pointers_are_a_halfedge_mesh(sphere):
    h = sphere.halfedges
    ids = np.arange(h.size)
    assert (h.twin[h.twin] == ids).all() and (h.prev[h.next] == ids).all()
    assert (h.vertex[h.next] == h.vertex[h.twin]).all()
    assert (h.edge[h.twin] == h.edge).all() and (h.face[h.next] == h.face).all()
    assert (h.edge[sphere.edges.halfedge] == np.arange(len(sphere.edges))).all()
    assert (h.vertex[sphere.elements("vertex").halfedge] == np.arange(sphere.vertex_count)).all()
    ends = np.stack([h.vertex[sphere.edges.halfedge], h.vertex[h.twin[sphere.edges.halfedge]]], 1)
    assert (sphere.edges.vertices == ends).all()
    assert (h.target == h.vertex[h.twin]).all()
    with pytest.raises(AttributeError, match="a halfedge has no pointer `nxt`"):
        h.nxt
    with pytest.raises(AttributeError, match="an edge has no pointer `nxt`"):
        sphere.edges.nxt
    for array in (h.next, sphere.vertices, sphere.faces, sphere.positions, sphere.edges.alive):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0


def test_faces_and_targets_of_what_is_there(ops):
    mesh = Mesh.grid(3, 3, triangles=True)
    assert ops.collapse(mesh, 12)
    beside, halfedges = mesh.edges.faces, mesh.halfedges
    of_language = hedgerow.program(
        "fn sides(e: edge) -> int { count(e.faces) } fn tip(h: halfedge) -> vertex { h.target }"
    )
    ids = mesh.edges.ids
    assert ((beside >= 0).sum(1)[ids] == of_language.sides(mesh)[ids]).all()
    assert set(beside[beside >= 0]) == set(mesh.face_ids) and (beside[~mesh.edges.alive] == -1).all()
    assert (halfedges.target == of_language.tip(mesh)).all() and (halfedges.target == -1).any()
    assert Mesh().edges.faces.shape == (0, 2) and len(Mesh().halfedges.target) == 0


def test_names_of_other_libraries(sphere):
    for name, plural in {"n_vertices": "vertices", "num_verts": "vertices", "nfaces": "faces", "n_edges": "edges"}.items():
        with pytest.raises(AttributeError, match=rf"no `{name}`: `len\(mesh.{plural}\)` is how many {plural}"):
            getattr(sphere, name)
    with pytest.raises(AttributeError, match="a mesh has no `vertexes`"):
        sphere.vertexes
    assert not hasattr(sphere, "__array__")


def test_numbers_stay(ops, sphere):
    edges, vertices = sphere.edges.size, sphere.vertex_count
    made = ops.split(sphere, 7)
    assert made.result == vertices and made.created.vertices == [vertices]
    gone = ops.collapse(sphere, 20)
    assert gone and len(gone.erased.vertices) == 1
    dead = gone.erased.vertices[0]
    assert not sphere.elements("vertex").alive[dead] and dead not in sphere.elements("vertex")
    assert sphere.elements("vertex").size == vertices + 1 and len(sphere.vertices) == vertices
    assert sphere.vertex_ids.tolist() == [v for v in range(vertices + 1) if v != dead]
    assert (sphere.vertices == sphere.positions[sphere.vertex_ids]).all()
    assert sphere.faces.max() == vertices - 1
    assert sphere.edges.size == edges + 3 and (sphere.halfedges.next[gone.erased.halfedges] == -1).all()
    again = ops.split(sphere, 3)
    assert not set(again.created.edges) & set(gone.erased.edges)
    sphere.recycle()
    last = ops.split(sphere, 9)
    assert set(last.created.edges) & set(gone.erased.edges)


def test_attributes_of_all_types(rng):
    mesh = Mesh.grid(3, 2)
    for kind in ("vertex", "halfedge", "edge", "face"):
        table = mesh.elements(kind)
        for name, shape, word in [
            ("real", (), "real"), ("two", (2,), "vec2"), ("three", (3,), "vec3"),
            ("four", (4,), "vec4"), ("m3", (3, 3), "mat3"), ("m4", (4, 4), "mat4"),
        ]:  # fmt: skip
            values = rng.random((table.size, *shape))
            table[name] = np.asfortranarray(values)
            assert (table[name] == values).all() and table.attributes[name] == word
        table["flag"] = np.arange(table.size) % 2 == 0
        table["number"] = np.arange(table.size, dtype=np.uint16)
        assert table["flag"].dtype == bool and table["number"].dtype == np.int64
        assert "flag" in table and "other" not in table
        del table["flag"]
        assert "flag" not in table
        with pytest.raises(KeyError, match="has an attribute `flag`; there is"):
            table["flag"]
    mesh["uv"] = mesh.vertices[:, :2]
    assert (mesh["uv"] == mesh.vertices[:, :2]).all() and "uv" in mesh
    mesh["uv"] = [1, 2]
    assert (mesh["uv"] == [1, 2]).all()
    # One for each living element will do, too: of faces, those that are no holes.
    size = np.arange(1.0, 1 + len(mesh.elements("face")))
    mesh.elements("face")["part"] = size
    table = mesh.elements("face")
    assert len(size) < table.size and (table["part"][table.ids] == size).all()
    assert (table["part"][table.is_hole] == 0).all()
    with pytest.raises(hedgerow.ArgumentError, match="is of 6 elements .or 7 places"):
        table["part"] = np.arange(5)
    mesh["heat"] = 1.5
    mesh["heat"] = np.arange(mesh.vertex_count)
    assert mesh.elements("vertex").attributes["heat"] == "real"
    del mesh["heat"]


def test_attributes_of_rows(ops, sphere):
    ops.collapse(sphere, 3)
    mixed = Mesh(np.eye(5, 3), [[0, 1, 2, 3], [0, 3, 4]])
    for mesh in (sphere, mixed):
        mesh.faces["label"], mesh.vertices["heat"] = 3, np.arange(mesh.vertex_count)
        faces = mesh.elements("face")
        assert (mesh.faces["label"] == faces["label"]).all() and faces.attributes == {"label": "int"}
        assert mesh.vertices["heat"][mesh.vertex_ids[-1]] == mesh.vertex_count - 1 == mesh["heat"].max()
        assert "label" in mesh.faces and "heat" not in mesh.faces and "heat" in mesh.vertices
        with pytest.raises(KeyError, match="no face has an attribute `none`; there is `label`"):
            mesh.faces["none"]
    # Otherwise they are arrays of numpy, and so is what is computed of them.
    corners = sphere.faces
    assert repr(corners) == repr(np.array(corners)) and type(corners[0]) is type(corners + 1) is np.ndarray
    assert type(corners.max()) is np.int64 and len({corners.max()}) == 1 and corners.mean() > 0
    assert type(pickle.loads(pickle.dumps(corners))) is np.ndarray
    assert (pickle.loads(pickle.dumps(corners)) == corners).all() and corners[0, 1] in corners
    with pytest.raises(ValueError, match="read-only"):
        corners[0] = 0
    assert type(pickle.loads(pickle.dumps(mixed.faces))) is list and len(mixed.faces[0]) == 4
    with pytest.raises(IndexError):
        np.copy(corners, subok=True)["label"]


def test_bools_of_any_byte(ops, sphere):
    sphere.edges["crease"] = np.full(sphere.edges.size, 4, np.uint8).view(bool)
    program = hedgerow.program("attr crease: edge bool fn creased(e: edge) -> bool { e.crease == true }")
    assert program.creased(sphere).all()
    assert sphere.edges["crease"].view(np.uint8).max() == 1
    assert pickle.loads(pickle.dumps(sphere)) == sphere


def test_rows_of_many_polygons():
    vertices, faces = Mesh.grid(30).arrays()
    mixed = Mesh(vertices, [*faces[:-1], faces[-1, :3], faces[-1, [0, 2, 3]]])
    rows = mixed.faces
    assert [row.tolist() for row in rows] == [*faces[:-1].tolist(), *(row.tolist() for row in rows[-2:])]
    assert len(rows[-1]) == 3 and rows[0] is rows[0] and rows[:2][1] is rows[1]


def test_attributes_of_programs(ops, sphere):
    ops.count_hits(sphere)
    ops.count_hits(sphere)
    assert (sphere.edges["hits"] == 2).all() and sphere.edges.attributes == {"hits": "int"}
    sphere.edges["hits"] = np.arange(sphere.edges.size)
    ops.count_hits(sphere)
    assert (sphere.edges["hits"] == np.arange(sphere.edges.size) + 1).all()
    sphere.edges["wrong"] = 1
    del sphere.edges["hits"]
    sphere.edges["hits"] = 0.5
    with pytest.raises(hedgerow.MeshError, match="`hits` is of type real, not int"):
        ops.count_hits(sphere)


def test_positions(sphere):
    where = sphere.positions * 2
    sphere.positions = where
    assert (sphere.positions == where).all()
    sphere.vertices = where[:, ::-1]
    assert (sphere.vertices == where[:, ::-1]).all()
    before = sphere.to_bytes()
    bad = where.copy()
    bad[3, 1] = np.nan
    for wrong in (bad, where[:-1], where[:, :1], "no", where + 1j):
        with pytest.raises(hedgerow.ArgumentError):
            sphere.positions = wrong
        with pytest.raises(hedgerow.ArgumentError):
            sphere.vertices = wrong
    assert sphere.to_bytes() == before


def test_copies_pickles_and_equality(ops, sphere):
    ops.split(sphere, 3)
    ops.collapse(sphere, 30)
    sphere["uv"] = np.ones((sphere.elements("vertex").size, 2))
    copies = [sphere.copy(), copy.copy(sphere), copy.deepcopy(sphere)]
    copies.append(pickle.loads(pickle.dumps(sphere)))
    copies.append(Mesh.from_bytes(sphere.to_bytes()))
    for other in copies:
        assert other == sphere and not other != sphere
        # What comes next has the same numbers.
        mine, theirs = (ops.split(mesh, 40) for mesh in (sphere.copy(), other))
        assert mine.created.edges == theirs.created.edges and other != sphere
    assert sphere != "mesh" and sphere == sphere
    moved = sphere.copy()
    moved.positions = moved.positions + 1e-12
    assert moved != sphere and moved.is_same(sphere, 1e-9)
    with pytest.raises(TypeError):
        hash(sphere)


def test_damaged_pickles_are_refused(sphere):
    data = sphere.to_bytes()
    for bad in (b"", b"nonsense", data[:-1], data + b"\0", data[:100] + b"\1" + data[101:]):
        with pytest.raises(hedgerow.MeshError):
            Mesh.from_bytes(bad)


def test_a_subclass_stays_one(sphere):
    class Mine(Mesh):
        pass

    mine = Mine(sphere.vertices, sphere.faces)
    assert type(mine.copy()) is Mine and type(Mine.cube()) is Mine


class Named(Mesh):
    """A mesh that is made in another way."""

    def __new__(cls, name, mesh):
        return super().__new__(cls, mesh.vertices, mesh.faces)

    def __init__(self, name, mesh):
        self.name = name


def test_a_subclass_may_be_made_of_other_arguments(ops, sphere):
    mesh = Named("ball", sphere)
    assert ops.collapse(mesh, 30)
    for other in (mesh.copy(), copy.copy(mesh), copy.deepcopy(mesh), pickle.loads(pickle.dumps(mesh))):
        assert type(other) is Named and other == mesh and other.name == "ball"
    small, vertices, _ = mesh.compact()
    assert type(small) is Named and small.name == "ball" and (small.vertices == mesh.vertices).all()


def test_trials(ops, sphere):
    before = sphere.to_bytes()
    with sphere.trial():
        assert ops.split(sphere, 4)
        with sphere.trial() as inner:
            ops.move(sphere)
            inner.keep()
        assert sphere.to_bytes() != before
    assert sphere.to_bytes() == before
    with pytest.raises(hedgerow.RunError), sphere.trial():
        ops.fails(sphere)
    assert sphere.to_bytes() == before
    with sphere.trial() as trial:
        ops.split(sphere, 4)
        sphere["x"] = 1.0
        trial.undo()
        assert sphere.to_bytes() == before
        ops.split(sphere, 5)
    assert sphere.to_bytes() != before
    with pytest.raises(hedgerow.RunError, match="has ended"):
        trial.keep()
    outer, inner = sphere.trial(), sphere.trial()
    outer.__enter__(), inner.__enter__()
    outer.keep()
    # A trial that has ended undoes nothing that others have done since.
    others = [sphere.trial() for _ in range(2)]
    for other in others:
        other.__enter__()
    ops.split(sphere, 6)
    before = sphere.to_bytes()
    with pytest.raises(hedgerow.RunError, match="has ended"):
        inner.undo()
    assert sphere.to_bytes() == before
    for other in reversed(others):
        other.keep()
    with sphere.trial() as outer, sphere.trial():
        ops.split(sphere, 7)
        outer.keep()
    assert sphere.to_bytes() != before


def test_compact(ops, sphere, rng):
    sphere["heat"] = rng.random(sphere.vertex_count)
    sphere.edges["crease"] = rng.random(sphere.edges.size)
    sphere.halfedges["uv"] = rng.random((sphere.halfedges.size, 2))
    sphere.elements("face")["group"] = np.arange(sphere.face_count)
    for edge in (3, 50, 70):
        assert ops.collapse(sphere, edge)
    small, vertices, faces = sphere.compact()
    assert small.vertex_count == small.elements("vertex").size == sphere.vertex_count
    assert (small["heat"] == sphere["heat"][vertices]).all()
    assert (small.elements("face")["group"] == sphere.elements("face")["group"][faces]).all()

    def by_ends(mesh, rows, table, name):
        ids = table.ids
        h = ids if table._kind == "halfedge" else table.halfedge[ids]
        start = rows[mesh.halfedges.vertex[h]]
        end = rows[mesh.halfedges.vertex[mesh.halfedges.twin[h]]]
        pairs = zip(start, end) if table._kind == "halfedge" else map(frozenset, zip(start, end))
        return {pair: tuple(np.atleast_1d(table[name][i])) for pair, i in zip(pairs, ids)}

    rows = np.full(sphere.elements("vertex").size, -1)
    rows[vertices] = np.arange(len(vertices))
    straight = np.arange(len(vertices))
    for kind, name in (("edges", "crease"), ("halfedges", "uv")):
        mine = by_ends(sphere, rows, getattr(sphere, kind), name)
        assert by_ends(small, straight, getattr(small, kind), name) == mine


def test_compact_keeps_holes_defaults_and_levels(ops):
    mesh = Mesh.grid(3, triangles=True)
    assert ops.collapse(mesh, 12)
    faces = mesh.elements("face")
    faces["label"] = np.arange(faces.size) + 100
    hole = faces["label"][faces.is_hole]
    small, _, numbers = mesh.compact()
    theirs = small.elements("face")
    assert theirs["label"].tolist() == [*(numbers + 100), *hole] and theirs.is_hole[-1]
    assert small.is_same(mesh) and small.vertices.tolist() == mesh.vertices.tolist()
    text = "attr label: face int = inherited(-1) script mark() { for f in faces { f.label = 7 } }"
    sphere = Mesh.icosphere(1)
    hedgerow.program(text).mark(sphere)
    small = sphere.compact()[0]
    for one in (sphere, small):
        hedgerow.std.subdivide.loop_subdivide(one)
    assert small == sphere
    # Two edges between the same vertices.
    flip = hedgerow.program("""op flip(e: edge) {
      before { face f: a -p-> b -q-> c -r-> a  face g: b -s-> a -t-> d -u-> b  edge e: p | s }
      after { face f: d -p-> c -r-> a -t-> d  face g: c -s-> d -u-> b -q-> c  edge e: p | s }
    }""").flip
    double = Mesh.tetrahedron()
    assert flip(double, 0) and double.level() != "simple"
    double.edges["rank"] = np.arange(6)
    assert double.compact()[0] == double


def test_iterating_while_elements_go(ops, sphere):
    seen, gone = [], set()
    for edge in sphere.edges:
        assert edge not in gone
        seen.append(edge)
        done = ops.collapse(sphere, edge)
        gone.update(done.erased.edges if done else ())
        if len(seen) == 20:
            break
    assert gone and len(set(seen)) == 20


NOT_MESHES = [
    (V, [[0, 1, 4]], "vertex 4"),
    (V, [[0, 1, -1]], "there is no vertex -1"),
    (V, [[0, 1, 2**40]], "there is no vertex"),
    (V, [[0, 1]], "corners"),
    (V, [[0, 1, 1]], "vertex 1"),
    (V, [[0, 1, 2], [0, 1, 3]], "0"),
    ([*V, [0, 0, 1]], [[0, 1, 2], [1, 0, 3], [0, 1, 4]], "0"),
    (V, F.astype(float), "whole numbers"),
    (V, [["a", "b", "c"]], "whole numbers"),
    (V, [0, 1, 2], "faces are rows"),
    (V, np.zeros((2, 3, 3), int), "shape"),
    (V[:, :1], F, "rows of 3 numbers"),
    (V.astype(str), F, "numbers"),
    (V + 1j, F, "numbers"),
    (V.astype(object), F, "numbers"),
    (np.where(V == 1, np.nan, V), F, "not finite"),
    (np.where(V == 1, np.inf, V), F, "not finite"),
    ([[0, 0, 0], [1, 0]], F, "rows of 3 numbers"),
    (V, [[0, 1, 2], [0, 2, "x"]], "whole numbers"),
    (V, [[0, 1, 2.5], [0, 2, 3, 1]], "whole numbers"),
]


@pytest.mark.parametrize("case", range(len(NOT_MESHES)))
def test_what_is_no_mesh(case):
    vertices, faces, words = NOT_MESHES[case]
    with pytest.raises(hedgerow.MeshError, match=words):
        Mesh(vertices, faces)


def test_wrong_attributes(sphere):
    before = sphere.to_bytes()
    n = sphere.vertex_count
    for values in (np.zeros(n + 1), np.zeros((n, 5)), np.zeros((n, 2, 2)), ["a"] * n, [None] * n,
                   np.zeros(n, complex), np.zeros((n - 1, 3)), np.full(n, 2**63, np.uint64), [[1], [2, 3]]):  # fmt: skip
        with pytest.raises(hedgerow.ArgumentError):
            sphere["x"] = values
    for name in ("", "1x", "a b", "position", "file:vertex"):
        with pytest.raises(hedgerow.ArgumentError):
            sphere[name] = 1.0
    with pytest.raises(TypeError):
        sphere[3] = 1.0
    with pytest.raises(KeyError):
        del sphere["x"]
    sphere["x"] = 1.0
    for values in (np.zeros((n, 2)), np.zeros((n, 3))):
        with pytest.raises(hedgerow.MeshError, match="of type real"):
            sphere["x"] = values
    del sphere["x"]
    for values in (10**30, -(10**30), [10**30] * n, 2**63, np.full(n, 2**63, np.uint64)):
        with pytest.raises(hedgerow.ArgumentError, match="the vertex attribute `big` has a value that is too large"):
            sphere["big"] = values
    assert sphere.to_bytes() == before


def test_elements_that_there_are(ops):
    mesh = Mesh.grid(2)
    faces = mesh.elements("face")
    assert [number in faces for number in range(-1, faces.size + 1)].count(True) == len(faces) == 4
    assert all(face in faces for face in faces) and np.flatnonzero(faces.is_hole)[0] not in faces
    assert 2**70 not in mesh.edges and -1 not in mesh.edges
    assert np.int64(1) in mesh.edges
    assert not any(one in mesh.edges for one in (1.0, np.float64(1), None, (1,), [], b"1"))
    asked = []

    def ask(done, total):
        for look in (lambda: 0 in mesh.edges, lambda: list(mesh.edges)):
            with pytest.raises(hedgerow.BusyError):
                look()
        asked.append(done)
        raise LookupError

    with pytest.raises(LookupError):
        ops.forever(mesh, progress=ask)
    assert asked


def test_tables_are_copied(sphere):
    sphere.edges["rank"] = np.arange(sphere.edges.size)
    for table in (copy.copy(sphere.edges), copy.deepcopy(sphere.edges), pickle.loads(pickle.dumps(sphere.edges))):
        assert (table["rank"] == sphere.edges["rank"]).all() and len(table) == len(sphere.edges)


def test_what_python_attaches_goes_along(sphere):
    sphere.tag = [1]
    assert copy.copy(sphere).tag is sphere.copy().tag is sphere.tag
    deep = copy.deepcopy(sphere)
    assert deep.tag == [1] and deep.tag is not sphere.tag and deep == sphere


def test_sizes_out_of_range():
    for make in (lambda: Mesh.icosphere(-1), lambda: Mesh.icosphere(99), lambda: Mesh.grid(2**33, 1)):
        with pytest.raises(ValueError, match="cannot be of sizes"):
            make()


def test_faces_of_every_kind():
    class Rows:
        def __array__(self, dtype=None, copy=None):
            return F

    for faces in (memoryview(F), Rows(), iter(F.tolist()), list(F)):
        assert (Mesh(V, faces).faces == F).all()
    with pytest.raises(hedgerow.MeshError, match="corners"):
        Mesh(V, [[0, 1, 2], []])
    # Lists whose integers are of several types.
    five, unsigned = [*V.tolist(), [2, 0.5, 0]], np.array([0, 1, 2], np.uint64)
    for faces in ([unsigned, np.array([0, 2, 3])], [unsigned, [0, 2, 3]], [[np.uint64(0), 1, np.int8(2)], (0, 2, 3)]):
        assert (Mesh(V, faces).faces == F).all()
    for square in (np.array([0, 1, 2, 3]), [0, 1, 2, 3], (np.uint64(0), 1, 2, 3)):
        ragged = Mesh(five, [square, np.array([1, 4, 2], np.uint64)])
        assert [face.tolist() for face in ragged.faces] == [[0, 1, 2, 3], [1, 4, 2]]
    for faces in ([[True, False, 2], [0, 1, 3, 4]], [[True, False, 2]], [[np.True_, 0, 2]], [(1, False, 2), unsigned],
                  [np.array([True, False, True]), [0, 1, 2, 3]], np.array([[True, False, True]])):  # fmt: skip
        with pytest.raises(hedgerow.MeshError, match="whole numbers, not bool"):
            Mesh(five, faces)
    for faces in ([[2**63, 1, 2]], [[0, 1, 2], np.array([2**63, 1, 2, 3], np.uint64)], [[0, np.uint64(2**63), 1, 2], [0, 1, 2]]):
        with pytest.raises(hedgerow.MeshError, match="corners of faces are too large"):
            Mesh(five, faces)


def test_repair():
    assert Mesh(V / 10, F, repair=np.True_) == Mesh(V / 10, F, repair=True)
    assert Mesh(V, F, repair=np.False_) == Mesh(V, F) and Mesh(V, F, repair=np.float32(0.1)).face_count == 2
    with pytest.raises(TypeError, match="`repair` is a bool or a tolerance, not str"):
        Mesh(V, F, repair="yes")
    soup = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 0], [0, 1, 0], [-1, 0, 0]], float)
    with pytest.raises(hedgerow.MeshError):
        Mesh(soup, [[0, 1, 2], [0, 1, 2]])
    assert Mesh(soup, [[0, 1, 2], [0, 1, 2]], repair=True).face_count == 1
    assert Mesh(soup, [[0, 1, 2], [3, 4, 5]], repair=0.0).edge_count == 5
    for wrong in (-1.0, float("nan")):
        with pytest.raises(hedgerow.ArgumentError):
            Mesh(soup, [[0, 1, 2]], repair=wrong)


def test_attributes_are_deleted_from_rows(sphere):
    sphere["heat"], sphere.faces["label"], sphere.edges["crease"] = 1.0, 3, True
    del sphere.faces["label"], sphere.vertices["heat"], sphere.edges["crease"]
    assert "label" not in sphere.faces and "heat" not in sphere and sphere.edges.attributes == {}
    with pytest.raises(KeyError, match="no face has an attribute `label`"):
        del sphere.faces["label"]
    with pytest.raises(ValueError):
        del sphere.faces[0]
    mixed = Mesh([*V.tolist(), [2, 0.5, 0]], [[0, 1, 2, 3], (1, 4, 2)])
    mixed.faces["label"] = 3
    del mixed.faces["label"]
    assert mixed.elements("face").attributes == {}
