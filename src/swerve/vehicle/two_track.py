"""Eq. (1) of the paper: the planar two-track model, three degrees of freedom and two forces a wheel.

    m (vx' - vy r) = sum of body-frame longitudinal tyre forces
    m (vy' + vx r) = sum of body-frame lateral tyre forces
    Izz r'         = sum of x_i Fy_i - y_i Fx_i  over the wheels at (x_i, y_i)
    psi' = r,   X' = vx cos psi - vy sin psi,   Y' = vx sin psi + vy cos psi

Written once: numbers give numbers, CasADi symbols give the expression that is differentiated, rolled out and compiled.
Slip angles are those of the wheels' own velocities. Below a speed v0 the rolling speed under the arctangent is rounded
off (v -> (v^2 + v0^2) / (2 v0)), which takes the singularity of eq. (1) at standstill away and changes nothing above.
The model's fastest pole there is near 365 / v0 [1/s] at friction 0.85, and proportional to it; a Runge-Kutta step h
needs h < 2.8 / that.
"""

from typing import Any, NamedTuple

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.conventions import N_WHEELS
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.parameters import Vehicle
from swerve.vehicle.tyre import lateral_force, longitudinal_force

SLIP_SPEED_FLOOR = 0.5  # [m/s] v0 for steps up to 3.7 ms
LOAD_PASSES = 3  # from static loads to loads that fit the accelerations; the error falls by mu h / L in each


class Parameters(NamedTuple):
    """What a kernel of the two-track model takes as one vector: the vehicle's numbers and the road's friction.

    Attributes, with the paper's letters:
        m [kg], Izz [kg m^2], lf, lr, lt, h (centre of gravity's height) [m], the tyre's b0 b1 c0 c1 d0 d1, mu [1],
        v0 (speed below which slip angles are rounded off) [m/s].
    """

    m: Any
    Izz: Any
    lf: Any
    lr: Any
    lt: Any
    h: Any
    b0: Any
    b1: Any
    c0: Any
    c1: Any
    d0: Any
    d1: Any
    mu: Any
    v0: Any

    @classmethod
    def of(cls, vehicle: Vehicle, friction: float, slip_speed_floor: float = SLIP_SPEED_FLOOR) -> "Parameters":
        """The numbers of `vehicle` on a road of `friction` [1], with slip angles rounded off below a speed [m/s]."""
        v, t = vehicle, vehicle.tyre
        body = (v.mass, v.yaw_inertia, v.cg_to_front_axle, v.cg_to_rear_axle, v.half_track, v.cg_height)
        return cls(*body, t.b0, t.b1, t.c0, t.c1, t.d0, t.d1, friction, slip_speed_floor)

    @classmethod
    def symbolic(cls) -> "Parameters":
        """A CasADi symbol for each."""
        return cls(*(ca.SX.sym(name) for name in cls._fields))

    def as_array(self) -> NDArray[np.float64]:
        """The vector that kernels take."""
        return np.array(self, dtype=float)


class Motion(NamedTuple):
    """What eq. (1) yields at one instant: derivatives, and the tyres behind them.

    Attributes:
        derivative: of the state, six components.
        acceleration: (ax, ay) of the centre of gravity in the body frame [m/s^2].
        slip_angles: FL FR RL RR [rad].
        longitudinal: tyre forces Fx in the wheel's frame, FL FR RL RR [N].
        lateral: tyre forces Fy in the wheel's frame, FL FR RL RR [N].
    """

    derivative: tuple[Any, ...]
    acceleration: tuple[Any, Any]
    slip_angles: tuple[Any, ...]
    longitudinal: tuple[Any, ...]
    lateral: tuple[Any, ...]


def two_track(xi: Any, u: Any, loads: Any, p: Parameters) -> Motion:
    """Eq. (1) with the tyre of eq. (4).

    Args:
        xi: state [vx vy r psi X Y], six numbers or symbols.
        u: input [delta Fx_fl Fx_fr Fx_rl Fx_rr].
        loads: vertical loads FL FR RL RR [N].
        p: parameters.
    """
    vx, vy, r, psi = (xi[i] for i in range(4))
    steer = (ca.cos(u[0]), ca.sin(u[0]))
    straight = (1.0, 0.0)
    wheels = (
        (p.lf, p.lt, steer),
        (p.lf, -p.lt, steer),
        (-p.lr, p.lt, straight),
        (-p.lr, -p.lt, straight),
    )
    slips, longitudinal, lateral = [], [], []
    force_x, force_y, moment = 0.0, 0.0, 0.0
    for i, (x, y, (cos, sin)) in enumerate(wheels):
        at_x, at_y = vx - y * r, vy + x * r
        slip = _slip_angle(at_x, at_y, cos, sin, p.v0)
        fx = longitudinal_force(u[1 + i], p.mu, loads[i])
        fy = lateral_force(p, slip, fx, p.mu, loads[i])
        body_x, body_y = fx * cos - fy * sin, fx * sin + fy * cos
        force_x, force_y, moment = force_x + body_x, force_y + body_y, moment + x * body_y - y * body_x
        slips.append(slip)
        longitudinal.append(fx)
        lateral.append(fy)
    ax, ay = force_x / p.m, force_y / p.m
    cos, sin = ca.cos(psi), ca.sin(psi)
    derivative = (ax + vy * r, ay - vx * r, moment / p.Izz, r, vx * cos - vy * sin, vx * sin + vy * cos)
    return Motion(derivative, (ax, ay), tuple(slips), tuple(longitudinal), tuple(lateral))


def quasi_static_loads(xi: Any, u: Any, p: Parameters) -> tuple[Any, ...]:
    """Loads FL FR RL RR [N], never negative, that fit the accelerations they cause: a fixed point."""
    loads: tuple[Any, ...] = wheel_loads(p)
    for _ in range(LOAD_PASSES):
        loads = wheel_loads(p, *two_track(xi, u, loads, p).acceleration)
        loads = tuple(ca.fmax(load, 0.0) for load in loads)
    return loads


def axle_slip_angle(xi: Any, x: Any, steering_angle: Any, p: Parameters) -> Any:
    """Slip angle [rad] in the middle of an axle at `x` [m] ahead of the centre of gravity."""
    return _slip_angle(xi[0], xi[1] + x * xi[2], ca.cos(steering_angle), ca.sin(steering_angle), p.v0)


def symbols() -> tuple[ca.SX, ca.SX, ca.SX, Parameters]:
    """CasADi symbols of a state, an input, four loads and the parameters."""
    return ca.SX.sym("xi", 6), ca.SX.sym("u", 5), ca.SX.sym("Fz", N_WHEELS), Parameters.symbolic()


def _slip_angle(at_x: Any, at_y: Any, cos: Any, sin: Any, v0: Any) -> Any:
    """Angle [rad] from a wheel's velocity (at_x, at_y in body axes) to its plane, steered by (cos, sin)."""
    rolling = ca.fabs(cos * at_x + sin * at_y)
    return -ca.atan((cos * at_y - sin * at_x) / ca.if_else(rolling < v0, (rolling**2 + v0**2) / (2 * v0), rolling))
