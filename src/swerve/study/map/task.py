"""What a worker does: one run of one controller, or all limits of one cell. Both come with all that they need.

The key of a task is a digest of that, so that what is stored under it is what the task would give again.
"""

import hashlib
import json
from dataclasses import dataclass
from functools import cached_property
from math import inf
from typing import Any

import numpy as np

from swerve.simulate import Outcome, first_contact, run
from swerve.study.limit import Means, point_mass
from swerve.study.limit.best import best
from swerve.study.limit.trajectory import Sought
from swerve.study.map.boundary import AVOIDED, LIMIT, RunRecord
from swerve.study.map.cell import Cell, covers_start
from swerve.study.map.settings import POINT_MASS

NOT_FOUND = "none"  # outcome of a limit


@dataclass(frozen=True, eq=False)
class Trial:
    """A run.

    Attributes:
        cell: where.
        distance: of the first obstacle ahead [m].
        controller: name.
        plant: name.
        seed: of the run.
    """

    cell: Cell
    distance: float
    controller: str
    plant: str
    seed: int

    @cached_property
    def key(self) -> str:
        """Digest of scenario, distance, controller, plant and seed."""
        return digest(self.cell, self.distance, self.controller, self.plant, self.seed)

    def __call__(self) -> dict[str, RunRecord]:
        """Run it as far as its first contact; where an obstacle covers the vehicle at the start there is no run."""
        scenario = self.cell.at(self.distance)
        if covers_start(scenario):
            return {self.key: self._record(Outcome.COLLIDED.value, min_clearance=0.0)}
        result = run(scenario, self.controller, self.plant, self.seed, until=first_contact(scenario)).result
        record = self._record(
            result.outcome.value,
            decision=result.decision,
            min_clearance=_finite(result.min_clearance),
            impact_speed=_finite(result.impact_speed),
            min_distance_ratio=_finite(result.min_distance_ratio),
            max_sideslip=_finite(result.max_sideslip),
        )
        return {self.key: record}

    def _record(self, outcome: str, **numbers: Any) -> RunRecord:
        return RunRecord(self.controller, self.cell.condition, self.distance, outcome, **numbers)


@dataclass(frozen=True, eq=False)
class Limits:
    """All limits of a cell, which share their work.

    Attributes:
        cell: where.
        names: of the series.
    """

    cell: Cell
    names: tuple[str, ...]

    @cached_property
    def key(self) -> str:
        """Digest of scenario and names."""
        return digest(self.cell, *self.names)

    @cached_property
    def keys(self) -> dict[str, str]:
        """By name, digests of scenario and name."""
        return {name: digest(self.cell, name) for name in self.names}

    def __call__(self) -> dict[str, RunRecord]:
        """Find them."""
        return {self.keys[name]: self._found(name) for name in self.names}

    def _found(self, name: str) -> RunRecord:
        scene, condition, means = self.cell.scene, self.cell.condition, name.removeprefix(LIMIT)
        if means == POINT_MASS:
            return RunRecord(name, condition, point_mass.smallest_distance(scene), AVOIDED)
        optimum = best(scene, Means(means), Sought.DISTANCE)
        if optimum is None:
            return RunRecord(name, condition, inf, NOT_FOUND)
        drive, distance = optimum.drive, optimum.trajectory.distance
        clear, ratio = drive.clearance, drive.ratio
        return RunRecord(name, condition, float(distance), AVOIDED, min_clearance=clear, min_distance_ratio=ratio)


Task = Trial | Limits


def digest(cell: Cell, *rest: str | float) -> str:
    """Of a cell's scenario, at its own distance, and whatever else tells one task from another."""
    content = json.dumps([cell.scenario.to_toml(), *rest])
    return hashlib.sha256(content.encode()).hexdigest()[:32]


def perform(task: Task) -> dict[str, RunRecord]:
    """The records of a task, by key."""
    return task()


def _finite(number: float | None) -> float | None:
    return None if number is None or not np.isfinite(number) else float(number)
