"""Where the search starts: the vehicle driven along simple paths, on either side, braking more or less.

A driver who looks ahead by a time T (Guo and Guan, Vehicle System Dynamics 22, 1993),

    delta = 2 / T^2 (f(X + T X') - Y - T Y') L / v^2,

follows a path f that swings aside and stays there, with the front tyres no further than their peak. Where the
distance is sought, the first of a geometric sequence at which this keeps clear is the guess: it can be driven.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import DELTA, FORCES, N_INPUTS, PSI, VX, VY, R, X, Y
from swerve.study.limit.dynamics import dynamics, slip_speed_floor
from swerve.study.limit.grid import N_INTERVALS, Ending, grid_for
from swerve.study.limit.means import Means
from swerve.study.limit.program import CREEP, END_SIDESLIP, END_YAW_RATE
from swerve.study.limit.scene import AHEAD, ASIDE, Scene, reach
from swerve.study.limit.separation import gaps
from swerve.study.limit.trajectory import Sought, Trajectory

Array = NDArray[np.float64]

PREVIEW: Final = 0.5  # [1] times the time that a point mass takes to go aside
PEAK_SLIP: Final = 0.12  # [rad] of the front wheels, near the tyre's peak
GENTLE_SLIP: Final = 0.08  # [rad]
MARGIN: Final = 0.3  # [m] beside an obstacle
NEAREST: Final = 0.9  # [1] times the distance at which a point mass goes aside: the first that is tried
GROWTH: Final = 1.1  # [1] from one distance that is tried to the next
TRIALS: Final = 20
MOST_SIDES: Final = 2  # obstacles that are passed left and right in turn; the others are on the last one's side


@dataclass(frozen=True)
class Start:
    """A way to drive.

    Attributes:
        ending: what it comes to.
        sides: of each obstacle in the order of their distances, 1 left or -1 right; empty straight on.
        brake: share of the brakes until the last obstacle [1].
        slip: largest of the front wheels [rad].
    """

    ending: Ending
    sides: tuple[int, ...]
    brake: float
    slip: float = PEAK_SLIP

    @property
    def name(self) -> str:
        """As in "left, braking 0.7, slip 0.12"."""
        words = ", then ".join("left" if side > 0 else "right" for side in self.sides) or "straight"
        stop = " to a stop" if self.ending is Ending.BEHIND else ""
        return f"{words}, braking {self.brake:g}, slip {self.slip:g}{stop}"


def starts(scene: Scene, means: Means) -> list[Start]:
    """The ways that are tried: those for which the road has room."""
    if means is Means.BRAKING:
        return [] if scene.is_oncoming else [Start(Ending.BEHIND, (), 1.0)]
    steering = ((0.0, PEAK_SLIP), (0.0, GENTLE_SLIP))
    hows = steering if means is Means.STEERING else ((0.3, PEAK_SLIP), (0.7, PEAK_SLIP))
    n = min(sum(map(scene.is_passed, scene.obstacles)), MOST_SIDES)
    tried = [Start(Ending.PAST, sides, *how) for sides in product((1, -1), repeat=n) for how in hows]
    return [start for start in tried if _is_on_road(scene, start)]


def _is_on_road(scene: Scene, start: Start) -> bool:
    """Whether its path keeps the road's edges."""
    levels = _path(scene, start)[1]
    poses = np.column_stack((np.zeros_like(levels), levels, np.zeros_like(levels)))
    return bool(scene.road.is_inside(scene.footprint, poses).all())


def guess(scene: Scene, start: Start, sought: Sought) -> Trajectory:
    """The start as driven: at the first distance or friction that it clears, or as it is for a violation."""
    driven = drive(scene, start)
    if sought is Sought.VIOLATION:
        return driven
    for at in _tried(scene, sought):
        driven = drive(at, start)
        if driven.violation <= 0 and _is_straight(driven):
            break
    return driven


def _is_straight(driven: Trajectory) -> bool:
    """Whether the end is what the program asks for."""
    end = driven.states[-1]
    return bool(abs(end[VY]) <= CREEP + END_SIDESLIP * end[VX] and abs(end[R]) <= END_YAW_RATE)


