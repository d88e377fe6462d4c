"""Driving a manoeuvre: the loop of `simulate` without a controller, on the same plants and with the same table."""

from dataclasses import dataclass
from functools import lru_cache
from typing import Final

import numpy as np

from swerve.errors import InputError, unknown
from swerve.plant import Plant
from swerve.simulate import DEFAULT_PLANT, Table
from swerve.simulate.assemble import multibody_plant, planar_plant
from swerve.simulate.log import motion_table
from swerve.study.manoeuvres.manoeuvre import Car, Manoeuvre, Measures
from swerve.vehicle import Vehicle

PLANTS: Final = {"planar": planar_plant, "multibody": multibody_plant}
STEP: Final = 1e-3  # of the plant [s]
SUBSTEPS: Final = 10  # in which a command is held
STANDSTILL: Final = 0.1  # [m/s] slower than this is at rest


@dataclass(frozen=True, eq=False)
class ManoeuvreRun:
    """A manoeuvre that is over.

    Attributes:
        manoeuvre: what was driven.
        car: what drove it.
        motion: a row for each step of the plant.
        measures: the characteristic values, by name.
    """

    manoeuvre: Manoeuvre
    car: Car
    motion: Table
    measures: Measures


def run_manoeuvre(manoeuvre: Manoeuvre, vehicle: Vehicle, plant: str = DEFAULT_PLANT) -> ManoeuvreRun:
    """Drive a manoeuvre to its end, to standstill, or to the sample in which the motion stops being finite.

    Args:
        manoeuvre: what is driven, and on which friction.
        vehicle: one of the library, with any numbers.
        plant: name of the plant.

    Raises:
        InputError: no such plant; or it cannot drive this: split friction, a lateral acceleration beyond the road's.
    """
    if plant not in PLANTS:
        raise InputError(unknown("plant", plant, PLANTS))
    car = Car(vehicle, plant, manoeuvre.road())
    motion = drive(manoeuvre, car)
    return ManoeuvreRun(manoeuvre, car, motion, manoeuvre.measure(motion, car))


def drive(manoeuvre: Manoeuvre, car: Car) -> Table:
    """The motion of a car in a manoeuvre."""
    plant, driver = _plant(car), manoeuvre.driver(car)
    state, traces = plant.start(manoeuvre.start()), []
    for k in range(round(manoeuvre.duration / (STEP * SUBSTEPS))):
        state, trace = plant.advance(state, driver(k * STEP * SUBSTEPS, state))
        traces.append(trace)
        if not np.hypot(*state.vehicle[:2]) >= STANDSTILL:  # nan too
            break
    n_rows = SUBSTEPS * len(traces)
    return motion_table(STEP * np.arange(float(n_rows)), traces)


@lru_cache(maxsize=8)
def _plant(car: Car) -> Plant:
    """The plant that stands for a car; one is made but once, for it keeps no state."""
    return PLANTS[car.plant](car.vehicle, car.road, STEP, SUBSTEPS)
