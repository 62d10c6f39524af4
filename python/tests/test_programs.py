"""Programs, operations, scripts and functions as Python has them."""

import copy
import gc
import importlib.metadata
import inspect
import pickle
import pydoc
import re
import signal
import threading
import time
import weakref
from pathlib import Path

import numpy as np
import pytest

import hedgerow
from hedgerow import Applied, Elements, Mesh, Refused

BROKEN = "op flip(e: edge) { before { edge e: a | d } after { } }"


def test_a_program_is_its_items(ops, tmp_path):
    assert {"flip", "move", "excess", "split"} <= set(dir(ops))
    assert ops.move is ops.move is ops["move"] and "move" in ops and "none" not in ops
    assert ops.scripts[:2] == ["move", "shake"] and "flip" in ops.ops and "gain" in ops.functions
    with pytest.raises(AttributeError, match="no operation, script or function `flp`; did you mean `flip`"):
        ops.flp
    with pytest.raises(KeyError):
        ops["none"]
    path = tmp_path / "ops.hedge"
    path.write_text("/// Says it.\nscript hello() { print \"hello\" }")
    assert hedgerow.load(path).hello.__doc__.endswith("\n\nSays it.")
    assert hedgerow.load("std/remesh.hedge").remesh.__name__ == "remesh"
    assert hedgerow.std.remesh is hedgerow.std.remesh
    with pytest.raises(AttributeError, match="the library has no file"):
        hedgerow.std.none


def test_signatures_and_docs(ops):
    assert str(inspect.signature(ops.move)).startswith("(mesh, /, by: 'vec3' = vec3(0, 0, 1), times: int = 1, *")
    assert list(inspect.signature(ops.flip).parameters) == ["mesh", "e"]
    assert inspect.signature(ops.gain).return_annotation is float
    by, times = ops.move.parameters
    assert (by.name, by.type, by.default, str(times)) == ("by", "vec3", "vec3(0, 0, 1)", "times: int = 1")
    assert ops.flip.parameters[0].default is None and ops.flip.parameters == ops.split.parameters[:1]
    match times:
        case hedgerow.Parameter(name, type="int"):
            assert name == "times"
        case _:
            raise AssertionError(times)
    signature, blank, docs = inspect.getdoc(ops.move).splitlines()
    assert signature == f"move{inspect.signature(ops.move)}" and (blank, docs) == ("", "Moves all vertices.")
    assert ops.total.__doc__ == "total(mesh, /) -> float"
    assert "flip(mesh, /, e: int)" in pydoc.render_doc(ops.flip)
    assert "corner" in ops.flip.__doc__ and "neighbours" in ops.excess.__doc__
    assert ops.split.result == "vertex" and ops.flip.result is None and ops.flip.level == "simple"


def test_examples_of_the_readme_run():
    pytest.importorskip("gymnasium")
    readme = importlib.metadata.metadata("hedgerow").get_payload()
    examples, names = re.findall(r"```python\n(.*?)```", readme, re.DOTALL), {}
    assert len(examples) > 2
    for example in examples:
        exec(example, names)
    top = names["cube"].vertices[:, 2] > 0.9
    # Four corners, the middles of four edges and of the face: creases keep the outline.
    assert top.sum() == 9 and np.abs(names["cube"].vertices[top]).max() == 1


def test_errors_carry_what_was_rendered():
    with pytest.raises(hedgerow.ProgramError) as caught:
        hedgerow.program(BROKEN, "broken.hedge")
    error = caught.value
    assert "broken.hedge:1:" in str(error) and error.code and error.diagnostics
    first = error.diagnostics[0]
    assert first["file"] == "broken.hedge" and first["line"] == 1 and first["severity"] == "error"
    assert isinstance(pickle.loads(pickle.dumps(error)), hedgerow.ProgramError)
    assert pickle.loads(pickle.dumps(error)).diagnostics == error.diagnostics
    assert hedgerow.check(BROKEN, "broken.hedge") == error.diagnostics
    assert hedgerow.check("script s() { }") == []
    with pytest.raises(hedgerow.FileError, match="none.hedge"):
        hedgerow.load("none.hedge")
    with pytest.raises(TypeError, match="`load` reads files"):
        hedgerow.program(b"script s() {}")
    with pytest.raises(TypeError, match="checks a file"):
        hedgerow.check(Path("broken.hedge"))
    with pytest.raises(hedgerow.ArgumentError, match="`broken.hedge` is a path, .* checks a file"):
        hedgerow.check("broken.hedge")
    with pytest.raises(hedgerow.ArgumentError, match="`a/broken.hedge` is a path, .* `load` reads files"):
        hedgerow.program("a/broken.hedge")
    assert hedgerow.check("// see ops.hedge") == []


