"""Beyond the horizon: a point mass that goes on with what the horizon began, past the obstacles or to a stop.

At 72 km/h the horizon of Table 3 ends after 20 m. A plan that sees no further meets the obstacle's near edge first,
slows down a little to stop short of it, and finds out too late that there was only room to steer; and no plan of that
length sees a stop. So the path goes on, in steps that grow:

    Y'' = clip(w^2 (target - Y) - 2 w Y', -a, a),    a <= CURVATURE X'^2,    X'' = -b while X' > 0

A stop needs its length whichever way the vehicle points: X' then begins as the speed over ground, so that a plan does
not swing to and fro to stop shorter. The tail asks of the horizon's end what a friction circle can still mend, and no
more; the optimised cost does not see it.
"""

from dataclasses import dataclass
from functools import cache

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.conventions import N_STATES, PSI, VX, VY, X, Y
from swerve.kernel import Kernel

Array = NDArray[np.float64]

N_MOTION = 4  # X, Y, X', Y'
CURVATURE = 0.15  # [1/m] of the tightest turn of a car, which is what limits a when it is slow
TURNING_SPEED = 2.0  # [m/s] below, the heading no longer follows the velocity
SLOWEST = 1e-3  # [m/s] keeps the speed over ground from having no derivative at rest
INSTANT = 1e-9  # [m/s^2] a braking below this is none


@dataclass(frozen=True, eq=False)
class Outlook:
    """What the point mass does.

    Attributes:
        durations: (n,) of its steps [s].
        targets: (n,) lateral offset that it steers for in each [m].
        stiffness: w^2 of the steering; 0 only ends the lateral motion [1/s^2].
        lateral: a, largest lateral acceleration [m/s^2].
        braking: b, deceleration [m/s^2].
        is_blocked: whether there is no room where it steers: something stands on both sides, and too close.
    """

    durations: Array
    targets: Array
    stiffness: float
    lateral: float
    braking: float
    is_blocked: bool = False

    @property
    def times(self) -> Array:
        """(n,) when each step ends, from the horizon's end on [s]."""
        return np.cumsum(self.durations)


class Tail:
    """The point mass, compiled for a number of steps."""

    def __init__(self, n_steps: int) -> None:
        """Compile, or take from the cache, the path and its derivatives."""
        self.n_steps = n_steps
        self._path, self._derivative = Kernel(_path(n_steps)), Kernel(_derivative(n_steps))

    def path(self, end: Array, outlook: Outlook) -> tuple[Array, Array]:
        """Poses (n, 3) after each step, from the state (6,) at the horizon's end, and speeds along X (n,)."""
        poses, speeds = self._path(end, *_arguments(outlook))
        return poses.T, speeds

    def sensitivities(self, end: Array, of_end: Array, outlook: Outlook) -> Array:
        """Derivatives (n, 3, m) of the poses, from those of the state at the horizon's end, (6, m)."""
        by_start, of_start = self._derivative(end, *_arguments(outlook))
        by_start = by_start.T.reshape(self.n_steps, N_MOTION, 3).transpose(0, 2, 1)
        moved: Array = by_start @ (of_start @ of_end)
        return moved


def _arguments(outlook: Outlook) -> tuple[Array, Array, Array]:
    return outlook.durations, outlook.targets, np.array([outlook.stiffness, outlook.lateral, outlook.braking])


@cache
def _path(n_steps: int) -> ca.Function:
    """(state, durations, targets, [w^2, a, b]) -> poses (3, n), speeds (n,)."""
    motion, *held = _symbols()
    after, pose = _step(motion, *held)
    step = ca.Function("step", [motion, *held], [after, ca.vertcat(pose, after[2])])
    end, durations, targets, p = _arguments_of(n_steps)
    start = _start()(end, p)
    _, found = step.mapaccum("tail", n_steps).call([start, durations, targets, ca.repmat(p, 1, n_steps)])
    return ca.Function("tail", [end, durations.T, targets.T, p], [found[:3, :], found[3, :].T])


