"""A map as data: the table of its boundaries, and one JSON object."""

import json
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any, Final

import pyarrow
import pyarrow.parquet

from swerve import __version__
from swerve.study.map.boundary import Boundary, Condition, Map
from swerve.study.map.closed_form import braking_distance, swerving_distance, turning_speed
from swerve.study.map.store import FORMAT, FORMAT_KEY, VERSION_KEY, flat, schema

UNITS: Final[Mapping[str, str]] = {
    "who": "",
    "speed": "m/s",
    "friction": "1",
    "offset": "m",
    "avoided": "m",
    "failed": "m",
    "decision": "",
    "outcome": "",
    "n_runs": "1",
    "turns": "m",
}


def map_json(made: Map) -> str:
    """Everything but the single runs, in SI; with what `closed_form` says of each condition."""
    boundaries = [_plain(each) for each in made.boundaries]
    whole = {key: value for key, value in vars(made).items() if key not in ("runs", "boundaries", "conditions")}
    conditions = [asdict(each) | _closed_forms(made, each) for each in made.conditions]
    content = {"format": FORMAT, "version": __version__, **whole, "conditions": conditions, "boundaries": boundaries}
    return json.dumps(content, indent=2)


def write_boundaries(made: Map, path: Path) -> None:
    """The boundaries as Parquet, a row for each series and cell, with units; holes as a list of distances."""
    metadata = {FORMAT_KEY: FORMAT.encode(), VERSION_KEY: __version__.encode()}
    holes = pyarrow.field("holes", pyarrow.list_(pyarrow.float64()), metadata={b"unit": b"m"})
    table = pyarrow.Table.from_pylist(list(map(_plain, made.boundaries)), schema(UNITS, metadata).append(holes))
    pyarrow.parquet.write_table(table, path)


def _closed_forms(made: Map, condition: Condition) -> dict[str, float | None]:
    speed, friction, width = condition.speed, condition.friction, made.half_width - abs(condition.offset)
    return {
        "braking_distance": braking_distance(speed, friction) + made.extent,
        "swerving_distance": swerving_distance(speed, friction, width),
        "turning_speed": turning_speed(friction, width, made.extent),
    }


def _plain(boundary: Boundary) -> dict[str, Any]:
    return flat(boundary) | {"holes": list(boundary.holes)}
