"""What holds of every manoeuvre on every plant."""

from dataclasses import fields, replace
from itertools import product

import numpy as np
import pytest

from swerve.errors import InputError
from swerve.study.manoeuvres import MANOEUVRES, Manoeuvre, manoeuvre_named, run_manoeuvre
from swerve.study.manoeuvres.run import PLANTS
from swerve.vehicle import VEHICLES, vehicle_named

SEDAN = vehicle_named("d-class-sedan")
REFUSED = {("split-friction-braking", "planar")}  # that plant has one friction for all wheels
ALLOWED = [pair for pair in product(MANOEUVRES, PLANTS) if pair not in REFUSED]


@pytest.mark.parametrize(("name", "plant"), ALLOWED)
def test_it_is_finite_and_the_same_again(name: str, plant: str) -> None:
    """The motion is finite, every measure has a unit and a meaning, and a second run has the same bits."""
    first, second = (run_manoeuvre(manoeuvre_named(name), SEDAN, plant) for _ in range(2))
    assert set(first.motion.columns) == set(first.motion.units)
    for column in first.motion.columns:
        assert np.isfinite(first.motion[column]).all()
        np.testing.assert_array_equal(first.motion[column], second.motion[column])
    assert all(measure.unit and measure.meaning for measure in first.measures.values())
    values = [[measure.value for measure in run.measures.values()] for run in (first, second)]
    np.testing.assert_array_equal(*values)


@pytest.mark.parametrize("vehicle", VEHICLES)
def test_every_vehicle_can_be_tested(vehicle: str) -> None:
    """A step steer of each comes to the lateral acceleration that was asked for, within 6 %."""
    measures = run_manoeuvre(manoeuvre_named("step-steer"), vehicle_named(vehicle)).measures
    assert measures["steady_lateral_acceleration"].value == pytest.approx(4.0, rel=0.06)


@pytest.mark.parametrize("manoeuvre", MANOEUVRES.values(), ids=MANOEUVRES)
def test_parameters_have_units_and_limits(manoeuvre: Manoeuvre) -> None:
    """Each has a unit, and refuses a number that is not positive."""
    for field in fields(manoeuvre):  # type: ignore[arg-type]
        assert field.metadata["unit"]
        with pytest.raises(ValueError, match=field.name):
            replace(manoeuvre, **{field.name: -1.0})  # type: ignore[type-var]


def test_split_friction_needs_a_plant_that_knows_it() -> None:
    """The planar plant refuses, and names the one that takes it."""
    with pytest.raises(InputError, match="take the multibody plant"):
        run_manoeuvre(manoeuvre_named("split-friction-braking"), SEDAN, "planar")


def test_names_are_a_closed_list() -> None:
    """A wrong name is refused with the nearest right one."""
    with pytest.raises(InputError, match="did you mean step-steer"):
        manoeuvre_named("step-stear")
    with pytest.raises(InputError, match="did you mean planar"):
        run_manoeuvre(manoeuvre_named("step-steer"), SEDAN, "plannar")


def test_more_lateral_acceleration_than_the_road_gives_is_refused() -> None:
    """A step to 4 m/s^2 cannot be made on friction 0.3; the message says how far it goes."""
    with pytest.raises(InputError, match=r"reaches no more than 2\.\d+ m/s\^2"):
        run_manoeuvre(replace(manoeuvre_named("step-steer"), friction=0.3), SEDAN, "planar")  # type: ignore[type-var]