def test_programs_that_cannot_be_read(tmp_path):
    (tmp_path / "folder.hedge").mkdir()
    (tmp_path / "bytes.hedge").write_bytes(b"\xff\xfe op")
    for name, error in (("folder", "FileError"), ("bytes", "FileError"), ("none", "MissingFileError")):
        path = tmp_path / f"{name}.hedge"
        (tmp_path / "uses.hedge").write_text(f'use "{name}.hedge"')
        for load in (lambda: hedgerow.load(path), lambda: hedgerow.load(tmp_path / "uses.hedge")):
            with pytest.raises(hedgerow.FileError, match=name) as caught:
                load()
            assert type(caught.value).__name__ == error
            assert isinstance(caught.value, FileNotFoundError) == (name == "none")
    with pytest.raises(FileNotFoundError):
        hedgerow.program('use "std/nothing.hedge"')


def test_meshes_are_no_programs():
    for name in ("bunny.obj", "bunny.PLY", "bunny.halfedges"):
        with pytest.raises(hedgerow.FileError, match=f"`{name}` is a mesh, not a program: `Mesh.load`"):
            hedgerow.load(name)


def test_applied_and_refused(ops, sphere):
    done = ops.split(sphere, 3)
    assert isinstance(done, Applied) and done and done.result == 42
    assert done.created.vertices == [42] and len(done.created.edges) == 3 and not len(done.erased)
    flat = Mesh.grid(1, 1, triangles=True)
    before = flat.to_bytes()
    no = ops.flip(flat, 0)
    assert isinstance(no, Refused) and not no and str(no) == no.reason == ops.flip.reasons[no.number]
    assert no == ops.flip(flat, 0) and flat.to_bytes() == before
    match done:
        case Applied(result=v):
            assert v == 42
    match no:
        case Refused(reason):
            assert "hole" in reason
    assert ops.split(sphere, e=np.int32(5)) and ops.split(sphere, e=np.uint64(6))


def test_questions_write_nothing(ops):
    mesh = Mesh.grid(3, 3, triangles=True)
    before = mesh.to_bytes()
    can, why = ops.flip.can(mesh), ops.flip.why(mesh)
    assert can.dtype == bool and len(can) == mesh.edges.size and 0 < can.sum() < len(can)
    assert ((why == -1) == can).all()
    for edge in range(len(can)):
        assert ops.flip.can(mesh, edge) == can[edge]
        reason = ops.flip.why(mesh, edge)
        assert (reason is None) == can[edge]
        if reason is not None:
            assert ops.flip.reasons[why[edge]] == reason
    assert mesh.to_bytes() == before
    ops.collapse(mesh, 12)
    dead = ~mesh.edges.alive
    assert dead.any() and (ops.flip.why(mesh)[dead] == -2).all() and not ops.flip.can(mesh)[dead].any()


def test_functions(ops, sphere):
    degrees = np.bincount(sphere.faces.ravel())
    assert (ops.excess(sphere) == degrees - 6).all() and ops.excess(sphere, 3) == degrees[3] - 6
    ends = sphere.edges.vertices
    assert (ops.gain(sphere) == (degrees - 6)[ends].sum(1)).all()
    assert (ops.gain(sphere, scale=2) == 2 * ops.gain(sphere)).all()
    along = sphere.positions[ends[:, 1]] - sphere.positions[ends[:, 0]]
    assert np.allclose(ops.along(sphere), along) and np.allclose(ops.along(sphere, 5), along[5])
    lengths = np.linalg.norm(along, axis=1)
    assert ops.total(sphere) == pytest.approx(lengths.sum())
    frame = ops.frame(sphere, 2)
    assert frame[:, 0].tolist() == [1, 2, 3] and frame[2, 2] == sphere.positions[2, 0]
    assert (ops.frame(sphere)[2] == frame).all()
    assert (ops.opposite(sphere) == sphere.halfedges.vertex[sphere.halfedges.prev[sphere.edges.halfedge]]).all()
    assert ops.word(sphere, 3) == "positive"
    assert ops.split_some(sphere, 4) == 4 and sphere.vertex_count == 46
    ops.collapse(sphere, 20)
    assert np.isnan(ops.gain(sphere)[~sphere.edges.alive]).all()


def test_scripts(ops, sphere, capsys):
    ops.say(sphere, 1)
    assert capsys.readouterr().out == "hello\n80 faces\n"
    before = sphere.positions
    report = ops.move(sphere, [0, 1, 0], times=3)
    assert report == {} and np.allclose(sphere.positions - before, [0, 3, 0])
    ops.move(sphere, np.array([0, -3, 0]))
    assert np.allclose(sphere.positions, before)
    report = hedgerow.std.remesh.remesh(sphere, target=0.3)
    assert report["split"].applied > 0 and report.applied >= report["split"].applied
    assert "split" in str(report) and sum(report["flip"].refused.values()) <= report.refused
    assert pickle.loads(pickle.dumps(report)) == report


