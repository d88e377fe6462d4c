"""A solution driven again, by an integrator that the program does not know: what it claims is measured here.

DOP853 of SciPy with tight tolerances on the right-hand side of eq. (1), interval by interval with the inputs held, slip
angles rounded off below the plant's speed only, and the distances of `world` every millisecond or less.
"""

from dataclasses import dataclass, replace
from functools import cache
from math import ceil
from typing import Final

import casadi as ca
import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from swerve.conventions import VX, VY, R
from swerve.kernel import Kernel
from swerve.study.limit.dynamics import inputs
from swerve.study.limit.grid import Ending
from swerve.study.limit.program import CREEP, END_SIDESLIP, END_YAW_RATE
from swerve.study.limit.scene import Scene
from swerve.study.limit.trajectory import Trajectory
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters, symbols, two_track
from swerve.world import Ellipse, Obstacle, Rectangle, clearance, distance_ratio

Array = NDArray[np.float64]

FINEST: Final = 1e-3  # [s] between two looks at the distances
TOLERANCE: Final = 1e-9  # of the integrator, relative and absolute
KEPT: Final = 0.999  # [1] smallest sqrt(rho) that counts as clear
TOUCH: Final = 2e-3  # [m] by which a rectangle or a road's edge may be overlapped
PAST: Final = 0.05  # [m] by which the end may fall short of an obstacle's
LOOSER: Final = 2.0  # [1] times the end's limits, for what the round-off at low speed and the integrator change


@dataclass(frozen=True, eq=False)
class Drive:
    """What was measured.

    Attributes:
        times: (n,) [s].
        states: (n, 6).
        ratio: smallest sqrt(rho) over all ellipses [1]; None without one.
        clearance: smallest distance to an obstacle [m].
        is_clear: whether no obstacle was touched, but for what the program's tolerances and chords leave.
        is_inside: whether the road's edges were kept.
        is_stable: whether the end is what the program asks of it.
    """

    times: Array
    states: Array
    ratio: float | None
    clearance: float
    is_clear: bool
    is_inside: bool
    is_stable: bool

    @property
    def is_avoided(self) -> bool:
        """Whether nothing was touched, the road kept and the end stable."""
        return self.is_clear and self.is_inside and self.is_stable


def resimulate(scene: Scene, found: Trajectory) -> Drive:
    """Drive the inputs of a solution, in the scene at its distance and friction."""
    scene = scene.at(found.distance).on(found.friction)
    times, states = _integrate(scene, found)
    poses = states[:, [4, 5, 3]]
    ellipses = [each for each in scene.obstacles if isinstance(each.shape, Ellipse)]
    ratios = [float(distance_ratio(scene.footprint, poses, each, times).min()) for each in ellipses]
    ratio = min(ratios, default=None)
    distance = min(float(clearance(scene.footprint, poses, each, times).min()) for each in scene.obstacles)
    cores = [_core(each, each.shape) for each in scene.obstacles if isinstance(each.shape, Rectangle)]
    touched = [bool((clearance(scene.footprint, poses, each, times) <= 0).any()) for each in cores]
    is_clear = not any(touched) and (ratio is None or ratio >= KEPT)
    is_inside, is_stable = _is_inside(scene, poses), _is_stable(scene, found, times[-1], states[-1])
    return Drive(times, states, ratio, distance, is_clear, is_inside, is_stable)


def _core(obstacle: Obstacle, shape: Rectangle) -> Obstacle:
    """A rectangle without the margin that may be overlapped."""
    length, width = (max(size - 2 * TOUCH, size / 2) for size in (shape.length, shape.width))
    return replace(obstacle, shape=replace(shape, length=length, width=width))


def _integrate(scene: Scene, found: Trajectory) -> tuple[Array, Array]:
    rate, parameters = _rate(), Parameters.of(scene.vehicle, scene.friction).as_array()
    step = found.grid.step
    looks = np.linspace(0.0, step, ceil(step / FINEST) + 1)
    times, states, x = [np.zeros(1)], [scene.start[np.newaxis]], scene.start
    for k, u in enumerate(inputs(scene.vehicle, scene.friction, found.shares)):
        part = solve_ivp(
            lambda _, xi, u=u: rate(xi, u, parameters)[0],
            (0.0, step),
            x,
            method="DOP853",
            t_eval=looks[1:],
            rtol=TOLERANCE,
            atol=TOLERANCE,
        )
        times.append(k * step + part.t)
        states.append(part.y.T)
        x = part.y[:, -1]
    return np.concatenate(times), np.concatenate(states)


@cache
def _rate() -> Kernel:
    """(xi, u, p) -> xi' of eq. (1) with static loads."""
    xi, u, _, p = symbols()
    rate = ca.vertcat(*two_track(xi, u, wheel_loads(p), p).derivative)
    return Kernel(ca.Function("limit_rate", [xi, u, ca.vertcat(*p)], [rate]))


def _is_inside(scene: Scene, poses: Array) -> bool:
    left, right = scene.road.left_edge, scene.road.right_edge
    if left is None or right is None:
        return True
    leftwards = np.column_stack((np.sin(poses[:, 2]), np.cos(poses[:, 2])))
    leftmost = (poses[:, 1] + scene.footprint.support(leftwards)).max()
    rightmost = (poses[:, 1] - scene.footprint.support(-leftwards)).min()
    return bool(leftmost <= left + TOUCH and rightmost >= right - TOUCH)


def _is_stable(scene: Scene, found: Trajectory, time: float, end: Array) -> bool:
    """Whether the last state is the program's: straight, and past or no faster."""
    is_straight = abs(end[VY]) <= LOOSER * (CREEP + END_SIDESLIP * end[VX]) and abs(end[R]) <= LOOSER * END_YAW_RATE
    if found.grid.ending is Ending.BEHIND:
        return bool(is_straight and end[VX] <= scene.slowest + LOOSER * CREEP)
    return bool(is_straight and scene.past(end, time) >= -PAST)
