"""Measures of meshes."""

import math

import numpy as np
import pytest

import hedgerow
from hedgerow import Mesh


def test_measures(ops, tmp_path):
    cube, grid = Mesh.cube(), Mesh.grid(2, 3)
    side = np.ptp(cube.vertices[:, 0])
    assert cube.area == pytest.approx(6 * side**2) and cube.volume == pytest.approx(side**3)
    assert (cube.bounds == [cube.vertices.min(0), cube.vertices.max(0)]).all()
    assert (cube.euler_number, cube.component_count, cube.is_watertight) == (2, 1, True)
    assert (grid.euler_number, grid.volume, grid.is_watertight) == (1, None, False)
    assert (grid.face_normals == [[0, 0, 1]] * 6).all() and (grid.vertex_normals == [[0, 0, 1]] * 12).all()
    outward = (cube.face_normals * cube.vertices[cube.faces].mean(1)).sum(1)
    assert (outward > 0).all() and cube.vertex_normals.shape == (8, 3)
    empty = Mesh()
    assert (empty.area, empty.volume, empty.bounds, empty.euler_number) == (0, None, None, 0)
    assert math.copysign(1, empty.area) == math.copysign(1, Mesh(grid.vertices, []).area) == 1
    assert empty.face_normals.shape == empty.vertex_normals.shape == (0, 3) and not empty.is_watertight
    told = grid.info()
    assert (told["vertices"], told["faces"], told["holes"], told["level"]) == (12, 6, 1, "simple")
    measures = told["measures"]
    assert measures["area"] == grid.area and measures["face_sizes"] == [{"size": 4, "count": 6}]
    # Rows are those of vertices and faces, also after some have gone.
    sphere = Mesh.icosphere(1)
    assert ops.collapse(sphere, 3)
    assert len(sphere.vertex_normals) == 41 and len(sphere.face_normals) == 78
    other = sphere.compact()[0]
    assert np.allclose(sphere.vertex_normals, other.vertex_normals) and np.allclose(sphere.area, other.area)


def test_measures_agree_with_trimesh(sphere):
    pytest.importorskip("trimesh")
    other = sphere.to_trimesh()
    for name in ("area", "volume", "bounds", "euler_number", "is_watertight", "face_normals"):
        assert np.allclose(getattr(sphere, name), getattr(other, name)), name


def test_directions_of_view():
    mesh = Mesh.cube()
    mesh.positions = mesh.positions * [1, 2, 3]

    def seen(*view):
        return mesh.picture(view=view, size=32).png

    assert len({seen(0, 0, 1), seen(1, 0, 0), seen(1, 1, 1)}) == 3
    for far in (1e-320, 1e-200, 1e200, 1e308):
        assert seen(far, 0, 0) == seen(1, 0, 0) and seen(far, far, far) == seen(1, 1, 1)
    assert mesh.picture(view=np.array([1, 0, 0]), size=32).png == seen(1, 0, 0)
    for wrong in ((0, 0, 0), (np.nan, 0, 0), (np.inf, 0, 1), (1, 0), (1, 0, 0, 0), np.eye(3), 3, None, "abc", (1, "x", 0),
                  (10**400, 0, 0), [[1], [0, 0], 1]):  # fmt: skip
        with pytest.raises(hedgerow.ArgumentError, match="`view` is a direction: 3 finite numbers"):
            mesh.picture(view=wrong)
    for wrong in (3, b"heat", ["heat"]):
        with pytest.raises(hedgerow.ArgumentError, match="`attribute` is the name of an attribute, not"):
            mesh.picture(attribute=wrong)
