"""How a point of a map is run again: the command, and the studio with that scene in it."""

import shlex
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Final
from urllib.parse import urlencode

from swerve.scenario import FAMILIES, Scenario, library_names, load
from swerve.study.map.boundary import LIMIT, Condition, Map
from swerve.study.map.cell import Cell

FOLDER: Final = "replay"  # of a run that is made again
POINT_MASS: Final = "limit: point-mass"


@dataclass(frozen=True)
class Source:
    """The scenario that a map was made of.

    Attributes:
        scenario: as it stands on the command line: a name of the library or a file.
        overrides: likewise, as KEY=VALUE.
    """

    scenario: str
    overrides: tuple[str, ...] = ()

    @cached_property
    def base(self) -> Scenario:
        """It, with its overrides."""
        return load(self.scenario, self.overrides)

    @property
    def is_known_to_studio(self) -> bool:
        """Whether the studio can make its scenes by moving a scenario of the library or of a family."""
        has_name = self.scenario in library_names() or any(self.scenario in family.members for family in FAMILIES)
        return has_name and not self.overrides


def run_command(found: Map, source: Source, who: str, condition: Condition, distance: float) -> str:
    """What to type for driving a point again."""
    there = _cell(source, condition).at(distance)
    ending = ("--controller", who, "--plant", found.plant, "--seed", str(found.seed), "--out", FOLDER)
    return _command("run", source, [*_moved(source.base, there), f"duration={there.duration!r}"], ending)


def limit_command(source: Source, limits: Sequence[str], condition: Condition) -> str:
    """What to type for finding limits again; the bound of a point mass stands below every table of them."""
    names = ["braking" if who == POINT_MASS else who.removeprefix(LIMIT) for who in limits]
    there = _cell(source, condition).scenario
    return _command("limit", source, list(_moved(source.base, there)), ("--means", ",".join(names)))


def studio_link(found: Map, source: Source, who: str, condition: Condition, distance: float) -> str | None:
    """Where `swerve view` has the scene, to be run; None for what has no name there."""
    if not source.is_known_to_studio:
        return None
    there = _cell(source, condition).at(distance)
    first = there.obstacles[0]
    x, y = first.waypoints[0].position if first.position is None else first.position
    scene = {"scenario": source.scenario, "speed": there.ego.speed, "friction": there.road.friction}
    place = {"distance": x, "offset": y, "duration": there.duration}
    return f"/studio?{urlencode(scene | place | {'controller': who, 'plant': found.plant, 'seed': found.seed})}"


@cache
def _cell(source: Source, condition: Condition) -> Cell:
    return Cell.of(source.base, condition)


def _command(name: str, source: Source, settings: Sequence[str], ending: Sequence[str]) -> str:
    words = [word for each in (*source.overrides, *settings) for word in ("--set", each)]
    return shlex.join(["swerve", name, source.scenario, *words, *ending])


def _moved(base: Scenario, there: Scenario) -> Iterator[str]:
    """The overrides that make a cell's scenario of the map's, as far as the two differ."""
    yield f"ego.speed={there.ego.speed!r}"
    yield f"goal.speed={there.goal.speed!r}"
    yield f"road.friction={there.road.friction!r}"
    for i, (before, after) in enumerate(zip(base.obstacles, there.obstacles, strict=True)):
        if before.position != after.position and after.position is not None:
            yield f"obstacles.{i}.position={list(after.position)}"
        for k, (was, point) in enumerate(zip(before.waypoints, after.waypoints, strict=True)):
            if was.position != point.position:
                yield f"obstacles.{i}.waypoints.{k}.position={list(point.position)}"
