"""Pictures of boards."""

from __future__ import annotations

import numpy as np

from .._hedgerow import mesh_pixels


def pixels(mesh, size):
    """The mesh seen from above, the vertices coloured by their scores: an array of red, green and
    blue."""
    width, flat = mesh_pixels(mesh, float(size), (0.0, 0.0, 1.0), "score")
    return flat.reshape(-1, width, 3)


def ansi(board, width=60):
    """The scores of the vertices where they lie: a dot where it is 0, which is best."""
    mesh = board.mesh
    at = mesh.vertices[:, :2]
    scores = mesh["score"][mesh.vertex_ids]
    extent = np.maximum(np.ptp(at, axis=0), 1e-12)
    # A letter is twice as high as wide.
    height = int(np.clip(np.ceil(width / 2 * extent[1] / extent[0]), 1, width))
    places = (at - at.min(axis=0)) / extent * (width - 1, height - 1)
    rows = [[" "] * (width + 2) for _ in range(height)]
    for (x, y), score in zip(np.rint(places).astype(int), scores):
        told = f"{score:+d}" if score else "."
        for i, letter in enumerate(told):
            rows[height - 1 - y][x + i] = letter
    told = f"irregularity {board.irregularity}, at least {board.least_irregularity}; "
    told += f"{mesh.vertex_count} vertices, {mesh.face_count} {board.rules.kind}s"
    return "\n".join([told, *("".join(row).rstrip() for row in rows)]) + "\n"
