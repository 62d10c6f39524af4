"""What agents are compared with."""

from __future__ import annotations

import numpy as np


def random_action(env, rng):
    """A random action among those that apply; 0 if none does."""
    numbers = np.flatnonzero(env.unwrapped.action_masks())
    return int(rng.choice(numbers)) if len(numbers) else 0


def greedy_action(env, rng):
    """The action that lowers the irregularity most, of equally good ones a random one; 0 if none
    applies.

    All actions that apply at the halfedges that are seen are tried, and undone. A greedy agent so
    wanders while nothing is gained; if all that applies is a loss, it takes the least one.
    """
    env = env.unwrapped
    numbers = np.flatnonzero(env.action_masks())
    if not len(numbers):
        return 0
    gains = np.array([env.board.gain(*env.decode(number)) for number in numbers])
    return int(rng.choice(numbers[gains == gains.max()]))
