"""The ablation as a file: Markdown for the documentation, CSV and JSON for programs.

Nothing in it depends on the machine: times of steps and runs are left out.
"""

import csv
import json
from dataclasses import asdict
from io import StringIO
from math import degrees
from typing import Any, Final

from swerve import __version__
from swerve.report.markdown import table
from swerve.simulate import Result
from swerve.study.ablation import PLANT, Ablation

MEASURED: Final = (
    "outcome",
    "decision",
    "min_distance_ratio",
    "min_clearance",
    "impact_speed",
    "max_steer",
    "max_sideslip",
    "steps",
    "fallback_steps",
    "solver_failures",
)


def as_markdown(ablation: Ablation) -> str:
    """Two tables, to be included in a page: what each row came to, and what it changed."""
    scenes = "\n".join(f"- `{scene.name}`: {scene.description}" for scene in ablation.scenes)
    came_to = table(
        ["controller", *(f"`{scene.name}`" for scene in ablation.scenes)],
        [[row.variant.name, *map(_cell, row.results)] for row in ablation.rows],
    )
    changed = table(
        ["controller", "what it changes, and why it matters"],
        [[row.variant.name, row.variant.change] for row in ablation.rows],
    )
    return f"""Measured by swerve {__version__} on the plant `{PLANT}`, in these scenarios:

{scenes}

Each cell has the outcome and the smallest $\\sqrt\\rho$ (1 is contact), then the largest steering angle, then the steps
that were answered by the fallback, and the programs without a solution.

{came_to}

A row with a + keeps all that the rows above it put right.

{changed}
"""


def as_csv(ablation: Ablation) -> str:
    """A line for each run, in SI units; an empty field for a value that does not exist."""
    text = StringIO()
    writer = csv.DictWriter(text, ["variant", "controller", "scenario", *MEASURED], lineterminator="\n")
    writer.writeheader()
    for row in ablation.rows:
        for result in row.results:
            names = {"variant": row.variant.name, "controller": result.controller, "scenario": result.scenario}
            writer.writerow(names | _measured(result))
    return text.getvalue()


def as_json(ablation: Ablation) -> str:
    """Scenes, and rows with settings, sentence and a result for each scene, in SI units."""
    rows = [
        asdict(row.variant) | {"results": {result.scenario: _measured(result) for result in row.results}}
        for row in ablation.rows
    ]
    scenes = [asdict(scene) for scene in ablation.scenes]
    whole = {"version": __version__, "plant": PLANT, "scenes": scenes, "rows": rows}
    return json.dumps(whole, indent=2, allow_nan=False) + "\n"


def _measured(result: Result) -> dict[str, Any]:
    values = result.to_json()
    return {name: values[name] for name in MEASURED}


def _cell(result: Result) -> str:
    values = _measured(result)
    ratio = "none" if values["min_distance_ratio"] is None else f"{values['min_distance_ratio']:.3f}"
    steer = "none" if values["max_steer"] is None else f"{degrees(values['max_steer']):.1f} deg"
    return f"{result.outcome.value} {ratio}<br>{steer}<br>{result.fallback_steps} / {result.solver_failures}"
