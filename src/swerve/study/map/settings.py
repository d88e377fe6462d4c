"""What a map is asked for: everything that its numbers depend on, and nothing else."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from swerve.scenario import Scenario
from swerve.study.map.boundary import LIMIT, Condition

POINT_MASS = "point-mass"
BRAKING = "braking"


@dataclass(frozen=True)
class MapSettings:
    """The request.

    Attributes:
        scenario: whose speed, friction and obstacles are moved.
        controllers: names.
        plant: name.
        speeds: [m/s].
        frictions: [1].
        offsets: of all obstacles along Y [m].
        tolerance: of a boundary [m].
        means: of the limits, as `study.limit.Means` calls them; with any of them braking's and the point mass's
            limits are looked for as well.
        seed: of every run.
    """

    scenario: Scenario
    controllers: tuple[str, ...]
    plant: str
    speeds: tuple[float, ...]
    frictions: tuple[float, ...]
    offsets: tuple[float, ...]
    tolerance: float
    means: tuple[str, ...]
    seed: int

    @property
    def conditions(self) -> Iterator[Condition]:
        """By friction, speed and offset, each ascending."""
        for friction in sorted(self.frictions):
            for speed in sorted(self.speeds):
                for offset in sorted(self.offsets):
                    yield Condition(speed, friction, offset)

    @property
    def limits(self) -> tuple[str, ...]:
        """Names of the series that are no controllers."""
        names = dict.fromkeys((*self.means, BRAKING, POINT_MASS)) if self.means else ()
        return tuple(LIMIT + name for name in names)

    def to_json(self) -> dict[str, Any]:
        """Plain values, the scenario as TOML."""
        plain = {key: value for key, value in vars(self).items() if key != "scenario"}
        lists: dict[str, Any] = json.loads(json.dumps({"scenario": self.scenario.to_toml(), **plain}))
        return lists
