"""Measures of meshes, and pictures of them."""

from __future__ import annotations

import json

import numpy as np

from . import _arrays
from ._elements import PLURALS
from ._hedgerow import mesh_measure, mesh_normals, mesh_png, mesh_summary
from ._pictures import Picture, expect_size
from .errors import ArgumentError


class Measured:
    """The measures of a mesh, under the names of trimesh where it has them."""

    __slots__ = ()

    def info(self):
        """What ``hedgerow info`` tells: counts, level, measures and attributes, as dictionaries.

        >>> from hedgerow import Mesh
        >>> told = Mesh.cube().info()
        >>> told["vertices"], told["level"], told["measures"]["genus"], told["measures"]["degrees"]
        (8, 'simple', 0, [{'size': 3, 'count': 8}])
        """
        return json.loads(mesh_summary(self))

    @property
    def area(self):
        """The sum of the areas of the faces."""
        return mesh_measure(self, "area")

    @property
    def volume(self):
        """The enclosed volume, negative if the mesh is inside out; ``None`` if it is not closed."""
        return mesh_measure(self, "volume")

    @property
    def bounds(self):
        """The least and the greatest corner of the bounding box, as two rows; ``None`` without
        vertices."""
        bounds = mesh_measure(self, "bounds")
        return None if bounds is None else np.array(bounds)

    @property
    def euler_number(self):
        """Vertices minus edges plus faces; holes and vertices without edges are not counted."""
        return mesh_measure(self, "euler")

    @property
    def component_count(self):
        """How many connected components there are."""
        return mesh_measure(self, "components")

    @property
    def is_watertight(self):
        """Whether there are faces and no holes."""
        return self.hole_count == 0 and self.face_count > 0

    @property
    def vertex_normals(self):
        """The unit normals at the rows of ``vertices``; 0 where there is none."""
        return _arrays.frozen(mesh_normals(self, "vertex").reshape(-1, 3))

    @property
    def face_normals(self):
        """The unit normals of the rows of ``faces``; 0 where there is none."""
        return _arrays.frozen(mesh_normals(self, "face").reshape(-1, 3))

    def picture(self, path=None, *, attribute=None, view=(0.5, 0.4, 1.0), size=800):
        """The picture of the mesh, which a notebook shows; written to a ``.png`` file, if one is
        given.

        ``view`` points from the mesh to the viewer; its length means nothing. ``size`` is from 16 to 16384
        pixels. ``attribute`` is shown in colour: ``"heat"``, or ``"face.label"`` if elements of several
        kinds have one of the name.
        """
        expect_size("size", size)
        shown = None if attribute is None else self._shown(attribute)
        picture = Picture(mesh_png(self, float(size), _direction(view), shown))
        if path is not None:
            picture.save(path)
        return picture

    def _repr_png_(self):
        return self.picture().png if self.face_count else None

    def _shown(self, attribute):
        """The kind and the name of an attribute."""
        if not isinstance(attribute, str):
            message = f"`attribute` is the name of an attribute, not {attribute!r}"
            raise ArgumentError(message, "wrong-argument")
        kind, dot, name = attribute.rpartition(".")
        if dot:
            return kind, name
        kinds = [kind for kind in PLURALS if name in self.elements(kind)]
        if len(kinds) > 1:
            names = ", ".join(f"`{kind}.{name}`" for kind in kinds)
            raise ArgumentError(f"`{name}` may be several attributes: {names}", "wrong-argument")
        if not kinds:
            raise KeyError(f"the mesh has no attribute `{name}`")
        return kinds[0], name


def _direction(view):
    """A direction as three numbers, the greatest of which is 1 or -1."""
    try:
        array = np.array([float(one) for one in view])
    except (TypeError, ValueError, OverflowError):
        array = np.zeros(0)
    most = np.abs(array).max() if array.shape == (3,) else 0.0
    if not (np.isfinite(most) and most > 0.0):
        message = f"`view` is a direction: 3 finite numbers, of which one is not 0, not {view!r}"
        raise ArgumentError(message, "wrong-argument")
    return tuple((array / most).tolist())
