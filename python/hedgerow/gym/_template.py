"""Neighbourhoods of halfedges as rows of the same length.

The template of a halfedge are the vertices around its face, from its origin, then those that come
with the faces across the sides, from the halfedge on, then those across the sides of these, and so
on, as many as are wanted: the same place in two templates is the same place seen from the halfedge.
Where there is no face, the place is left out, and all that would have come through it.
"""

from __future__ import annotations

import numpy as np


def template_vertices(next_, twin, vertex, inside, darts, sides, size):
    """The vertices of the templates of some halfedges: a row for each, -1 where there is none.

    ``next_``, ``twin`` and ``vertex`` are pointers of all halfedges, and ``inside`` whether their
    faces are none of the holes; all faces have as many ``sides``.
    """
    # One place more, the last: where -1 leads, and from there to itself.
    step = np.append(next_, -1)
    across = np.append(np.where(inside[twin], twin, -1), -1)
    origin = np.append(vertex, -1)
    front = np.empty((len(darts), sides), dtype=np.int64)
    front[:, 0] = darts
    for side in range(1, sides):
        front[:, side] = step[front[:, side - 1]]
    found = [origin[front]]
    count = sides
    while count < size:
        beyond = across[front]
        around, corners = [], []
        for side in range(1, sides):
            beyond = step[beyond]
            around.append(beyond)
            if side > 1:
                corners.append(origin[beyond])
        width = front.shape[1]
        found.append(np.stack(corners, axis=2).reshape(len(darts), width * (sides - 2)))
        front = np.stack(around, axis=2).reshape(len(darts), width * (sides - 1))
        count += width * (sides - 2)
    return np.concatenate(found, axis=1)[:, :size]


def observe(boards, count, size, only_valid, bound):
    """What is seen of some boards: observations, the halfedges that their rows are of (-1 where there
    are fewer), and which actions apply there.

    All boards are looked at together: their tables are put one behind the other.
    """
    rules = boards[0].rules
    actions = len(rules.actions)
    tables = [_table(board, only_valid) for board in boards]
    shift = np.cumsum([0, *(len(table[0]) for table in tables)])
    vertex_shift = np.cumsum([0, *(len(table[4]) for table in tables)])

    def joined(column, by):
        parts = (table[column] + by[i] for i, table in enumerate(tables))
        return np.concatenate(list(parts))

    next_, twin, darts = joined(0, shift), joined(1, shift), joined(6, shift)
    vertex = joined(2, vertex_shift)
    inside = np.concatenate([table[3] for table in tables])
    score = np.append(np.concatenate([table[4] for table in tables]), 0)
    ideal = np.append(np.concatenate([table[5] for table in tables]), 0)
    vertices = template_vertices(next_, twin, vertex, inside, darts, rules.sides, size)
    scores = score[vertices]
    keys = np.abs(scores).sum(axis=1)

    observations = np.zeros((len(boards), count, 2 * size), dtype=np.int64)
    chosen = np.full((len(boards), count), -1, dtype=np.int64)
    valid = np.zeros((len(boards), count, actions), dtype=bool)
    end = 0
    for i, table in enumerate(tables):
        begin, end = end, end + len(table[6])
        # The most irregular first; of equal ones the lower number.
        rows = np.argsort(-keys[begin:end], kind="stable")[:count]
        here = begin + rows
        observations[i, : len(rows), :size] = scores[here]
        observations[i, : len(rows), size:] = ideal[vertices[here]] - scores[here]
        chosen[i, : len(rows)] = table[6][rows]
        valid[i, : len(rows)] = table[7][table[6][rows]]
    np.clip(observations, -bound, bound, out=observations)
    return observations, chosen, valid


def _table(board, only_valid):
    mesh = board.mesh
    halfedges = mesh.halfedges
    inside = board._inside()
    valid = board.valid()
    darts = np.flatnonzero(valid.any(axis=1) if only_valid else inside)
    pointers = (halfedges.next, halfedges.twin, halfedges.vertex)
    return *pointers, inside, mesh["score"], mesh["ideal"], darts, valid
