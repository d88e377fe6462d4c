"""The full vehicle: fourteen degrees of freedom, and the transient slip of four tyres.

    6  the sprung body:      X, Y, z, psi, pitch, roll
    4  the unsprung masses:  q, travel along their guides
    4  the wheels:           w, spin

`body` has the equations of motion, `suspension`, `tyre` and `wheel` the forces in them; here they meet. The state
begins with the six of the two-track model: vx and vy are those of O, the body's point in which the centre of gravity is
at rest, in yaw axes; r is psi'. Tyre forces act R below the wheel's centre, in the road's axes; a wheel's plane stands
upright, so camber is neglected, and so are the toe that travel makes and the inertia of steering a wheel.
"""

from typing import Any, NamedTuple

import casadi as ca

from swerve.conventions import GRAVITY, N_STATES, N_WHEELS
from swerve.vehicle.multibody import tyre
from swerve.vehicle.multibody.body import Attitude, Guided, accelerations, attitude
from swerve.vehicle.multibody.numbers import Numbers
from swerve.vehicle.multibody.suspension import suspension_forces, tyre_load
from swerve.vehicle.multibody.wheel import spin_rate

# After [vx vy r psi X Y]: z, vz, roll, pitch, their rates; four each of travel, its rate, spin, kappa, tan alpha.
N_INNER = 6 + 5 * N_WHEELS
N_MULTIBODY = N_STATES + N_INNER
SPIN = slice(N_STATES + 14, N_STATES + 18)
SLIP_SPEED_FLOOR = 0.1  # [m/s] below, the slip angle that is shown fades; no force depends on it


class Motion(NamedTuple):
    """What the model yields at one instant.

    Attributes:
        derivative: of the state, (N_MULTIBODY,).
        acceleration: (ax, ay) of O in yaw axes [m/s^2].
        loads: FL FR RL RR [N].
        slip_angles: of the wheels' velocities [rad].
        longitudinal: Fx in the wheel's axes [N].
        lateral: Fy in the wheel's axes [N].
    """

    derivative: Any
    acceleration: tuple[Any, Any]
    loads: list[Any]
    slip_angles: list[Any]
    longitudinal: list[Any]
    lateral: list[Any]


class _Wheel(NamedTuple):
    """One wheel at one instant, in yaw axes."""

    guided: Guided
    moment: Any
    spin_momentum: Any
    rates: tuple[Any, Any, Any]  # of spin, kappa, tan alpha
    load: Any
    slip_angle: Any
    fx: Any
    fy: Any


