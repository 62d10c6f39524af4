from collections.abc import Callable, Sequence
from typing import Any, Literal, NamedTuple

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium.vector import AutoresetMode, VectorEnv

from .. import Applied, Mesh, Op, Refused, Script

_Kind = Literal["triangle", "quad"]
_Family = Literal["delaunay", "shuffled"]
_Ints = npt.NDArray[np.int64]
_Bools = npt.NDArray[np.bool_]

ACTIONS: dict[str, tuple[str, ...]]

class _Rules(NamedTuple):
    kind: _Kind
    sides: int
    actions: tuple[str, ...]
    ops: tuple[Op, ...]
    at_edges: tuple[bool, ...]
    measure: Script
    strict: bool

class Board:
    rules: _Rules
    mesh: Mesh
    least_irregularity: int
    def __init__(self, mesh: Mesh, kind: _Kind = "triangle", *, strict: bool = False) -> None: ...
    @property
    def irregularity(self) -> int: ...
    @property
    def is_ideal(self) -> bool: ...
    def valid(self) -> _Bools: ...
    def apply(self, action: int, halfedge: int) -> Applied | Refused: ...
    def gain(self, action: int, halfedge: int) -> int | None: ...

class PlanarMeshEnv(gymnasium.Env[_Ints, Any]):
    rules: _Rules
    board: Board | None
    darts: _Ints
    def __init__(
        self,
        kind: _Kind = "triangle",
        mesh: Mesh | Callable[[np.random.Generator], Mesh] | None = None,
        *,
        points: int = 10,
        family: _Family = "delaunay",
        darts: int = 20,
        template: int = 12,
        max_steps: int = 50,
        only_valid: bool = True,
        strict: bool = False,
        pairs: bool = False,
        reward_scale: float = 1.0,
        invalid_reward: float = -1.0,
        render_mode: Literal["rgb_array", "ansi"] | None = None,
        render_size: int = 400,
    ) -> None: ...
    @property
    def mesh(self) -> Mesh: ...
    @property
    def actions(self) -> tuple[str, ...]: ...
    def decode(self, action: Any) -> tuple[int, int]: ...
    def action_masks(self) -> _Bools: ...
    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[_Ints, dict[str, Any]]: ...
    def step(self, action: Any) -> tuple[_Ints, float, bool, bool, dict[str, Any]]: ...
    def begin(self, seed: int | None, options: dict[str, Any] | None) -> None: ...
    def act(self, action: Any) -> tuple[float, str | None]: ...
    def is_over(self) -> tuple[bool, bool]: ...
    def render(self) -> Any: ...

class PlanarMeshVectorEnv(VectorEnv[_Ints, Any, Any]):
    envs: list[PlanarMeshEnv]
    autoreset_mode: AutoresetMode
    def __init__(
        self,
        num_envs: int = 1,
        *,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
        **kwargs: Any,
    ) -> None: ...
    def action_masks(self) -> _Bools: ...
    def reset(
        self,
        *,
        seed: int | Sequence[int | None] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[_Ints, dict[str, Any]]: ...
    def step(self, actions: Any) -> tuple[_Ints, npt.NDArray[np.float64], _Bools, _Bools, dict[str, Any]]: ...
    def render(self) -> tuple[Any, ...]: ...

def random_mesh(
    kind: _Kind = "triangle",
    rng: np.random.Generator | int | None = None,
    *,
    points: int = 10,
    family: _Family = "delaunay",
) -> Mesh: ...
def random_action(env: gymnasium.Env[Any, Any], rng: np.random.Generator) -> int: ...
def greedy_action(env: gymnasium.Env[Any, Any], rng: np.random.Generator) -> int: ...
def template_vertices(
    next_: _Ints, twin: _Ints, vertex: _Ints, inside: _Bools, darts: _Ints, sides: int, size: int
) -> _Ints: ...
