"""The environment."""

from __future__ import annotations

import operator
from collections.abc import Callable

import gymnasium
import numpy as np
from gymnasium import spaces

from .. import _mesh
from .._pictures import expect_size
from ..errors import ArgumentError
from ._board import Board, rules
from ._meshes import random_mesh
from ._render import ansi, pixels
from ._template import observe

#: Scores and degrees beyond are seen as this.
BOUND = 15


def _expect_source(mesh):
    """Raises an exception unless an episode can begin with something."""
    if mesh is not None and not isinstance(mesh, (_mesh.Mesh, Callable)):
        message = f"`mesh` is a mesh, or a function that makes one, not {type(mesh).__name__}"
        raise TypeError(message)


class PlanarMeshEnv(gymnasium.Env):
    """A planar mesh whose vertices are to get the degrees that suit them.

    **Observation**: an array of whole numbers with a row for each of ``darts`` halfedges, those with the
    most irregular neighbourhoods first, and rows of zeros if there are fewer. A row has the scores of
    the ``template`` vertices nearest to the halfedge (:func:`template_vertices`), and then their
    degrees; zeros where there is no vertex. The score is the ideal degree minus the degree.

    **Action**: a number, ``row * len(actions) + action``: what is done, and at the halfedge of which
    row. With ``pairs=True`` it is ``[action, row]``, as TUNE has it, and a number is taken as well. The
    actions are those of ``std/planar_triangle.hedge`` (flip, split, collapse) or of
    ``std/planar_quad.hedge`` and ``std/planar_cleanup.hedge`` (flip_cw, flip_ccw, split, collapse,
    cleanup).

    **Mask**: ``info["action_mask"]`` tells for each number whether the action applies, as
    ``action_space.sample`` takes it; :meth:`action_masks` is the same as bools, as the maskable agents
    of sb3-contrib ask for it. With ``pairs=True`` it is for numbers as well, since a ``MultiDiscrete``
    only takes a mask for each of the two parts, which cannot tell which pairs apply: sample a number by
    ``spaces.Discrete(len(mask)).sample(mask)`` or :func:`random_action`, and give ``step`` the number, or
    the pair ``[number % len(actions), number // len(actions)]``.

    **Reward**: by how much the irregularity fell, the sum of the absolute scores, times
    ``reward_scale`` (TUNE has 10); ``invalid_reward`` for an action that does not apply, which leaves
    the mesh as it is.

    **End**: terminated when the irregularity is the least that can be reached; truncated after
    ``max_steps`` steps, and where no action applies any more.

    **Info**: ``irregularity``, ``least_irregularity``, ``action_mask``, ``is_applied``, ``is_success``,
    and ``reason``, why the action did not apply, else ``None``. The mesh is ``env.unwrapped.mesh``.

    ``mesh`` is what each episode begins with: a :class:`hedgerow.Mesh` (of which each gets a copy), a
    function that makes one of a ``numpy.random.Generator``, or ``None`` for :func:`random_mesh` with
    ``points`` and ``family``. ``reset(options={"mesh": mesh})`` is for one episode. ``only_valid`` leaves
    halfedges out at which no action applies. ``strict`` plays by the rules that keep a simple mesh
    simple. ``render_size`` is the width of a picture in pixels, from 16 to 16384.

    **Copies**: ``copy.deepcopy(env)`` and ``pickle`` work at any time. The copy goes on exactly as the
    original would, and neither shows what is done to the other. To be pickled, a function ``mesh`` must
    be one that ``pickle`` takes, which a ``lambda`` is not.
    """

    metadata = {"render_modes": ["rgb_array", "ansi"], "render_fps": 4}

    def __init__(
        self,
        kind="triangle",
        mesh=None,
        *,
        points=10,
        family="delaunay",
        darts=20,
        template=12,
        max_steps=50,
        only_valid=True,
        strict=False,
        pairs=False,
        reward_scale=1.0,
        invalid_reward=-1.0,
        render_mode=None,
        render_size=400,
    ):
        if render_mode is not None and render_mode not in self.metadata["render_modes"]:
            known = ", ".join(self.metadata["render_modes"])
            raise ArgumentError(f"`render_mode` is one of {known}, not {render_mode!r}", "wrong-argument")
        for name, number in (("darts", darts), ("template", template), ("max_steps", max_steps)):
            if not isinstance(number, (int, np.integer)) or isinstance(number, bool) or number < 1:
                message = f"`{name}` is a whole number from 1, not {number!r}"
                raise ArgumentError(message, "wrong-argument")
        expect_size("render_size", render_size)
        _expect_source(mesh)
        self.rules = rules(kind, strict)
        self.render_mode = render_mode
        self._made_of = {"kind": kind, "strict": strict}
        self._mesh = mesh
        self._random = {"points": points, "family": family}
        self._darts, self._template, self._max_steps = int(darts), int(template), int(max_steps)
        self._only_valid, self._pairs, self._render_size = only_valid, pairs, render_size
        self._reward_scale, self._invalid_reward = float(reward_scale), float(invalid_reward)
        if isinstance(mesh, _mesh.Mesh):
            Board(mesh.copy(), **self._made_of)
        elif mesh is None:
            random_mesh(kind, 0, **self._random)
        shape = (self._darts, 2 * self._template)
        self.observation_space = spaces.Box(-BOUND, BOUND, shape, np.int64)
        actions = len(self.rules.actions)
        if pairs:
            self.action_space = spaces.MultiDiscrete([actions, self._darts])
        else:
            self.action_space = spaces.Discrete(actions * self._darts)
        #: The board; ``None`` before the first reset.
        self.board = None
        #: The halfedges that the rows of the observation are of; -1 where there is none.
        self.darts = np.full(self._darts, -1)
        self._valid = np.zeros((self._darts, actions), dtype=bool)
        self._steps = 0

    @property
    def mesh(self):
        """The mesh as it is now. It must not be changed: an agent's moves do that."""
        self._expect_begun()
        return self.board.mesh

    @property
    def actions(self):
        """The names of the actions, by number."""
        return self.rules.actions

    def decode(self, action):
        """What an action is: the number of what is done, and the halfedge; -1 if its row has none."""
        try:
            if self._pairs and np.shape(action) == (2,):
                does, row = map(operator.index, action)
            else:
                row, does = divmod(operator.index(action), len(self.actions))
        except (TypeError, ValueError):
            wanted = "a whole number or a pair of them" if self._pairs else "a whole number"
            raise ArgumentError(f"an action is {wanted}, not {action!r}", "wrong-argument") from None
        if not (0 <= row < len(self.darts) and 0 <= does < len(self.actions)):
            raise ArgumentError(f"there is no action {action}", "wrong-argument")
        return does, int(self.darts[row])

    def action_masks(self):
        """For each number of an action whether it applies now."""
        return self._valid.reshape(-1).copy()

    def reset(self, *, seed=None, options=None):
        self.begin(seed, options)
        return self._look([self])[0], self._info(None)

    def step(self, action):
        reward, reason = self.act(action)
        observation = self._look([self])[0]
        return observation, reward, *self.is_over(), self._info(reason)

    # A vectorised environment does the same with many of them, but looks at all together.

    def begin(self, seed, options):
        """Begins an episode, without an observation."""
        self._begin([self], [seed], options)

    @staticmethod
    def _begin(envs, seeds, options):
        """Begins an episode of some environments: of all, or, with an exception, of none. Their
        generators are then as they were, too."""
        # The attributes, since asking for a generator makes one.
        before = [(env._np_random, env._np_random_seed) for env in envs]
        states = [one and one.bit_generator.state for one, _ in before]
        try:
            boards = [env._board(seed, options) for env, seed in zip(envs, seeds)]
        except BaseException:
            for env, (one, seed), state in zip(envs, before, states):
                env._np_random, env._np_random_seed = one, seed
                if one:
                    one.bit_generator.state = state
            raise
        for env, board in zip(envs, boards):
            env.board, env._steps = board, 0

    def _board(self, seed, options):
        """The board of an episode that is about to begin."""
        mesh = (options or {}).get("mesh", self._mesh)
        _expect_source(mesh)
        super().reset(seed=seed)
        for _ in range(100):
            if mesh is None:
                made = random_mesh(self.rules.kind, self.np_random, **self._random)
            elif isinstance(mesh, _mesh.Mesh):
                made = mesh.copy()
            else:
                made = mesh(self.np_random)
            board = Board(made, **self._made_of)
            if isinstance(mesh, _mesh.Mesh) or not board.is_ideal:
                break
        return board

    def act(self, action):
        """Does an action, without an observation: the reward, and why it did not apply."""
        self._expect_begun()
        return self._do(*self.decode(action))

    def _do(self, does, dart):
        """Does what an action says at a halfedge; -1 is none."""
        before = self.board.irregularity
        self._steps += 1
        reason = "there is no halfedge"
        if dart >= 0:
            result = self.board.apply(does, dart)
            if result:
                return self._reward_scale * (before - self.board.irregularity), None
            reason = result.reason
        return self._invalid_reward, reason

    @staticmethod
    def _look(envs):
        """The observations of some environments, which are told what is seen."""
        one = envs[0]
        boards = [env.board for env in envs]
        seen = observe(boards, one._darts, one._template, one._only_valid, BOUND)
        observations, darts, valid = seen
        for env, env.darts, env._valid in zip(envs, darts, valid):
            pass
        return observations

    def is_over(self):
        """Whether the episode is terminated, and whether it is truncated."""
        terminated = self.board.is_ideal
        truncated = self._steps >= self._max_steps or not self._valid.any()
        return terminated, bool(truncated and not terminated)

    def _info(self, reason):
        return {
            "irregularity": self.board.irregularity,
            "least_irregularity": self.board.least_irregularity,
            "action_mask": self._valid.reshape(-1).astype(np.int8),
            "is_applied": reason is None,
            "is_success": self.board.is_ideal,
            "reason": reason,
        }

    def _expect_begun(self):
        if self.board is None:
            raise gymnasium.error.ResetNeeded("reset the environment first")

    def __getstate__(self):
        # They are made when they are asked for first, by chance: copies have the same.
        _ = self.np_random, self.action_space.np_random
        return self.__dict__

    def render(self):
        self._expect_begun()
        if self.render_mode == "rgb_array":
            return pixels(self.mesh, self._render_size)
        if self.render_mode == "ansi":
            return ansi(self.board)
        gymnasium.logger.warn("say what to render: `render_mode` is rgb_array or ansi")
        return None
