"""Pictures of meshes and operations, and their files."""

import functools
import signal

import numpy as np
import pytest

import hedgerow
from hedgerow import Mesh


def test_pictures_of_meshes(tmp_path, sphere):
    sphere["heat"], sphere.faces["heat"], sphere.edges["crease"] = 0.5, 2, True
    plain = sphere.picture(tmp_path / "x.png")
    assert (tmp_path / "x.png").read_bytes() == plain.png == sphere._repr_png_() == plain._repr_png_()
    plain = sphere.picture(size=60, view=(0, 0, 1))
    assert plain.png.startswith(b"\x89PNG")
    pictures = {sphere.picture(attribute=name, size=60, view=(0, 0, 1)).png for name in ("vertex.heat", "face.heat", "crease")}
    assert len(pictures | {plain.png}) == 4
    assert Mesh()._repr_png_() is None and Mesh().picture(size=60).png
    with pytest.raises(hedgerow.ArgumentError, match="may be several attributes: `vertex.heat`, `face.heat`"):
        sphere.picture(attribute="heat")
    with pytest.raises(KeyError, match="no attribute `none`"):
        sphere.picture(attribute="none")
    with pytest.raises(KeyError, match="no face has an attribute `none`"):
        sphere.picture(attribute="face.none")
    with pytest.raises(ValueError, match="is a .png file"):
        sphere.picture(tmp_path / "x.svg")


def test_pictures_are_written_whole_or_not_at_all(tmp_path, sphere):
    resource = pytest.importorskip("resource")
    diagram = hedgerow.std.triangle.flip.diagram()
    small = functools.partial(sphere.picture, size=100)
    writes = {"d.svg": diagram.save, "p.png": small, "q.PNG": small().save}
    limits, action = resource.getrlimit(resource.RLIMIT_FSIZE), signal.getsignal(signal.SIGXFSZ)
    for name, write in writes.items():
        (tmp_path / name).write_text("old")
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (1000, limits[1]))
        try:
            with pytest.raises(hedgerow.FileError, match=f"{name}: "):
                write(tmp_path / name)
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, limits)
            signal.signal(signal.SIGXFSZ, action)
        assert (tmp_path / name).read_text() == "old"
        with pytest.raises(hedgerow.FileError, match="does not exist"):
            write(tmp_path / "nowhere" / name)
        write(str(tmp_path / name))
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(writes)
    assert (tmp_path / "d.svg").read_text(encoding="utf-8") == diagram.svg
    with pytest.raises(hedgerow.ArgumentError, match=r"an operation is a \.svg file, not `d\.png`"):
        diagram.save("d.png")


@pytest.mark.parametrize("size", [-1, 0, 15, 16385, 10**7, 10**400, float("nan"), float("inf"), "60", None])
def test_sizes_of_pictures(sphere, size):
    with pytest.raises(hedgerow.ArgumentError, match="`size` is a number of pixels from 16 to 16384"):
        sphere.picture(size=size)
    assert sphere.picture(size=np.int32(16)).png != sphere.picture(size=16.5).png
