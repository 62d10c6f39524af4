"""The environment: what it shows, pays and refuses, and that gymnasium takes it for one."""

import copy
import pickle
import signal

import numpy as np
import pytest

import hedgerow

gymnasium = pytest.importorskip("gymnasium")
from gymnasium.utils.env_checker import check_env  # noqa: E402

from hedgerow import gym  # noqa: E402

IDS = {"triangle": "hedgerow/PlanarTriangle-v0", "quad": "hedgerow/PlanarQuad-v0"}
KINDS = list(IDS)


def grid(kind, side=4):
    return hedgerow.Mesh.grid(side, side, triangles=kind == "triangle")


def played(env, seed, policy=gym.random_action):
    """Plays an episode, and yields what each step gives."""
    observation, info = env.reset(seed=seed)
    rng = np.random.default_rng(seed)
    over = False
    while not over:
        result = env.step(policy(env, rng))
        yield result
        over = result[2] or result[3]


def asked_anew(env):
    """Where actions apply, asked on a copy, which has kept nothing."""
    mesh = env.mesh.copy()
    halfedges = mesh.halfedges
    inside = halfedges.alive & ~mesh.elements("face").is_hole[halfedges.face]
    columns = []
    for op, at_edges in zip(env.rules.ops, env.rules.at_edges):
        can = op.can(mesh)
        columns.append(inside & (can[halfedges.edge] if at_edges else can))
    return np.stack(columns, axis=1)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("pairs", [False, True])
@pytest.mark.filterwarnings("ignore:.*we recommend.*")
@pytest.mark.filterwarnings("error")
def test_gymnasium_takes_it(kind, pairs):
    env = gymnasium.make(IDS[kind], pairs=pairs, points=5, render_mode="rgb_array", render_size=64)
    check_env(env.unwrapped)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("family", ["delaunay", "shuffled"])
@pytest.mark.parametrize("strict", [False, True])
def test_scores_rewards_and_masks_are_what_they_say(kind, family, strict):
    env = gym.PlanarMeshEnv(kind, points=9, family=family, strict=strict, max_steps=25, darts=1000)
    for seed in range(2):
        before = None
        for observation, reward, terminated, truncated, info in played(env, seed):
            assert env.observation_space.contains(observation)
            mesh = env.mesh
            halfedges, size = mesh.halfedges, mesh.elements("vertex").size
            degree = np.bincount(halfedges.vertex[halfedges.ids], minlength=size)
            scores = (mesh["ideal"] - degree)[mesh.vertex_ids]
            assert info["irregularity"] == np.abs(scores).sum()
            assert info["least_irregularity"] == abs(scores.sum())
            assert info["is_applied"] and info["reason"] is None
            if before is not None:
                assert reward == before - info["irregularity"]
            before = info["irregularity"]
            assert terminated == info["is_success"] == (before == info["least_irregularity"])
            mesh.check()
            valid = asked_anew(env)
            rows = env.darts >= 0
            seen = env.action_masks().reshape(len(env.darts), -1)
            assert (seen[rows] == valid[env.darts[rows]]).all() and not seen[~rows].any()
            assert set(env.darts[rows]) == set(np.flatnonzero(valid.any(axis=1)))


@pytest.mark.parametrize("kind", KINDS)
def test_an_action_that_does_not_apply_changes_nothing_and_says_why(kind):
    env = gym.PlanarMeshEnv(kind, mesh=grid(kind), only_valid=False, darts=110, max_steps=10_000)
    _, info = env.reset(seed=0)
    board, before = env.mesh, env.mesh.copy()
    numbers = np.flatnonzero(info["action_mask"] == 0)
    reasons = set()
    for number in numbers:
        _, reward, _, _, info = env.step(number)
        assert reward == -1 and not info["is_applied"]
        reasons.add(info["reason"])
    assert env.mesh is board and board == before
    assert "there is no halfedge" in reasons and len(reasons) >= 3