def test_a_script_takes_elements(sphere):
    text = "script lift(v: vertex, by: real = 1) { v.position = v.position + vec3(0, 0, by) }"
    lift = hedgerow.program(text).lift
    before = sphere.positions
    lift(sphere, 3)
    lift(sphere, v=4, by=2)
    moved = sphere.positions - before
    assert np.allclose(moved[[3, 4], 2], [1, 2]) and np.count_nonzero(moved) == 2
    for wrong in (10**6, -1, 1.5, "a", None):
        with pytest.raises((hedgerow.ArgumentError, TypeError, ValueError)):
            lift(sphere, wrong)
    assert np.array_equal(sphere.positions - before, moved)


def test_seeds(ops, sphere):
    def shaken(seed):
        mesh = sphere.copy()
        ops.shake(mesh, 0.1, seed=seed)
        return mesh

    assert shaken(3) == shaken(3) != shaken(4)
    mesh = sphere.copy()
    ops.shake(mesh, 0.1)
    ops.shake(mesh, 0.1)
    with pytest.raises(ValueError):
        shaken(-1)
    with pytest.raises(TypeError):
        shaken("a")


def test_random_numbers_of_a_copy_go_on(sphere):
    text = "fn draw() -> real {{ random() }} script skip() {{ let _x = random() }} // {}"
    one, other = (hedgerow.program(text.format(name)) for name in ("one", "other"))
    fresh = Mesh.cube()
    assert one.draw(fresh) == other.draw(Mesh.cube())
    one.skip(sphere, seed=None)
    assert one.draw(sphere) == one.draw(fresh) != one.draw(Mesh.cube())
    one.skip(sphere, seed=7)
    copies = [sphere.copy(), copy.copy(sphere), copy.deepcopy(sphere), sphere.copy().copy()]
    assert len({one.draw(mesh) for mesh in [sphere, *copies]}) == 1
    # Of each program, also of those that are not in use, and of one that has not been.
    assert len({other.draw(mesh) for mesh in [sphere, *copies]}) == 1
    assert one.draw(sphere) != one.draw(sphere) != one.draw(copies[0])
    third = hedgerow.program(text.format("third"))
    assert len({third.draw(mesh) for mesh in [sphere.copy(), sphere, *copies]}) == 1
    assert third.draw(Mesh.cube()) == one.draw(Mesh.cube())
    assert one.draw(pickle.loads(pickle.dumps(sphere))) == one.draw(Mesh.cube())


def test_a_script_that_fails(ops, sphere):
    before = sphere.positions
    with pytest.raises(hedgerow.RunError, match="there are faces") as caught:
        ops.fails(sphere)
    assert caught.value.code == "assertion-failed" and caught.value.report is not None
    assert (sphere.positions == 2 * before).all()


def test_wrong_arguments_leave_the_mesh(ops, sphere):
    before = sphere.to_bytes()
    wrong = [
        (ops.flip, (10**6,), {}), (ops.flip, (-1,), {}), (ops.flip, (2**70,), {}),
        (ops.flip, (1.5,), {}), (ops.flip, ("a",), {}), (ops.flip, (None,), {}),
        (ops.flip, (True,), {}), (ops.flip, (1, 2), {}), (ops.flip, (1,), {"e": 2}),
        (ops.flip, (), {}), (ops.flip, (1,), {"f": 2}), (ops.flip, ([1],), {}),
        (ops.move, ([1, 2],), {}), (ops.move, ([1, 2, "x"],), {}), (ops.move, ("abc",), {}),
        (ops.move, ([1, 2, float("nan")],), {}), (ops.move, (), {"times": 1.5}),
        (ops.move, (), {"times": True}), (ops.move, (), {"times": 2**80}),
        (ops.move, (), {"progress": 3}), (ops.move, (), {"tims": 3}),
        (ops.move, ([1, "x", 10**400],), {}),
        (ops.shake, (float("inf"),), {}), (ops.shake, ("1",), {}), (ops.shake, (), {}),
        (ops.say, ("a",), {}), (ops.say, (1, 2), {}),
        (ops.gain, (1, 2, 3), {}), (ops.total, (1,), {}), (ops.word, (), {}),
        (ops.flip.can, ("a",), {}), (ops.flip.why, (10**6,), {}), (ops.flip.live, (3,), {}),
        (ops.flip.each, ([1, 10**6],), {}), (ops.flip.each, ([-1],), {}),
        (ops.flip.each, (["a"],), {}), (ops.flip.each, ([1.5],), {}), (ops.flip.each, (), {}),
    ]  # fmt: skip
    for call, args, kwargs in wrong:
        with pytest.raises((hedgerow.ArgumentError, TypeError, ValueError)) as caught:
            call(sphere, *args, **kwargs)
        assert str(caught.value), call
    for call in (ops.flip, ops.move, ops.gain, ops.flip.can, ops.flip.live):
        for mesh in (None, 3, "mesh", object()):
            with pytest.raises(TypeError):
                call(mesh)
    assert sphere.to_bytes() == before


