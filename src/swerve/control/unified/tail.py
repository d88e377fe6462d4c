"""Beyond the horizon: a point mass that goes on with what the horizon began, until the obstacles are passed or it stands.

At 72 km/h the horizon of Table 3 ends after 20 m. A plan that sees no further meets the obstacle's near edge first,
slows down a little to stop short of it, and finds out too late that there was only room to steer; and no plan of that
length sees a stop. So the path goes on, in steps that grow:

    Y'' = clip(w^2 (target - Y) - 2 w Y', -a, a),    a <= CURVATURE X'^2,    X'' = -b while X' > 0

A stop needs its length whichever way the vehicle points: X' then begins as the speed over ground, so that a plan does
not swing to and fro to stop shorter. It asks of the horizon's end what a friction circle can still mend, and no more; the optimised cost does not see it.
"""

from dataclasses import dataclass

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.conventions import N_STATES, PSI, VX, VY, X, Y
from swerve.kernel import Kernel

Array = NDArray[np.float64]

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
    """

    durations: Array
    targets: Array
    stiffness: float
    lateral: float
    braking: float

    @property
    def times(self) -> Array:
        """(n,) when each step ends, from the horizon's end on [s]."""
        return np.cumsum(self.durations)


class Tail:
    """The point mass, compiled for a number of steps."""

    def __init__(self, n_steps: int) -> None:
        """Compile, or take from the cache, the path and its derivatives."""
        self.n_steps = n_steps
        path = _path(n_steps)
        self._path, self._derivative = Kernel(path), Kernel(_derivative(path))

    def path(self, end: Array, outlook: Outlook) -> tuple[Array, Array]:
        """Poses (n, 3) after each step, from the state (6,) at the horizon's end, and speeds along X (n,)."""
        poses, speeds = self._path(end, *_arguments(outlook))
        return poses.T, speeds

    def sensitivities(self, end: Array, of_end: Array, outlook: Outlook) -> Array:
        """Derivatives (n, 3, m) of the poses, from those of the state at the horizon's end, (6, m)."""
        (by_state,) = self._derivative(end, *_arguments(outlook))
        moved: Array = (by_state @ of_end).reshape(self.n_steps, 3, -1)
        return moved


def _arguments(outlook: Outlook) -> tuple[Array, Array, Array]:
    return outlook.durations, outlook.targets, np.array([outlook.stiffness, outlook.lateral, outlook.braking])


def _path(n_steps: int) -> ca.Function:
    """(state, durations, targets, [w^2, a, b]) -> poses (3, n), speeds (n,)."""
    end, motion = ca.SX.sym("end", N_STATES), ca.SX.sym("motion", 4)
    duration, target, p = ca.SX.sym("h"), ca.SX.sym("target"), ca.SX.sym("p", 3)
    step = ca.Function("step", [motion, duration, target, p], _step(motion, duration, target, p))
    cos, sin = ca.cos(end[PSI]), ca.sin(end[PSI])
    along = ca.fmax(cos * end[VX] - sin * end[VY], 0)
    forwards = ca.if_else(p[0] > 0, along, ca.sqrt(end[VX] ** 2 + end[VY] ** 2 + SLOWEST**2))
    start = ca.vertcat(end[X], end[Y], forwards, sin * end[VX] + cos * end[VY])
    durations, targets = ca.SX.sym("durations", n_steps), ca.SX.sym("targets", n_steps)
    poses, speeds = [], []
    for j in range(n_steps):
        start, pose = step(start, durations[j], targets[j], p)
        poses.append(pose)
        speeds.append(start[2])
    return ca.Function("tail", [end, durations, targets, p], [ca.horzcat(*poses), ca.vertcat(*speeds)])


def _step(motion: ca.SX, duration: ca.SX, target: ca.SX, p: ca.SX) -> list[ca.SX]:
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
    return [ca.vertcat(x_end, y_end, slower, ended_leftwards), ca.vertcat(x_end, y_end, psi)]


def _derivative(path: ca.Function) -> ca.Function:
    arguments = path.sx_in()
    poses, _ = path.call(arguments)
    return ca.Function("tail_derivative", arguments, [ca.densify(ca.jacobian(ca.vec(poses), arguments[0]))])
