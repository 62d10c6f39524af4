"""Files, and meshes of other libraries."""

import errno
import pickle

import numpy as np
import pytest

import hedgerow
from hedgerow import Mesh

V = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)
F = np.array([[0, 1, 2], [0, 2, 3]])


@pytest.mark.parametrize("ending", ["obj", "ply", "off", "msh", "halfedges", "stl"])
def test_files(tmp_path, ending, sphere):
    path = tmp_path / f"mesh.{ending}"
    sphere.save(path)
    back = Mesh.load(str(path))
    assert back.is_same(sphere, 1e-6)


def test_files_keep_what_they_hold(tmp_path):
    path = tmp_path / "a.obj"
    path.write_text(
        "g left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n"
    )
    mesh = Mesh.load(path)
    assert mesh.halfedges["uv"][mesh.halfedges.face == 0].tolist() == [[0, 0], [1, 0], [0, 1]]
    mesh.copy().save(tmp_path / "b.obj")
    text = (tmp_path / "b.obj").read_text()
    assert "vt 1 0" in text and "g left" in text


def test_files_that_fail(tmp_path, sphere):
    for name, text in [("a.obj", "f 1 2 3\n"), ("a.xyz", ""), ("b.ply", "nonsense")]:
        (tmp_path / name).write_text(text)
        with pytest.raises(hedgerow.FileError, match=name):
            Mesh.load(tmp_path / name)
    for ask in (
        lambda: Mesh.load(tmp_path / "none.obj"),
        lambda: hedgerow.load(tmp_path / "none.hedge"),
        lambda: sphere.save(tmp_path / "no" / "folder.obj"),
    ):
        with pytest.raises(FileNotFoundError, match="no") as caught:
            ask()
        error = caught.value
        assert isinstance(error, hedgerow.FileError) and error.strerror == str(error)
        assert (error.errno, error.filename) == (errno.ENOENT, None)
        again = pickle.loads(pickle.dumps(error))
        assert (str(again), again.code, again.diagnostics) == (str(error), error.code, error.diagnostics)
    with pytest.raises(OSError):
        sphere.save(tmp_path / "no" / "folder.obj")


def test_files_without_a_vertex(tmp_path):
    noise = np.random.default_rng(0).integers(128, 256, 2000).astype(np.uint8).tobytes()
    for text in (b"", b"once upon a time\n", noise):
        (tmp_path / "a.obj").write_bytes(text)
        for repair in (False, True):
            with pytest.raises(hedgerow.FileError, match=r"a\.obj: .*is it an OBJ file\?"):
                Mesh.load(tmp_path / "a.obj", repair=repair)
    # A list of no polygons is probably an accident; tables and bytes say that they are empty.
    for ending in ("obj", "ply", "off", "msh", "stl"):
        Mesh().save(tmp_path / f"none.{ending}")
        with pytest.raises(hedgerow.FileError, match="there is no vertex in it"):
            Mesh.load(tmp_path / f"none.{ending}")
    Mesh().save(tmp_path / "none.halfedges")
    assert Mesh.load(tmp_path / "none.halfedges") == Mesh() == Mesh.from_bytes(Mesh().to_bytes())


def test_other_libraries(sphere):
    trimesh = pytest.importorskip("trimesh")
    there = sphere.to_trimesh()
    assert isinstance(there, trimesh.Trimesh) and there.is_watertight
    assert Mesh.from_trimesh(there) == sphere
    with pytest.raises(hedgerow.MeshError, match="wants triangles"):
        Mesh.cube().to_trimesh()


def test_meshio(sphere):
    pytest.importorskip("meshio")
    sphere["heat"] = np.arange(sphere.vertex_count, dtype=float)
    assert Mesh.from_meshio(sphere.to_meshio()) == sphere
    mixed = Mesh([*V.tolist(), [2, 0.5, 0]], [[0, 1, 2, 3], (1, 4, 2)])
    assert Mesh.from_meshio(mixed.to_meshio()).is_same(mixed)
    empty = Mesh()
    empty["heat"], empty["frame"] = 1.0, np.eye(3)
    assert {name: data.shape for name, data in empty.to_meshio().point_data.items()} == {"heat": (0,), "frame": (0, 9)}


def test_data_of_points():
    meshio = pytest.importorskip("meshio")
    data = {
        "column": np.ones((4, 1)), "1st": np.arange(4.0), "a b": np.ones(4), "a_b": np.zeros(4),
        "tensor": np.ones((4, 6)), "position": np.ones(4),
    }  # fmt: skip
    other = meshio.Mesh(V, [("triangle", F)], point_data=data)
    for repair in (False, True):
        with pytest.warns(UserWarning, match="`a_b`, `tensor`, `position`$"):
            mesh = Mesh.from_meshio(other, repair=repair)
        assert mesh.elements("vertex").attributes == {"column": "real", "_1st": "real", "a_b": "real"}
        assert mesh["_1st"].tolist() == [0, 1, 2, 3] and (mesh["a_b"] == 1).all()
    other.points[3] = other.points[2]
    with pytest.warns(UserWarning, match="`column`, `1st`"):
        assert not Mesh.from_meshio(other, repair=0.0).elements("vertex").attributes


def test_pyvista(sphere):
    pytest.importorskip("pyvista")
    sphere["heat"] = np.arange(sphere.vertex_count, dtype=float)
    assert Mesh.from_pyvista(sphere.to_pyvista()) == sphere
    mixed = Mesh([*V.tolist(), [2, 0.5, 0]], [[0, 1, 2, 3], (1, 4, 2)])
    assert Mesh.from_pyvista(mixed.to_pyvista()) == mixed
