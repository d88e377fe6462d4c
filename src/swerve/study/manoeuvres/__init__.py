"""Manoeuvres of the test standards, driven without a controller."""

from typing import Final

from swerve.errors import InputError, unknown
from swerve.study.manoeuvres.braking_in_a_turn import BrakingInATurn
from swerve.study.manoeuvres.double_lane_change import DoubleLaneChange
from swerve.study.manoeuvres.manoeuvre import Manoeuvre, Measure
from swerve.study.manoeuvres.run import ManoeuvreRun, run_manoeuvre
from swerve.study.manoeuvres.sine_with_dwell import SineWithDwell
from swerve.study.manoeuvres.smooth_lane_change import SmoothLaneChange
from swerve.study.manoeuvres.split_friction_braking import SplitFrictionBraking
from swerve.study.manoeuvres.steady_circle import SteadyCircle
from swerve.study.manoeuvres.step_steer import StepSteer

__all__ = [
    "MANOEUVRES",
    "BrakingInATurn",
    "DoubleLaneChange",
    "Manoeuvre",
    "ManoeuvreRun",
    "Measure",
    "SineWithDwell",
    "SmoothLaneChange",
    "SplitFrictionBraking",
    "SteadyCircle",
    "StepSteer",
    "manoeuvre_named",
    "run_manoeuvre",
]

_ALL: Final = (
    StepSteer(),
    SteadyCircle(),
    SineWithDwell(),
    BrakingInATurn(),
    SplitFrictionBraking(),
    DoubleLaneChange(),
    SmoothLaneChange(),
)
MANOEUVRES: Final[dict[str, Manoeuvre]] = {manoeuvre.name: manoeuvre for manoeuvre in _ALL}


def manoeuvre_named(name: str) -> Manoeuvre:
    """The manoeuvre of this name, as its standard has it; InputError when there is none."""
    if name not in MANOEUVRES:
        raise InputError(unknown("manoeuvre", name, MANOEUVRES))
    return MANOEUVRES[name]
