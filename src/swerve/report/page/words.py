"""A run in words: the verdict in one sentence, the scene, and the moments that matter."""

from collections.abc import Iterator
from math import hypot
from typing import Any, Final

import numpy as np

from swerve.report.page.interim import plan_of
from swerve.report.page.motion import Motion
from swerve.scenario.surroundings import ObstacleSettings
from swerve.simulate import Outcome, Run

TIMES: Final = "\N{MULTIPLICATION SIGN}"
KM_H: Final = 3.6  # [(km/h) / (m/s)]
TITLES: Final = {
    Outcome.AVOIDED: "Avoided",
    Outcome.COLLIDED: "Collided",
    Outcome.LEFT_ROAD: "Left the road",
    Outcome.SPUN: "Spun",
    Outcome.DIVERGED: "Diverged",
}
MOST_CHANGES: Final = 6  # of the decision that are listed as moments
_DEEDS: Final = {"none": "drove on", "brake": "braked", "steer-left": "steered left", "steer-right": "steered right"}


def verdict(run: Run, motion: Motion) -> str:
    """What the vehicle did and what came of it."""
    result = run.result
    if result.outcome is Outcome.DIVERGED and result.divergence is not None:
        return f"The simulated motion grew beyond all bounds after {result.divergence.time:.2f} s."
    deeds = " and ".join(_DEEDS[word] for word in result.decision.split("+"))
    return f"The vehicle {deeds}{_consequence(run, motion)}{_peak(motion)}."


def _consequence(run: Run, motion: Motion) -> str:
    result = run.result
    when = "" if motion.closest is None else f" after {motion.time[motion.closest]:.2f} s"
    match result.outcome:
        case Outcome.COLLIDED:
            speed = "" if result.impact_speed is None else f" at {result.impact_speed * KM_H:.1f} km/h"
            return f" and hit an obstacle{speed}{when}"
        case Outcome.LEFT_ROAD:
            return " and crossed the edge of the road"
        case Outcome.SPUN:
            return " and turned more than 45° away from where it was going"
    if result.min_clearance is None:
        return " with no obstacle about"
    return f" and kept {_length(result.min_clearance)} clear"


def _peak(motion: Motion) -> str:
    most = peak_friction_use(motion)
    return "" if most is None else f", using up to {_percent(most)} of a tyre's friction"


def _length(length: float) -> str:
    """In centimetres below a metre [m]."""
    return f"{length * 100:.1f} cm" if length < 1 else f"{length:.2f} m"


def _percent(share: float) -> str:
    return f"{share * 100:.0f}\N{NO-BREAK SPACE}%"


def peak_friction_use(motion: Motion) -> float | None:
    """Largest share of its friction that any wheel used [1]; None when all were in the air."""
    use = motion.wheels["use"]
    return None if np.isnan(use).all() else float(np.nanmax(use))


def facts(run: Run) -> list[tuple[str, str]]:
    """The scene: name and text of each fact."""
    scenario = run.scenario
    ego, road = scenario.ego, scenario.road
    lanes = "no edges" if road.lane_width is None else f"{_lanes(run)} of {road.lane_width:g} m"
    goal = f"{scenario.goal.speed * KM_H:.4g} km/h at Y = {scenario.goal.lateral_offset:g} m"
    return [
        ("Vehicle", f"{ego.vehicle} at {ego.speed * KM_H:.4g} km/h, judged by its {_judged(ego.footprint)}"),
        ("Road", f"friction {road.friction:g}{' with patches' if road.patches else ''}, {lanes}"),
        ("Obstacles" if len(scenario.obstacles) > 1 else "Obstacle", _obstacles(scenario.obstacles)),
        ("Goal", goal),
    ]


def settings(run: Run) -> list[tuple[str, str]]:
    """Who drove what: name and text of each."""
    controller, result = run.scenario.controller, run.result
    horizon = f"{controller.prediction_horizon} {TIMES} {controller.sample_time * 1e3:g} ms"
    return [
        ("Controller", f"{result.controller}, horizon {horizon}"),
        ("Plant", f"{result.plant}, step {run.scenario.plant.step * 1e3:g} ms, seed {result.seed}"),
    ]


def _judged(footprint: str) -> str:
    return "centre of gravity" if footprint == "point" else "body"


def _lanes(run: Run) -> str:
    n = run.scenario.road.lanes_left + run.scenario.road.lanes_right + 1
    return f"{n} lane" if n == 1 else f"{n} lanes"


def _obstacles(obstacles: tuple[ObstacleSettings, ...]) -> str:
    return "; ".join(map(_obstacle, obstacles)) or "none"


def _obstacle(obstacle: ObstacleSettings) -> str:
    if obstacle.semi_axes is not None:
        kind, size = "ellipse", tuple(2 * each for each in obstacle.semi_axes)
    else:
        kind, size = "box", obstacle.size or (0.0, 0.0)
    speed = hypot(*obstacle.velocity)
    motion = "at rest" if speed == 0 else f"at {speed * KM_H:.4g} km/h"
    x, y = obstacle.position
    return f"{kind} {size[0]:g} m {TIMES} {size[1]:g} m at ({x:g}, {y:g}) m, {motion}"


def moments(run: Run, motion: Motion) -> list[dict[str, Any]]:
    """Instants worth a look: time [s] and words, in order of time."""
    found = [*_decisions(run), *_extremes(run, motion)]
    return [{"time": round(time, 4), "words": words} for time, words in sorted(found)]


def _decisions(run: Run) -> list[tuple[float, str]]:
    """Where the plan's name changes, and the first step of the fallback."""
    plans = [plan_of(plan) for plan in run.plans]
    times = run.log.steps["time"]
    changes = [
        (float(times[k]), f"plan: {plan.name}")
        for k, plan in enumerate(plans)
        if (plan.name != plans[k - 1].name if k else plan.name != "keep")
    ]
    failed = [float(times[k]) for k, plan in enumerate(plans) if plan.fallback]
    return changes[:MOST_CHANGES] + [(time, "first fallback") for time in failed[:1]]


def _extremes(run: Run, motion: Motion) -> Iterator[tuple[float, str]]:
    if motion.closest is not None:
        gap = motion.columns["clearance"][motion.closest]
        words = "contact" if run.result.outcome is Outcome.COLLIDED else f"closest, {_length(float(gap))}"
        yield float(motion.time[motion.closest]), words
    most = peak_friction_use(motion)
    if most is not None:
        row = int(np.nanargmax(np.nanmax(np.nan_to_num(motion.wheels["use"]), axis=1)))
        yield float(motion.time[row]), f"most friction used, {_percent(most)}"