@cache
def _derivative(n_steps: int) -> ca.Function:
    """The same arguments -> derivatives of the poses by the motion at the start, (3, 4 n), and of that by the state."""
    motion, *held = _symbols()
    after, pose = _step(motion, *held)
    by_start = ca.SX.sym("by_start", N_MOTION, N_MOTION)  # of the motion before the step
    ends = [ca.densify(ca.jacobian(each, motion) @ by_start) for each in (after, pose)]
    carried = ca.vertcat(motion, ca.vec(by_start))
    step = ca.Function("step", [carried, *held], [ca.vertcat(after, ca.vec(ends[0])), ca.vec(ends[1])])
    end, durations, targets, p = _arguments_of(n_steps)
    start = _start()
    begun = ca.vertcat(start(end, p), ca.vec(ca.DM.eye(N_MOTION)))
    _, found = step.mapaccum("tail", n_steps).call([begun, durations, targets, ca.repmat(p, 1, n_steps)])
    arguments = start.sx_in()
    jacobian = ca.Function("of_start", arguments, [ca.densify(ca.jacobian(start(*arguments), arguments[0]))])
    results = [ca.reshape(found, 3, N_MOTION * n_steps), jacobian(end, p)]
    return ca.Function("tail_derivative", [end, durations.T, targets.T, p], results)


def _symbols() -> tuple[ca.SX, ca.SX, ca.SX, ca.SX]:
    return ca.SX.sym("motion", N_MOTION), ca.SX.sym("h"), ca.SX.sym("target"), ca.SX.sym("p", 3)


def _arguments_of(n_steps: int) -> tuple[ca.MX, ca.MX, ca.MX, ca.MX]:
    row = (1, n_steps)
    return ca.MX.sym("end", N_STATES), ca.MX.sym("durations", *row), ca.MX.sym("targets", *row), ca.MX.sym("p", 3)


def _start() -> ca.Function:
    """(state, [w^2, a, b]) -> [X Y X' Y'] of the point mass."""
    end, p = ca.SX.sym("end", N_STATES), ca.SX.sym("p", 3)
    cos, sin = ca.cos(end[PSI]), ca.sin(end[PSI])
    along = ca.fmax(cos * end[VX] - sin * end[VY], 0)
    forwards = ca.if_else(p[0] > 0, along, ca.sqrt(end[VX] ** 2 + end[VY] ** 2 + SLOWEST**2))
    return ca.Function("start", [end, p], [ca.vertcat(end[X], end[Y], forwards, sin * end[VX] + cos * end[VY])])


def _step(motion: ca.SX, duration: ca.SX, target: ca.SX, p: ca.SX) -> tuple[ca.SX, ca.SX]:
    """[X Y X' Y'] and [X Y psi] after a step."""
    x, y, forwards, leftwards = ca.vertsplit(motion)
    stiffness, lateral, braking = ca.vertsplit(p)
    largest = ca.fmin(lateral, CURVATURE * forwards**2)
    damping = 2 * ca.fmax(ca.sqrt(stiffness), 1)
    sideways = ca.fmax(-largest, ca.fmin(largest, stiffness * (target - y) - damping * leftwards))
    moving = ca.fmin(duration, forwards / ca.fmax(braking, INSTANT))
    slower = ca.fmax(forwards - braking * duration, 0)
    ended_leftwards = ca.fmax(-slower, ca.fmin(slower, leftwards + duration * sideways))
    x_end = x + moving * (forwards + slower) / 2
    y_end = y + moving * (leftwards + ended_leftwards) / 2
    psi = ca.atan(ended_leftwards / ca.fmax(slower, TURNING_SPEED))
    return ca.vertcat(x_end, y_end, slower, ended_leftwards), ca.vertcat(x_end, y_end, psi)