def test_numbers_that_are_too_large_are_told(ops, sphere):
    too_large = [
        (ops.shake, (10**400,), {}, "`.*` is too large"), (ops.move, ([1, -(10**400), 2],), {}, "`.*` is too large"),
        (ops.move, (), {"times": 2**80}, "`times` is too large"),
        (ops.flip, (10**30,), {}, "`e` is no edge of the mesh"),
        (ops.flip.each, ([1, 10**30],), {}, f"there is no edge {10**30}"),
        (ops.flip.each, ([2**63],), {}, f"there is no edge {2**63}"),
    ]  # fmt: skip
    for call, args, kwargs, message in too_large:
        with pytest.raises(hedgerow.ArgumentError, match=message) as caught:
            call(sphere, *args, **kwargs)
        assert caught.value.code == "wrong-argument"


def test_what_is_refused_adds_no_attribute():
    program = hedgerow.program("""
      attr w: vertex real = 0.25
      attr other: vertex int = 1
      fn bump(v: vertex) -> int { v.w = v.w + 1 v.other = 2 1 }
      fn shrink(v: vertex, n: int) { v.w = v.w - n }
      script grow(n: int) { for v in vertices { v.w = v.w + n } }
      script both() { for v in vertices { v.w = 1.0 v.other = 1 } }
    """)
    mesh = Mesh.cube()
    before, other = mesh.to_bytes(), mesh.copy()
    calls = [
        lambda: program.bump(mesh), lambda: program.bump(mesh, 99), lambda: program.bump(mesh, 0, 1),
        lambda: program.shrink(mesh, 0), lambda: program.shrink(mesh), lambda: program.shrink(mesh, 8, 1),
        lambda: program.grow(mesh), lambda: program.grow(mesh, 1, 2), lambda: program.grow(mesh, m=1),
    ]  # fmt: skip
    for call in calls:
        with pytest.raises(hedgerow.ArgumentError):
            call()
        assert mesh == other and mesh.to_bytes() == before
    mesh["other"] = 0.5
    before = mesh.to_bytes()
    with pytest.raises(hedgerow.MeshError, match="`other`"):
        program.both(mesh)
    assert mesh.to_bytes() == before
    assert program.bump(Mesh.cube(), 0) == 1 and program.grow(mesh, 1) == {} and (mesh["w"] == 1.25).all()


@pytest.mark.parametrize("default", ["1", "inherited(1)"])
def test_new_elements_have_the_default_of_the_program(default):
    program = hedgerow.program(f"""
      use "std/triangle.hedge"
      attr q: face int = {default}
      script split_some() {{ for e in edges {{ split(e) }} }}
      script look() {{ print "nothing" }}
    """)
    new = 5 if "inherited" in default else 1
    for split in (lambda mesh: program.split(mesh, 3), lambda mesh: program.split_some(mesh),
                  lambda mesh: program.split.each(mesh, [3])):  # fmt: skip
        mesh = Mesh.icosphere(1)
        mesh.faces["q"] = 5
        split(mesh)
        faces = mesh.faces["q"]
        assert (faces[:80] == 5).all() and (faces[80:] == new).all() and len(faces) > 80
    # Also if the mesh gets the attribute later.
    mesh = Mesh.icosphere(1)
    mesh.faces["q"] = 5
    del mesh.faces["q"]
    assert program.split(mesh, 3)
    mesh.faces["q"] = 5
    made = program.split(mesh, 5).created.faces
    assert made and (mesh.faces["q"][made] == new).all()


def test_a_default_that_nothing_uses_makes_no_attribute():
    program = hedgerow.program('use "std/triangle.hedge" attr q: face int = 1 script look() { print "" }')
    mesh = Mesh.icosphere(1)
    assert program.split(mesh, 3) and "q" not in mesh.faces
    # One of another type is another attribute.
    mesh.faces["q"] = 0.5
    made = program.split(mesh, 5).created.faces
    assert mesh.elements("face").attributes == {"q": "real"} and (mesh.faces["q"][made] == 0).all()
    # Questions, refusals, and what only looks leave the default as it was.
    for call in (lambda mesh: program.split.can(mesh), lambda mesh: program.look(mesh),
                 lambda mesh: program.flip(mesh, 0), lambda mesh: program.split.why(mesh, 0)):  # fmt: skip
        mesh = Mesh.grid(1, triangles=True)
        mesh.faces["q"] = 5
        before = mesh.to_bytes()
        call(mesh)
        assert mesh.to_bytes() == before


