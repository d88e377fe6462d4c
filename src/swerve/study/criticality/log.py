"""The criticality of a run: its measures at every sample of the controller, the worst of them, and what came of it."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import STATES
from swerve.scenario import Scenario
from swerve.simulate import Table
from swerve.simulate.outcome import n_sane
from swerve.study.criticality.measures import UNITS, Measures, measure
from swerve.study.criticality.post_encroachment import post_encroachment_time
from swerve.study.criticality.scene import Scene

Array = NDArray[np.float64]

GROWS: Final = ("required", "btn", "stn", "impact")  # begin the names of measures whose largest value is the worst
PET_STEP: Final = 0.02  # [s] between the instants that a post-encroachment time is measured on


@dataclass(frozen=True)
class Worst:
    """The worst value of a measure, and when it was there first.

    Attributes:
        value: in the measure's unit.
        time: [s].
    """

    value: float
    time: float


@dataclass(frozen=True, eq=False)
class Criticality:
    """How critical the instants of a scenario or run were.

    Attributes:
        scenario: what happened.
        plant: name of the one that was driven.
        times: (n,) of the instants [s].
        measures: values (n,) by name, in `UNITS`.
        pet: post-encroachment time of the motion [s]; inf without one.
    """

    scenario: Scenario
    plant: str
    times: Array
    measures: Measures
    pet: float

    @property
    def worst(self) -> Mapping[str, Worst]:
        """By name of the measure."""
        found = {}
        for name in UNITS:
            values = self.measures[name]
            at = int(values.argmax() if name.startswith(GROWS) else values.argmin())
            found[name] = Worst(float(values[at]), float(self.times[at]))
        return found

    @property
    def point_of_no_return(self) -> float | None:
        """The first instant at which none of the manoeuvres of last resort helps [s]; None without one."""
        lost = self.measures["ttr"] == -np.inf
        return float(self.times[lost.argmax()]) if lost.any() else None


def of_scenario(scenario: Scenario, plant: str) -> Criticality:
    """Of the first instant, before anything is done."""
    scene = Scene.of_start(scenario, plant)
    return Criticality(scenario, plant, scene.times, measure(scene), np.inf)


def of_motion(scenario: Scenario, plant: str, motion: Table) -> Criticality:
    """Of a run's motion, up to where it stops being one.

    Args:
        scenario: that was run.
        plant: name of the one that was driven.
        motion: a row for each step of the plant.
    """
    sampled = _scene(scenario, plant, motion, scenario.n_substeps)
    fine = _scene(scenario, plant, motion, max(1, round(PET_STEP / scenario.plant.step)))
    return Criticality(scenario, plant, sampled.times, measure(sampled), post_encroachment_time(fine))


def _scene(scenario: Scenario, plant: str, motion: Table, stride: int) -> Scene:
    """Every `stride`th row."""
    states = motion.stack(*STATES)
    rows = slice(0, n_sane(states), stride)
    return Scene.of_motion(scenario, plant, motion["time"][rows], states[rows], motion["delta"][rows])
