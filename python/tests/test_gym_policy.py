"""The recorded policy, and the way it is trained and played."""

import pathlib
import sys

import numpy as np
import pytest

pytest.importorskip("gymnasium")
EXAMPLES = pathlib.Path(__file__).parents[2] / "examples" / "python"
if not EXAMPLES.is_dir():
    pytest.skip("the examples are not here", allow_module_level=True)
sys.path.insert(0, str(EXAMPLES))
import play_policy  # noqa: E402
import policy as policies  # noqa: E402
import train_policy  # noqa: E402
from gymnasium.vector import AutoresetMode  # noqa: E402

import hedgerow  # noqa: E402
from hedgerow import gym  # noqa: E402

RECORDED = EXAMPLES / "policy_triangle.npz"


def test_the_recorded_policy_beats_the_greedy_agent():
    policy = policies.Policy.load(RECORDED)
    env = gym.PlanarMeshEnv(**policy.made_for)
    rng = np.random.default_rng(0)

    def act(_, observation, info):
        return int(policy.act(observation[None], info["action_mask"][None], rng)[0])

    seeds = range(500, 510)
    ours = policies.play(env, act, seeds)
    greedy = policies.play(env, lambda env, *_: gym.greedy_action(env, rng), seeds)
    assert (ours[:, 0] == greedy[:, 0]).all()
    assert ours[:, 1].mean() < 0.8 * greedy[:, 1].mean()


def test_it_plays_a_mesh_of_ones_own(tmp_path, capsys):
    mesh = gym.random_mesh("triangle", 5, points=8)
    mesh.save(tmp_path / "board.obj")
    better = tmp_path / "better.obj"
    given = [str(RECORDED), "--mesh", str(tmp_path / "board.obj"), "--save", str(better), "--show"]
    best = play_policy.main(given)
    told = capsys.readouterr().out
    board = gym.Board(hedgerow.Mesh.load(better))
    assert board.irregularity == best < gym.Board(mesh).irregularity
    assert f"{best} at best" in told and "triangles" in told
    with pytest.raises(SystemExit):
        play_policy.main([str(tmp_path / "board.obj")])
    hedgerow.Mesh.cube().save(tmp_path / "cube.obj")
    with pytest.raises(SystemExit):
        play_policy.main([str(RECORDED), "--mesh", str(tmp_path / "cube.obj")])
    assert "other faces than triangles" in capsys.readouterr().err


@pytest.mark.parametrize("kind", ["triangle", "quad"])
def test_training_runs_and_what_is_written_is_read(kind, tmp_path):
    made_for = {"kind": kind, "points": 3, "darts": 8, "template": 6, "max_steps": 6}
    env = gym.PlanarMeshVectorEnv(4, autoreset_mode=AutoresetMode.SAME_STEP, **made_for)
    policy = train_policy.train(env, 0.002, 1, steps=16, batch=32, say=lambda *_, **__: None)
    policy.made_for = made_for
    policy.save(tmp_path / "policy.npz")
    again = policies.Policy.load(tmp_path / "policy.npz")
    assert again.made_for == made_for
    observations, infos = env.reset(seed=3)
    masks = infos["action_mask"]
    actions = policy.act(observations, masks)
    assert (actions == again.act(observations, masks)).all()
    assert masks[np.arange(4), actions].all()


def test_slopes_are_those_of_the_network():
    rng = np.random.default_rng(0)
    network = policies.Network([3, 5, 4, 2], rng)
    network.parameters = [one.astype(float) for one in network.parameters]
    rows, weights = rng.normal(size=(6, 3)), rng.normal(size=(6, 2))
    _, inputs = network(rows)
    slopes = network.gradient(inputs, weights)
    for one, slope in zip(network.parameters, slopes):
        found = np.zeros_like(one)
        for place in np.ndindex(one.shape):
            for sign in (1, -1):
                one[place] += sign * 1e-6
                found[place] += sign * (network(rows)[0] * weights).sum() / 2e-6
                one[place] -= sign * 1e-6
        np.testing.assert_allclose(slope, found, atol=1e-6)
