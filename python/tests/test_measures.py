"""Measures of meshes."""

import numpy as np
import pytest

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
