"""The roll-out against eq. (1) stepped by hand, and its Jacobians against finite differences."""

import numpy as np
import pytest
from hypothesis import given, settings

from swerve.control import Horizon
from swerve.control.unified.prediction import SLIP_SPEED_FLOOR, PredictionModel
from swerve.vehicle.integrate import rk4
from swerve.vehicle.two_track import Parameters
from swerve.vehicle.tyre import factors, magic_formula
from tests.control.unified.situations import model, random_inputs, random_start, seeds
from tests.kernel.compilers import uncompiled
from tests.vehicle.motions import MIRROR, SEDAN, STATIC, mirrored, move

ROLLING = Parameters.of(SEDAN, 0.85, SLIP_SPEED_FLOOR)


@settings(max_examples=15)
@given(seeds)
def test_a_sample_is_two_runge_kutta_steps(seed: int) -> None:
    """States are those after each sample, poses those after each half of one, starting from the measured state."""
    random = np.random.default_rng(seed)
    start, inputs = random_start(random), random_inputs(random)
    trajectory = model().roll_out(start, inputs, STATIC)
    state, states, poses = start, [start], [start[[4, 5, 3]]]
    for u in inputs:
        for _ in range(2):
            state = rk4(lambda xi, u=u: move(xi, u, STATIC, ROLLING).derivative, state, 0.025)
            poses.append(state[[4, 5, 3]])
        states.append(state)
    np.testing.assert_allclose(trajectory.states, states, rtol=1e-10, atol=1e-10)
    np.testing.assert_allclose(trajectory.poses, poses, rtol=1e-10, atol=1e-10)
    np.testing.assert_array_equal(trajectory.poses[0::2], trajectory.states[:, [4, 5, 3]])


@settings(max_examples=15)
@given(seeds)
def test_slip_angles_are_those_of_the_axles(seed: int) -> None:
    """The front slip is that of the front axle when an input sets in, the rear slip that at the end of its sample."""
    random = np.random.default_rng(seed)
    start, inputs = random_start(random), random_inputs(random)
    trajectory = model().roll_out(start, inputs, STATIC)
    vx, vy, r = trajectory.states[:, :3].T
    front = inputs[:, 0] - np.arctan2(vy + 1.11 * r, vx)[:-1]
    rear = -np.arctan2(vy - 1.67 * r, vx)[1:]
    np.testing.assert_allclose(trajectory.front_slip, front, atol=1e-12)
    np.testing.assert_allclose(trajectory.rear_slip, rear, atol=1e-12)


@settings(max_examples=10)
@given(seeds)
def test_lateral_demand_is_the_share_of_the_peak(seed: int) -> None:
    """|M| / D of each wheel when an input sets in: from 0 to 1."""
    random = np.random.default_rng(seed)
    trajectory = model().roll_out(random_start(random), random_inputs(random, 3.0), STATIC)
    for k in (0, 5, 19):
        slips = move(trajectory.states[k], trajectory.inputs[k], STATIC, ROLLING).slip_angles
        wanted = [
            abs(magic_formula(ROLLING, slip, load)) / factors(ROLLING, load)[2]
            for slip, load in zip(slips, STATIC, strict=True)
        ]
        np.testing.assert_allclose(trajectory.lateral_demand[k], wanted, atol=1e-9)
    assert trajectory.lateral_demand.min() >= 0
    assert trajectory.lateral_demand.max() <= 1 + 1e-12


@settings(max_examples=25)
@given(seeds)
def test_jacobians_are_the_slopes(seed: int) -> None:
    """A, B, C and D of a sample are what finite differences of the roll-out say, at any state and input."""
    random = np.random.default_rng(seed)
    start, inputs = random_start(random), random_inputs(random)

    def sample(x: np.ndarray, u: np.ndarray) -> np.ndarray:
        changed = inputs.copy()
        changed[0] = u
        there = model().roll_out(x, changed, STATIC)
        return np.concatenate([there.states[1], there.poses[1], [there.front_slip[0], there.rear_slip[0]]])

    found = model().linearise(model().roll_out(start, inputs, STATIC), STATIC)
    by_state, by_input = np.vstack([found.A[0], found.C[0]]), np.vstack([found.B[0], found.D[0]])
    for j in range(6):
        d = np.eye(6)[j] * 1e-5
        slope = (sample(start + d, inputs[0]) - sample(start - d, inputs[0])) / 2e-5
        np.testing.assert_allclose(by_state[:, j], slope, rtol=1e-5, atol=1e-6)
    for j, h in enumerate([1e-6, 0.1, 0.1, 0.1, 0.1]):
        d = np.eye(5)[j] * h
        slope = (sample(start, inputs[0] + d) - sample(start, inputs[0] - d)) / (2 * h)
        np.testing.assert_allclose(by_input[:, j], slope, rtol=1e-4, atol=1e-6 if j == 0 else 1e-9)


