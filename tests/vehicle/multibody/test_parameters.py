"""Parameters of the full vehicle: every named vehicle is complete, usual, and refuses nonsense."""

from dataclasses import replace
from math import inf, nan, pi, sqrt

import pytest

from swerve.conventions import GRAVITY
from swerve.vehicle import VEHICLES, vehicle_named
from swerve.vehicle.multibody import COMPLETIONS, Actuators, completion_of
from swerve.vehicle.multibody.numbers import Numbers
from tests.vehicle.multibody.cars import ACTUATORS, CHASSIS, SEDAN


def test_every_vehicle_has_a_chassis() -> None:
    """What a scenario can name, the multibody plant can drive."""
    assert COMPLETIONS.keys() == VEHICLES.keys()


@pytest.mark.parametrize("name", COMPLETIONS)
def test_bodies_move_as_those_of_cars_do(name: str) -> None:
    """Ride at 1 to 2 Hz with a damping of 0.15 to 0.5, wheel hop at 8 to 16 Hz, roll of 2 to 9 degrees at 1 g."""
    p = Numbers.of(vehicle_named(name), completion_of(name)[0])
    for load, unsprung, spring, damper in ((p.Ff, p.muf, p.kf, p.cf), (p.Fr, p.mur, p.kr, p.cr)):
        sprung = load / GRAVITY - unsprung
        assert 1.0 < sqrt(spring / sprung) / (2 * pi) < 2.0
        assert 0.15 < damper / (2 * sqrt(spring * sprung)) < 0.5
        assert 8.0 < sqrt((p.kz + spring) / unsprung) / (2 * pi) < 16.0
    stiffness = 2 * p.lt**2 * (p.kf + p.kr + 2 * (p.bf + p.br))
    assert 2.0 < p.ms * GRAVITY * (p.h + p.zs) / stiffness * 180 / pi < 9.0


def test_a_changed_mass_changes_the_sprung_body() -> None:
    """The chassis leaves to the vehicle what is the vehicle's: 100 kg more are 100 kg more of body and load."""
    before, after = (Numbers.of(SEDAN.with_changes({"mass": mass}), CHASSIS) for mass in (1530.0, 1630.0))
    assert after.ms - before.ms == pytest.approx(100.0)
    assert 2 * (after.Ff + after.Fr - before.Ff - before.Fr) == pytest.approx(100.0 * GRAVITY)


def test_the_vehicles_own_height_comes_first() -> None:
    """A height of 0 is none, and the chassis' own holds; any other one holds itself."""
    assert Numbers.of(SEDAN, CHASSIS).h == CHASSIS.cg_height
    assert Numbers.of(SEDAN.with_changes({"cg_height": 0.6}), CHASSIS).h == 0.6


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"cg_height": 0.0}, "cg_height must be positive, got 0"),
        ({"roll_inertia": nan}, "roll_inertia must be finite, got nan"),
        ({"spring_rate": (0.0, 1.0)}, "spring_rate must be positive and finite, got 0 at the front"),
        ({"damping_rate": (1.0, -1.0)}, "damping_rate must be finite and not negative, got -1 at the rear"),
        ({"unsprung_mass": (40.0, inf)}, "unsprung_mass must be positive and finite, got inf at the rear"),
    ],
)
def test_a_chassis_refuses_nonsense(changes: dict[str, object], message: str) -> None:
    """The message has the name and the number."""
    with pytest.raises(ValueError, match=message):
        replace(CHASSIS, **changes)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"delay": -0.01}, "delay must be not negative, got -0.01"),
        ({"steering_lag": inf}, "steering_lag must be finite, got inf"),
        ({"motor_torque_limit": 0.0}, "motor_torque_limit must be positive, got 0"),
    ],
)
def test_actuators_refuse_nonsense(changes: dict[str, float], message: str) -> None:
    """A lag is finite and not negative, a limit positive."""
    with pytest.raises(ValueError, match=message):
        replace(ACTUATORS, **changes)
    assert Actuators().motor_power_limit == inf


@pytest.mark.parametrize(("changes", "name"), [({"mass": 150.0}, "mass"), ({"yaw_inertia": 300.0}, "yaw_inertia")])
def test_wheels_are_less_than_the_whole(changes: dict[str, float], name: str) -> None:
    """A vehicle no heavier than its wheels is refused, with what would be enough."""
    with pytest.raises(ValueError, match=f"{name} must be more than"):
        Numbers.of(SEDAN.with_changes(changes), CHASSIS)
