"""Wheel loads against the balance of forces and moments."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.conventions import GRAVITY
from swerve.vehicle import Vehicle
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters
from tests.vehicle.motions import DRY, SEDAN, fitting_loads, move, situations

accelerations = st.floats(-10.0, 10.0)
heights = st.floats(0.0, 0.9)


def tall(height: float) -> Parameters:
    """The sedan with its centre of gravity at this height [m]."""
    return Parameters.of(SEDAN.with_changes({"cg_height": height}), 0.85)


def test_static_loads_of_the_paper() -> None:
    """At rest a front wheel carries m g lr / (2 L) and a rear one m g lf / (2 L), with m = 1370 + 2 x 80 kg."""
    front, rear = 1530 * 9.81 * 1.67 / (2 * 2.78), 1530 * 9.81 * 1.11 / (2 * 2.78)
    assert wheel_loads(DRY) == pytest.approx((front, front, rear, rear))


@given(heights, accelerations, accelerations)
def test_the_loads_carry_the_weight(height: float, ax: float, ay: float) -> None:
    """However the vehicle accelerates, the four loads together are m g."""
    assert sum(wheel_loads(tall(height), ax, ay)) == pytest.approx(SEDAN.mass * GRAVITY)


@given(heights, accelerations, accelerations)
def test_the_loads_balance_the_moments(height: float, ax: float, ay: float) -> None:
    """About the centre of gravity the loads' moments are those of the inertia forces at its height."""
    p = tall(height)
    fl, fr, rl, rr = wheel_loads(p, ax, ay)
    assert p.lf * (fl + fr) - p.lr * (rl + rr) == pytest.approx(-p.m * ax * height, abs=1e-6)
    assert p.lt * (fl + rl - fr - rr) == pytest.approx(-p.m * ay * height, abs=1e-6)


@given(st.floats(0.1, 0.9), st.floats(1.0, 9.0))
def test_load_goes_where_a_driver_feels_it(height: float, acceleration: float) -> None:
    """Braking loads the front, driving the rear, a left turn the right wheels; the two sides are alike."""
    static = np.array(wheel_loads(tall(height)))
    braking = np.array(wheel_loads(tall(height), ax=-acceleration)) - static
    left = np.array(wheel_loads(tall(height), ay=acceleration)) - static
    right = np.array(wheel_loads(tall(height), ay=-acceleration)) - static
    assert (np.sign(braking) == [1, 1, -1, -1]).all()
    assert (np.sign(left) == [-1, 1, -1, 1]).all()
    np.testing.assert_allclose(left, right[[1, 0, 3, 2]])


@given(st.floats(0.1, 0.9), accelerations)
def test_roll_is_shared_as_the_static_load_is(height: float, ay: float) -> None:
    """Of the load that a turn moves from left to right, each axle moves its static share."""
    fl, fr, rl, rr = wheel_loads(tall(height), ay=ay)
    assert (fr - fl) * SEDAN.cg_to_front_axle == pytest.approx((rr - rl) * SEDAN.cg_to_rear_axle, abs=1e-6)


@given(situations(), st.floats(0.2, 0.7))
def test_quasi_static_loads_fit_the_accelerations_that_they_cause(situation: tuple, height: float) -> None:
    """With the loads put back into the model, the accelerations call for the same loads, to a part of what was moved.

    At the edge of the friction circle, where a little load decides over all lateral force, no few passes could.
    """
    xi, u, _, dry = situation
    p = dry._replace(h=height)
    half_of_grip = 0.5 * p.mu * np.array(wheel_loads(p))
    u = np.append(u[0], np.clip(u[1:], -half_of_grip, half_of_grip))
    found = fitting_loads(xi, u, p)
    again = np.maximum(np.array(wheel_loads(p, *move(xi, u, found, p).acceleration)), 0.0)
    assert (found >= 0).all()
    assert np.abs(again - found).max() <= 0.15 * np.abs(found - np.array(wheel_loads(p))).max() + 1.0


@given(situations())
def test_a_vehicle_without_height_keeps_its_static_loads(situation: tuple) -> None:
    """With the centre of gravity on the ground nothing moves the loads: the paper's vehicle."""
    xi, u, _, p = situation
    found = fitting_loads(xi, u, p)
    np.testing.assert_allclose(found, wheel_loads(p))


def test_a_tall_vehicle_lifts_a_wheel_and_no_more() -> None:
    """A wheel that would have to pull at the road carries nothing."""
    van = SEDAN.with_changes({"cg_height": 1.5})
    p = Parameters.of(van, 1.2)
    found = fitting_loads([25.0, 0, 0.6, 0, 0, 0], [0.2, 0, 0, 0, 0], p)
    assert isinstance(van, Vehicle)
    assert found.min() == 0.0
    assert found[1] > wheel_loads(p)[1]