def test_erased_elements(ops, sphere):
    gone = ops.collapse(sphere, 20).erased.edges
    before = sphere.to_bytes()
    for call in (ops.flip, ops.flip.can, ops.flip.why, ops.gain):
        with pytest.raises(hedgerow.ArgumentError, match="no edge of the mesh"):
            call(sphere, gone[0])
    assert not ops.flip.each(sphere, gone).any() and sphere.to_bytes() == before


def test_a_mesh_below_the_level(ops):
    # Two triangles back to back with two edges between the same vertices.
    pillow = Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 1]])
    before = pillow.to_bytes()
    for call in (ops.flip, ops.flip.can, ops.flip.why):
        try:
            call(pillow, 0)
        except hedgerow.MeshError as error:
            assert error.code == "below-level"
    assert pillow.to_bytes() == before


def test_each(ops, sphere, rng):
    one_by_one, at_once = sphere.copy(), sphere.copy()
    edges = rng.integers(0, sphere.edges.size, 200)
    slow = [bool(ops.flip(one_by_one, e)) for e in edges]
    assert ops.flip.each(at_once, edges).tolist() == slow and at_once == one_by_one
    assert ops.flip.each(at_once, np.asarray(edges[:5], np.int32)).shape == (5,)
    assert ops.flip.each(at_once, []).shape == (0,)
    # Also at those of a mask.
    masked, numbered = sphere.copy(), sphere.copy()
    mask, live = ops.flip.can(sphere) & (np.arange(sphere.edges.size) % 3 == 0), ops.flip.live(masked)
    assert (ops.flip.each(masked, mask) == ops.flip.each(numbered, np.flatnonzero(mask))).all()
    assert masked == numbered
    assert (ops.flip.each(masked, live) == ops.flip.each(numbered, ops.flip.can(numbered))).all()
    with pytest.raises(hedgerow.ArgumentError, match="a mask of elements has 120 places, not 3"):
        ops.flip.each(sphere, [True, False, True])


def test_each_that_stops_tells_where_it_was_applied():
    program = hedgerow.program("""
      use "std/triangle.hedge"
      attr gate: edge int = 1
      op pick(e: edge) {
        steps {
          let _x = 10 div e.gate
          must flip(e)
        }
      }
      fn wreck() {
        for e in edges { flip(e) }
        assert false
      }
    """)
    mesh = Mesh.icosphere(1)
    mesh.edges["gate"] = np.where(mesh.edges.ids == 60, 0, 1)
    before = mesh.copy()
    edges = np.arange(50, 70)
    with pytest.raises(hedgerow.RunError) as caught:
        program.pick.each(mesh, edges)
    applied = caught.value.applied
    assert applied.dtype == bool and len(applied) == 20 and applied[:10].any() and not applied[10:].any()
    assert (pickle.loads(pickle.dumps(caught.value)).applied == applied).all()
    other = before.copy()
    assert (program.pick.each(other, edges[:10]) == applied[:10]).all() and other == mesh != before
    with pytest.raises(hedgerow.RunError) as caught, mesh.trial():
        program.wreck(mesh)
    assert caught.value.applied is None and mesh == other
    # Also of a signal.
    text = "op o(e: edge) { steps { while is_slow(e) { let _x = 1 } } } fn is_slow(e: edge) -> bool { degree(e.halfedge.vertex) == 6 }"
    slow = hedgerow.program(text).o
    threading.Timer(0.2, signal.raise_signal, (signal.SIGINT,)).start()
    with pytest.raises(KeyboardInterrupt) as caught:
        slow.each(mesh, mesh.edges.ids)
    assert len(caught.value.applied) == len(mesh.edges.ids) and not caught.value.applied.all()


def test_live_masks(ops, rng):
    mesh = Mesh.grid(6, 6, triangles=True)
    actions = [ops.flip, ops.split, ops.collapse]
    live = [op.live(mesh) for op in actions]
    applied = 0
    for _ in range(150):
        at = rng.integers(3)
        edge = live[at].pick(rng.random())
        if edge is None:
            continue
        assert live[at][edge]
        done = actions[at](mesh, edge)
        applied += bool(done)
        for op, mask in zip(actions, live):
            fresh = op.can(mesh)
            assert (mask.array == fresh).all() and (op.can(mesh, near=done) == fresh).all()
            assert mask.count() == fresh.sum() and mask.numbers().tolist() == np.flatnonzero(fresh).tolist()
    assert applied > 100
    before = live[0].array
    other = rng.random(len(before)) < 0.5
    assert (live[0].sum(), live[0].any(), live[0].all()) == (before.sum(), before.any(), before.all())
    assert (live[0] & other).tolist() == (other & live[0]).tolist() == (before & other).tolist()
    assert (live[0] | other).tolist() == (other | live[0]).tolist() == (before | other).tolist()
    assert (~live[0]).tolist() == (~before).tolist() and (live[0] & live[0]).tolist() == before.tolist()
    assert (live[0] ^ other).tolist() == (other ^ live[0]).tolist() == (before ^ other).tolist()
    assert not (live[0] ^ live[0]).any() and (True ^ live[0]).tolist() == (~before).tolist()
    with mesh.trial():
        ops.flip(mesh, live[0].pick(0.5))
        assert len(live[0]) == len(before)
    assert (live[0].array == before).all()
    ops.move(mesh)
    mesh.positions = mesh.positions * 2
    assert (np.asarray(live[0]) == ops.flip.can(mesh)).all()
    for number in (10**6, -1, 2**70):
        with pytest.raises(IndexError, match=f"no element {number}"):
            live[0][number]


