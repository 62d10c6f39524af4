"""Trains a masked policy on `hedgerow.gym` for a few minutes, and compares it with a greedy agent.

    python train_policy.py --minutes 5 --out policy.npz

Proximal policy optimisation (J. Schulman and others, "Proximal policy optimization algorithms", 2017)
with advantages of J. Schulman and others, "High-dimensional continuous control using generalized
advantage estimation", 2016. The network that says how good a mesh is looks at every halfedge too, and
sums what it finds there.

What came of it for triangles, on 100 meshes that training had not seen (seeds 1000000 to 1000099; 10
points, episodes of 50 steps), after 5 minutes of one processor, which are 230,000 steps, with seed 1:

    agent       begin    end   removed %      at best %      all of it %
    random      20.14  75.42   -285.2 ± 7.6     1.5 ± 0.4     0.0 ± 0.0
    greedy      20.14  12.30    38.4 ± 2.5    43.5 ± 2.4     3.0 ± 1.7
    policy      20.14   6.38    68.5 ± 2.6    71.4 ± 2.5    18.0 ± 3.9
    likeliest   20.14   7.06    65.1 ± 2.6    66.9 ± 2.5    13.0 ± 3.4

`begin` and `end` are the irregularity above the least that can be reached, `removed` is the share of it
that is gone at the end, `at best` at the best moment of the episode, and `all of it` the share of the
meshes that became ideal: means and standard errors over the meshes. `greedy` takes the action that
lowers the irregularity most, of equally good ones a random one; `policy` draws its actions, and
`likeliest` takes the likeliest. The policy is `policy_triangle.npz`. That is one training: another one
differs, and the errors do not tell by how much.
"""

from __future__ import annotations

import argparse
import time

import numpy as np
from gymnasium.vector import AutoresetMode
from policy import HEAD, Adam, Network, Policy, log_probabilities, play, seen, told

import hedgerow.gym as hedgerow_gym

#: Seeds of the meshes on which agents are compared; training draws others.
TESTED = range(1_000_000, 1_000_100)


class Critic:
    """How much irregularity is still to be removed, as far as can be seen."""

    def __init__(self, columns, rng):
        self.network = Network([columns, 64, 64, 1], rng, last=0.1)

    def __call__(self, rows, is_row):
        found, inputs = self.network(rows.reshape(-1, rows.shape[-1]))
        values = (found.reshape(rows.shape[:2]) * is_row).sum(axis=1)
        return values, (inputs, is_row)

    def gradient(self, kept, slope):
        inputs, is_row = kept
        return self.network.gradient(inputs, (slope[:, None] * is_row).reshape(-1, 1))


def train(env, minutes, seed, steps=64, epochs=3, batch=512, discount=0.98, smooth=0.95, say=print):
    """Trains on an environment that is vectorised and begins again in the same step."""
    rng = np.random.default_rng(seed)
    columns = env.single_observation_space.shape[1]
    actions = len(env.envs[0].actions)
    policy = Policy(Network([columns, 128, 64, actions], rng, last=0.1))
    critic = Critic(columns, rng)
    actor_steps = Adam(policy.network.parameters, 7e-4)
    critic_steps = Adam(critic.network.parameters, 1e-3)
    observations, infos = env.reset(seed=seed)
    masks = infos["action_mask"].astype(bool)
    begun, rounds, done = time.process_time(), 0, []
    while time.process_time() - begun < 60 * minutes:
        left = 1 - (time.process_time() - begun) / (60 * minutes)
        actor_steps.rate, entropy_share = 7e-4 * max(left, 0.1), 0.01 * left
        kept = []
        for _ in range(steps):
            rows = seen(observations)
            is_row = masks.reshape(*rows.shape[:2], -1).any(axis=2)
            logs = policy.log_probabilities(observations, masks)
            chosen = (logs + rng.gumbel(size=logs.shape)).argmax(axis=1)
            values, _ = critic(rows, is_row)
            result = env.step(chosen)
            next_observations, rewards, terminated, truncated, infos = result
            ended = terminated | truncated
            later = np.zeros(len(rewards), np.float32)
            if truncated.any():
                # What would have come, had the time not run out.
                last = np.stack([infos["final_obs"][i] for i in np.flatnonzero(truncated)])
                there = infos["final_info"]["action_mask"][truncated].astype(bool)
                there = there.reshape(*last.shape[:2], -1).any(axis=2)
                later[truncated], _ = critic(seen(last), there)
            if ended.any():
                final = infos["final_info"]
                gaps = final["irregularity"] - final["least_irregularity"]
                done += gaps[ended].tolist()
            log = logs[np.arange(len(chosen)), chosen]
            kept.append((rows, is_row, masks, chosen, log, values, rewards, ended, later))
            observations, masks = next_observations, infos["action_mask"].astype(bool)
        rows, is_row, all_masks, chosen, logs, values, rewards, ended, later = (
            np.stack(part) for part in zip(*kept)
        )
        following, _ = critic(seen(observations), masks.reshape(*is_row.shape[1:], -1).any(axis=2))
        advantages = np.zeros_like(values)
        ahead = np.zeros(values.shape[1])
        for t in reversed(range(steps)):
            after = np.where(ended[t], later[t], following)
            error = rewards[t] + discount * after - values[t]
            ahead = error + discount * smooth * np.where(ended[t], 0, ahead)
            advantages[t], following = ahead, values[t]
        returns = advantages + values
        data = [part.reshape(-1, *part.shape[2:]) for part in (rows, is_row, all_masks, chosen, logs)]
        advantages, returns = advantages.reshape(-1), returns.reshape(-1)
        advantages = (advantages - advantages.mean()) / (advantages.std() + 1e-8)
        for _ in range(epochs):
            order = rng.permutation(len(returns))
            for some in np.split(order, range(batch, len(order), batch)):
                part = [column[some] for column in data]
                improve(policy.network, actor_steps, part, advantages[some], entropy_share)
                found, inputs = critic(part[0], part[1])
                slope = (found - returns[some]).astype(np.float32) / len(some)
                critic_steps.step(critic.gradient(inputs, slope), most=5.0)
        rounds += 1
        if rounds % 10 == 0 and done:
            say(
                f"{(time.process_time() - begun) / 60:5.1f} min  {rounds * steps * env.num_envs:8} steps  "
                f"left at the end of an episode {np.mean(done):5.2f}",
                flush=True,
            )
            done = []
    return policy


