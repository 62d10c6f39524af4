"""Meshes."""

from __future__ import annotations

import math
import numbers
import os
import re
import warnings
from copy import deepcopy

import numpy as np

from . import _arrays
from ._elements import PLURALS, ElementTable, rows
from ._hedgerow import Mesh as MeshTables
from ._hedgerow import Trial
from ._measures import Measured
from .errors import ArgumentError, MeshError

__all__ = ["Mesh", "Trial"]

#: What other libraries call the numbers of elements.
_COUNTS = re.compile(r"(?:n|num|nb|number_of|count)_?(vert|halfedge|edge|face)\w*")


class Mesh(MeshTables, Measured):
    """A halfedge mesh of polygons.

    ``vertices`` are rows of 3 coordinates (2 get a third, 0), ``faces`` rows or lists of corners,
    counterclockwise. Arrays that are no mesh are refused with the first place where they are none;
    with ``repair=True`` what keeps them from being one is mended (nothing is closed), and with a
    number, points that are no farther from each other than this become one vertex as well.

    Vertex, edge, halfedge and face go by numbers. The number of an element stays its own while it
    lives; numbers of erased elements are not given out again, unless by scripts, and after
    :meth:`recycle`. Vertex ``i`` and face ``i`` are row ``i`` of what the mesh was made of.

    >>> mesh = Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    >>> mesh
    <Mesh: 4 vertices, 5 edges, 2 faces, 1 hole>
    >>> mesh.faces
    array([[0, 1, 2],
           [0, 2, 3]])
    """

    def __new__(cls, vertices=None, faces=(), *, repair=False):
        if vertices is None:
            vertices = np.zeros((0, 3))
        if isinstance(vertices, (str, os.PathLike)):
            raise TypeError("a mesh is made of arrays; `Mesh.load` reads files")
        if faces is None:
            raise TypeError("a mesh wants its faces: rows or lists of corners")
        coordinates = _arrays.coordinates(vertices)
        corners, ends = _arrays.polygons(faces)
        return super().__new__(cls, coordinates, corners, ends, _repair(repair))

    # Where meshes come from.

    @classmethod
    def _of(cls, tables):
        mesh = cls()
        mesh._take(tables)
        return mesh

    def _like(self, tables):
        """A mesh of the same class, with what Python has attached to it."""
        mesh = _bare(type(self), tables)
        mesh.__dict__.update(self.__dict__)
        return mesh

    @classmethod
    def load(cls, path, *, repair=False):
        """The mesh of a file: ``.obj``, ``.ply``, ``.stl``, ``.off``, ``.msh`` or ``.halfedges``.

        What the file says besides (texture coordinates, groups, materials …) becomes attributes
        where it can, or is kept and written back by :meth:`save`: also by that of a :meth:`copy`, but
        not after ``pickle``, :meth:`to_bytes` or :meth:`compact`.
        """
        return cls._of(MeshTables._read(os.fspath(path), _repair(repair)))

    @classmethod
    def _named(cls, name, *sizes):
        try:
            return cls._of(MeshTables._shape(name, list(sizes)))
        except OverflowError:
            raise ValueError(f"`{name}` cannot be of sizes {list(sizes)}") from None

    @classmethod
    def tetrahedron(cls):
        """A tetrahedron."""
        return cls._named("tetrahedron")

    @classmethod
    def cube(cls):
        """A cube of six squares."""
        return cls._named("cube")

    @classmethod
    def octahedron(cls):
        """An octahedron."""
        return cls._named("octahedron")

    @classmethod
    def icosahedron(cls):
        """An icosahedron."""
        return cls._named("icosahedron")

    @classmethod
    def icosphere(cls, subdivisions=2):
        """A sphere: an icosahedron with each triangle divided into four so many times."""
        return cls._named("icosphere", subdivisions)

    @classmethod
    def grid(cls, rows, columns=None, *, triangles=False):
        """A flat rectangle of squares, or of triangles, two for each."""
        name = "triangle_grid" if triangles else "grid"
        return cls._named(name, rows, rows if columns is None else columns)

    @classmethod
    def torus(cls, around, across, *, triangles=False):
        """A torus of quadrangles, or of triangles."""
        return cls._named("triangle_torus" if triangles else "torus", around, across)

    @classmethod
    def from_trimesh(cls, other, *, repair=False):
        """The mesh of a ``trimesh.Trimesh``."""
        return cls(other.vertices, np.asarray(other.faces), repair=repair)

    @classmethod
    def from_meshio(cls, other, *, repair=False):
        """The mesh of the triangles, quadrangles and polygons of a ``meshio.Mesh``; its data of
        points becomes attributes of vertices, but for what a warning names."""
        blocks = [
            block.data
            for block in other.cells
            if block.type in ("triangle", "quad") or block.type.startswith("polygon")
        ]
        if not blocks:
            raise MeshError("the meshio mesh has no triangles, quads or polygons", "no-mesh")
        faces = blocks[0] if len(blocks) == 1 else [face for block in blocks for face in block]
        mesh = cls(other.points, faces, repair=repair)
        _bring(mesh, other)
        return mesh

    @classmethod
    def from_pyvista(cls, other, *, repair=False):
        """The mesh of a ``pyvista.PolyData``; its data of points becomes attributes of vertices, but
        for what a warning names."""
        if other.n_lines or other.n_strips:
            raise MeshError("the pyvista mesh has lines or strips: call `.triangulate()`", "no-mesh")
        if other.n_verts:
            raise MeshError("the pyvista mesh has vertex cells", "no-mesh")
        if other.is_all_triangles:
            faces = other.regular_faces
        else:
            packed = np.asarray(other.faces, dtype=np.int64)
            faces, at = [], 0
            while at < len(packed):
                faces.append(packed[at + 1 : at + 1 + packed[at]])
                at += 1 + packed[at]
        mesh = cls(other.points, faces, repair=repair)
        _bring(mesh, other)
        return mesh

    # Where they go.

    def save(self, path):
        """Writes a file, in the format that its name ends in: whole, or not at all."""
        super()._save(os.fspath(path))

    def arrays(self):
        """Coordinates and faces, to be written to: ``V, F = mesh.arrays()``."""
        return self._vertices(), self._faces()

    def to_trimesh(self):
        """A ``trimesh.Trimesh``; faces must be triangles."""
        import trimesh

        return trimesh.Trimesh(self._vertices(), self._triangles("trimesh"), process=False)

    def to_meshio(self):
        """A ``meshio.Mesh``, with the attributes of vertices as data of points."""
        import meshio

        corners, ends = self._polygons(False)
        starts = np.concatenate([[0], ends[:-1]])
        sides = ends - starts
        cells = []
        for side in np.unique(sides):
            rows = starts[sides == side][:, None] + np.arange(side)
            name = {3: "triangle", 4: "quad"}.get(int(side), "polygon")
            cells.append((name, corners[rows]))
        return meshio.Mesh(self._vertices(), cells, point_data=self._point_data())

    def to_pyvista(self):
        """A ``pyvista.PolyData``, with the attributes of vertices as data of points."""
        import pyvista

        corners, ends = self._polygons(False)
        faces = pyvista.CellArray.from_arrays(np.concatenate([[0], ends]), corners)
        made = pyvista.PolyData(self._vertices(), faces=faces)
        for name, values in self._point_data().items():
            made.point_data[name] = values
        return made

    def _point_data(self):
        ids, table = self.vertex_ids, self.elements("vertex")
        data = {name: table[name][ids] for name in table.attributes}
        # A matrix becomes a row of numbers.
        return {
            name: values.reshape(len(ids), math.prod(values.shape[1:])) if values.ndim > 1 else values
            for name, values in data.items()
        }

    # What it is.

    def elements(self, kind):
        """The elements of a kind: ``vertex``, ``halfedge``, ``edge`` or ``face``."""
        for name, plural in PLURALS.items():
            if kind in (name, plural):
                return ElementTable(self, name)
        raise ValueError(f"there is no kind of elements `{kind}`")

    @property
    def edges(self):
        """The edges: ``mesh.edges["crease"]``, ``mesh.edges.vertices``, ``mesh.edges.faces``,
        ``len(mesh.edges)``."""
        return ElementTable(self, "edge")

    @property
    def halfedges(self):
        """The halfedges: ``mesh.halfedges.next``, ``prev``, ``twin``, ``vertex``, ``target``, ``edge``,
        ``face``."""
        return ElementTable(self, "halfedge")

    @property
    def hole_count(self):
        """How many holes there are: loops along boundaries."""
        return self._hole_count()

    @property
    def vertex_count(self):
        """How many vertices live."""
        return self._count("vertex")

    @property
    def edge_count(self):
        """How many edges live."""
        return self._count("edge")

    @property
    def face_count(self):
        """How many faces live; holes are none."""
        return self._count("face")

    @property
    def vertices(self):
        """The coordinates of the living vertices, as other programs want them: their rows are what
        :attr:`faces` names. If vertices have been erased, row and number differ: see
        :attr:`vertex_ids`, :attr:`positions`."""
        return rows(self._vertices(), self.elements("vertex"))

    @vertices.setter
    def vertices(self, values):
        positions = np.array(self.positions)
        coordinates = _arrays.coordinates(values, ArgumentError).reshape(-1, 3)
        ids = self.vertex_ids
        if len(coordinates) != len(ids):
            message = f"there are {len(ids)} vertices, not {len(coordinates)}"
            raise ArgumentError(message, "wrong-argument")
        positions[ids] = coordinates
        self.positions = positions

    def _vertices(self):
        return super()._positions(True).reshape(-1, 3)

    @property
    def positions(self):
        """The coordinates of the vertices by number; those of erased ones mean nothing."""
        return _arrays.frozen(super()._positions(False).reshape(-1, 3))

    @positions.setter
    def positions(self, values):
        self._set_positions(_arrays.coordinates(values, ArgumentError))

    @property
    def faces(self):
        """The faces by the rows of :attr:`vertices`: an array if all have the same number of sides,
        else a list of arrays. By a name it is an attribute of the faces, by number, as that of
        ``mesh.elements("face")``.

        >>> mesh = Mesh.cube()
        >>> mesh.faces["label"] = 3
        >>> mesh.faces["label"]
        array([3, 3, 3, 3, 3, 3])
        """
        return rows(self._faces(), self.elements("face"))

    def _faces(self):
        corners, ends = self._polygons(False)
        if not len(ends):
            return corners.reshape(0, 3)
        sides = len(corners) // len(ends)
        if sides * len(ends) == len(corners) and (ends == sides * np.arange(1, len(ends) + 1)).all():
            return corners.reshape(-1, sides)
        ends = ends.tolist()
        return [corners[start:end] for start, end in zip([0, *ends], ends)]

    def _triangles(self, who):
        faces = self._faces()
        if not isinstance(faces, np.ndarray) or faces.shape[1] != 3:
            raise MeshError(
                f"{who} wants triangles: `hedgerow.std.triangulate.triangulate(mesh)` divides polygons", "not-triangles"
            )
        return faces

    @property
    def vertex_ids(self):
        """The numbers of the vertices that are the rows of :attr:`vertices`."""
        return self.elements("vertex").ids

    @property
    def face_ids(self):
        """The numbers of the faces that are the rows of :attr:`faces`."""
        return self.elements("face").ids

    def __getitem__(self, name):
        """An attribute of the vertices, by number."""
        return self.elements("vertex")[name]

    def __setitem__(self, name, values):
        self.elements("vertex")[name] = values

    def __delitem__(self, name):
        del self.elements("vertex")[name]

    def __contains__(self, name):
        return name in self.elements("vertex").attributes

    __iter__ = None

    def __getattr__(self, name):
        message = f"a mesh has no `{name}`"
        if counts := _COUNTS.fullmatch(name):
            plural = next(plural for plural in PLURALS.values() if plural.startswith(counts[1]))
            message += f": `len(mesh.{plural})` is how many {plural} there are"
        raise AttributeError(message, name=name, obj=self)

    def check(self):
        """Raises a :class:`MeshError` if the tables are not in order: they always are, unless
        something is wrong with this package."""
        wrong = self._invalid()
        if wrong is not None:
            raise MeshError(wrong, "broken-mesh")

    # What is done with it.

    def copy(self):
        """Another mesh that is equal, number by number. Random numbers go on there as they would here;
        after ``pickle`` they begin with seed 0, as on a new mesh."""
        return self._like(self._copied())

    __copy__ = copy

    def __deepcopy__(self, memo):
        made = memo[id(self)] = _bare(type(self), self._copied())
        made.__dict__.update(deepcopy(self.__dict__, memo))
        return made

    def to_bytes(self):
        """All of the mesh as bytes, with its numbers and attributes; as ``pickle`` has it. What its
        file said besides, as materials and groups, is not among them: see :meth:`load`."""
        return self._packed()

    @classmethod
    def from_bytes(cls, data):
        """The mesh of bytes that :meth:`to_bytes` gave; others are refused."""
        return cls._of(MeshTables._unpacked(bytes(data)))

    def __reduce__(self):
        return _unpickled, (type(self), self.to_bytes()), self.__dict__ or None

    def trial(self):
        """What is done within ``with mesh.trial() as trial:`` is undone at the end, whatever ended
        it, unless ``trial.keep()`` is called.

        >>> import hedgerow
        >>> mesh = Mesh.cube()
        >>> with mesh.trial():
        ...     report = hedgerow.std.subdivide.catmull_clark(mesh)
        ...     mesh.face_count
        24
        >>> mesh.face_count
        6
        """
        return Trial(self)

    def compact(self):
        """The same mesh with numbers without gaps, and for its vertices and faces the numbers that
        they had here: ``(mesh, vertices, faces)``. All elements keep their order, but holes come
        behind the faces. Attributes go along, and what Python has attached; what the file of the mesh
        said besides does not."""
        return self._like(self._compacted()), self.vertex_ids, self.face_ids

    def is_same(self, other, tolerance=0.0):
        """Whether both are the same but for the numbers of elements, and coordinates that differ by
        no more than the tolerance."""
        return super()._is_same(other, float(tolerance))

    def __eq__(self, other):
        """Whether the same numbers live in both, and pointers, coordinates and attributes agree."""
        if not isinstance(other, MeshTables):
            return NotImplemented
        return self._is_identical(other)

    __hash__ = None

    def __repr__(self):
        def told(count, one, many):
            return f"{count} {one if count == 1 else many}"

        parts = [told(self._count(kind), kind, PLURALS[kind]) for kind in ("vertex", "edge", "face")]
        if self.hole_count:
            parts.append(told(self.hole_count, "hole", "holes"))
        return f"<Mesh: {', '.join(parts)}>"


