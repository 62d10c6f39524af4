"""Many environments at once."""

from __future__ import annotations

import numpy as np
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from ..errors import ArgumentError
from ._environment import PlanarMeshEnv


def _mode(given):
    """The mode of a name, of a value of gymnasium, or itself."""
    for mode in AutoresetMode:
        if given in (mode, mode.value, mode.name.lower()):
            return mode
    known = ", ".join(mode.name.lower() for mode in AutoresetMode)
    raise ArgumentError(f"`autoreset_mode` is one of {known}, not {given!r}", "wrong-argument")


class PlanarMeshVectorEnv(VectorEnv):
    """Many :class:`PlanarMeshEnv` at once, in one process: they share the compiled program, and are
    looked at together, which takes most of the time of a single one.

    Takes what a single one takes, and the mode in which environments that have ended begin again:
    ``"next_step"``, ``"same_step"`` or ``"disabled"``, or one of gymnasium's ``AutoresetMode``.
    ``action_space.sample(tuple(info["action_mask"]))`` samples actions that apply; with
    ``pairs=True`` see there. It is copied and pickled as a single one is.
    """

    def __init__(self, num_envs=1, *, autoreset_mode=AutoresetMode.NEXT_STEP, **kwargs):
        super().__init__()
        if not isinstance(num_envs, (int, np.integer)) or num_envs < 1:
            raise ArgumentError(f"`num_envs` is a whole number from 1, not {num_envs!r}", "wrong-argument")
        self.autoreset_mode = _mode(autoreset_mode)
        self.envs = [PlanarMeshEnv(**kwargs) for _ in range(num_envs)]
        self.num_envs = int(num_envs)
        first = self.envs[0]
        self.render_mode = first.render_mode
        self.metadata = {**first.metadata, "autoreset_mode": self.autoreset_mode}
        self.single_observation_space = first.observation_space
        self.single_action_space = first.action_space
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._over = np.zeros(num_envs, dtype=bool)
        self._observations = np.zeros(self.observation_space.shape, dtype=np.int64)

    def action_masks(self):
        """For each environment, a row, whether the actions apply now."""
        return np.stack([env.action_masks() for env in self.envs])

    def _look(self, which):
        """Looks at the environments of some numbers anew."""
        if len(which):
            self._observations[which] = PlanarMeshEnv._look([self.envs[i] for i in which])

    def _begin(self, which, seeds, options):
        """Begins an episode of the environments of some numbers, without observations: of all, or,
        with an exception, of none."""
        PlanarMeshEnv._begin([self.envs[i] for i in which], seeds, options)
        self._over[which] = False

    def reset(self, *, seed=None, options=None):
        options = dict(options or {})
        mask = np.asarray(options.pop("reset_mask", np.ones(self.num_envs, dtype=bool)))
        if mask.shape != (self.num_envs,):
            message = f"`reset_mask` has a bool for each of {self.num_envs} environments"
            raise ArgumentError(message, "wrong-argument")
        which = np.flatnonzero(mask)
        if seed is None or isinstance(seed, (int, np.integer)):
            seeds = [None if seed is None else int(seed) + i for i in range(self.num_envs)]
        else:
            seeds = list(seed)
        if len(seeds) != self.num_envs:
            message = f"there are {self.num_envs} environments, not {len(seeds)} as there are seeds"
            raise ArgumentError(message, "wrong-argument")
        self._begin(which, [seeds[i] for i in which], options)
        self._look(which)
        infos = {}
        for i in which:
            infos = self._add_info(infos, self.envs[i]._info(None), i)
        return self._observations.copy(), infos

    def step(self, actions):
        rewards = np.zeros(self.num_envs)
        reasons = [None] * self.num_envs
        ended = np.zeros((2, self.num_envs), dtype=bool)
        again = self._over.copy()
        if again.any() and self.autoreset_mode == AutoresetMode.DISABLED:
            raise ArgumentError("an environment has ended: reset it first", "wrong-argument")
        moves = self._moves(actions, again)
        which = np.flatnonzero(again)
        # Before any moves, since a new mesh may not come about.
        self._begin(which, [None] * len(which), None)
        which = np.flatnonzero(~again)
        try:
            for i in which:
                rewards[i], reasons[i] = self.envs[i]._do(*moves[i])
        finally:
            self._look(range(self.num_envs))
        for i in which:
            ended[:, i] = self.envs[i].is_over()
        self._over = ended.any(axis=0)
        infos = {}
        if self.autoreset_mode == AutoresetMode.SAME_STEP:
            which = np.flatnonzero(self._over)
            for i in which:
                last = {"final_obs": self._observations[i].copy()}
                last["final_info"] = self.envs[i]._info(reasons[i])
                infos = self._add_info(infos, last, i)
                reasons[i] = None
            # If a new mesh does not come about, they begin again at the next step.
            self._begin(which, [None] * len(which), None)
            self._look(which)
        for i, env in enumerate(self.envs):
            infos = self._add_info(infos, env._info(reasons[i]), i)
        return self._observations.copy(), rewards, ended[0], ended[1], infos

    def _moves(self, actions, again):
        """What each environment is to do, ``None`` where it begins again; nothing is done yet."""
        try:
            actions = list(actions)
        except TypeError:
            message = f"actions are a row, one for each environment, not {actions!r}"
            raise ArgumentError(message, "wrong-argument") from None
        if len(actions) != self.num_envs:
            message = f"there are {self.num_envs} environments, not {len(actions)} as there are actions"
            raise ArgumentError(message, "wrong-argument")
        for env in self.envs:
            env._expect_begun()
        return [None if over else env.decode(a) for env, a, over in zip(self.envs, actions, again)]

    def __getstate__(self):
        # As for a single one.
        _ = self.np_random, self.action_space.np_random
        return self.__dict__

    def render(self):
        return tuple(env.render() for env in self.envs)