def test_jacobians_follow_the_trajectory() -> None:
    """The Jacobians of sample k are those of a roll-out that begins there."""
    random = np.random.default_rng(5)
    trajectory = model().roll_out(random_start(random), random_inputs(random), STATIC)
    found = model().linearise(trajectory, STATIC)
    for k in (1, 7, 19):
        rest = np.concatenate([trajectory.inputs[k:], trajectory.inputs[:k]])
        later = model().linearise(model().roll_out(trajectory.states[k], rest, STATIC), STATIC)
        for name in ("A", "B", "C", "D"):
            np.testing.assert_allclose(getattr(found, name)[k], getattr(later, name)[0], rtol=1e-9, atol=1e-12)


@settings(max_examples=15)
@given(seeds)
def test_left_and_right_are_mirror_images(seed: int) -> None:
    """Started and steered in the mirror, the prediction is the mirror image."""
    random = np.random.default_rng(seed)
    start, inputs = random_start(random), random_inputs(random)
    here = model().roll_out(start, inputs, STATIC)
    there = model().roll_out(start * MIRROR, np.array([mirrored(u) for u in inputs]), STATIC)
    np.testing.assert_allclose(there.states, here.states * MIRROR, rtol=1e-11, atol=1e-11)
    np.testing.assert_allclose(there.poses, here.poses * [1, -1, -1], rtol=1e-11, atol=1e-11)
    np.testing.assert_allclose(there.rear_slip, -here.rear_slip, atol=1e-12)


def test_loads_matter() -> None:
    """The loads that are measured are those of the prediction: less load in front, less turn."""
    inputs = np.zeros((20, 5))
    inputs[:, 0] = 0.02
    start = np.array([20.0, 0, 0, 0, 0, 0])
    light = STATIC * [0.5, 0.5, 1.5, 1.5]
    turned = [model().roll_out(start, inputs, loads).states[3, 2] for loads in (STATIC, light)]
    assert 0 < turned[1] < 0.8 * turned[0]


@pytest.mark.parametrize("speed", [0.0, 0.5, 3.0, -2.0])
def test_it_stays_finite_and_calm_at_standstill(speed: float) -> None:
    """With its steps of 25 ms the prediction does not shake itself apart where the vehicle stands or creeps."""
    start = np.array([speed, 0.2, 0.1, 0, 0, 0])
    trajectory = model().roll_out(start, np.zeros((20, 5)), STATIC)
    assert trajectory.is_finite
    assert np.abs(trajectory.states[-1, 1:3]).max() < 2e-3
    assert all(np.isfinite(each).all() for each in vars(model().linearise(trajectory, STATIC)).values())


@pytest.mark.parametrize("state", [np.full(6, np.nan), np.array([1e200, 0, 1e200, 0, 0, 0])])
def test_what_diverges_says_so(state: np.ndarray) -> None:
    """A roll-out that leaves the numbers behind is not finite, and no exception."""
    assert not model().roll_out(state, np.zeros((20, 5)), STATIC).is_finite


@pytest.mark.parametrize(("prediction", "control"), [(1, 1), (2, 1), (5, 5)])
def test_horizons_may_be_short(prediction: int, control: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The shortest horizon is one sample; shapes follow it."""
    short = uncompiled(monkeypatch, lambda: PredictionModel(SEDAN, 0.85, Horizon(prediction, control, 0.05)))
    trajectory = short.roll_out(np.array([20.0, 0, 0, 0, 0, 0]), np.zeros((prediction, 5)), STATIC)
    assert trajectory.states.shape == (prediction + 1, 6)
    assert trajectory.poses.shape == (2 * prediction + 1, 3)
    assert trajectory.front_slip.shape == (prediction,)
    assert trajectory.lateral_demand.shape == (prediction, 4)
    assert short.linearise(trajectory, STATIC).D.shape == (prediction, 5, 5)


def test_a_lifted_wheel_has_derivatives() -> None:
    """A wheel without load carries no force, and takes no number away from the linearisation."""
    lifted = STATIC * [0.0, 2.0, 0.0, 2.0]
    trajectory = model().roll_out(np.array([20.0, 0.3, 0.4, 0, 0, 0]), np.full((20, 5), [0.05, 0, 0, 0, 0]), lifted)
    jacobians = model().linearise(trajectory, lifted)
    assert all(np.isfinite(each).all() for each in vars(jacobians).values())
