"""Environments for agents that improve planar meshes: ``pip install gymnasium``.

An agent flips, splits and collapses edges of a planar mesh of triangles or of quads until each
vertex has the degree that suits it. This is the game of A. Narayanan, Y. Pan and P.-O. Persson,
*Learning topological operations on meshes with application to block decomposition of polygons*,
2024, with actions and observations as TUNE has them (the Topologic UntaNgling 2D mEsher of LIHPC
Computational Geometry), and with a mask of the actions that apply.

>>> import gymnasium
>>> import hedgerow.gym
>>> env = gymnasium.make("hedgerow/PlanarTriangle-v0")
>>> observation, info = env.reset(seed=1)
>>> observation.shape
(20, 24)
>>> action = env.action_space.sample(info["action_mask"])
>>> observation, reward, terminated, truncated, info = env.step(action)
>>> info["is_applied"]
True

Registered are ``hedgerow/PlanarTriangle-v0`` and ``hedgerow/PlanarQuad-v0``; both also for
``gymnasium.make_vec``, which makes a :class:`PlanarMeshVectorEnv`, or with
``vectorization_mode="sync"`` or ``"async"`` one of gymnasium's own.
"""

from __future__ import annotations

try:
    import gymnasium
except ImportError as error:
    raise ImportError("hedgerow.gym needs gymnasium: `pip install gymnasium`") from error

from ._board import ACTIONS, Board
from ._environment import PlanarMeshEnv
from ._meshes import random_mesh
from ._policies import greedy_action, random_action
from ._template import template_vertices
from ._vector import PlanarMeshVectorEnv

__all__ = [
    "ACTIONS",
    "Board",
    "PlanarMeshEnv",
    "PlanarMeshVectorEnv",
    "greedy_action",
    "random_action",
    "random_mesh",
    "template_vertices",
]

for _name, _kind in (("PlanarTriangle", "triangle"), ("PlanarQuad", "quad")):
    gymnasium.register(
        id=f"hedgerow/{_name}-v0",
        entry_point="hedgerow.gym:PlanarMeshEnv",
        vector_entry_point="hedgerow.gym:PlanarMeshVectorEnv",
        kwargs={"kind": _kind},
    )