@pytest.mark.parametrize("kind", KINDS)
def test_the_same_seed_gives_the_same_episode(kind):
    def all_of(seed):
        env = gymnasium.make(IDS[kind], points=6, max_steps=12)
        return [(o.tolist(), r, a, b) for o, r, a, b, _ in played(env, seed)]

    assert all_of(5) == all_of(5)
    assert all_of(5) != all_of(6)


def test_the_template_is_the_neighbourhood():
    # A hexagon of six triangles around a vertex: all that a halfedge at it can see.
    angles = np.pi / 3 * np.arange(6)
    points = np.vstack([[0, 0], np.stack([np.cos(angles), np.sin(angles)], axis=1)])
    mesh = hedgerow.Mesh(points, [[0, i + 1, (i + 1) % 6 + 1] for i in range(6)])
    halfedges = mesh.halfedges
    inside = ~mesh.elements("face").is_hole[halfedges.face]
    ends = list(zip(halfedges.vertex.tolist(), halfedges.vertex[halfedges.twin].tolist()))
    dart = ends.index((0, 1))
    rows = gym.template_vertices(
        halfedges.next, halfedges.twin, halfedges.vertex, inside, np.array([dart]), 3, 12
    )
    # The triangle 0 1 2; across 0-1 lies 6, across 1-2 nothing, across 2-0 lies 3; then, through
    # 6, 5 and nothing; through what is not there, nothing; through 3, nothing and 4.
    assert rows.tolist() == [[0, 1, 2, 6, -1, 3, 5, -1, -1, -1, -1, 4]]


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_seen_is_the_same_from_each_side_of_a_torus(kind):
    mesh = hedgerow.Mesh.torus(7, 7, triangles=kind == "triangle")
    halfedges = mesh.halfedges
    inside = np.ones(halfedges.size, dtype=bool)
    sides = 3 if kind == "triangle" else 4
    rows = gym.template_vertices(
        halfedges.next, halfedges.twin, halfedges.vertex, inside, halfedges.ids, sides, 20
    )
    assert rows.shape == (halfedges.size, 20) and (rows >= 0).all()
    assert (rows[:, 0] == halfedges.vertex).all()
    assert (rows[:, 1] == halfedges.vertex[halfedges.twin]).all()


def test_rows_are_scores_and_degrees_the_most_irregular_first():
    mesh = grid("triangle", 5)
    env = gym.PlanarMeshEnv(mesh=mesh, template=3, darts=30, only_valid=False)
    observation, _ = env.reset(seed=1)
    played_on = env.mesh
    scores, ideal = played_on["score"], played_on["ideal"]
    halfedges = played_on.halfedges
    corners = [env.darts]
    for _ in range(2):
        corners.append(halfedges.next[corners[-1]])
    vertices = halfedges.vertex[np.stack(corners, axis=1)]
    assert (observation[:, :3] == scores[vertices]).all()
    assert (observation[:, 3:] == (ideal - scores)[vertices]).all()
    sums = np.abs(observation[:, :3]).sum(axis=1)
    assert (np.diff(sums) <= 0).all() and sums[0] > 0


def test_a_mesh_of_ones_own_is_copied_for_each_episode():
    mesh = grid("quad")
    hedgerow.std.planar_cleanup.random_actions(mesh, actions=10, seed=4)
    before = mesh.copy()
    env = gym.PlanarMeshEnv("quad", mesh=mesh, max_steps=5)
    first, _ = env.reset(seed=1)
    env.step(gym.random_action(env, np.random.default_rng(0)))
    again, _ = env.reset()
    assert mesh == before and (first == again).all()
    other = gym.random_mesh("quad", 3, points=4)
    env.reset(options={"mesh": other})
    assert env.mesh.face_count == other.face_count
    made = gym.PlanarMeshEnv(mesh=lambda rng: gym.random_mesh("triangle", rng, points=3))
    assert made.reset(seed=2)[0].tolist() == made.reset(seed=2)[0].tolist()


