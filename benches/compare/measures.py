"""What the comparisons of surfaces share: reading, writing, and how far two surfaces are apart."""

import pathlib

import igl
import numpy as np

HOUSE = pathlib.Path(__file__).resolve().parent.parent.parent
HEDGEROW = HOUSE / "target/release/hedgerow"
SAMPLES = 200_000


def read(path):
    lines = [line.split() for line in open(path)]
    points = [[float(x) for x in words[1:4]] for words in lines if words[:1] == ["v"]]
    faces = [[int(x.split("/")[0]) - 1 for x in words[1:]] for words in lines if words[:1] == ["f"]]
    return np.array(points), np.array(faces, dtype=np.int64)


def write(path, surface):
    points, faces = surface
    with open(path, "w") as out:
        out.writelines("v %r %r %r\n" % tuple(map(float, point)) for point in points)
        out.writelines("f %d %d %d\n" % tuple(face + 1) for face in faces)


def edges(faces):
    pairs = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    return np.unique(pairs, axis=0, return_counts=True)


def distances(left, right):
    """Root mean square and largest distance of two surfaces, both ways."""
    squares = []
    for (points, faces), other in ((left, right), (right, left)):
        random = np.random.default_rng(1)
        corners = points[faces]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        areas = np.linalg.norm(normals, axis=1)
        chosen = corners[random.choice(len(faces), SAMPLES, p=areas / areas.sum())]
        u, v = np.sqrt(random.random(SAMPLES)), random.random(SAMPLES)
        weights = np.stack([1 - u, u * (1 - v), u * v], axis=1)
        samples = np.einsum("ij,ijk->ik", weights, chosen)
        squares.append(igl.point_mesh_squared_distance(samples, *other)[0])
    squares = np.maximum(np.concatenate(squares), 0)
    return np.sqrt(squares.mean()), np.sqrt(squares.max())
