"""The drivers: a time series, and one who keeps a lane."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.driver import DriverSeries, LaneKeeper
from swerve.driver.cruise import cruise
from swerve.vehicle.parameters import D_CLASS_SEDAN as SEDAN
from swerve.vehicle.steady_state import steering_per_acceleration

AHEAD = np.array([20.0, 0, 0, 0, 0, 0])


@pytest.mark.parametrize(
    ("time", "angle", "force"),
    [(-1.0, 0.0, -100.0), (1.0, 0.0, -100.0), (1.5, 0.05, -150.0), (2.0, 0.1, -200.0), (9.0, 0.1, -300.0)],
)
def test_a_series_is_linear_between_its_instants_and_held_beyond(time: float, angle: float, force: float) -> None:
    """Steering and force each have their own instants; before the first and after the last they stay."""
    driver = DriverSeries(((1.0, 0.0), (2.0, 0.1)), ((1.0, -100.0), (3.0, -300.0)))
    asked = driver(time, AHEAD)
    assert (asked.steering_angle, asked.force) == pytest.approx((angle, force))


def test_what_no_series_tells_is_nothing() -> None:
    """A driver without a series neither steers nor touches a pedal."""
    asked = DriverSeries()(1.0, AHEAD)
    assert (asked.steering_angle, asked.force) == (0.0, 0.0)


@given(offset=st.floats(-1.0, 1.0), yaw=st.floats(-0.05, 0.05))
def test_a_lane_keeper_steers_for_the_point_ahead(offset: float, yaw: float) -> None:
    """The angle is the steady turn's whose parabola meets the lane after the preview time."""
    state = np.array([20.0, 0, 0, yaw, 5.0, offset])
    asked = LaneKeeper(SEDAN, 0.85, 0.3, 20.0, 1.0)(0.0, state)
    acceleration = 2 * (0.3 - offset - 20.0 * np.sin(yaw))
    assert asked.steering_angle == pytest.approx(acceleration * steering_per_acceleration(SEDAN, 0.85, 20.0), abs=1e-12)
    assert asked.force == 0.0


@given(vx=st.floats(0.0, 60.0), speed=st.floats(0.0, 60.0))
def test_a_cruise_goes_for_its_speed_within_its_limit(vx: float, speed: float) -> None:
    """The acceleration has the sign of what is missing and is at most 3 m/s^2."""
    acceleration = cruise(vx, speed)
    assert abs(acceleration) <= 3.0
    assert acceleration * (speed - vx) >= 0.0
    assert abs(acceleration) == pytest.approx(min(3.0, 5.0 * abs(speed - vx)))
