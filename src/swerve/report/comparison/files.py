"""A comparison as files for programs and documents: Parquet and Markdown."""

import json
from pathlib import Path
from typing import Any, Final, get_type_hints

import numpy as np

from swerve import __version__
from swerve.report.comparison.measures import MEASURES, NOTHING, shown
from swerve.report.markdown import table
from swerve.report.page.head import flat
from swerve.report.tables import PLANT, SEED, VERSION, write_columns
from swerve.simulate import Table
from swerve.simulate.result import Range, Result, StepTime
from swerve.study.comparison import Comparison, Entry, Group

CONTROLLERS: Final = b"swerve.controllers"  # keys of the file's metadata: a JSON list of names ...
SCENARIOS: Final = b"swerve.scenarios"  # ... and a JSON object with each scenario as TOML by its name
STEADY: Final = tuple(each for each in MEASURES if not each.is_of_machine)
WORDS: Final = ("scenario", "controller", "plant", "version", "outcome", "decision", "refusal")
RANGES: Final = {Range: ("min", "max", "final"), StepTime: ("median", "p99", "max")}
UNITS: Final = {  # of the columns that have one other than 1
    **dict.fromkeys(("min_clearance", "lateral_excursion"), "m"),
    **{f"lateral_offset.{name}": "m" for name in RANGES[Range]},
    **{f"speed.{name}": "m/s" for name in RANGES[Range]},
    **dict.fromkeys(("impact_speed", "final_lateral_speed"), "m/s"),
    **dict.fromkeys(("final_yaw_rate", "max_yaw_rate"), "rad/s"),
    **dict.fromkeys(("max_sideslip", "max_steer", "driver_deviation"), "rad"),
    **{f"step_time.{name}": "s" for name in RANGES[StepTime]},
    **dict.fromkeys(("wall_time", "oncoming_lane_time"), "s"),
}


def write_parquet(comparison: Comparison, path: Path) -> None:
    """Write a row for each entry: the numbers of its result in SI, nan where there is none; words are empty there."""
    rows = [flat(row) for row in comparison.to_json()["runs"]]
    columns = {name: _column(name, [row.get(name) for row in rows]) for name in _names()}
    units = {name: "" if name in WORDS else UNITS.get(name, "1") for name in columns}
    scenarios = {group.scenario.name: group.scenario.to_toml() for group in comparison.groups}
    metadata = {
        VERSION: __version__.encode(),
        PLANT: comparison.plant.encode(),
        SEED: str(comparison.seed).encode(),
        CONTROLLERS: json.dumps(comparison.controllers).encode(),
        SCENARIOS: json.dumps(scenarios).encode(),
    }
    write_columns(Table(columns, units), metadata, path)


def _names() -> list[str]:
    """Of the columns: those of a result, nested ones dotted; where a simulation diverged is in the JSON alone."""
    kinds = {name: kind for name, kind in get_type_hints(Result).items() if name != "divergence"}
    nested = [[f"{name}.{each}" for each in RANGES.get(kind, ())] or [name] for name, kind in kinds.items()]
    return [*(name for names in nested for name in names), "refusal", "best"]


def _column(name: str, values: list[Any]) -> "np.ndarray[Any, np.dtype[np.generic]]":
    if name in WORDS:
        return np.array([value or "" for value in values])
    if name in ("seed", "best"):  # which every row has
        return np.array(values)
    return np.array([np.nan if value is None else value for value in values], dtype=float)


def as_markdown(comparison: Comparison) -> str:
    """A table for each scenario, to be included in a page; nothing in it depends on the machine."""
    about = f"Measured by swerve {__version__} on the plant `{comparison.plant}`, seed {comparison.seed}."
    return "\n\n".join([about, *map(_section, comparison.groups)]) + "\n"


def _section(group: Group) -> str:
    titles = [f"{each.title} [{each.unit}]" if each.unit else each.title for each in STEADY]
    rows = [_row(each, is_best=group.is_best(each)) for each in group.entries]
    about = f"`{group.scenario.name}`: {group.scenario.description}".rstrip(": ")
    return f"{about}\n\n{table(['controller', 'outcome', 'decision', *titles], rows)}"


def _row(entry: Entry, *, is_best: bool) -> list[str]:
    name = f"`{entry.controller}`"
    if entry.result is None:
        return [name, "refused", (entry.refusal or "").replace("|", "\\|"), *[NOTHING] * len(STEADY)]
    outcome = entry.result.outcome.value
    return [name, f"**{outcome}**" if is_best else outcome, entry.result.decision, *shown(entry, STEADY)]
