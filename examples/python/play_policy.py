"""Plays a recorded policy on a random mesh, or on one of yours.

    python play_policy.py policy_triangle.npz --seed 7
    python play_policy.py policy_triangle.npz --mesh plate.obj --save better.obj

The mesh has to be planar, of the faces that the policy was trained on, counterclockwise. What is kept
is the best mesh on the way.
"""

from __future__ import annotations

import argparse

import numpy as np
from policy import Policy

import hedgerow
import hedgerow.gym as hedgerow_gym


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("policy", help="a file that train_policy.py wrote (.npz)")
    parser.add_argument("--mesh", help="a file of a mesh; else a random mesh")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--steps", type=int, help="at most; else as many as in training")
    parser.add_argument("--save", help="where to write the best mesh")
    parser.add_argument("--show", action="store_true", help="print the scores before and after")
    given = parser.parse_args(arguments)
    try:
        policy = Policy.load(given.policy)
        made_for = {**policy.made_for, "max_steps": given.steps or policy.made_for["max_steps"]}
        mesh = hedgerow.Mesh.load(given.mesh) if given.mesh else None
        env = hedgerow_gym.PlanarMeshEnv(mesh=mesh, render_mode="ansi", **made_for)
    except (hedgerow.Error, OSError, ValueError) as error:
        parser.exit(2, f"{error}\n")
    rng = np.random.default_rng(given.seed)
    observation, info = env.reset(seed=given.seed)
    if given.show:
        print(env.render())
    begin = info["irregularity"]
    best, best_mesh, steps, over = begin, env.mesh.copy(), 0, False
    while not over:
        action = int(policy.act(observation[None], info["action_mask"][None], rng)[0])
        does, halfedge = env.decode(action)
        observation, reward, terminated, truncated, info = env.step(action)
        over = terminated or truncated
        steps += 1
        if reward:
            told = f"{env.actions[does]} at halfedge {halfedge}"
            print(f"{steps:4} {told:30} {reward:+4.0f}   irregularity {info['irregularity']}")
        if info["irregularity"] < best:
            best, best_mesh = info["irregularity"], env.mesh.copy()
            picture = env.render()
    if given.show and best < begin:
        print(picture)
    print(f"{begin} at the beginning, {best} at best, in {steps} steps; ", end="")
    print(f"less than {info['least_irregularity']} cannot be reached")
    if given.save:
        best_mesh.save(given.save)
    return best


if __name__ == "__main__":
    main()
