"""What is round the vehicle: road, friction, obstacles over time, and the goal."""

from collections.abc import Sequence
from math import isfinite
from typing import Any

import numpy as np

from swerve.report.page.rounding import ANGLE, MILLIMETRE, TIME, rounded
from swerve.scenario import Scenario
from swerve.world import Obstacle, Patch, Road

EVERY = 0.05  # between two positions of an obstacle that moves [s]


def scene_json(scenarios: Sequence[Scenario], end: float) -> dict[str, Any]:
    """The scene that the scenarios share, up to the time `end` [s].

    Raises:
        ValueError: they do not share one.
    """
    first = scenarios[0]
    if any(_shared(scenario) != _shared(first) for scenario in scenarios[1:]):
        raise ValueError("the runs of one page need the same road, obstacles, goal and sample time")
    return {
        "name": first.name,
        "end": end,
        "sample_time": first.controller.sample_time,
        "goal": {"speed": first.goal.speed, "lateral_offset": first.goal.lateral_offset},
        "road": _road(first.road.to_world()),
        "friction": first.road.friction,
        "patches": [_patch(each) for each in first.road.to_friction().patches],
        "obstacles": [_obstacle(each.to_world(), end) for each in first.obstacles],
    }


def _shared(scenario: Scenario) -> tuple[Any, ...]:
    return scenario.road, scenario.obstacles, scenario.goal, scenario.controller.sample_time


def _road(road: Road) -> dict[str, Any]:
    """Y of the edges, of the lines between lanes, and of the one between directions [m]; none without lanes."""
    if road.lane_width is None:
        return {"edges": [], "lines": [], "oncoming": None}
    marks = [(k + 0.5) * road.lane_width for k in range(-road.lanes_right - 1, road.lanes_left + 1)]
    lines = [each for each in marks[1:-1] if each != road.oncoming_edge]
    return {"edges": [marks[0], marks[-1]], "lines": lines, "oncoming": road.oncoming_edge}


def _patch(patch: Patch) -> dict[str, Any]:
    """From and to along X and Y [m], null where it has no bound."""
    bounds = {name: [end if isfinite(end) else None for end in ends] for name, ends in (("x", patch.x), ("y", patch.y))}
    return {**bounds, "friction": patch.friction}


def _obstacle(obstacle: Obstacle, end: float) -> dict[str, Any]:
    """The outline in its own frame, and its pose over time; one at rest has a single row."""
    times = np.append(np.arange(0.0, end, EVERY), end)
    positions, headings = obstacle.position_at(times), obstacle.heading_at(times)
    if np.ptp(positions, axis=0).max() == 0 and np.ptp(headings) == 0:
        times, positions, headings = times[:1], positions[:1], headings[:1]
    return {
        "outline": rounded(obstacle.shape.outline(), MILLIMETRE),
        "time": rounded(times, TIME),
        "X": rounded(positions[:, 0], MILLIMETRE),
        "Y": rounded(positions[:, 1], MILLIMETRE),
        "psi": rounded(headings, ANGLE),
    }
