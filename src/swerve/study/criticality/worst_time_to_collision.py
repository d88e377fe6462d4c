"""Worst time to collision: the shortest until contact, whatever vehicle and obstacle do within their friction.

    gap(t) <= (a_ego + a_obstacle) t^2 / 2

where the gap is that of footprints which keep velocity and heading. Wachenfeld, Junietz, Wenzel, Winner, The
worst-time-to-collision metric for situation identification, IEEE IV (2016), with exact footprints in place of circles
and the heading kept. An obstacle at rest counts as one that could start; mu g is what each of them can have.
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import GRAVITY
from swerve.study.criticality.scene import Scene, Seen
from swerve.study.criticality.time_to_collision import time_to
from swerve.world import clearance

Array = NDArray[np.float64]

BISECTIONS: Final = 15
FINENESS: Final = 0.1  # [1] of the longest time, in which the first contact is looked for


def worst_time_to_collision(scene: Scene) -> Array:
    """With the obstacle that could be met first, (n,) [s]; inf without obstacles."""
    none = np.full(len(scene.times), np.inf)
    return np.asarray(np.minimum.reduce([none, *(_with(scene, each) for each in scene.obstacles)]))


def gap_after(scene: Scene, seen: Seen, elapsed: Array) -> Array:
    """Clearance to an obstacle after `elapsed` (n,) [s] at constant velocity and heading, (n,) [m]."""
    relative = scene.velocity - seen.velocity
    poses = np.column_stack((scene.position + elapsed[:, np.newaxis] * relative, scene.heading))
    return clearance(scene.footprint, poses, seen.obstacle, scene.times)


def _with(scene: Scene, seen: Seen) -> Array:
    """The first zero of gap(t) - 2 mu g t^2 / 2, bracketed on a grid up to a time by which it is there."""
    grip = scene.friction * GRAVITY

    def excess(times: Array) -> Array:
        return gap_after(scene, seen, times) - grip * times**2

    longest = np.minimum(_longest(gap_after(scene, seen, np.zeros(len(grip))), scene, seen), time_to(scene, seen))
    low, high = np.zeros(len(grip)), longest
    for share in np.arange(1.0, 0.0, -FINENESS):
        high = np.where(excess(share * longest) <= 0, share * longest, high)
    low = np.maximum(high - FINENESS * longest, 0.0)
    for _ in range(BISECTIONS):
        middle = (low + high) / 2
        is_met = excess(middle) <= 0
        low, high = np.where(is_met, low, middle), np.where(is_met, middle, high)
    return high


def _longest(gap: Array, scene: Scene, seen: Seen) -> Array:
    """The time after which even a gap that grows by the whole relative speed is closed: d + u t = mu g t^2."""
    grip, speed = scene.friction * GRAVITY, np.linalg.norm(scene.velocity - seen.velocity, axis=1)
    return np.asarray((speed + np.sqrt(speed**2 + 4 * grip * gap)) / (2 * grip))
