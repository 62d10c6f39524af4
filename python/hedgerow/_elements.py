"""Elements of a kind: their tables, and rows of them."""

from __future__ import annotations

import numpy as np

from . import _arrays

__all__ = ["ElementTable"]

_POINTERS = {
    "halfedge": ("next", "prev", "twin", "vertex", "edge", "face"),
    "vertex": ("halfedge",),
    "edge": ("halfedge",),
    "face": ("halfedge",),
}
PLURALS = {"vertex": "vertices", "halfedge": "halfedges", "edge": "edges", "face": "faces"}


class ElementTable:
    """The elements of one kind, by number: which live, their pointers, and their attributes.

    All arrays have a place for each number, also for those of erased elements (``alive`` tells).
    Arrays are copies and cannot be written: an attribute is set as a whole.

    >>> from hedgerow import Mesh
    >>> mesh = Mesh.cube()
    >>> mesh.edges["crease"] = 0.0
    >>> mesh.edges["crease"] = np.where(mesh.edges.ids < 4, 1.0, mesh.edges["crease"])
    >>> float(mesh.edges["crease"].sum())
    4.0
    >>> mesh.halfedges.next[mesh.halfedges.next[:4]]
    array([2, 3, 0, 1])
    """

    __slots__ = ("_kind", "_mesh")

    def __init__(self, mesh, kind):
        self._mesh = mesh
        self._kind = kind

    def __len__(self):
        """How many live; holes are not counted among faces."""
        return self._mesh._count(self._kind)

    @property
    def size(self):
        """How many places an array by number has."""
        return self._mesh._capacity(self._kind)

    @property
    def alive(self):
        """By number whether the element lives; holes count as faces."""
        return _arrays.frozen(self._mesh._living(self._kind))

    @property
    def ids(self):
        """The numbers of the living ones, in order; of faces those that are no holes."""
        alive = self._mesh._living(self._kind)
        if self._kind == "face":
            alive &= ~self._mesh._holes()
        return np.flatnonzero(alive)

    @property
    def is_hole(self):
        """Of faces by number whether it is a hole: a loop along a boundary."""
        if self._kind != "face":
            raise AttributeError("only faces can be holes")
        return _arrays.frozen(self._mesh._holes())

    @property
    def vertices(self):
        """Of edges by number the two vertices; -1 where there is no edge."""
        if self._kind != "edge":
            raise AttributeError("only edges have two vertices")
        return _arrays.frozen(self._mesh._ends().reshape(-1, 2))

    @property
    def faces(self):
        """Of edges by number the two faces, that of the halfedge of the edge first; -1 where there is
        a hole, or no edge."""
        if self._kind != "edge":
            raise AttributeError("only edges have two faces")
        halfedges, first = self._mesh.halfedges, self.halfedge
        faces = np.where(self._mesh._holes()[halfedges.face], -1, halfedges.face)
        pairs = np.stack([faces[first], faces[halfedges.twin[first]]], 1)
        pairs[first < 0] = -1
        return _arrays.frozen(pairs)

    @property
    def target(self):
        """Of halfedges by number the vertex where it ends; -1 where there is no halfedge."""
        if self._kind != "halfedge":
            raise AttributeError("only halfedges have a target")
        twin = self.twin
        return _arrays.frozen(np.where(twin < 0, -1, self.vertex[twin]))

    @property
    def attributes(self):
        """The types of the attributes, by name."""
        return self._mesh._attributes(self._kind)

    def __getattr__(self, name):
        if name in self.__slots__:
            raise AttributeError(f"this table has no `{name}` yet", name=name, obj=self)
        if name in _POINTERS[self._kind]:
            return _arrays.frozen(self._mesh._pointers(self._kind, name))
        article = "an" if self._kind == "edge" else "a"
        raise AttributeError(f"{article} {self._kind} has no pointer `{name}`", name=name, obj=self)

    def __dir__(self):
        return sorted({*super().__dir__(), *_POINTERS[self._kind]})

    def __iter__(self):
        """The numbers of those that lived when the loop began and still do when their turn comes."""
        for number in self.ids.tolist():
            if self._mesh._is_alive(self._kind, number):
                yield number

    def __contains__(self, number):
        """Whether a number is that of a living element, of faces of one that is no hole; a text,
        whether it is an attribute. Nothing else is in."""
        if isinstance(number, str):
            return number in self.attributes
        try:
            return self._mesh._is_alive(self._kind, number)
        except (OverflowError, TypeError):
            return False

    def __getitem__(self, name):
        if not isinstance(name, str):
            raise TypeError("attributes go by their names")
        return _arrays.of_column(*self._mesh._attribute(self._kind, name))

    def __setitem__(self, name, values):
        if not isinstance(name, str):
            raise TypeError("attributes go by their names")
        what = f"the {self._kind} attribute `{name}`"
        array, word = _arrays.attribute(values, self.size, self.ids, what)
        known = self.attributes.get(name)
        if known == "real" and word in ("int", "bool"):
            array, word = array.astype(np.float64), "real"
        self._mesh._set_attribute(self._kind, name, array, word)

    def __delitem__(self, name):
        self._mesh._remove_attribute(self._kind, name)

    def __repr__(self):
        names = ", ".join(f"{name}: {word}" for name, word in self.attributes.items())
        return f"<{len(self)} {PLURALS[self._kind]}{' with ' + names if names else ''}>"


class _ByName:
    """Rows of elements, which by a name are an attribute of the elements."""

    _table = None

    def __getitem__(self, key):
        return self._table[key] if self._names(key) else self._row(key)

    def __setitem__(self, key, values):
        if self._names(key):
            self._table[key] = values
        else:
            super().__setitem__(key, values)

    def __delitem__(self, key):
        if self._names(key):
            del self._table[key]
        else:
            super().__delitem__(key)

    def __contains__(self, key):
        return key in self._table if self._names(key) else super().__contains__(key)

    def _names(self, key):
        return self._table is not None and isinstance(key, str)


class _Array(_ByName, np.ndarray):
    """Rows as an array; what is computed of it is an array of numpy."""

    def _plain(self):
        return self.view(np.ndarray)

    def _row(self, key):
        return self._plain()[key]

    def __reduce__(self):
        return self._plain().__reduce__()

    def __array_wrap__(self, array, context=None, return_scalar=False):
        return np.asarray(array)[()]

    def __repr__(self):
        return repr(self._plain())


class _List(_ByName, list):
    """Rows as a list of arrays."""

    _row = list.__getitem__

    def __reduce__(self):
        return list, (list(self),)


def rows(values, table):
    """Rows of the elements of a table, an array or a list, that take the names of attributes."""
    if isinstance(values, np.ndarray):
        made = _arrays.frozen(values.view(_Array))
    else:
        made = _List(values)
    made._table = table
    return made
