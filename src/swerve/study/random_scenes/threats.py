"""What a scene asks of a vehicle, by geometry alone: whether it must act, and whether it may not.

A scene is a threat where the vehicle touches an obstacle if it drives on as it starts; it is quiet where nothing comes
within a corridor about its path, neither in the run nor a while after.
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.scenario import Scenario
from swerve.simulate.outcome import touches
from swerve.world import Obstacle, Rectangle, clearance

Array = NDArray[np.float64]

STEP: Final = 0.01  # of the times at which it is looked [s]
CORRIDOR: Final = 0.5  # on each side of the footprint's path [m]
LOOK_AHEAD: Final = 5.0  # after the end of the run [s]


def is_threat(scene: Scenario) -> bool:
    """Whether the vehicle touches an obstacle within the run if it keeps its speed and heading."""
    times = np.arange(0.0, scene.duration, STEP)
    poses, footprint = driving_on(scene, times), scene.ego.to_footprint()
    return any(touches(each.to_world(), footprint, poses, times).any() for each in scene.obstacles)


def is_quiet(scene: Scenario) -> bool:
    """Whether no obstacle comes within the corridor, at any time until LOOK_AHEAD after the end of the run."""
    times = np.arange(0.0, scene.duration + LOOK_AHEAD, STEP)
    return all(_keeps_off(scene, each.to_world(), times) for each in scene.obstacles)


def driving_on(scene: Scenario, times: Array) -> Array:
    """Poses (n, 3) at times (n,) [s] of a vehicle that keeps its speed and heading."""
    ego = scene.ego
    along = ego.speed * times
    x, y = ego.position[0] + along * np.cos(ego.heading), ego.position[1] + along * np.sin(ego.heading)
    return np.column_stack([x, y, np.full(len(times), ego.heading)])


def _keeps_off(scene: Scenario, obstacle: Obstacle, times: Array) -> bool:
    """Whether an obstacle stays out of the corridor, which is as long as the whole path."""
    outline, path = scene.ego.to_footprint().outline(), driving_on(scene, times)
    ends = path[[0, -1], 0] + [outline[:, 0].min(), outline[:, 0].max()]
    width = np.ptp(outline[:, 1]) + 2 * CORRIDOR
    corridor = Rectangle(float(np.ptp(ends)), float(width))
    middle = np.array([ends.mean(), path[0, 1], 0.0])
    return bool((clearance(corridor, np.tile(middle, (len(times), 1)), obstacle, times) > 0).all())
