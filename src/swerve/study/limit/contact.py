"""When the vehicle would touch an obstacle if nothing were done."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.study.limit.scene import Scene
from swerve.world import Ellipse, Obstacle, clearance, distance_ratio

Array = NDArray[np.float64]

LONGEST_DRIVE: Final = 60.0  # [s] in which a contact without action is looked for
CLOCK: Final = 1e-3  # [s]


def time_to_collision(scene: Scene) -> float | None:
    """Time [s] until the vehicle, going straight on, touches an obstacle; None where it never does."""
    times = np.arange(0.0, LONGEST_DRIVE, CLOCK)
    heading = scene.start[3]
    way = scene.speed * times[:, np.newaxis] * np.array([np.cos(heading), np.sin(heading)])
    poses = np.column_stack((scene.start[4:] + way, np.full(len(times), heading)))
    first = [_first_contact(scene, each, poses, times) for each in scene.obstacles]
    return min((time for time in first if time is not None), default=None)


def _first_contact(scene: Scene, obstacle: Obstacle, poses: Array, times: Array) -> float | None:
    if isinstance(obstacle.shape, Ellipse):
        touches = distance_ratio(scene.footprint, poses, obstacle, times) <= 1
    else:
        touches = clearance(scene.footprint, poses, obstacle, times) <= 0
    return float(times[np.argmax(touches)]) if touches.any() else None
