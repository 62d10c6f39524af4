"""The batch example: on Ray, in processes and in threads, with meshes that fail."""

import importlib.util
import os
import pathlib
import sys

import pytest

import hedgerow

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples" / "python"
if not EXAMPLES.is_dir():
    pytest.skip("the examples are not here", allow_module_level=True)
sys.path.insert(0, str(EXAMPLES))
import batch  # noqa: E402

HAS_RAY = importlib.util.find_spec("ray") is not None
RUNNERS = [
    "threads",
    "processes",
    pytest.param("ray", marks=pytest.mark.skipif(not HAS_RAY, reason="ray is not installed")),
]


def dies_at_cube(script, name, mesh, arguments):
    """Work that ends the worker at one mesh."""
    if name == "cube.obj":
        os._exit(3)
    return batch.work(script, name, mesh, arguments)


@pytest.fixture
def folder(tmp_path):
    """A folder with four good meshes and a broken one."""
    source = tmp_path / "in"
    source.mkdir()
    hedgerow.Mesh.icosphere(1).save(source / "sphere.obj")
    hedgerow.Mesh.torus(5, 4, triangles=True).save(source / "torus.ply")
    hedgerow.Mesh.grid(3, 3, triangles=True).save(source / "grid.off")
    hedgerow.Mesh.cube().save(source / "cube.obj")
    (source / "broken.obj").write_text("v 0 0 0\nv 1 0 0\nf 1 2 9\n")
    (source / "notes.txt").write_text("no mesh")
    return source


@pytest.mark.parametrize("run", RUNNERS)
def test_one_broken_mesh_loses_nothing(folder, run):
    target = folder.parent / "out"
    script = hedgerow.std.remesh.remesh
    outcomes = batch.run_folder(folder, target, script, {"iterations": 1}, run=run, workers=2)
    outcomes = {outcome.name: outcome for outcome in outcomes}
    assert sorted(outcomes) == ["broken.obj", "cube.obj", "grid.off", "sphere.obj", "torus.ply"]
    assert "there is no vertex 9" in outcomes["broken.obj"].error
    # A cube has no triangles: the script says so, and nothing is written.
    assert "only triangles are remeshed" in outcomes["cube.obj"].error
    assert sorted(path.name for path in target.iterdir()) == ["grid.off", "sphere.obj", "torus.ply"]
    for name in ("grid.off", "sphere.obj", "torus.ply"):
        assert outcomes[name].error is None and outcomes[name].seconds > 0
        mesh = hedgerow.Mesh.load(folder / name)
        assert script(mesh, iterations=1) == outcomes[name].report
        assert hedgerow.Mesh.load(target / name).is_same(mesh, 1e-6)


@pytest.mark.parametrize("run", RUNNERS[1:])
def test_a_worker_that_dies_loses_its_mesh_alone(folder, run):
    target = folder.parent / "out"
    script = hedgerow.std.subdivide.linear_quads
    outcomes = batch.run_folder(folder, target, script, run=run, workers=2, function=dies_at_cube)
    errors = {outcome.name: outcome.error for outcome in outcomes}
    assert errors.pop("cube.obj") and errors.pop("broken.obj")
    assert set(errors.values()) == {None} and len(errors) == 3
    assert len(list(target.iterdir())) == 3


def test_a_worker_compiles_a_program_once():
    import pickle

    packed = pickle.dumps(hedgerow.program("script nothing() { }").nothing)
    assert pickle.loads(packed).program is pickle.loads(packed).program


def test_the_command(folder, capsys):
    target = folder.parent / "out"
    given = [str(folder), str(target), "--runner", "threads", "--workers", "2"]
    assert batch.main([*given, "--set", "iterations=1"]) == 1
    told = capsys.readouterr().out
    assert "5 meshes, 2 failed" in told and "torus.ply: " in told and "applied (" in told
    for wrong, message in (
        (["--script", "nothing"], "nothing"),
        (["--program", "nowhere.hedge"], "nowhere.hedge"),
        (["--set", "target=long"], "is not a number"),
    ):
        with pytest.raises(SystemExit) as stopped:
            batch.main([*given, *wrong])
        assert stopped.value.code == 2
        assert message in capsys.readouterr().err
    with pytest.raises(SystemExit):
        batch.main(["nowhere", str(target), "--runner", "threads"])
    assert "there is no folder `nowhere`" in capsys.readouterr().err


def test_meshes_are_not_replaced(folder, capsys):
    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    for same in (folder, folder.parent / "out" / ".." / "in"):
        (folder.parent / "out").mkdir(exist_ok=True)
        with pytest.raises(SystemExit) as stopped:
            batch.main([str(folder), str(same), "--runner", "threads"])
        assert stopped.value.code == 2 and "name another folder" in capsys.readouterr().err
    assert before == {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.mark.parametrize("workers", ["-1", "0"])
@pytest.mark.parametrize("run", ["threads", "processes", "auto"])
def test_there_is_a_worker(folder, capsys, run, workers):
    target = folder.parent / "out"
    with pytest.raises(SystemExit) as stopped:
        batch.main([str(folder), str(target), "--runner", run, "--workers", workers])
    assert stopped.value.code == 2 and not target.exists()
    assert f"from 1, not {workers}: leave it out" in capsys.readouterr().err


def test_a_file_that_is_no_mesh_is_told_as_such(folder):
    (folder / "noise.obj").write_bytes(bytes(range(256)) * 4)
    (folder / "empty.obj").write_text("")
    script = hedgerow.std.remesh.remesh
    outcomes = batch.run_folder(folder, folder.parent / "out", script, run="threads", workers=1)
    errors = {outcome.name: outcome.error for outcome in outcomes}
    assert "is it an OBJ file?" in errors["empty.obj"] and "noise.obj: " in errors["noise.obj"]
