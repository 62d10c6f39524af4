"""A mesh that is played on: its score, and which actions apply where."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from .. import _mesh, std
from ..errors import ArgumentError

#: The actions on meshes of a kind, by number.
ACTIONS = {
    "triangle": ("flip", "split", "collapse"),
    "quad": ("flip_cw", "flip_ccw", "split", "collapse", "cleanup"),
}
_SIDES = {"triangle": 3, "quad": 4}


class Rules(NamedTuple):
    """What may be done with meshes of a kind."""

    kind: str
    #: The sides of a face.
    sides: int
    #: The names of the actions, and the operations that they are.
    actions: tuple
    ops: tuple
    #: Of each operation whether it is for an edge; else it is for a halfedge.
    at_edges: tuple
    #: The script that fixes the ideal degrees.
    measure: object
    #: Whether they keep a simple mesh simple.
    strict: bool

    def __reduce__(self):
        return rules, (self.kind, self.strict)


def rules(kind, strict=False):
    """The rules of a kind of meshes: those that were published, or those that keep a simple mesh
    simple."""
    if kind not in ACTIONS:
        raise ArgumentError(f"`kind` is triangle or quad, not {kind!r}", "wrong-argument")
    program = std.planar_triangle if kind == "triangle" else std.planar_cleanup
    actions = ACTIONS[kind]
    ops = tuple(
        program[f"strict_{name}" if strict and name != "cleanup" else name] for name in actions
    )
    at_edges = tuple(op.parameters[0].type == "edge" for op in ops)
    return Rules(kind, _SIDES[kind], actions, ops, at_edges, program.measure, bool(strict))


class Board:
    """A planar mesh that is played on.

    The *score* of a vertex is its ideal degree minus its degree; the ideal degree is 6 in a mesh of
    triangles and 4 in one of quads, and on the boundary as many as make angles of about 60 or 90
    degrees. The *irregularity* of the mesh is the sum of the absolute scores. No action changes the
    sum of the scores, so its absolute value is the least irregularity that can be reached.

    The mesh is changed; it gets the attributes ``ideal`` and ``score``. Refused is one that is not planar
    or closed, that has faces of another number of sides or a clockwise one, or a vertex without edges.
    """

    def __init__(self, mesh, kind="triangle", *, strict=False):
        self.rules = rules(kind, strict)
        _require_planar(mesh, self.rules)
        self.mesh = mesh
        self.rules.measure(mesh)
        self._masks = self._live()
        self._irregularity, self.least_irregularity = self._sums()

    def _live(self):
        """The masks of the operations by their columns, kept current; but for cleanups."""
        return {
            column: op.live(self.mesh)
            for column, op in enumerate(self.rules.ops)
            if self.rules.actions[column] != "cleanup"
        }

    def __getstate__(self):
        return {name: value for name, value in self.__dict__.items() if name != "_masks"}

    def __setstate__(self, state):
        self.__dict__.update(state)
        self._masks = self._live()

    def _sums(self):
        scores = self.mesh["score"][self.mesh.vertex_ids]
        return int(np.abs(scores).sum()), abs(int(scores.sum()))

    @property
    def irregularity(self):
        """The sum of the absolute scores."""
        if self._irregularity is None:
            self._irregularity, _ = self._sums()
        return self._irregularity

    @property
    def is_ideal(self):
        """Whether the irregularity is the least that can be reached."""
        return self.irregularity == self.least_irregularity

    def valid(self):
        """Whether an action applies: an array with a row for each halfedge by number, and a column
        for each action. Halfedges of holes have none."""
        halfedges = self.mesh.halfedges
        edge = halfedges.edge
        inside = self._inside()
        valid = np.zeros((len(edge), len(self.rules.actions)), dtype=bool)
        for column, mask in self._masks.items():
            values = mask.array
            valid[:, column] = values[edge] if self.rules.at_edges[column] else values[: len(edge)]
        if len(self._masks) < len(self.rules.actions):
            valid[:, -1] = self._cleanup(halfedges.next, halfedges.twin, inside)
        valid &= inside[:, None]
        return valid

    def _cleanup(self, next_, twin, inside):
        """Where a cleanup applies: it is asked once for all halfedges of a row, which it takes out
        whole."""
        op = self.rules.ops[-1]
        can = np.zeros(len(next_), dtype=bool)
        ahead = np.where(inside, twin[next_[next_]], -1).tolist()
        is_asked = (~inside).tolist()
        # Rows that begin at the boundary, then those that are rings.
        firsts = np.flatnonzero(inside & ~inside[twin]).tolist()
        for first in [*firsts, *np.flatnonzero(inside).tolist()]:
            row = []
            at = first
            while not is_asked[at]:
                is_asked[at] = True
                row.append(at)
                at = ahead[at]
            if row:
                can[row] = op.can(self.mesh, first)
        return can

    def _inside(self):
        """By number whether a halfedge lives, and has a face that is not a hole."""
        faces = self.mesh.elements("face")
        halfedges = self.mesh.halfedges
        return halfedges.alive & ~faces.is_hole[halfedges.face]

    def apply(self, action, halfedge):
        """Does an action, by its number, at a halfedge: what the operation returns."""
        # It is not known until it is asked for, so that an interrupt leaves none that is wrong.
        self._irregularity = None
        number = self.mesh.halfedges.edge[halfedge] if self.rules.at_edges[action] else halfedge
        return self.rules.ops[action](self.mesh, int(number))

    def gain(self, action, halfedge):
        """By how much an action would lower the irregularity; ``None`` if it does not apply."""
        before = self.irregularity
        with self.mesh.trial():
            gain = before - self._sums()[0] if self.apply(action, halfedge) else None
        self._irregularity = before
        return gain


def _require_planar(mesh, rules):
    if not isinstance(mesh, _mesh.Mesh):
        raise TypeError(f"a board is a `hedgerow.Mesh`, not {type(mesh).__name__}")
    if not mesh.face_count:
        raise ArgumentError("the mesh has no faces", "wrong-argument")
    ids = mesh.vertex_ids
    lone = ids[mesh.elements("vertex").halfedge[ids] < 0]
    if len(lone):
        raise ArgumentError(f"vertex {lone[0]} has no edges", "wrong-argument")
    faces = mesh.faces
    if not isinstance(faces, np.ndarray) or faces.shape[1] != rules.sides:
        raise ArgumentError(f"the mesh has other faces than {rules.kind}s", "wrong-argument")
    corners = mesh.vertices
    if np.ptp(corners[:, 2]) > 1e-9 * max(1.0, float(np.ptp(corners))):
        raise ArgumentError("the mesh is not planar: its vertices differ in z", "wrong-argument")
    if not mesh.elements("face").is_hole.any():
        raise ArgumentError("the mesh is not planar: it has no boundary", "wrong-argument")
    x, y = corners[faces, 0], corners[faces, 1]
    areas = (x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum(axis=1)
    if areas.min() < 0:
        face = int(mesh.face_ids[areas.argmin()])
        raise ArgumentError(f"face {face} is clockwise: turn the mesh over", "wrong-argument")