def _tried(scene: Scene, sought: Sought) -> Iterator[Scene]:
    """The scene, easier from one to the next."""
    aside = scene.closing * scene.time_aside
    for i in range(TRIALS):
        if sought is Sought.DISTANCE:
            yield scene.at(NEAREST * aside * GROWTH**i)
        else:
            yield scene.on(min(scene.friction * (aside / scene.distance) ** 2, 1.0) * GROWTH**i)


def drive(scene: Scene, start: Start) -> Trajectory:
    """The start driven in the scene as it is; `violation` is how far it touches an obstacle."""
    grid = grid_for(scene, start.ending)
    knots_x, knots_y = _path(scene, start)
    advance, floor = dynamics(scene.vehicle), slip_speed_floor(grid.step, scene.friction)
    states, shares = np.empty((N_INTERVALS + 1, 6)), np.zeros((N_INTERVALS, N_INPUTS))
    states[0] = scene.start
    for k, x in enumerate(states[:-1]):
        if start.sides:
            shares[k, DELTA] = _steering(scene, x, knots_x, knots_y, start.slip) / scene.vehicle.steering_limit
        is_before = start.ending is Ending.BEHIND or x[X] < knots_x[-1]
        shares[k, FORCES] = -min(start.brake, _to_stop(scene, x, grid.step)) if is_before else 0.0
        states[k + 1] = np.array(advance(x, shares[k], scene.friction, grid.step, floor)).ravel()
    violation = max(-float(gaps(each, scene.footprint, states, grid.times)[1].min()) for each in scene.obstacles)
    return Trajectory(grid, states, shares, scene.distance, scene.friction, max(0.0, violation))


def _to_stop(scene: Scene, x: Array, step: float) -> float:
    """The share of the brakes that stops within an interval."""
    full = scene.vehicle.force_limit * scene.grip * step
    return float(max(0.0, x[VX] - scene.slowest) / full)


def _steering(scene: Scene, x: Array, knots_x: Array, knots_y: Array, slip: float) -> float:
    """The driver's angle [rad]."""
    vehicle, speed = scene.vehicle, max(float(np.hypot(x[VX], x[VY])), 1.0)
    course = x[PSI] + np.arctan2(x[VY], x[VX])
    preview = PREVIEW * scene.time_aside
    ahead = _height(x[X] + preview * speed * np.cos(course), knots_x, knots_y)
    missing = ahead - x[Y] - preview * speed * np.sin(course)
    wanted = 2 / preview**2 * missing * vehicle.wheelbase / speed**2
    at_front = np.arctan2(x[VY] + vehicle.cg_to_front_axle * x[R], max(x[VX], 1.0))
    angle = np.clip(wanted, at_front - slip, at_front + slip)
    return float(np.clip(angle, -vehicle.steering_limit, vehicle.steering_limit))


def _height(x: float, knots_x: Array, knots_y: Array) -> float:
    """f(x): level outside the knots, and 3 s^2 - 2 s^3 between two."""
    i = int(np.clip(np.searchsorted(knots_x, x) - 1, 0, len(knots_x) - 2))
    s = float(np.clip((x - knots_x[i]) / (knots_x[i + 1] - knots_x[i]), 0.0, 1.0))
    return float(knots_y[i] + (knots_y[i + 1] - knots_y[i]) * s * s * (3 - 2 * s))


def _path(scene: Scene, start: Start) -> tuple[Array, Array]:
    """Knots of the path: where the vehicle starts, and beside each obstacle where it is when that is passed."""
    own = float(scene.footprint.support(ASIDE).max())
    knots = [(float(scene.start[X]), float(scene.start[Y]))]
    order = sorted(filter(scene.is_passed, scene.obstacles), key=lambda each: float(each.position_at(0.0)[0]))
    for i, obstacle in enumerate(order):
        closing = max(scene.speed - obstacle.velocity_at(0.0)[0], 1.0)
        time = max(0.0, obstacle.position_at(0.0)[0] - scene.start[X]) / closing
        x, y = obstacle.position_at(time)
        side = start.sides[min(i, len(start.sides) - 1)] if start.sides else 0
        level = y + side * (float(reach(obstacle, side * ASIDE[:1], time)[0]) + own + MARGIN)
        half = float(reach(obstacle, AHEAD, time)[1]) / 2
        before = max(x - half, knots[-1][0] + 1.0)
        knots += [(before, level), (max(x + half, before + 1.0), level)]
    across, up = np.array(knots).T
    return across, up
