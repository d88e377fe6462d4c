"""Time to steer: until the last instant at which a swerve to one side still avoids every obstacle.

Hillenbrand et al. (2006) and Tamke et al. (2011), as for the time to brake. A swerve counts when it ends well as a
run does (simulate/outcome.py): it touches nothing, stays on the road and does not spin.
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.simulate.outcome import SPIN_SIDESLIP, sideslip
from swerve.study.criticality.last_start import last_start
from swerve.study.criticality.manoeuvre import SHIFTS, swerve
from swerve.study.criticality.roll_out import roll_out
from swerve.study.criticality.scene import Scene

Array = NDArray[np.float64]

BISECTIONS: Final = 3  # of the shift, where something else is in the way


def time_to_steer(scene: Scene, side: int, ttc: Array) -> Array:
    """Of instants that lead to a collision, (n,) [s]; -inf where no swerve to this side helps.

    Args:
        scene: n instants.
        side: 1 to the left, -1 to the right.
        ttc: (n,) time to collision, finite [s].
    """
    shifts = np.array(SHIFTS)
    times = np.array([_of_one(scene, side, np.full(len(ttc), shift), ttc) for shift in shifts])
    at, best = times.argmax(axis=0), times.max(axis=0)
    if scene.road.left_edge is None and len(scene.obstacles) == 1:
        return np.asarray(best)
    # a larger shift leaves more time until it meets an edge or another obstacle: the best one is between two of them
    low, high = shifts[at], shifts[np.minimum(at + 1, len(shifts) - 1)]
    for _ in range(BISECTIONS):
        middle = np.sqrt(low * high)
        found = _of_one(scene, side, middle, ttc)
        low, high = np.where(found >= best, middle, low), np.where(found >= best, high, middle)
        best = np.maximum(best, found)
    return np.asarray(best)


def _of_one(scene: Scene, side: int, shift: Array, ttc: Array) -> Array:
    path = roll_out(scene, swerve(scene, side, shift))
    slips = np.array([np.abs(sideslip(states)).max() for states in path.states])
    return np.where(slips > SPIN_SIDESLIP, -np.inf, last_start(scene, path, ttc, on_road=True))
