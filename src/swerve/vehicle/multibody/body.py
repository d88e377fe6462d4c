"""The equations of motion of a sprung body on four guided wheels, by Newton and Euler, without a small angle.

All vectors are in the yaw axes: they turn with psi, their z axis is the world's, and their origin O moves with that
point of the body in which the vehicle's centre of gravity is at rest. The unknowns are a, the acceleration of O, and
alpha, the angular acceleration of the body; a mass m at rho from O that the body carries has

    acceleration = a + alpha x rho + w x (w x rho)

A wheel slides on a straight guide of the body, along D; q is how far it is up. It adds D q'' + 2 w x D q', with

    m D . acceleration = D . f - S          f: forces of road and weight on it, S: of the suspension, along the guide

With g = (D, rho x D) and u = (a, alpha), q'' = (free - g . u) / D^2. Eliminated, it leaves six symmetric equations,
those of one rigid body less m g g' / D^2 for each wheel:

    sum of m acceleration             = sum of forces
    sum of rho x m acceleration + H'  = sum of moments about O,     H' = I alpha + w x (I w + spin momentum)

The guide of a wheel at y = +-lt leans outwards by h_rc / lt: so a lateral force at the road meets the body at the
height h_rc of the roll centre, and only the moment above it passes through the springs; jacking follows from that lean.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

import casadi as ca


class Attitude(NamedTuple):
    """The body's rotation against the yaw axes.

    Attributes:
        rotation: (3, 3) from body to yaw axes, Ry(pitch) Rx(roll).
        omega: (3,) angular velocity [rad/s].
        bias: (3,) angular acceleration [rad/s^2] when the rates of roll, pitch and yaw are constant.
    """

    rotation: Any
    omega: Any
    bias: Any


class Guided(NamedTuple):
    """A wheel as a mass on its guide.

    Attributes:
        mass: [kg].
        position: (3,) of its centre from O [m].
        guide: (3,) D, the direction of its guide; its length says how far the wheel goes for a unit of q.
        speed: q' [m/s].
        force: (3,) of road and weight [N].
        suspension: S, force of spring, damper and bar on the body, along the guide [N].
    """

    mass: Any
    position: Any
    guide: Any
    speed: Any
    force: Any
    suspension: Any


def attitude(roll: Any, pitch: Any, rates: tuple[Any, Any, Any]) -> Attitude:
    """Of roll and pitch [rad] and the rates of roll, pitch and yaw [rad/s]."""
    sr, cr, sp, cp = ca.sin(roll), ca.cos(roll), ca.sin(pitch), ca.cos(pitch)
    rotation = ca.vertcat(ca.horzcat(cp, sp * sr, sp * cr), ca.horzcat(0, cr, -sr), ca.horzcat(-sp, cp * sr, cp * cr))
    p, q, r = rates
    omega = ca.vertcat(cp * p, q, r - sp * p)
    bias = ca.vertcat(-q * r - q * sp * p, r * cp * p, -q * cp * p)
    return Attitude(rotation, omega, bias)


def accelerations(
    sprung: tuple[Any, Any], inertia: Any, wheels: Sequence[Guided], turn: Attitude, force: Any, moment: Any
) -> tuple[Any, Any, list[Any]]:
    """Acceleration of O (3,) [m/s^2], angular acceleration (3,) [rad/s^2], and q'' of each wheel [m/s^2].

    Args:
        sprung: mass [kg] and position from O (3,) [m] of the sprung body's centre of gravity.
        inertia: (3, 3) of the sprung body about it, in yaw axes [kg m^2].
        wheels: four.
        turn: how the body turns.
        force: (3,) all external forces [N].
        moment: (3,) all external moments about O less the change of the wheels' spin momentum [N m].
    """
    # as if the wheels were fixed to the body, and then without what their guides let go
    bodies = [(*sprung, _centripetal(turn.omega, sprung[1]))]
    bodies += [(w.mass, w.position, _carried(turn.omega, w)) for w in wheels]
    matrix = _composite(bodies, inertia)
    moment = moment - ca.cross(turn.omega, inertia @ turn.omega)
    right = ca.vertcat(
        force - sum(mass * bias for mass, _, bias in bodies),
        moment - sum(mass * ca.cross(at, bias) for mass, at, bias in bodies),
    )
    loose = []
    for wheel, (_, _, bias) in zip(wheels, bodies[1:], strict=True):
        row = ca.vertcat(wheel.guide, ca.cross(wheel.position, wheel.guide))
        length2 = ca.dot(wheel.guide, wheel.guide)
        free = (ca.dot(wheel.guide, wheel.force) - wheel.suspension) / wheel.mass - ca.dot(wheel.guide, bias)
        matrix = matrix - row @ (row.T * (wheel.mass / length2))
        right = right - row * (wheel.mass * free / length2)
        loose.append((free, row, length2))
    solved = _solve(matrix, right)
    return solved[:3], solved[3:], [(free - ca.dot(row, solved)) / length2 for free, row, length2 in loose]


def _composite(bodies: Sequence[tuple[Any, Any, Any]], inertia: Any) -> Any:
    """Mass matrix (6, 6) of masses (mass, position, ...) on one rigid body, and of an inertia about none of them."""
    total = sum(mass for mass, _, _ in bodies)
    coupling = -ca.skew(sum(mass * at for mass, at, _ in bodies))
    for mass, at, _ in bodies:
        inertia = inertia + mass * (ca.dot(at, at) * ca.SX.eye(3) - at @ at.T)
    return ca.vertcat(ca.horzcat(total * ca.SX.eye(3), coupling), ca.horzcat(coupling.T, inertia))


def _carried(omega: Any, wheel: Guided) -> Any:
    """Acceleration of a wheel (3,) [m/s^2] when neither O, nor the body, nor q' is accelerated."""
    return _centripetal(omega, wheel.position) + 2 * wheel.speed * ca.cross(omega, wheel.guide)


def _centripetal(omega: Any, position: Any) -> Any:
    return ca.cross(omega, ca.cross(omega, position))


def _solve(matrix: Any, right: Any) -> Any:
    """The solution of a symmetric positive definite system, by L D L'."""
    diagonal, factor, order = ca.ldl(matrix)
    return ca.ldl_solve(right, diagonal, factor, order)