def test_an_episode_ends():
    env = gym.PlanarMeshEnv(max_steps=7, points=30)
    assert len(list(played(env, 1))) == 7
    # A single quad: nothing can be done.
    lonely = gym.PlanarMeshEnv("quad", mesh=hedgerow.Mesh.grid(1, 1))
    _, info = lonely.reset()
    assert not info["action_mask"].any()
    _, reward, terminated, truncated, info = lonely.step(0)
    assert (terminated, truncated) == (True, False) or (terminated, truncated) == (False, True)
    # An edge that is turned the wrong way: one flip mends it.
    mesh = grid("triangle", 6)
    flip = hedgerow.std.planar_triangle.flip
    hedgerow.std.planar_triangle.measure(mesh)
    before = mesh["score"].copy()
    assert flip(mesh, int(flip.live(mesh).numbers()[20]))
    assert not (mesh["score"] == before).all()


@pytest.mark.parametrize("kind", KINDS)
def test_greedy_takes_the_best(kind):
    env = gym.PlanarMeshEnv(kind, points=6)
    env.reset(seed=3)
    board, rng = env.board, np.random.default_rng(0)
    before = env.mesh.copy()
    gains = [board.gain(*env.decode(n)) for n in np.flatnonzero(env.action_masks())]
    assert env.mesh == before and None not in gains
    _, reward, *_ = env.step(gym.greedy_action(env, rng))
    assert reward == max(gains)


@pytest.mark.parametrize("kind", KINDS)
def test_an_interrupt_leaves_the_irregularity_of_the_mesh(kind, monkeypatch):
    board = gym.Board(gym.random_mesh(kind, 1), kind)
    before, mesh = board.irregularity, board.mesh.copy()
    places = np.argwhere(board.valid()).tolist()
    halfedge, action = next(place for place in places if board.gain(*place[::-1]))

    def interrupted():
        raise KeyboardInterrupt

    def true():
        return int(np.abs(board.mesh["score"][board.mesh.vertex_ids]).sum())

    # At the moment when the operation has been done.
    for does, undoes in ((board.gain, True), (board.apply, False)):
        monkeypatch.setattr(board, "_sums", interrupted)
        with pytest.raises(KeyboardInterrupt):
            does(action, halfedge)
            _ = board.irregularity
        monkeypatch.undo()
        assert (board.irregularity == before) == undoes == (board.mesh == mesh)
        assert board.irregularity == true()
    # And wherever it comes.
    rng = np.random.default_rng(2)
    env = gym.PlanarMeshEnv(kind, points=6)
    env.reset(seed=1)
    board, whole = env.board, env.mesh.copy()
    usual = signal.signal(signal.SIGALRM, signal.default_int_handler)
    try:
        for _ in range(100):
            with pytest.raises(KeyboardInterrupt):
                signal.setitimer(signal.ITIMER_REAL, rng.uniform(0.001, 0.01))
                while True:
                    gym.greedy_action(env, rng)
            assert board.mesh == whole and board.irregularity == true()
    finally:
        signal.signal(signal.SIGALRM, usual)


def test_pictures():
    env = gymnasium.make(IDS["triangle"], render_mode="rgb_array", render_size=120)
    env.reset(seed=1)
    picture = env.render()
    assert picture.dtype == np.uint8 and picture.ndim == 3 and picture.shape[2] == 3
    assert len(np.unique(picture.reshape(-1, 3), axis=0)) > 20
    first = picture.copy()
    for _ in range(5):
        env.step(gym.random_action(env, np.random.default_rng(2)))
    assert (env.render() != first).any()
    text = gymnasium.make(IDS["quad"], render_mode="ansi")
    text.reset(seed=1)
    told = text.render()
    assert told.startswith("irregularity ") and "quads" in told and "+1" in told


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"kind": "hexagon"}, "triangle or quad"),
        ({"darts": 0}, "`darts` is a whole number from 1"),
        ({"template": 2.5}, "`template` is a whole number"),
        ({"max_steps": -1}, "`max_steps`"),
        ({"points": -1}, "`points`"),
        ({"family": "odd"}, "delaunay or shuffled"),
        ({"render_mode": "human"}, "rgb_array, ansi"),
        ({"mesh": "a.obj"}, "a mesh, or a function"),
        ({"mesh": hedgerow.Mesh.cube()}, "other faces than triangles"),
        ({"mesh": hedgerow.Mesh.icosphere(1)}, "not planar"),
        ({"mesh": hedgerow.Mesh([[0, 0], [0, 1], [1, 0]], [[0, 1, 2]])}, "clockwise"),
        ({"mesh": hedgerow.Mesh()}, "no faces"),
        ({"render_size": -1}, "`render_size` is a number of pixels from 16 to 16384, not -1"),
        ({"render_size": 10**7}, "`render_size`"),
    ],
)
def test_wrong_arguments_are_told(arguments, message):
    with pytest.raises((ValueError, TypeError), match=message):
        gym.PlanarMeshEnv(**arguments)


