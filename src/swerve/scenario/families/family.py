"""A family of scenarios: one test of a protocol in all its speeds and impact locations, each a member with a name."""

import tomllib
from collections.abc import Callable, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass
from functools import cached_property
from importlib.resources import files
from itertools import pairwise
from math import prod
from string import Formatter
from typing import Any, Final

from swerve.units import to_si

Tables = dict[str, Any]

BASE: Final[Tables] = tomllib.loads((files("swerve.scenario") / "families" / "base.toml").read_text("utf-8"))
BODY: Final[Mapping[str, float]] = BASE["ego"]["parameters"]
UNITS: Final = {"speed": "km/h", "target": "km/h", "impact": "%"}


@dataclass(frozen=True)
class Case:
    """The parameters of one member.

    Attributes:
        speed: of the vehicle under test [km/h].
        target: speed of the target at the start [km/h].
        impact: impact location, where the middle of the target meets the front, 0 its right end, 100 its left one [%].
    """

    speed: int
    target: int
    impact: int = 50

    @property
    def speeds(self) -> tuple[float, float]:
        """Of the vehicle under test and of the target [m/s]."""
        return to_si(f"{self.speed} km/h", "speed"), to_si(f"{self.target} km/h", "speed")

    @property
    def lateral_offset(self) -> float:
        """Of the target's middle from that of the vehicle under test, IL / 100 w - w / 2 [m]."""
        return (self.impact / 100 - 0.5) * BODY["width"]


@dataclass(frozen=True)
class Family:
    """A test with parameters.

    Attributes:
        name: with which the names of all members begin.
        form: of a member's name, with the parameters that it shows in braces.
        title: what happens, a few words.
        description: of a member, with its parameters in braces.
        source: where the numbers come from, and which of them are our own.
        cases: of all members.
        scene: the tables of a member beside or in place of those of the base.
    """

    name: str
    form: str
    title: str
    description: str
    source: str
    cases: Sequence[Case]
    scene: Callable[[Case], Tables]

    @cached_property
    def members(self) -> dict[str, Case]:
        """The parameters of each member by its name."""
        return {self.form.format(**vars(case)): case for case in self.cases}

    @property
    def pattern(self) -> str:
        """The form as a listing shows it: ccrs-SPEED-ilIMPACT."""
        return self.form.format(**{key: key.upper() for key in UNITS})

    @property
    def ranges(self) -> str:
        """What may stand in the form: a range for each parameter, or the few names where not all go together."""
        keys = [key for _, key, _, _ in Formatter().parse(self.form) if key]
        values = {key: sorted({getattr(case, key) for case in self.cases}) for key in keys}
        if prod(map(len, values.values())) != len(self.cases):
            return " or ".join(self.members)
        return ", ".join(f"{key.upper()} {_range(values[key])} {UNITS[key]}" for key in keys)

    def tables(self, member: str) -> Tables:
        """A member as the tables of a scenario file; KeyError when there is no such."""
        case = self.members[member]
        scene = self.scene(case)
        about = {"name": member, "description": self.description.format(**vars(case)), "source": self.source}
        return {**about, **{key: _merged(BASE.get(key), scene.get(key)) for key in {**BASE, **scene}}}


def _merged(base: Any, scene: Any) -> Any:
    """A table of the base with the scene's keys in it; of anything else the scene's, if it has it."""
    if isinstance(base, dict):
        return deepcopy(base) | (scene or {})
    return deepcopy(base) if scene is None else scene


def _range(values: Sequence[int]) -> str:
    steps = {after - before for before, after in pairwise(values)}
    if len(steps) != 1 or len(values) < 3:
        return " or ".join(map(str, values))
    return f"{values[0]} to {values[-1]} by {steps.pop()}"