@pytest.mark.parametrize("reduce", [np.sum, np.any, np.all, np.count_nonzero, np.mean])
def test_numpy_reduces_a_live_mask_as_an_array(ops, reduce):
    live = ops.flip.live(Mesh.grid(2, triangles=True))
    array = live.array
    for given in ({}, {"axis": None}, {"axis": 0}, {"keepdims": True}, {"axis": 0, "keepdims": True}):
        assert np.array_equal(reduce(live, **given), reduce(array, **given)), given
    with pytest.raises(np.exceptions.AxisError if hasattr(np, "exceptions") else np.AxisError):
        reduce(live, axis=1)


def test_methods_of_a_live_mask_take_what_numpy_gives(ops):
    live = ops.flip.live(Mesh.grid(2, triangles=True))
    array, out = live.array, np.zeros((), np.int64)
    assert np.sum(live, dtype=np.float32).dtype == np.float32 and type(live.sum()) is int
    assert np.sum(live, out=out) is out and out == array.sum() == live.sum(None, None, None)
    assert np.sum(live, where=~array) == 0 and live.any(axis=None, out=None) is True
    with pytest.raises(TypeError):
        live.sum(axes=0)


def test_a_live_mask_is_compared_as_an_array(ops):
    mesh = Mesh.grid(2, triangles=True)
    live = ops.flip.live(mesh)
    array = live.array
    for other in (True, False, array, ~array, live, ops.collapse.live(mesh), None):
        assert ((live == other) == (array == other)).all() and ((live != other) == (array != other)).all()
        assert ((other == live) == (array == other)).all() and (live == other).shape == array.shape
    for truth in (bool, lambda live: not live, lambda live: live and live):
        with pytest.raises(ValueError, match=r"`\.any\(\)` or `\.all\(\)`"):
            truth(live)
    assert live.any() and not live.all()
    with pytest.raises(TypeError):
        hash(live)


def test_picks_of_a_live_mask(ops, rng):
    mesh = Mesh.grid(20, 20, triangles=True)
    live = ops.flip.live(mesh)
    for _ in range(5):
        numbers = live.numbers()
        shares = (np.arange(len(numbers)) + 0.5) / len(numbers)
        assert [live.pick(share) for share in shares] == numbers.tolist()
        ops.flip(mesh, rng.choice(numbers))
    with mesh.trial():
        ops.split(mesh, 7)
        assert live.count() == len(live.numbers())
    assert live.count() == ops.flip.can(mesh).sum() and ops.flip.live(Mesh()).pick(0.5) is None
    assert live.pick(0) == live.numbers()[0] and live.pick(np.nextafter(1, 0)) == live.numbers()[-1]
    for share in (1, 7.0, -3.0, -1e-9, float("nan"), float("inf")):
        with pytest.raises(hedgerow.ArgumentError, match="`share` is a number from 0 and below 1, not "):
            live.pick(share)


def test_asking_leaves_the_mesh_as_it_was():
    flip, mesh = hedgerow.std.planar_triangle.flip, Mesh.grid(3, 3, triangles=True)
    before, other = mesh.to_bytes(), mesh.copy()
    live = flip.live(mesh)
    for ask in (lambda: flip.can(mesh, 0), lambda: flip.why(mesh, 0), lambda: flip.can(mesh), live.count):
        ask()
        assert mesh == other and mesh.elements("vertex").attributes == {} and mesh.to_bytes() == before
    # Nor does it tell what new elements have.
    labelled = hedgerow.program('use "std/polygon.hedge" attr label: face int = inherited(7)')
    made = []
    for asks in (False, True):
        mesh = Mesh.cube()
        mesh.faces["label"] = np.arange(6)
        if asks:
            labelled.split.can(mesh, 5)
            live = labelled.split.live(mesh)
        hedgerow.std.polygon.split(mesh, 5)
        if asks:
            assert (live.array == labelled.split.can(mesh)).all()
        made.append(mesh.to_bytes())
    assert made[0] == made[1]


