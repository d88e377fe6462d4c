"""Scenes for tests: one instant, from a scenario in SI."""

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swerve.scenario import Scenario, load
from swerve.simulate.outcome import touches
from swerve.study.criticality import Scene

Array = NDArray[np.float64]

FRONT = 2.02  # [m] from the sedan's centre of gravity to its front end
REAR = 4.85 - FRONT
WIDTH = 1.8  # [m]


def box(x: float, y: float = 0.0, vx: float = 0.0, vy: float = 0.0, **more: Any) -> dict[str, Any]:
    """A rectangular obstacle of 4 m by 1.8 m."""
    return {"position": (x, y), "velocity": (vx, vy), "size": (4.0, 1.8), **more}


def scenario(*obstacles: dict[str, Any], speed: float = 20.0, friction: float = 0.85, **more: Any) -> Scenario:
    """The paper's scenario with other obstacles; `more` are of the ego vehicle, or the lane width."""
    tables = load("paper").model_dump(exclude_none=True)
    tables["road"] = {"friction": friction}
    if "lane_width" in more:
        tables["road"] |= {"lane_width": more.pop("lane_width"), "lanes_left": 1, "lanes_right": 1}
    tables["ego"] |= {"speed": speed, "footprint": "rectangle", **more}
    return Scenario.model_validate({**tables, "obstacles": obstacles})


def scene(*obstacles: dict[str, Any], plant: str = "planar", **more: Any) -> Scene:
    """The first instant of `scenario`."""
    return Scene.of_start(scenario(*obstacles, **more), plant)


def later(at: Scene, tau: float) -> Scene:
    """The scene after `tau` [s] of which the vehicle and the obstacles have kept velocity and heading."""
    states = at.states.copy()
    states[:, 4:] += tau * at.velocity
    obstacles = tuple(replace(each, position=each.position + tau * each.velocity) for each in at.obstacles)
    return replace(at, times=at.times + tau, states=states, obstacles=obstacles)


def is_hit(at: Scene, elapsed: Array, poses: Array) -> bool:
    """Whether any obstacle is touched along poses (n, 3) at times (n,) after the instant, as a run's outcome has it."""
    times = at.times[0] + elapsed
    return any(touches(each.obstacle, at.footprint, poses, times).any() for each in at.obstacles)
