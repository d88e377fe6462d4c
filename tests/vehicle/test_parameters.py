"""A vehicle is numbers that make sense, or it is refused."""

import math

import pytest

from swerve.vehicle import VEHICLES, Vehicle, vehicle_named
from tests.vehicle.motions import SEDAN

POSITIVE = ["mass", "yaw_inertia", "cg_to_front_axle", "half_track", "wheel_radius", "steering_limit", "width"]


def test_table_2() -> None:
    """The D-class sedan is Table 2 of the paper; 80 kg of each axle count."""
    assert (SEDAN.mass, SEDAN.yaw_inertia, SEDAN.wheelbase) == (1530.0, 2315.3, pytest.approx(2.78))
    assert SEDAN.cg_height == 0.0
    assert SEDAN.steering_rate_limit == math.inf


@pytest.mark.parametrize("name", POSITIVE)
@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf])
def test_what_no_vehicle_has_is_refused(name: str, value: float) -> None:
    """Zero, a negative number, nan and infinity are refused by a sentence that begins with the name."""
    with pytest.raises(ValueError, match=f"^{name} must be"):
        SEDAN.with_changes({name: value})


@pytest.mark.parametrize(
    ("name", "value"),
    [("cg_height", -0.1), ("force_limit", 1.0), ("steering_rate_limit", 0.0), ("steering_rate_limit", math.nan)],
)
def test_limits_with_bounds_of_their_own(name: str, value: float) -> None:
    """A height below the ground, a force on the friction circle, an actuator that cannot move: refused."""
    with pytest.raises(ValueError, match=f"^{name} must be"):
        SEDAN.with_changes({name: value})


def test_a_vehicle_can_have_no_height_and_no_rate_limit() -> None:
    """The paper's own vehicle: static loads, and an actuator without a rate limit."""
    assert SEDAN.with_changes({"cg_height": 0.0, "steering_rate_limit": math.inf}) == SEDAN


def test_changes_make_another_vehicle() -> None:
    """The vehicle that was changed stays as it was."""
    heavy = SEDAN.with_changes({"mass": 2000.0})
    assert (heavy.mass, SEDAN.mass) == (2000.0, 1530.0)
    assert heavy.tyre is SEDAN.tyre


def test_vehicles_are_found_by_their_names() -> None:
    """Each vehicle of the library answers to its own name; another name is a KeyError."""
    assert all(vehicle_named(name).name == name for name in VEHICLES)
    assert isinstance(vehicle_named("d-class-sedan"), Vehicle)
    with pytest.raises(KeyError):
        vehicle_named("tricycle")