def test_a_mask_may_be_given_up_while_something_runs(ops, sphere):
    kept = [ops.flip.live(sphere)]

    def look(*_):
        kept.clear()
        raise LookupError

    with pytest.raises(LookupError):
        ops.forever(sphere, progress=look)
    assert not kept and ops.flip(sphere, 3) and ops.flip.live(sphere).count() == ops.flip.can(sphere).sum()


def test_programs_and_live_masks_are_collected(sphere):
    program = hedgerow.program('use "std/triangle.hedge" script s() { } fn f(e: edge) -> int { 1 }')
    for item in (program.flip, program.s, program.f):
        assert program in gc.get_referents(item)
    assert any(program.flip in known.values() for known in gc.get_referents(program) if type(known) is dict)
    mesh = sphere.copy()
    mesh.mask = program.flip.live(mesh)
    gone = weakref.ref(mesh)
    del mesh
    gc.collect()
    assert gone() is None


def test_help_of_a_program(ops):
    told = ops.__doc__
    assert "Moves all vertices." in told and "move(mesh" in told and "flip(mesh" in told
    assert hedgerow.std.remesh.__doc__.startswith("Isotropic remeshing")
    # A name may be a keyword of Python.
    assert "lambda: float = 0.63" in str(inspect.signature(hedgerow.std.smooth.taubin))
    assert "Functions: excess, gain" in pydoc.render_doc(ops, renderer=pydoc.plaintext)



def test_what_is_no_outcome_and_no_number_is_said_to_be_none(ops, sphere):
    for near in (5, True, "near", [3]):
        with pytest.raises(TypeError, match="`near` wants what an action gave"):
            ops.flip.can(sphere, near=near)
    for number in (-1, 2**32, 10**30, np.int64(-5), 999_999):
        with pytest.raises(hedgerow.ArgumentError, match=f"^`e` is no edge of the mesh: {number}$"):
            ops.flip(sphere, number)
    for several in ([1, 2], np.array([1, 2]), (1,)):
        with pytest.raises(TypeError, match="^`e` wants the number of an edge; `each` applies the operation"):
            ops.flip(sphere, several)
    with pytest.raises(TypeError, match="^`e` wants the number of an edge$"):
        ops.gain(sphere, [1, 2])
    for other in (1.0, True, "1", None, [1]):
        with pytest.raises(TypeError, match="`e` wants the number of an edge"):
            ops.flip(sphere, other)

def test_a_parameter_may_have_the_name_of_an_option():
    program = hedgerow.program("""
      op o(near: halfedge) {
        before { face f: v -near-> w => v }
        after { keep f  v.position = v.position * 2 }
      }
      script mesh(mesh: int, seed: int = 1) { print "{mesh} {seed}" }
    """)
    mesh = Mesh.cube()
    for near in (3, 10**6):
        if near == 3:
            assert program.o.can(mesh, near=near) is program.o.can(mesh, near) is True
        else:
            with pytest.raises(hedgerow.ArgumentError, match="`near` is no halfedge"):
                program.o.can(mesh, near=near)
    assert program.o.can(mesh).all() and program.o.why(mesh, near=3) is None
    assert str(inspect.signature(program.mesh)).startswith("(_mesh, /, mesh: int, seed: int = 1, *, progress=None)")
    assert program.mesh.__doc__.startswith("mesh(_mesh") and "seed: int" in pydoc.render_doc(program.mesh)
    both = hedgerow.program("script s(mesh: int, _mesh: int) { print mesh + _mesh }").s
    assert list(inspect.signature(both).parameters)[:3] == ["__mesh", "mesh", "_mesh"]
    assert program.mesh(mesh, mesh=4) == program.mesh(mesh, 4) == {}


def test_pictures_and_proofs(ops, tmp_path):
    picture = ops.flip.diagram()
    assert picture._repr_svg_().startswith("<svg") and ops.flip._repr_svg_() == picture.svg
    assert "v0" in str(picture)
    picture.save(tmp_path / "flip.svg")
    assert (tmp_path / "flip.svg").read_text() == picture.svg
    proof = ops.flip.check()
    assert proof.level == "simple" and "simple" in proof.keeps and proof.rules[0]["cases"] > 0
    assert "triangles" in proof.rules[0]["keeps"]


def test_programs_pickle(ops, sphere):
    for thing in (ops, ops.flip, ops.move, ops.gain):
        back = pickle.loads(pickle.dumps(thing))
        assert type(back) is type(thing)
    assert pickle.loads(pickle.dumps(ops)) is pickle.loads(pickle.dumps(ops))
    assert pickle.loads(pickle.dumps(ops)) == ops
    # Operations of another program work on the same mesh.
    other = pickle.loads(pickle.dumps(ops.flip))
    assert other(sphere, 3) and ops.flip(sphere, 4)


