"""What is shown of a manoeuvre: a table, JSON, and files."""

import json
from collections.abc import Iterable
from dataclasses import fields
from math import isfinite
from pathlib import Path
from typing import Any

from swerve import __version__
from swerve.report.output import filled
from swerve.study.manoeuvres import Manoeuvre, ManoeuvreRun


def manoeuvre_json(run: ManoeuvreRun) -> str:
    """The run as one JSON object on one line, in SI; a value that does not exist is null."""
    return json.dumps(_values(run), allow_nan=False)


def manoeuvre_table(run: ManoeuvreRun) -> str:
    """The run for people: what was driven, then a row for each characteristic value."""
    head = [
        f"{run.manoeuvre.name}: {run.car.vehicle.name} on {run.car.plant}, {run.manoeuvre.source}",
        ", ".join(f"{name} {_shown(value)} {unit}".rstrip(" 1") for name, value, unit in _parameters(run.manoeuvre)),
        "",
    ]
    width = max(map(len, run.measures))
    rows = [f"{name:<{width}}  {_shown(m.value):>9} {m.unit:<9}  {m.meaning}" for name, m in run.measures.items()]
    return "\n".join([*head, *rows])


def library_table(manoeuvres: Iterable[Manoeuvre]) -> str:
    """A line for each."""
    known = list(manoeuvres)
    width = max(len(each.name) for each in known)
    return "\n".join(f"{each.name:<{width}}  {each.description} ({each.source})" for each in known)


def library_json(manoeuvres: Iterable[Manoeuvre]) -> str:
    """Name, description and source of each."""
    return json.dumps([{key: getattr(each, key) for key in ("name", "description", "source")} for each in manoeuvres])


def write_manoeuvre(run: ManoeuvreRun, directory: Path) -> list[Path]:
    """Write result.json, motion.parquet, and the figure as PNG and PDF; OSError as the file system says."""
    from swerve.report.figures.manoeuvre import manoeuvre as draw
    from swerve.report.figures.style import save
    from swerve.report.tables import PLANT, VERSION, write_columns

    result = manoeuvre_json(run)
    metadata = {VERSION: __version__.encode(), PLANT: run.car.plant.encode(), b"swerve.manoeuvre": result.encode()}
    names = ["result.json", "motion.parquet", "manoeuvre.png", "manoeuvre.pdf"]
    with filled(directory) as place:
        (place / names[0]).write_text(result + "\n", encoding="utf-8", newline="\n")
        write_columns(run.motion, metadata, place / names[1])
        for name in names[2:]:
            save(draw(run), place / name)
    return [directory / name for name in names]


def _values(run: ManoeuvreRun) -> dict[str, Any]:
    return {
        "manoeuvre": run.manoeuvre.name,
        "source": run.manoeuvre.source,
        "vehicle": run.car.vehicle.name,
        "plant": run.car.plant,
        "version": __version__,
        "parameters": {
            name: {"value": _finite(value), "unit": unit} for name, value, unit in _parameters(run.manoeuvre)
        },
        "duration": float(run.motion["time"][-1]),
        "measures": {
            name: {"value": _finite(each.value), "unit": each.unit, "meaning": each.meaning}
            for name, each in run.measures.items()
        },
    }


def _parameters(manoeuvre: Manoeuvre) -> list[tuple[str, float, str]]:
    """Name, value and unit of each."""
    return [(f.name, getattr(manoeuvre, f.name), f.metadata["unit"]) for f in fields(manoeuvre)]  # type: ignore[arg-type]


def _finite(value: float) -> float | None:
    return value if isfinite(value) else None


def _shown(value: float) -> str:
    return f"{value:.4g}" if isfinite(value) else "none"