def multibody(x: Any, steering: Any, torques: Any, brakes: Any, friction: Any, p: Numbers, step: Any) -> Motion:
    """The model at one instant.

    Args:
        x: state, (N_MULTIBODY,).
        steering: angle of the front wheels [rad].
        torques: (4,) of the motors on the wheels [N m]; what is below zero resists as a brake does.
        brakes: (4,) strength of the friction brakes [N m], >= 0.
        friction: (4,) mu under each wheel [1].
        p: numbers.
        step: over which a wheel's dry friction acts [s].
    """
    vx, vy, r, psi, _, _, z, vz, roll, pitch, roll_rate, pitch_rate = ca.vertsplit(x[:12])
    travel, travel_rate, spin, kappa, tangent = (x[12 + 4 * i : 16 + 4 * i] for i in range(5))
    turn = attitude(roll, pitch, (roll_rate, pitch_rate, r))
    velocity = ca.vertcat(vx, vy, vz)
    pushes = suspension_forces(travel, travel_rate, p)
    headings = (ca.vertcat(ca.cos(steering), ca.sin(steering)), ca.DM([1, 0]))
    wheels = []
    for i in range(N_WHEELS):
        states = (travel[i], travel_rate[i], spin[i], kappa[i], tangent[i])
        acting = (torques[i], brakes[i], friction[i], pushes[i])
        wheels.append(_wheel(i, states, acting, headings[i // 2], turn, velocity, z, p, step))
    force, moment = _external(wheels, turn, vx, p)
    inertia = turn.rotation @ ca.diag(ca.vertcat(p.Ixx, p.Iyy, p.Izz)) @ turn.rotation.T
    at = turn.rotation @ ca.vertcat(p.xs, 0, p.zs)
    a, alpha, lifts = accelerations((p.ms, at), inertia, [w.guided for w in wheels], turn, force, moment)
    roll_acc, pitch_acc, yaw_acc = _euler(alpha - turn.bias, pitch)
    derivative = ca.vertcat(
        *(a[0] + r * vy, a[1] - r * vx, yaw_acc, r),
        *(vx * ca.cos(psi) - vy * ca.sin(psi), vx * ca.sin(psi) + vy * ca.cos(psi)),
        *(vz, a[2], roll_rate, pitch_rate, roll_acc, pitch_acc),
        *(travel_rate, *lifts),
        *(w.rates[k] for k in range(3) for w in wheels),
    )
    shown = (list(column) for column in zip(*((w.load, w.slip_angle, w.fx, w.fy) for w in wheels), strict=True))
    return Motion(derivative, (a[0], a[1]), *shown)


def _wheel(
    i: int, states: tuple[Any, ...], acting: tuple[Any, ...], heading: Any, turn: Attitude, velocity: Any, z: Any,
    p: Numbers, step: Any,
) -> _Wheel:  # fmt: skip
    """Wheel `i`: how it moves, what slips, and the forces that follow."""
    travel, travel_rate, spin, kappa, tangent = states
    torque, brake, friction, suspension = acting
    place, static, mass, lean = _geometry(i, p)
    guide = turn.rotation @ ca.vertcat(0, lean, 1)
    position = turn.rotation @ place + guide * travel
    contact = position - ca.vertcat(0, 0, p.R)
    centre_velocity = velocity + ca.cross(turn.omega, position) + guide * travel_rate
    # of the point R below the centre that goes with the wheel's carrier
    lateral_velocity = centre_velocity - p.R * ca.cross(turn.omega, ca.DM([0, 0, 1]))
    load = tyre_load(static, z + position[2] - (p.R - p.h), centre_velocity[2], p)
    cos, sin = heading[0], heading[1]
    at_x = cos * centre_velocity[0] + sin * centre_velocity[1]
    at_y = cos * lateral_velocity[1] - sin * lateral_velocity[0]
    rates, (fx, fy) = tyre.contact(p, (kappa, tangent), at_x, spin * p.R, at_y, friction, load)
    dry = brake + ca.fmax(-torque, 0.0) + p.rolling * load * p.R  # a motor that brakes resists, and turns nothing back
    spin_acc = spin_rate(spin, ca.fmax(torque, 0.0) - fx * p.R, dry, p.Iw, step)
    axle = turn.rotation @ ca.vertcat(-sin, cos, 0)
    force = ca.vertcat(cos * fx - sin * fy, sin * fx + cos * fy, load)
    weight = ca.vertcat(0, 0, -mass * GRAVITY)
    moment = ca.cross(contact, force) + ca.cross(position, weight) - axle * (p.Iw * spin_acc)
    shown = -ca.atan(at_y / ca.fmax(ca.fabs(at_x), SLIP_SPEED_FLOOR))
    guided = Guided(mass, position, guide, travel_rate, force + weight, suspension)
    return _Wheel(guided, moment, axle * (p.Iw * spin), (spin_acc, *rates), load, shown, fx, fy)


def _geometry(i: int, p: Numbers) -> tuple[Any, Any, Any, Any]:
    """Of wheel `i` at rest: its centre from O, in the body, its load and mass, and how its guide leans to the left."""
    is_front, side = i < 2, 1 if i % 2 == 0 else -1
    x, static, mass, lean = (p.lf, p.Ff, p.muf, p.ef) if is_front else (-p.lr, p.Fr, p.mur, p.er)
    return ca.vertcat(x, side * p.lt, p.R - p.h), static, mass, side * lean


def _external(wheels: list[_Wheel], turn: Attitude, vx: Any, p: Numbers) -> tuple[Any, Any]:
    """Forces of road, weight and air, and their moments about O less the change of spin momentum."""
    weight = ca.vertcat(0, 0, -p.ms * GRAVITY)
    at = turn.rotation @ ca.vertcat(p.xs, 0, p.zs)
    force = weight + ca.vertcat(-p.drag * ca.fabs(vx) * vx, 0, 0)
    moment = ca.cross(at, weight)
    for wheel in wheels:
        force = force + wheel.guided.force
        moment = moment + wheel.moment - ca.cross(turn.omega, wheel.spin_momentum)
    return force, moment


def _euler(alpha: Any, pitch: Any) -> tuple[Any, Any, Any]:
    """Second derivatives of roll, pitch and yaw [rad/s^2] of an angular acceleration without its bias."""
    roll = alpha[0] / ca.cos(pitch)
    return roll, alpha[1], alpha[2] + ca.sin(pitch) * roll