@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda one: pickle.loads(pickle.dumps(one))])
def test_outcomes_and_parameters_are_copied_and_pickled(ops, sphere, again):
    done = ops.collapse(sphere, 20)
    other = again(done)
    assert type(other) is Applied and repr(other) == repr(done) and other.result == done.result
    for kind in ("vertices", "halfedges", "edges", "faces"):
        assert getattr(other.erased, kind) == getattr(done.erased, kind)
    assert repr(again(done.erased)) == repr(done.erased)
    assert other == done and hash(other) == hash(done)
    assert again(done.erased) == done.erased and hash(again(done.erased)) == hash(done.erased)
    assert done != ops.collapse(sphere, 50) and done.erased != done.created and done != 3 != done.erased
    assert Elements([1, 2], edges=[3]) == Elements([1, 2], edges=[3]) != Elements([2, 1], edges=[3])
    assert Elements([1]) != Elements(faces=[1]) and Elements() == Elements()
    assert Applied(1, Elements(), Elements()) != Applied(None, Elements(), Elements())
    no = ops.flip(Mesh.grid(1, 1, triangles=True), 0)
    assert isinstance(no, Refused) and again(no) == no and again(no).number == no.number
    for parameter in ops.move.parameters + ops.flip.parameters:
        assert again(parameter) == parameter and str(again(parameter)) == str(parameter)
    with pytest.raises(ValueError, match="no type `edges`"):
        hedgerow.Parameter("e", "edges", None)


def test_interrupts(ops, sphere):
    threading.Timer(0.4, signal.raise_signal, (signal.SIGINT,)).start()
    started = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        ops.forever(sphere)
    assert time.perf_counter() - started < 20
    sphere.check()


def test_interrupts_of_operations_and_questions(sphere):
    text = "op o(e: edge) { steps { var n = 0 while n == 0 { n = n * 2 } } }"
    endless, before = hedgerow.program(text).o, sphere.copy()
    asks = (lambda: endless(sphere, 1), lambda: endless.can(sphere, 1), lambda: endless.can(sphere),
            lambda: endless.why(sphere), lambda: endless.live(sphere), lambda: endless.each(sphere, [1, 2]),
            lambda: endless.can(sphere, near=endless_outcome))  # fmt: skip
    flip = hedgerow.std.triangle.flip
    endless_outcome = flip(sphere.copy(), 1)
    for ask in asks:
        threading.Timer(0.1, signal.raise_signal, (signal.SIGINT,)).start()
        started = time.perf_counter()
        with pytest.raises(KeyboardInterrupt):
            ask()
        assert time.perf_counter() - started < 20
        assert sphere == before
    assert flip(sphere, 1)


def test_the_exception_of_a_signal_is_what_is_raised(sphere):
    def handler(number, frame):
        raise LookupError("enough")

    endless = hedgerow.program("op o(e: edge) { steps { var n = 0 while n == 0 { n = n * 2 } } }").o
    old = signal.signal(signal.SIGINT, handler)
    try:
        threading.Timer(0.1, signal.raise_signal, (signal.SIGINT,)).start()
        with pytest.raises(LookupError, match="enough"):
            endless(sphere, 1)
    finally:
        signal.signal(signal.SIGINT, old)


def test_progress(ops, sphere):
    told = []

    def stop_at_last(done, total):
        told.append((done, total))
        if len(told) == 3:
            raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        ops.forever(sphere, progress=stop_at_last)
    assert len(told) == 3 and told[0][1] is None and told[0][0] < told[2][0]
    pytest.importorskip("tqdm")
    ops.move(sphere, progress=True)
    ops.move(sphere, progress=False)


def test_a_running_mesh_is_busy(ops, sphere):
    seen, other = [], sphere.copy()

    def look(done, total):
        for use in (lambda: sphere.vertices, lambda: ops.flip(sphere, 3), sphere.copy,
                    lambda: sphere == other, lambda: setattr(sphere, "positions", other.positions)):  # fmt: skip
            with pytest.raises(hedgerow.BusyError):
                use()
        seen.append(ops.flip(other, 3))
        raise LookupError

    with pytest.raises(LookupError):
        ops.forever(sphere, progress=look)
    assert len(seen) == 1 and ops.flip(sphere, 3)


def test_the_lock_is_released(ops, sphere):
    counted, done = [0], threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    looks = []

    def look(*_):
        looks.append(counted[0])
        if len(looks) == 4:
            raise LookupError

    with pytest.raises(LookupError):
        ops.forever(sphere, progress=look)
    done.set()
    thread.join()
    assert looks[-1] - looks[0] > 10
