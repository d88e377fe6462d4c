"""What is expected of an obstacle, against motions that are known and against sums over small steps."""

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.control.forecast import LARGEST, LASTING, NOVELTY, Forecast, forecasts
from swerve.signals import Observation
from swerve.world import Accelerating, Ellipse
from tests.control.unified.situations import Array

DISC = Ellipse((1.0, 1.0))
numbers = st.floats(-40.0, 40.0).map(lambda v: round(v, 3))
accelerations = st.floats(-12.0, 12.0).map(lambda a: round(a, 3))
pairs = st.tuples(numbers, numbers)


def expected(velocity: Sequence[float], acceleration: Sequence[float]) -> Forecast:
    """An obstacle seen at 1 s in (3, -2)."""
    return Forecast(DISC, 0.2, 1.0, np.array([3.0, -2.0]), np.array(velocity), np.array(acceleration))


def watched(velocities: Sequence[Array], period: float = 0.05) -> Forecast:
    """The forecast after an obstacle was seen with these velocities, one after the other."""
    known: tuple[Forecast, ...] = ()
    for k, (vx, vy) in enumerate(velocities):
        known = forecasts(k * period, [Observation(DISC, (0.0, 0.0), (float(vx), float(vy)), 0.0)], known)
    return known[0]


@given(pairs, st.tuples(accelerations, accelerations))
def test_the_position_is_the_sum_of_the_velocity(
    velocity: tuple[float, float], acceleration: tuple[float, float]
) -> None:
    """From what was seen on, the position moves by the velocity that is expected, in steps of a millisecond."""
    found = expected(velocity, acceleration)
    times = 1.0 + np.arange(0.0, 4.0, 1e-3)
    middle = found.velocity_at(times + 0.5e-3) * 1e-3
    summed = np.array([3.0, -2.0]) + np.cumsum(middle, axis=0)
    np.testing.assert_allclose(found.position_at(times + 1e-3), summed, atol=1e-3)
    np.testing.assert_array_equal(found.position_at(np.array([1.0])), [[3.0, -2.0]])
    np.testing.assert_array_equal(found.velocity_at(np.array([1.0])), [velocity])


@given(pairs, st.tuples(accelerations, accelerations))
def test_what_slows_down_stops_and_does_not_come_back(
    velocity: tuple[float, float], acceleration: tuple[float, float]
) -> None:
    """No component of a velocity changes its sign, and one that grows does so for a while only."""
    found = expected(velocity, acceleration)
    later = found.velocity_at(1.0 + np.linspace(0.0, 60.0, 601))
    for i in range(2):
        if velocity[i] != 0:
            assert (later[:, i] * np.sign(velocity[i]) >= -1e-9).all()
        assert np.abs(later[:, i]).max() <= abs(velocity[i]) + LASTING * abs(acceleration[i]) + 1e-9


@given(st.floats(1.0, 40.0), st.floats(0.5, 11.0))
def test_a_lead_that_brakes_is_where_it_will_be(speed: float, braking: float) -> None:
    """With its deceleration known it is expected where a car that brakes to a stop is."""
    truth = Accelerating((3.0, -2.0), (speed, 0.0), 0.0, (-braking, 0.0))
    elapsed = np.linspace(0.0, 8.0, 81)
    found = expected((speed, 0.0), (-braking, 0.0))
    np.testing.assert_allclose(found.position_at(1.0 + elapsed), truth.position_at(elapsed), atol=1e-9)
    np.testing.assert_allclose(found.velocity_at(1.0 + elapsed), truth.velocity_at(elapsed), atol=1e-9)


@given(st.floats(-10.0, 10.0), st.floats(-5.0, 5.0), st.integers(1, 12))
def test_a_steady_acceleration_is_learnt(along: float, across: float, n: int) -> None:
    """Without noise each step halves what is still wrong about a constant acceleration."""
    truth = np.array([along, across])
    found = watched([np.array([20.0, 1.0]) + truth * 0.05 * k for k in range(n + 1)])
    np.testing.assert_allclose(found.acceleration, truth * (1 - (1 - NOVELTY) ** n), atol=1e-9)


@given(pairs)
def test_a_steady_velocity_is_no_acceleration(velocity: tuple[float, float]) -> None:
    """What keeps its velocity is expected to keep it, from the first step on."""
    for n in (1, 2, 7):
        found = watched([np.array(velocity)] * n)
        np.testing.assert_array_equal(found.acceleration, 0.0)


@given(st.lists(pairs, min_size=2, max_size=8))
def test_no_acceleration_is_larger_than_a_vehicles(velocities: list[tuple[float, float]]) -> None:
    """Velocities that jump are believed no more than brakes could do."""
    assert np.abs(watched([np.array(each) for each in velocities]).acceleration).max() <= LARGEST


def test_another_number_of_obstacles_is_another_scene() -> None:
    """Where one comes or goes nothing is known of any but what is seen: no difference of two different cars."""
    first, second = (Observation(DISC, (x, 0.0), (v, 0.0), 0.0) for x, v in ((10.0, 20.0), (30.0, 5.0)))
    both = forecasts(0.0, [first, second], ())
    for seen in ([second], [first, second, first], []):
        found = forecasts(0.05, seen, both)
        assert len(found) == len(seen)
        assert all((each.acceleration == 0).all() for each in found)


def test_the_same_measurement_twice_tells_nothing_new() -> None:
    """Seen again at the same instant, even with another velocity, there is no division by the time between."""
    braking = watched([np.array([20.0, 0.0]), np.array([19.6, 0.0])])
    again = forecasts(0.05, [Observation(DISC, (0.0, 0.0), (3.0, 0.0), 0.0)], (braking,))[0]
    np.testing.assert_array_equal(again.acceleration, braking.acceleration)
    assert again.velocity[0] == 3.0


@pytest.mark.parametrize("times", [np.array([1.0]), np.array([0.5, 1.0, 99.0]), np.array([-1e5, 1e5])])
@pytest.mark.parametrize("velocity", [(0.0, 0.0), (1e-300, -1e-300), (1e5, -1e5)])
@pytest.mark.parametrize("acceleration", [(0.0, 0.0), (-1e-300, 1e-300), (-12.0, 12.0)])
def test_every_number_is_one(times: Array, velocity: tuple[float, float], acceleration: tuple[float, float]) -> None:
    """At rest, hardly moving, absurdly fast, and long before or after: finite."""
    found = expected(velocity, acceleration)
    assert np.isfinite(found.position_at(times)).all()
    assert np.isfinite(found.velocity_at(times)).all()


def test_a_forecast_does_not_share_its_numbers_with_the_measurement() -> None:
    """Shape and heading are what was seen; the heading is held."""
    found = forecasts(0.3, [Observation(DISC, (1.0, 2.0), (3.0, 4.0), 0.7)], ())[0]
    assert (found.shape, found.heading, found.stamp) == (DISC, 0.7, 0.3)
    np.testing.assert_array_equal(found.position, [1.0, 2.0])
    np.testing.assert_array_equal(found.velocity, [3.0, 4.0])
