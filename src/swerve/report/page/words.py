"""A run in words: the verdict in one sentence, the scene, and the moments that matter."""

from collections.abc import Iterator
from typing import Any, Final

import numpy as np

from swerve.control.plan import KEEP
from swerve.report.page.motion import Motion
from swerve.report.page.obstacles import KM_H, TIMES, obstacles_in_words
from swerve.simulate import Outcome, Run

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
    return f"The vehicle {deeds}{_consequence(run, motion)}{_peak(run)}."


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


def _peak(run: Run) -> str:
    most = run.result.max_friction_use
    return "" if most is None else f", using up to {_percent(most)} of a tyre's friction"


def _length(length: float) -> str:
    """In centimetres below a metre [m]."""
    return f"{length * 100:.1f} cm" if length < 1 else f"{length:.2f} m"


def _percent(share: float) -> str:
    return f"{share * 100:.0f}\N{NO-BREAK SPACE}%"


def facts(run: Run) -> list[tuple[str, str]]:
    """The scene: name and text of each fact."""
    scenario = run.scenario
    ego, road = scenario.ego, scenario.road
    lanes = "no edges" if road.lane_width is None else f"{_lanes(run)} of {road.lane_width:g} m"
    goal = f"{scenario.goal.speed * KM_H:.4g} km/h at Y = {scenario.goal.lateral_offset:g} m"
    return [
        ("Vehicle", f"{ego.vehicle} at {ego.speed * KM_H:.4g} km/h, judged by its {_judged(ego.footprint)}"),
        ("Road", f"friction {road.friction:g}{' with patches' if road.patches else ''}, {lanes}"),
        ("Obstacles" if len(scenario.obstacles) > 1 else "Obstacle", obstacles_in_words(scenario.obstacles)),
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
    road = run.scenario.road
    n = road.lanes_left + road.lanes_right + 1
    oncoming = f", {road.lanes_oncoming} of them oncoming," if road.lanes_oncoming else ""
    return f"{n} {'lane' if n == 1 else 'lanes'}{oncoming}"


def moments(run: Run, motion: Motion) -> list[dict[str, Any]]:
    """Instants worth a look: time [s] and words, in order of time."""
    found = [*_decisions(run), *_extremes(run, motion)]
    return [{"time": round(time, 4), "words": words} for time, words in sorted(found)]


def _decisions(run: Run) -> list[tuple[float, str]]:
    """Where the plan's name changes, and the first step of the fallback."""
    steps = run.log.steps
    times, names = steps["time"].tolist(), steps["branch"].tolist()
    pairs = zip(times, [KEEP, *names], names, strict=False)
    changes = [(time, f"plan: {name}") for time, before, name in pairs if name != before]
    failed = [time for time, words in zip(times, steps["fallback"].tolist(), strict=True) if words]
    return changes[:MOST_CHANGES] + [(time, "first fallback") for time in failed[:1]]


def _extremes(run: Run, motion: Motion) -> Iterator[tuple[float, str]]:
    if motion.closest is not None:
        gap = motion.columns["clearance"][motion.closest]
        words = "contact" if run.result.outcome is Outcome.COLLIDED else f"closest, {_length(float(gap))}"
        yield float(motion.time[motion.closest]), words
    most = run.result.max_friction_use
    if most is not None:
        row = int(np.nanargmax(np.nanmax(np.nan_to_num(motion.wheels["use"]), axis=1)))
        yield float(motion.time[row]), f"most friction used, {_percent(most)}"
