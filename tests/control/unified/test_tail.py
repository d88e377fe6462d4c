"""The path beyond the horizon against closed forms of a point mass, and its derivatives by finite differences."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from swerve.control.unified.tail import CURVATURE, Outlook, Tail
from tests.control.unified.situations import Array, formulation, random_start, seeds
from tests.vehicle.motions import MIRROR

N = 36
FINE = np.concatenate([np.full(20, 0.05), np.full(16, 0.15)])
AT_REST = np.array([0.0, 0, 0, 0.4, 3.0, -1.0])
speeds, brakings = st.floats(0.5, 40.0), st.floats(0.5, 10.0)


@pytest.fixture(scope="module")
def tail() -> Tail:
    """The tail of the controller's own length."""
    return Tail(N)


def steering(target: float, stiffness: float = 9.0, lateral: float = 5.0, braking: float = 0.0) -> Outlook:
    """An outlook that steers for a target."""
    return Outlook(FINE, np.full(N, target), stiffness, lateral, braking)


def stopping(braking: float, durations: Array = FINE) -> Outlook:
    """An outlook of a straight stop."""
    return Outlook(durations, np.zeros(N), 0.0, 2.5, braking)


def running(speed: float, heading: float = 0.0) -> Array:
    """A state that runs where it points."""
    return np.array([speed, 0.0, 0.0, heading, 1.0, 2.0])


def test_it_is_the_one_the_controller_uses() -> None:
    """The outlook's steps of a formula are as many as its tail has."""
    assert formulation()._tail.n_steps == N


@given(speeds, brakings, st.floats(0.02, 1.0))
def test_a_stop_is_as_long_as_in_the_textbook(tail: Tail, speed: float, braking: float, duration: float) -> None:
    """v^2 / 2 b, whatever the steps are, once it stands; before that v t - b t^2 / 2; and it never moves back."""
    outlook = stopping(braking, np.full(N, duration))
    poses, found = tail.path(running(speed), outlook)
    lasted = np.minimum(outlook.times, speed / braking)
    np.testing.assert_allclose(poses[:, 0] - 1.0, speed * lasted - braking * lasted**2 / 2, rtol=1e-5, atol=1e-4)
    np.testing.assert_allclose(found, np.maximum(speed - braking * outlook.times, 0.0), atol=1e-5)
    np.testing.assert_allclose(poses[:, 1], 2.0, atol=1e-9)
    assert (np.diff(poses[:, 0]) >= 0).all()


@given(st.floats(10.0, 40.0), st.floats(0.5, 8.0), st.sampled_from([-1.0, 1.0]))
def test_far_from_its_target_it_is_pushed_steadily(tail: Tail, speed: float, lateral: float, side: float) -> None:
    """As long as the wish is larger than a, Y is side a t^2 / 2 and X goes on as before."""
    poses, _ = tail.path(running(speed), steering(side * 500.0, lateral=lateral))
    time = np.cumsum(FINE)
    steady = lateral * time < 0.9 * speed  # no path is steeper than 45 degrees
    np.testing.assert_allclose((poses[:, 1] - 2.0)[steady], (side * lateral * time**2 / 2)[steady], atol=1e-9)
    np.testing.assert_allclose(poses[:, 0] - 1.0, speed * time, atol=1e-9)


@given(st.floats(1.0, 4.0))
def test_slow_it_turns_no_tighter_than_a_car(tail: Tail, speed: float) -> None:
    """The lateral acceleration is at most the curvature of the tightest turn times the square of the speed."""
    poses, _ = tail.path(running(speed), steering(500.0, lateral=9.0))
    time = np.cumsum(FINE)
    steady = CURVATURE * speed**2 * time < 0.9 * speed
    np.testing.assert_allclose((poses[:, 1] - 2.0)[steady], (CURVATURE * speed**2 * time**2 / 2)[steady], atol=1e-9)


@given(speeds.filter(lambda v: v > 8.0), st.floats(-3.0, 7.0))
def test_it_reaches_its_target_and_stays(tail: Tail, speed: float, target: float) -> None:
    """Within its limits it comes to its target without swinging over it, pointing along the road again."""
    outlook = Outlook(np.full(N, 0.1), np.full(N, target), 9.0, 6.0, 0.0)
    poses, _ = tail.path(running(speed), outlook)
    assert poses[-1, 1] == pytest.approx(target, abs=0.05)
    assert abs(poses[-1, 2]) < 0.02
    beyond = (poses[:, 1] - target) * np.sign(target - 2.0)
    assert beyond.max() < 0.35


