"""What is shown of a run beside others: the same measures in the terminal, in Markdown and on the page."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import degrees
from typing import Any, Final

from swerve.report.page.head import flat
from swerve.study.comparison import Entry

NOTHING: Final = "-"  # a value that does not exist


@dataclass(frozen=True)
class Measure:
    """One column.

    Attributes:
        title: of the column.
        unit: of what is shown; "" for none.
        keys: of the values in the JSON of `swerve run`, dotted; several are shown with a stroke between them.
        factor: of what is shown to the value in SI.
        decimals: of what is shown.
        is_of_machine: whether it depends on the machine.
    """

    title: str
    unit: str
    keys: tuple[str, ...]
    factor: float = 1.0
    decimals: int = 2
    is_of_machine: bool = False

    def text(self, values: Mapping[str, Any]) -> str:
        """What is shown of values by dotted key."""
        return " / ".join(self._number(values[key]) for key in self.keys)

    def _number(self, value: float | None) -> str:
        return NOTHING if value is None else f"{value * self.factor:.{self.decimals}f}"


MEASURES: Final = (
    Measure("clearance", "m", ("min_clearance",), decimals=3),
    Measure("impact", "km/h", ("impact_speed",), 3.6, 1),
    Measure("sideslip", "deg", ("max_sideslip",), degrees(1), 1),
    Measure("excursion", "m", ("lateral_excursion",)),
    Measure("friction", "%", ("max_friction_use", "mean_friction_use"), 100.0, 0),
    Measure("step time", "ms", ("step_time.median", "step_time.p99"), 1e3, 1, is_of_machine=True),
    Measure("fallback", "", ("fallback_steps",), 1.0, 0),
)
LEGEND: Final = (
    "clearance: smallest; impact: speed at first contact; sideslip: largest; excursion: farthest beside the way to the",
    "goal's line; friction: largest share that a wheel used / mean of all while an obstacle shaped the plan;",
    "step time: median / 99 %; fallback: steps that were answered by it",
)


def shown(entry: Entry, measures: Sequence[Measure] = MEASURES) -> list[str]:
    """The text of each measure; of an entry that has a result."""
    values = flat(entry.to_json())
    return [each.text(values) for each in measures]