def improve(network, adam, part, advantages, entropy_share, clip=0.2):
    """A step of the policy."""
    rows, _, masks, chosen, before = part
    count = len(rows)
    logits, inputs = network(rows.reshape(-1, rows.shape[-1]))
    logs = log_probabilities(logits.reshape(count, -1), masks)
    odds = np.exp(logs)
    each = np.arange(count)
    ratio = np.exp(logs[each, chosen] - before)
    too_far = np.where(advantages > 0, ratio > 1 + clip, ratio < 1 - clip)
    pull = np.where(too_far, 0, ratio * advantages)
    slope = odds * pull[:, None]
    slope[each, chosen] -= pull
    entropy = -(odds * np.where(masks, logs, 0)).sum(axis=1, keepdims=True)
    slope += entropy_share * odds * (np.where(masks, logs, 0) + entropy)
    slope = (np.where(masks, slope, 0) / count).astype(np.float32)
    adam.step(network.gradient(inputs, slope.reshape(len(logits), -1)))


def compare(policy, made_for, seeds):
    """Plays the same meshes with all agents."""
    env = hedgerow_gym.PlanarMeshEnv(**made_for)
    rng = np.random.default_rng(0)

    def of_policy(rng):
        return lambda _, observation, info: int(
            policy.act(observation[None], info["action_mask"][None], rng)[0]
        )

    agents = {
        "random": lambda env, *_: hedgerow_gym.random_action(env, rng),
        "greedy": lambda env, *_: hedgerow_gym.greedy_action(env, rng),
        "policy": of_policy(rng),
        "likeliest": of_policy(None),
    }
    print(HEAD)
    for name, act in agents.items():
        if policy is not None or name in ("random", "greedy"):
            print(told(name, play(env, act, seeds)), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--kind", default="triangle", choices=["triangle", "quad"])
    parser.add_argument("--points", type=int, default=10)
    parser.add_argument("--darts", type=int, default=30)
    parser.add_argument("--template", type=int, default=24)
    parser.add_argument("--max-steps", type=int, default=50)
    parser.add_argument("--minutes", type=float, default=5, help="of the processor's time")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--envs", type=int, default=32)
    parser.add_argument("--tested", type=int, default=len(TESTED), help="on how many meshes")
    parser.add_argument("--out", help="where to write the policy (.npz)")
    given = parser.parse_args()
    made_for = {
        "kind": given.kind,
        "points": given.points,
        "darts": given.darts,
        "template": given.template,
        "max_steps": given.max_steps,
    }
    if given.minutes <= 0 or given.tested < 2:
        parser.error("`--minutes` is above 0, and `--tested` at least 2")
    env = hedgerow_gym.PlanarMeshVectorEnv(given.envs, autoreset_mode=AutoresetMode.SAME_STEP, **made_for)
    policy = train(env, given.minutes, given.seed)
    policy.made_for = made_for
    if given.out:
        policy.save(given.out)
    compare(policy, made_for, TESTED[: given.tested])


if __name__ == "__main__":
    main()
