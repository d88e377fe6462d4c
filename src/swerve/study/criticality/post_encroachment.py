"""Post-encroachment time: how long apart vehicle and obstacle are at a place that both of them take up.

Allen, Shin, Cooper, Analysis of traffic conflicts and collisions, Transportation Research Record 667 (1978): from the
end of the one's encroachment to the other's arrival. It is measured on what happened, not on a prediction:

    PET = min |t_ego - t_obstacle|  over all pairs of times at which the two outlines, each at its own time, touch

and makes sense for an obstacle that moves. It is 0 for a collision.
"""

from math import inf
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.study.criticality.encounter import contact_along, poses_now
from swerve.study.criticality.scene import Scene, Seen

Array = NDArray[np.float64]

AT_REST: Final = 0.1  # [m/s] slower than this never leaves a place


def post_encroachment_time(scene: Scene) -> float:
    """The smallest over the obstacles that move [s]; inf where none crosses the vehicle's path in the log.

    Args:
        scene: n instants of a motion, in order; between them an obstacle keeps its velocity.
    """
    return min((_with(scene, i) for i in range(len(scene.obstacles))), default=inf)


def _with(scene: Scene, i: int) -> float:
    """Each instant's obstacle, moved along its path until half way to the neighbouring ones, against every pose."""
    times, smallest = scene.times, inf
    if len(times) < 2:
        return inf
    half = np.diff(times).max() / 2
    for k, time in enumerate(times):
        seen = _held(scene.obstacles[i], k, len(times))
        if np.hypot(*seen.velocity[0]) < AT_REST:
            continue
        # the obstacle moved by lambda w is the vehicle moved by -lambda w
        first, last = contact_along(scene, seen, np.zeros((len(times), 1)), poses_now(scene, 1), -seen.velocity)
        first, last = np.maximum(first[:, 0], -half), np.minimum(last[:, 0], half)
        apart = np.maximum(np.maximum(first + time - times, times - last - time), 0.0)
        smallest = min(smallest, float(np.where(first <= last, apart, inf).min()))
    return smallest


def _held(seen: Seen, k: int, n: int) -> Seen:
    """The obstacle of instant k at all n instants."""
    return Seen(
        seen.obstacle,
        np.repeat(seen.position[k : k + 1], n, axis=0),
        np.repeat(seen.velocity[k : k + 1], n, axis=0),
        np.repeat(seen.heading[k : k + 1], n),
    )