def test_it_is_the_motion_of_its_equation(tail: Tail) -> None:
    """In steps that are small it is the solution of its differential equation."""
    outlook = Outlook(np.full(N, 0.02), np.full(N, 2.5), 9.0, 20.0, 3.0)
    start = running(20.0, 0.02)
    vx, vy = 20 * np.cos(0.02), 20 * np.sin(0.02)

    def derivative(_: float, p: Array) -> list[float]:
        return [p[2], p[3], -3.0, 9.0 * (2.5 - p[1]) - 6.0 * p[3]]

    exact = solve_ivp(derivative, (0, 0.72), [1.0, 2.0, vx, vy], t_eval=outlook.times[:-1], rtol=1e-9, atol=1e-9)
    poses, found = tail.path(start, outlook)
    np.testing.assert_allclose(poses[:-1, 0], exact.y[0], atol=1e-6)
    np.testing.assert_allclose(found[:-1], exact.y[2], atol=1e-6)
    np.testing.assert_allclose(poses[:-1, 1], exact.y[1], atol=6e-3)
    np.testing.assert_allclose(poses[:-1, 2], np.arctan2(exact.y[3], exact.y[2]), atol=6e-3)


@pytest.mark.parametrize("outlook", [steering(5.0), steering(5.0, braking=6.0), stopping(6.0)])
def test_at_rest_it_stays(tail: Tail, outlook: Outlook) -> None:
    """A vehicle that stands is nowhere else later, however far its target is."""
    poses, found = tail.path(AT_REST, outlook)
    np.testing.assert_allclose(poses[:, :2], np.tile([3.0, -1.0], (N, 1)), atol=5e-3)
    np.testing.assert_allclose(found, 0.0, atol=2e-3)
    assert np.isfinite(tail.sensitivities(AT_REST, np.eye(6), outlook)).all()


@pytest.mark.parametrize("outlook", [steering(5.0), steering(-5.0, braking=6.0)])
def test_backwards_it_goes_nowhere(tail: Tail, outlook: Outlook) -> None:
    """A vehicle that rolls back is taken to stand: nothing that steers for a target is expected of it."""
    poses, found = tail.path(np.array([-5.0, 0, 0, 0, 3.0, -1.0]), outlook)
    np.testing.assert_allclose(poses[:, :2], np.tile([3.0, -1.0], (N, 1)), atol=1e-9)
    np.testing.assert_array_equal(found, 0.0)


@given(st.floats(-1.5, 1.5), speeds)
def test_a_stop_needs_its_length_whichever_way_it_points(tail: Tail, heading: float, speed: float) -> None:
    """No plan gets shorter a stop by turning away."""
    straight, _ = tail.path(running(speed), stopping(7.0, np.full(N, 0.2)))
    turned, _ = tail.path(running(speed, heading), stopping(7.0, np.full(N, 0.2)))
    np.testing.assert_allclose(turned[:, 0], straight[:, 0], rtol=1e-5, atol=1e-4)


@given(seeds, st.floats(-5.0, 5.0), st.sampled_from([0.0, 9.0]), st.sampled_from([0.0, 5.0]))
def test_the_mirror_image_goes_the_mirrored_way(
    tail: Tail, seed: int, target: float, stiffness: float, braking: float
) -> None:
    """State and target mirrored, so is the path."""
    state = random_start(np.random.default_rng(seed))
    here, fast = tail.path(state, steering(target, stiffness, braking=braking))
    there, also = tail.path(state * MIRROR, steering(-target, stiffness, braking=braking))
    np.testing.assert_allclose(there, here * [1, -1, -1], atol=1e-12)
    np.testing.assert_allclose(also, fast, atol=1e-12)


@settings(max_examples=40)
@given(seeds, st.floats(-5.0, 5.0), st.sampled_from([0.0, 9.0]), st.sampled_from([0.0, 5.0, 8.0]))
def test_sensitivities_are_the_slopes(tail: Tail, seed: int, target: float, stiffness: float, braking: float) -> None:
    """Moving the last state moves the path as the sensitivities say; at a kink, between the slopes of both sides."""
    state, outlook = random_start(np.random.default_rng(seed)), steering(target, stiffness, braking=braking)
    found, here = tail.sensitivities(state, np.eye(6), outlook), tail.path(state, outlook)[0]
    for j in range(6):
        d = 1e-6 * np.eye(6)[j]
        one_sided = [(here - tail.path(state - d, outlook)[0]) / 1e-6, (tail.path(state + d, outlook)[0] - here) / 1e-6]
        assert (np.minimum(*one_sided) - 1e-4 <= found[:, :, j]).all()
        assert (found[:, :, j] <= np.maximum(*one_sided) + 1e-4).all()


def test_sensitivities_are_linear_in_those_of_the_state(tail: Tail) -> None:
    """Through any map from free inputs to the last state the path's derivatives follow by the chain rule."""
    random = np.random.default_rng(2)
    end, of_end = random_start(random), random.normal(size=(6, 11))
    found = tail.sensitivities(end, of_end, steering(1.0))
    assert found.shape == (N, 3, 11)
    np.testing.assert_allclose(found, tail.sensitivities(end, np.eye(6), steering(1.0)) @ of_end, atol=1e-9)


def test_times_are_the_ends_of_its_steps(tail: Tail) -> None:
    """The first pose is one step after the horizon's end."""
    np.testing.assert_allclose(steering(0.0).times[[0, 19, 20, 35]], [0.05, 1.0, 1.15, 3.4])
