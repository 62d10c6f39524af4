"""Random planar meshes."""

from __future__ import annotations

import numpy as np

from .. import _mesh, std
from ..errors import ArgumentError

#: How random meshes are made.
FAMILIES = ("delaunay", "shuffled")


def random_mesh(kind="triangle", rng=None, *, points=10, family="delaunay"):
    """A random planar mesh; the same generator gives the same mesh.

    ``delaunay``: a random polygon of 4 to 9 corners, with that many ``points`` inside, each place as
    likely, in Delaunay triangles; for quads each triangle is cut in three, as the published game
    begins. ``shuffled``: a regular mesh of at least that many vertices, on which as many actions were
    done at random, as TUNE begins.

    ``rng`` is a ``numpy.random.Generator``, or a seed for one.
    """
    if kind not in ("triangle", "quad"):
        raise ArgumentError(f"`kind` is triangle or quad, not {kind!r}", "wrong-argument")
    if family not in FAMILIES:
        known = " or ".join(FAMILIES)
        raise ArgumentError(f"`family` is {known}, not {family!r}", "wrong-argument")
    if not isinstance(points, (int, np.integer)) or isinstance(points, bool) or points < 0:
        raise ArgumentError(f"`points` is a whole number from 0, not {points!r}", "wrong-argument")
    rng = np.random.default_rng(rng)
    seed = int(rng.integers(2**63))
    if family == "shuffled":
        return _shuffled(kind, seed, points)
    mesh = _polygon(rng)
    std.random.random_triangulation(mesh, points=int(points), seed=seed)
    if kind == "quad":
        std.subdivide.linear_quads(mesh)
    return mesh


def _polygon(rng):
    """A polygon that is seen whole from its middle."""
    corners = int(rng.integers(4, 10))
    part = 2 * np.pi / corners
    angles = part * (np.arange(corners) + rng.uniform(-0.25, 0.25, corners))
    far = rng.uniform(0.6, 1.0, corners)
    points = np.stack([far * np.cos(angles), far * np.sin(angles)], axis=1)
    return _mesh.Mesh(points, [np.arange(corners)])


def _shuffled(kind, seed, points):
    if kind == "quad":
        side = max(2, int(np.ceil(np.sqrt(points))) - 1)
        mesh = _mesh.Mesh.grid(side, side)
        std.planar_cleanup.random_actions(mesh, seed=seed)
        return mesh
    angles = np.pi / 2 + 2 * np.pi / 3 * np.arange(3)
    mesh = _mesh.Mesh(np.stack([np.cos(angles), np.sin(angles)], axis=1), [[0, 1, 2]])
    std.random.grow_board(mesh, vertices_wanted=max(3, int(points)))
    ops = std.planar_triangle
    ops.measure(mesh)
    rng = np.random.default_rng(seed)
    masks = [ops.flip.live(mesh), ops.split.live(mesh), ops.collapse.live(mesh)]
    for _ in range(mesh.vertex_count):
        choice = int(rng.integers(3))
        number = masks[choice].pick(rng.random())
        if number is not None:
            (ops.flip, ops.split, ops.collapse)[choice](mesh, number)
    return mesh
