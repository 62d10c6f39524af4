"""A masked policy for `hedgerow.gym`, with numpy alone: one small network looks at every halfedge.

The network takes a row of the observation, the neighborhood of a halfedge, and gives a number for
each action there; the policy takes an action with the probability that softmax makes of all these
numbers together, of actions that do not apply none. So it plays meshes of any size.
"""

from __future__ import annotations

import numpy as np


class Network:
    """Layers of numbers with max(0, x) between them."""

    def __init__(self, sizes, rng, last=1.0):
        scales = [np.sqrt(2 / size) for size in sizes[:-1]]
        scales[-1] *= last
        self.parameters = []
        for inputs, outputs, scale in zip(sizes, sizes[1:], scales):
            weights = rng.normal(0, scale, (inputs, outputs)).astype(np.float32)
            self.parameters += [weights, np.zeros(outputs, np.float32)]

    def __call__(self, rows):
        """What comes out, and what went into each layer, for `gradient`."""
        inputs = []
        layers = list(zip(self.parameters[::2], self.parameters[1::2]))
        for number, (weights, bias) in enumerate(layers):
            inputs.append(rows)
            rows = rows @ weights + bias
            if number + 1 < len(layers):
                np.maximum(rows, 0, out=rows)
        return rows, inputs

    def gradient(self, inputs, slope):
        """The slopes of all parameters, given that of what came out."""
        slopes = []
        for weights, rows in zip(self.parameters[::2][::-1], inputs[::-1]):
            slopes += [slope.sum(axis=0), rows.T @ slope]
            slope = (slope @ weights.T) * (rows > 0)
        return slopes[::-1]


class Adam:
    """Steps against the slopes: D. Kingma, J. Ba, "Adam: a method for stochastic optimization", 2015."""

    def __init__(self, parameters, rate):
        self.parameters, self.rate, self.count = parameters, rate, 0
        self.means = [np.zeros_like(one) for one in parameters]
        self.squares = [np.zeros_like(one) for one in parameters]

    def step(self, slopes, most=0.5):
        size = np.sqrt(sum(float((slope**2).sum()) for slope in slopes))
        shrink = min(1.0, most / (size + 1e-12))
        self.count += 1
        rate = self.rate * np.sqrt(1 - 0.999**self.count) / (1 - 0.9**self.count)
        for one, mean, square, slope in zip(self.parameters, self.means, self.squares, slopes):
            slope = slope * shrink
            mean += 0.1 * (slope - mean)
            square += 0.001 * (slope**2 - square)
            one -= rate * mean / (np.sqrt(square) + 1e-8)


def seen(observations):
    """Observations as the network takes them: scores and degrees, about as large as one."""
    half = observations.shape[-1] // 2
    scores, degrees = observations[..., :half], observations[..., half:]
    return np.concatenate([scores / 2, degrees / 6], axis=-1).astype(np.float32)


def log_probabilities(logits, masks):
    """Logarithms of the probabilities of all actions; those that do not apply have next to none."""
    logits = np.where(masks, logits, np.float32(-1e9))
    logits = logits - logits.max(axis=1, keepdims=True)
    return logits - np.log(np.exp(logits).sum(axis=1, keepdims=True))


class Policy:
    """The network, and what it was made for: what `PlanarMeshEnv` takes as arguments."""

    def __init__(self, network, **made_for):
        self.network, self.made_for = network, made_for

    def log_probabilities(self, observations, masks):
        """Of actions, a row for each observation."""
        rows = seen(observations).reshape(-1, observations.shape[-1])
        logits, _ = self.network(rows)
        return log_probabilities(logits.reshape(len(observations), -1), masks)

    def act(self, observations, masks, rng=None):
        """An action for each observation: drawn at random, or without `rng` the likeliest one."""
        logs = self.log_probabilities(observations, np.asarray(masks, dtype=bool))
        if rng is None:
            return logs.argmax(axis=1)
        return (logs + rng.gumbel(size=logs.shape)).argmax(axis=1)

    def save(self, path):
        """Writes a file of numpy."""
        made_for = {f"for_{name}": value for name, value in self.made_for.items()}
        arrays = {f"layer{i:02}": one for i, one in enumerate(self.network.parameters)}
        np.savez_compressed(path, **arrays, **made_for)

    @classmethod
    def load(cls, path):
        """Reads a file that `save` wrote."""
        with np.load(path) as file:
            names = sorted(name for name in file if name.startswith("layer"))
            made_for = {name[4:]: file[name].item() for name in file if name.startswith("for_")}
            network = Network.__new__(Network)
            network.parameters = [file[name] for name in names]
        if not network.parameters:
            raise ValueError(f"`{path}` is no policy")
        return cls(network, **made_for)


def play(env, act, seeds):
    """Plays an episode for each seed: the irregularities above the least one at the beginning, at the
    end, and at their lowest. `act` takes the environment, an observation and its info."""
    all_gaps = []
    for seed in seeds:
        observation, info = env.reset(seed=int(seed))
        gaps = [info["irregularity"] - info["least_irregularity"]]
        over = False
        while not over:
            action = act(env, observation, info)
            observation, _, terminated, truncated, info = env.step(action)
            gaps.append(info["irregularity"] - info["least_irregularity"])
            over = terminated or truncated
        all_gaps.append((gaps[0], gaps[-1], min(gaps)))
    return np.array(all_gaps)


def told(name, gaps):
    """A line about what `play` gave: means, and their standard errors."""
    begin, end, lowest = gaps.T
    shares = [1 - end / begin, 1 - lowest / begin, end == 0]
    parts = [f"{100 * s.mean():5.1f} ± {100 * s.std(ddof=1) / np.sqrt(len(s)):3.1f}" for s in shares]
    return f"{name:10} {begin.mean():6.2f} {end.mean():6.2f}   {'   '.join(parts)}"


HEAD = "agent       begin    end   removed %      at best %      all of it %"
