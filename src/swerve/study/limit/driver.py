"""A driver, who makes the guesses: along a path that swings aside and stays there, braking more or less before.

Who looks ahead by a time T (Guo and Guan, Vehicle System Dynamics 22, 1993) and steers

    delta = 2 / T^2 (f(X + T X') - Y - T Y') L / v^2

follows the path f, here with the front tyres no further than their peak.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import DELTA, FORCES, N_INPUTS, N_STATES, PSI, VX, VY, R, X, Y
from swerve.study.limit.dynamics import dynamics, model_numbers
from swerve.study.limit.grid import Ending, grid_for
from swerve.study.limit.layout import STATE_SCALE
from swerve.study.limit.scene import AHEAD, ASIDE, Scene, reach
from swerve.study.limit.separation import gaps
from swerve.study.limit.trajectory import Trajectory

Array = NDArray[np.float64]

PEAK_SLIP: Final = 0.12  # [rad] of the front wheels, near the tyre's peak
SLOWED: Final = 0.5  # [1] of the speed over the slowest obstacle's, below which a guess brakes no further
MARGIN: Final = 0.3  # [m] beside an obstacle


@dataclass(frozen=True)
class Start:
    """A way to drive.

    Attributes:
        ending: what it comes to.
        sides: of each obstacle in the order of their distances, 1 left or -1 right; empty straight on.
        brake: share of the brakes until the first obstacle [1].
        preview: T in units of the time that a point mass takes to go aside [1].
    """

    ending: Ending
    sides: tuple[int, ...]
    brake: float
    preview: float

    @property
    def name(self) -> str:
        """As in "left, braking 0.7, preview 1"."""
        words = ", then ".join("left" if side > 0 else "right" for side in self.sides) or "straight"
        stop = " to a stop" if self.ending is Ending.BEHIND else ""
        return f"{words}, braking {self.brake:g}, preview {self.preview:g}{stop}"


def drive(scene: Scene, start: Start) -> Trajectory:
    """The start driven in the scene as it is; `violation` is how far it touches an obstacle."""
    grid = grid_for(scene, start.ending)
    knots_x, knots_y = path(scene, start)
    advance, model = dynamics().value, model_numbers(scene.vehicle, grid.step, scene.friction)
    states, shares = np.empty((grid.n_intervals + 1, N_STATES)), np.zeros((grid.n_intervals, N_INPUTS))
    states[0], slowed = scene.start, scene.slowest + SLOWED * (scene.speed - scene.slowest)
    for k, x in enumerate(states[:-1]):
        if start.sides:
            shares[k, DELTA] = _steering(scene, x, knots_x, knots_y, start.preview) / scene.vehicle.steering_limit
        if start.ending is Ending.BEHIND or (start.sides and x[X] < knots_x[1] and x[VX] > slowed):
            shares[k, FORCES] = -min(start.brake, _to_stop(scene, x, grid.step))
        y = np.concatenate([x, shares[k], [scene.friction]])
        states[k + 1] = np.array(advance(y, model)).ravel() * STATE_SCALE
    violation = max(-float(gaps(each, scene.footprint, states, grid.times)[1].min()) for each in scene.obstacles)
    return Trajectory(grid, states, shares, scene.distance, scene.friction, max(0.0, violation))


def _to_stop(scene: Scene, x: Array, step: float) -> float:
    """The share of the brakes that stops within an interval."""
    full = scene.vehicle.force_limit * scene.grip * step
    return float(max(0.0, x[VX] - scene.slowest) / full)


def _steering(scene: Scene, x: Array, knots_x: Array, knots_y: Array, preview: float) -> float:
    """The driver's angle [rad]."""
    vehicle, speed = scene.vehicle, max(float(np.hypot(x[VX], x[VY])), 1.0)
    course = x[PSI] + np.arctan2(x[VY], x[VX])
    preview *= scene.time_aside
    ahead = _height(x[X] + preview * speed * np.cos(course), knots_x, knots_y)
    missing = ahead - x[Y] - preview * speed * np.sin(course)
    wanted = 2 / preview**2 * missing * vehicle.wheelbase / speed**2
    at_front = np.arctan2(x[VY] + vehicle.cg_to_front_axle * x[R], max(x[VX], 1.0))
    angle = np.clip(wanted, at_front - PEAK_SLIP, at_front + PEAK_SLIP)
    return float(np.clip(angle, -vehicle.steering_limit, vehicle.steering_limit))


def _height(x: float, knots_x: Array, knots_y: Array) -> float:
    """f(x): level outside the knots, and 3 s^2 - 2 s^3 between two."""
    i = int(np.clip(np.searchsorted(knots_x, x) - 1, 0, len(knots_x) - 2))
    s = float(np.clip((x - knots_x[i]) / (knots_x[i + 1] - knots_x[i]), 0.0, 1.0))
    return float(knots_y[i] + (knots_y[i + 1] - knots_y[i]) * s * s * (3 - 2 * s))


def path(scene: Scene, start: Start) -> tuple[Array, Array]:
    """Knots of the path: where the vehicle starts, and beside each obstacle where it is when that is passed."""
    own = float(scene.footprint.support(ASIDE).max())
    knots = [(float(scene.start[X]), float(scene.start[Y]))]
    passed = filter(scene.is_passed, scene.obstacles) if start.sides else ()
    for i, obstacle in enumerate(sorted(passed, key=scene.meeting)):
        time = scene.meeting(obstacle)
        x, y = obstacle.position_at(time)
        side = start.sides[min(i, len(start.sides) - 1)]
        beside = y + side * (float(reach(obstacle, side * ASIDE[:1], time)[0]) + own + MARGIN)
        level = side * max(side * beside, side * knots[-1][1])  # no nearer than the one before asks for
        half = float(reach(obstacle, AHEAD, time)[1]) / 2
        before = max(x - half, knots[-1][0] + 1.0)
        knots += [(before, level), (max(x + half, before + 1.0), level)]
    across, up = np.array(knots).T
    return across, up
