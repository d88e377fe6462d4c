"""A certificate from below: what no control can avoid, because not even a point mass with the same grip could.

Tyre forces stay within mu Fz max(1, D) of eq. (3), so the centre of gravity accelerates by no more than a = mu g max(1,
D) whatever is done, and at time t it is within a t^2 / 2 of where it would be without action. Let q be the vector from
there to an obstacle's centre and e the direction of approach. Either the vehicle stays behind the line abreast of the
centre, or it comes to that line on one side, by the last time t* to which it can have stayed behind; before that it has
crossed every ray n from the centre that lies between, beyond r(n), where the ray leaves the obstacle. So avoiding takes

    behind:         -e . q(t) <= a t^2 / 2  for every t
    left or right:  for every ray of that side some t <= t* and s >= r with  |q(t) + s n| <= a t^2 / 2.

For the ray abreast alone that is near  D >= v sqrt(2 w / a), and behind it is  D >= v^2 / (2 a). The obstacle is
widened by the largest disc about the centre of gravity that the footprint holds. Between instants of the time grid |q|
and a t^2 / 2 change by no more than their speeds allow, which is granted.
"""

from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import PSI, VX
from swerve.study.limit.scene import Scene, reach
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters
from swerve.vehicle.tyre import factors
from swerve.world import Obstacle

Array = NDArray[np.float64]

N_TIMES: Final = 20000
RAYS: Final = np.radians(np.arange(90.0, 171.0, 5.0))  # [rad] from the direction of approach, backwards
N_DIRECTIONS: Final = 720
N_HEADINGS: Final = 20  # of an obstacle that turns
COARSE: Final = 0.5  # [m] between the distances of which the first that can be avoided is looked for
FURTHEST: Final = 400  # of them
FINE: Final = 1e-3  # [m] and, of friction, [1]
MOST_FRICTION: Final = 2.0  # [1]


@lru_cache(maxsize=4)
def smallest_distance(scene: Scene) -> float:
    """The distance [m] below which nothing helps."""
    feasible = next((i for i in range(FURTHEST) if is_avoidable(scene.at(COARSE * i))), FURTHEST)
    low, high = COARSE * max(feasible - 1, 0), COARSE * feasible
    while high - low > FINE:
        middle = (low + high) / 2
        low, high = (low, middle) if is_avoidable(scene.at(middle)) else (middle, high)
    return low


@lru_cache(maxsize=4)
def smallest_friction(scene: Scene) -> float:
    """The friction [1] below which nothing helps at the scene's own distance."""
    low, high = 0.0, MOST_FRICTION
    while high - low > FINE:
        middle = (low + high) / 2
        low, high = (low, middle) if is_avoidable(scene.on(middle)) else (middle, high)
    return low


def is_avoidable(scene: Scene) -> bool:
    """Whether a point mass could come by, or stay behind, each obstacle on its own."""
    return all(_is_avoidable(scene, each) for each in scene.obstacles)


def _is_avoidable(scene: Scene, obstacle: Obstacle) -> bool:
    heading, speed = scene.start[PSI], scene.start[VX]
    velocity = speed * np.array([np.cos(heading), np.sin(heading)])
    grip = _grip(scene)
    closing = velocity - obstacle.velocity_at(0.0)
    times = np.linspace(0.0, 2 * (speed + np.hypot(*closing)) / grip, N_TIMES)
    q = obstacle.position_at(times) - scene.start[4:] - times[:, np.newaxis] * velocity
    moves = np.hypot(*np.diff(q, axis=0).T).max() / 2  # between an instant of the grid and the nearest in between
    reached = grip * times**2 / 2 + moves + grip * times * times[1] / 2
    direction = np.arctan2(closing[1], closing[0])
    ahead = np.array([np.cos(direction), np.sin(direction)])
    is_behind = -q @ ahead <= reached
    if is_behind.all():
        return True
    in_time = slice(0, int(np.argmin(is_behind)) + 1)
    seen = np.arctan2(*-q[0][::-1]) - direction  # of the start, from the centre
    between = [side * RAYS[(side * seen) % (2 * np.pi) >= RAYS] + direction for side in (1, -1)]
    turning = np.linspace(0.0, times[in_time][-1], N_HEADINGS)
    return any(
        _passes(rays, _leaves(scene, obstacle, rays, turning), q[in_time], reached[in_time])
        for rays in (np.column_stack((np.cos(angles), np.sin(angles))) for angles in between)
    )


def _passes(rays: Array, leaves: Array, q: Array, reached: Array) -> bool:
    """Whether every ray can be crossed at some time, beyond where it leaves the obstacle."""
    from_centre = np.maximum(leaves[:, np.newaxis], -rays @ q.T)
    nearest = np.hypot(*(q.T[:, np.newaxis] + rays.T[:, :, np.newaxis] * from_centre))
    return bool((nearest <= reached).any(axis=1).all())


def _leaves(scene: Scene, obstacle: Obstacle, rays: Array, times: Array) -> Array:
    """Where each ray leaves the obstacle at the least, widened by a disc [m]: the nearest of its supporting lines."""
    angles = np.linspace(0.0, 2 * np.pi, N_DIRECTIONS, endpoint=False)
    normals = np.column_stack((np.cos(angles), np.sin(angles)))
    disc = max(0.0, float(scene.footprint.support(normals).min()))
    along = rays @ normals.T
    supports = [reach(obstacle, normals, time) for time in times]
    lines = (np.min(supports, axis=0) + disc) / np.where(along > 1e-9, along, np.nan)
    leaves: Array = np.nanmin(lines, axis=1)
    leaves *= np.cos(np.pi / N_DIRECTIONS)  # the nearest line of N is no further out than this
    return leaves


def _grip(scene: Scene) -> float:
    """a [m/s^2]."""
    loads = wheel_loads(Parameters.of(scene.vehicle, scene.friction))
    peak = max(1.0, *(float(factors(scene.vehicle.tyre, load)[2]) for load in loads))
    return scene.grip * peak
