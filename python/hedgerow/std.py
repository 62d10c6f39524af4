"""The standard library: each file is an attribute, read when it is named first.

>>> from hedgerow import Mesh, std
>>> mesh = Mesh.cube()
>>> report = std.subdivide.catmull_clark(mesh)
>>> mesh.face_count
24
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import _hedgerow

if TYPE_CHECKING:
    from . import Program

_FILES = (
    "components",
    "curvature",
    "delete",
    "distance",
    "dual",
    "map",
    "planar",
    "planar_cleanup",
    "planar_quad",
    "planar_triangle",
    "polygon",
    "random",
    "remesh",
    "repair",
    "sharp",
    "simplify",
    "smooth",
    "subdivide",
    "transform",
    "triangle",
    "triangulate",
    "trim",
)

__all__ = list(_FILES)


def __getattr__(name: str) -> Program:
    if name not in _FILES:
        raise AttributeError(f"the library has no file `{name}`: it has {', '.join(_FILES)}")
    found = globals()[name] = _hedgerow.Program._read(f"std/{name}.hedge")
    return found


def __dir__() -> list[str]:
    return sorted({*globals(), *_FILES})