def _bare(cls, tables):
    """A mesh of a class, which is not asked to make it: it may want other arguments."""
    nothing = np.zeros(0, dtype=np.int64)
    mesh = MeshTables.__new__(cls, np.zeros(0), nothing, nothing)
    mesh._take(tables)
    return mesh


def _unpickled(cls, data):
    return _bare(cls, MeshTables._unpacked(data))


def _repair(repair):
    """What the compiled part takes for a repair: nothing, a negative number, or a tolerance."""
    if repair is None:
        return None
    if isinstance(repair, (bool, np.bool_)):
        return -1.0 if repair else None
    if not isinstance(repair, numbers.Real):
        raise TypeError(f"`repair` is a bool or a tolerance, not {type(repair).__name__}")
    tolerance = float(repair)
    if not (tolerance >= 0.0 and np.isfinite(tolerance)):
        raise ArgumentError("the tolerance of a repair is a number from 0", "wrong-argument")
    return tolerance


def _bring(mesh, other):
    """Brings the data of the points of another mesh that the mesh was made of, and warns of data that
    cannot be attributes: a repair has changed the points, values are of no type of attributes, or
    another name has become the same one."""
    is_same = np.array_equal(mesh._vertices().reshape(-1), _arrays.coordinates(other.points))
    left_out = []
    for name, values in other.point_data.items():
        word = re.sub(r"\W|^(?=\d)|^$", "_", str(name))
        values = np.asarray(values)
        if values.ndim == 2 and values.shape[1] == 1:
            values = values[:, 0]
        try:
            if word in mesh or not is_same:
                left_out.append(name)
            else:
                mesh[word] = values
        except ArgumentError:
            left_out.append(name)
    if left_out:
        told = ", ".join(f"`{name}`" for name in left_out)
        warnings.warn(f"this data of points has not become attributes: {told}", stacklevel=3)
