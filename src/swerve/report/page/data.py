"""Runs as one JSON document, which is all that the page knows.

    {"format": 1, "scene": ..., "cars": [{"name", "result", "verdict", "body", "motion", "steps", "plans", "moments"}]}

Values are in SI. `result` is the run's own, number by number as in result.json; everything else is for display:
down-sampled and rounded. A comparison is a document with several cars in one scene.
"""

from collections.abc import Sequence
from typing import Any

from swerve.report.page.motion import Motion
from swerve.report.page.plans import plans_json, steps_json
from swerve.report.page.scene import scene_json
from swerve.report.page.words import moments, verdict
from swerve.simulate import Run
from swerve.vehicle import Vehicle

FORMAT = 1  # of the document; grows when a key changes its meaning


def document(runs: Sequence[Run]) -> dict[str, Any]:
    """The document of one run, or of several in one scene.

    Raises:
        ValueError: their scenes differ.
    """
    cars = [_car(run, name, is_ghost=i > 0) for i, (run, name) in enumerate(zip(runs, names(runs), strict=True))]
    end = max(car["motion"]["time"][-1] for car in cars)
    return {"format": FORMAT, "scene": scene_json([run.scenario for run in runs], end), "cars": cars}


def names(runs: Sequence[Run]) -> list[str]:
    """A name for each: its controller, with plant and seed as far as these differ between the runs."""
    seen = {name: {getattr(run.result, name) for run in runs} for name in ("controller", "plant", "seed")}
    several = {name for name, values in seen.items() if len(values) > 1}
    return [_name(run, several) for run in runs]


def _name(run: Run, several: set[str]) -> str:
    result = run.result
    plant = f" on {result.plant}" if "plant" in several else ""
    return f"{result.controller}{plant}{f', seed {result.seed}' if 'seed' in several else ''}"


def _car(run: Run, name: str, *, is_ghost: bool) -> dict[str, Any]:
    motion = Motion.of(run)
    return {
        "name": name,
        "result": run.result.to_json(),
        "verdict": verdict(run, motion),
        "body": _body(run.scenario.ego.to_vehicle()),
        "footprint": run.scenario.ego.footprint,
        "closest": None if motion.closest is None else round(float(motion.time[motion.closest]), 5),
        "motion": motion.to_json(),
        "steps": steps_json(run),
        "plans": plans_json(run, is_ghost=is_ghost),
        "moments": moments(run, motion),
    }


def _body(vehicle: Vehicle) -> dict[str, float]:
    """What is drawn of a vehicle, from its centre of gravity [m]."""
    return {
        "front": vehicle.cg_to_front_end,
        "rear": vehicle.cg_to_front_end - vehicle.length,
        "width": vehicle.width,
        "front_axle": vehicle.cg_to_front_axle,
        "rear_axle": -vehicle.cg_to_rear_axle,
        "half_track": vehicle.half_track,
        "wheel_radius": vehicle.wheel_radius,
    }