def test_wrong_use_is_told():
    env = gym.PlanarMeshEnv()
    for use in (lambda: env.step(0), env.render, lambda: env.mesh):
        with pytest.raises(gymnasium.error.ResetNeeded):
            use()
    env.reset(seed=0)
    before, state = env.mesh.copy(), env.np_random.bit_generator.state
    for action in (1.7, "3", None, [0, 1], np.array([3]), np.float64(2)):
        with pytest.raises(hedgerow.ArgumentError, match="an action is a whole number, not"):
            env.step(action)
    with pytest.raises(TypeError, match="`mesh` is a mesh, or a function that makes one, not int"):
        env.reset(seed=3, options={"mesh": 3})
    assert env.mesh == before and env.np_random.bit_generator.state == state
    pairs = gym.PlanarMeshEnv(pairs=True)
    pairs.reset(seed=0)
    for action in ([0, 1, 2], [0], [0, 1.5], "ab", [[0, 1]]):
        with pytest.raises(hedgerow.ArgumentError, match="or a pair of them"):
            pairs.step(action)
    with pytest.raises(ValueError, match="there is no action"):
        env.step(10_000)
    with pytest.raises(TypeError, match=r"hedgerow\.Mesh"):
        env.reset(options={"mesh": lambda rng: 3})


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("mode", ["NextStep", "SameStep"])
def test_many_at_once_do_as_each_alone(kind, mode):
    mode = gymnasium.vector.AutoresetMode(mode)
    given = {"kind": kind, "points": 4, "max_steps": 5}
    batch = gym.PlanarMeshVectorEnv(3, autoreset_mode=mode, **given)
    alone = gymnasium.vector.SyncVectorEnv(
        [lambda: gym.PlanarMeshEnv(**given)] * 3, autoreset_mode=mode
    )
    a, b = batch.reset(seed=7), alone.reset(seed=7)
    rng = np.random.default_rng(1)
    for _ in range(14):
        _same(a, b)
        masks = a[-1]["action_mask"]
        actions = np.array([rng.choice(np.flatnonzero(m)) if m.any() else 0 for m in masks])
        a, b = batch.step(actions), alone.step(actions)
    assert batch.observation_space.contains(a[0])


class Failing:
    """A source of meshes that fails once."""

    def __init__(self, kind, fails_at):
        self.kind, self.left = kind, fails_at

    def __call__(self, rng):
        self.left -= 1
        if not self.left:
            raise OSError("no mesh")
        return gym.random_mesh(self.kind, rng, points=8)


def state(many):
    """What many environments are, and whether what they have seen is so."""
    boards = [env.board for env in many.envs]
    for env, board in zip(many.envs, boards):
        assert board.irregularity == gym.Board(board.mesh.copy(), many.envs[0].rules.kind).irregularity
    seen = many._observations.copy(), many.action_masks()
    many._look(range(many.num_envs))
    np.testing.assert_array_equal(seen[0], many._observations)
    np.testing.assert_array_equal(seen[1], many.action_masks())
    generators = [env.np_random.bit_generator.state for env in many.envs]
    meshes = [board.mesh.to_bytes() for board in boards]
    return generators, meshes, [env._steps for env in many.envs], many._over.tolist()


def test_a_refused_beginning_of_many_begins_none():
    many = gym.PlanarMeshVectorEnv(2, points=4)
    many.reset(seed=1)
    before = state(many)
    with pytest.raises(gymnasium.error.Error):
        many.reset(seed=[5, -1])
    assert state(many) == before
    for env in many.envs:
        env._mesh = Failing("triangle", 2)
    with pytest.raises(OSError):
        many.reset(options={"mesh": Failing("triangle", 2)})
    assert state(many) == before
    one = many.envs[0]
    with pytest.raises(OSError):
        one.reset(seed=7, options={"mesh": Failing("triangle", 1)})
    assert state(many) == before


@pytest.mark.parametrize("mode", ["next_step", "same_step"])
def test_a_step_of_many_whose_new_mesh_fails_can_be_repeated(mode):
    source = Failing("triangle", 0)
    many = gym.PlanarMeshVectorEnv(2, mesh=source, max_steps=3, autoreset_mode=mode)

    def step():
        return many.step([int(mask.argmax()) for mask in many.action_masks()])

    many.reset(seed=1)
    step(), step()
    many.reset(options={"reset_mask": [False, True]})
    if mode == "next_step":
        step()
    before = state(many)
    source.left = 1
    with pytest.raises(OSError):
        step()
    # The first one has ended, and did so in a step that has been done.
    assert state(many)[2:] == ([3, 1], [True, False])
    assert mode == "same_step" or state(many) == before
    *_, info = step()
    assert state(many)[2:] == ([0, 2], [False, False]) and info["is_applied"].all()


def _same(a, b):
    for ours, theirs in zip(a[:-1], b[:-1]):
        np.testing.assert_array_equal(ours, theirs)
    assert a[-1].keys() == b[-1].keys()
    for name in ("action_mask", "irregularity", "is_success"):
        np.testing.assert_array_equal(a[-1][name], b[-1][name])


def test_registered_and_vectorised():
    env = gymnasium.make_vec(IDS["quad"], num_envs=2, points=3)
    assert isinstance(env, gym.PlanarMeshVectorEnv)
    observation, info = env.reset(seed=1)
    assert observation.shape == (2, 20, 24) and info["action_mask"].shape == (2, 100)
    env.step(env.action_space.sample())
    with pytest.raises(ValueError, match="as there are seeds"):
        env.reset(seed=[1])


def test_in_processes():
    env = gymnasium.make_vec(
        IDS["triangle"], num_envs=2, vectorization_mode="async", points=4,
        vector_kwargs={"context": "spawn"},
    )  # fmt: skip
    try:
        observation, _ = env.reset(seed=1)
        same, _ = gymnasium.make_vec(IDS["triangle"], num_envs=2, points=4).reset(seed=1)
        assert (observation == same).all()
        assert env.step(env.action_space.sample())[1].shape == (2,)
    finally:
        env.close()


COPIES = [copy.deepcopy, lambda env: pickle.loads(pickle.dumps(env))]


@pytest.mark.parametrize("copied", COPIES)
def test_an_environment_that_was_not_begun_is_copied(copied):
    env = gym.PlanarMeshEnv("quad", points=3)
    other = copied(env)
    assert (env.reset()[0] == other.reset()[0]).all()
    assert env.action_space.sample() == other.action_space.sample()


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("copied", COPIES)
@pytest.mark.parametrize("given", [{}, {"pairs": True}, {"strict": True, "family": "shuffled"}])
def test_a_copy_goes_on_as_the_original(kind, copied, given):
    env = gymnasium.make(IDS[kind], points=6, max_steps=6, **given)
    env.reset(seed=2)
    rng = np.random.default_rng(0)
    for _ in range(2):
        env.step(gym.random_action(env, rng))
    before = env.unwrapped.mesh.copy()
    other = copied(env)
    rngs = [np.random.default_rng(5), np.random.default_rng(5)]
    told = [list(_going_on(one, rng)) for one, rng in zip((other, env), rngs)]
    assert told[0] == told[1]
    # The one copied from has not been touched by what the copy did.
    again = copied(env)
    env.reset()
    for one in (other, again):
        one.reset()
        assert one.unwrapped.mesh == env.unwrapped.mesh != before
    mesh = env.unwrapped.mesh.copy()
    other.step(gym.random_action(other, rng))
    assert env.unwrapped.mesh == mesh != other.unwrapped.mesh
    assert (asked_anew(other.unwrapped) == other.unwrapped.board.valid()).all()


def _going_on(env, rng):
    """What is told until the episode after this one is at its third step."""
    for _ in range(2):
        over, steps = False, 0
        while not over and steps < 3:
            observation, reward, terminated, truncated, info = env.step(gym.random_action(env, rng))
            over, steps = terminated or truncated, steps + 1
            mask = info.pop("action_mask").tolist()
            yield observation.tolist(), reward, over, mask, info, env.unwrapped.mesh.to_bytes()
        env.reset()


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("copied", COPIES)
def test_many_are_copied(kind, copied):
    env = gymnasium.make_vec(IDS[kind], num_envs=3, points=4, max_steps=3)
    env.reset()
    other = copied(env)
    for _ in range(8):
        actions = env.action_space.sample()
        assert (actions == other.action_space.sample()).all()
        _same(env.step(actions), other.step(actions))


@pytest.mark.parametrize("name", ["next_step", "same_step", "disabled"])
def test_modes_go_by_their_names(name):
    mode = gymnasium.vector.AutoresetMode[name.upper()]
    for given in (name, mode, mode.value):
        env = gymnasium.make_vec(IDS["quad"], num_envs=2, autoreset_mode=given)
        assert env.autoreset_mode is mode and env.metadata["autoreset_mode"] is mode
    for wrong in ("never", 3, None):
        with pytest.raises(hedgerow.ArgumentError, match="is one of next_step, same_step, disabled"):
            gym.PlanarMeshVectorEnv(2, autoreset_mode=wrong)


@pytest.mark.parametrize("pairs", [False, True])
def test_wrong_actions_of_many_do_nothing(pairs):
    env = gym.PlanarMeshVectorEnv(3, pairs=pairs, points=4)
    with pytest.raises(gymnasium.error.ResetNeeded):
        env.step([0, 0, 0])
    env.reset(seed=1)
    before = [one.mesh.copy() for one in env.envs]
    good = env.action_space.sample()
    for actions, words in (
        (good[:1], "there are 3 environments, not 1"),
        ([*good, good[0]], "there are 3 environments, not 4"),
        (3, "one for each environment"),
        ([*good[:2], 1.5], "an action is a whole number"),
        ([*good[:2], 10_000], "there is no action"),
    ):
        with pytest.raises(hedgerow.ArgumentError, match=words):
            env.step(actions)
    with pytest.raises(hedgerow.ArgumentError, match="`reset_mask`"):
        env.reset(options={"reset_mask": np.ones(4, dtype=bool)})
    assert [one.mesh for one in env.envs] == before and all(one._steps == 0 for one in env.envs)


def test_masks_are_sampled_from_as_it_says():
    many = gym.PlanarMeshVectorEnv(3, points=4)
    _, info = many.reset(seed=1)
    assert many.step(many.action_space.sample(tuple(info["action_mask"])))[-1]["is_applied"].all()
    env = gymnasium.make(IDS["quad"], pairs=True)
    _, info = env.reset(seed=1)
    mask = info["action_mask"]
    number = gymnasium.spaces.Discrete(len(mask), seed=1).sample(mask)
    actions = len(env.unwrapped.actions)
    pair = np.array([number % actions, number // actions])
    assert env.action_space.contains(pair) and env.unwrapped.decode(pair) == env.unwrapped.decode(number)
    assert env.step(pair)[-1]["is_applied"]


@pytest.mark.parametrize("kind", KINDS)
def test_a_board_has_no_vertices_without_edges(kind):
    mesh = grid(kind)
    lone = hedgerow.Mesh([*mesh.vertices.tolist(), [9, 9, 0]], mesh.faces)
    for make in (lambda: gym.Board(lone, kind), lambda: gym.PlanarMeshEnv(kind, mesh=lone)):
        with pytest.raises(hedgerow.ArgumentError, match="vertex 25 has no edges"):
            make()
    assert lone.elements("vertex").attributes == {} and gym.Board(mesh, kind).mesh is mesh
