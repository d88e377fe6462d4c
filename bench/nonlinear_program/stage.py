"""One sample of the full nonlinear program as CasADi functions, with first and second derivatives.

    c(x_k, u_k) = [x_k+1; gap_k+1/2 and gap_k+1 of each obstacle; alpha_front(x_k, u_k); alpha_rear(x_k+1)]

by the controller's own discretisation of eq. (1), two Runge-Kutta steps a sample. An obstacle is the ellipse of eq. (5)
as it is:

    gap = (rho - 1) min(a, b) / 2

which is the distance from a circle [m] to first order at contact, and smooth everywhere.
"""

from typing import Any, NamedTuple

import casadi as ca
import numpy as np

from swerve.conventions import N_INPUTS, N_STATES, N_WHEELS, X, Y
from swerve.vehicle.integrate import rk4
from swerve.vehicle.two_track import Parameters, axle_slip_angle, symbols, two_track

N_OBSTACLE = 7  # centre X, Y [m], its velocity [m/s], semi-axes [m], heading [rad]
N_BOTH = N_STATES + N_INPUTS  # variables of a sample, [x; u]
N_SLIPS = 2  # front, rear
INPUT_SCALE = np.array([0.1, 1e3, 1e3, 1e3, 1e3])  # [rad, N, N, N, N] per unit of the scaled inputs


class Stage(NamedTuple):
    """Functions of (x, u, k, data), with u in units of INPUT_SCALE and k the sample's index.

    Attributes:
        value: c.
        jacobian: c, and dc/d[x; u].
        hessian: of (..., lambda): the second derivatives of lambda' c by [x; u], and its gradient.
    """

    value: ca.Function
    jacobian: ca.Function
    hessian: ca.Function


def n_data(n_obstacles: int) -> int:
    """Length of data = [wheel loads; vehicle and road; Ts; each obstacle]."""
    return N_WHEELS + len(Parameters._fields) + 1 + N_OBSTACLE * n_obstacles


def stage(n_obstacles: int) -> Stage:
    """The sample for a number of obstacles."""
    x, u, loads, p = symbols()
    k, duration = ca.SX.sym("k"), ca.SX.sym("Ts")
    obstacles = ca.SX.sym("obstacles", N_OBSTACLE, n_obstacles)
    data = ca.vertcat(loads, *p, duration, ca.vec(obstacles))
    inputs = [u[i] * INPUT_SCALE[i] for i in range(N_INPUTS)]
    wheel_loads = [loads[i] for i in range(N_WHEELS)]

    def derivative(state: ca.SX) -> Any:
        return ca.vertcat(*two_track(state, inputs, wheel_loads, p).derivative)

    middle = rk4(derivative, x, duration / 2)
    end = rk4(derivative, middle, duration / 2)
    gaps = [
        _gap(state, (k + share) * duration, obstacles[:, i])
        for i in range(n_obstacles)
        for state, share in ((middle, 0.5), (end, 1.0))
    ]
    slips = (axle_slip_angle(x, p.lf, inputs[0], p), axle_slip_angle(end, -p.lr, 0.0, p))
    return _with_derivatives(x, u, (k, data), ca.vertcat(end, *gaps, *slips))


def _with_derivatives(x: ca.SX, u: ca.SX, others: tuple[ca.SX, ...], c: ca.SX) -> Stage:
    arguments, both = [x, u, *others], ca.vertcat(x, u)
    multipliers = ca.SX.sym("lambda", c.numel())
    hessian, gradient = ca.hessian(ca.dot(multipliers, c), both)
    return Stage(
        ca.Function("stage", arguments, [c]),
        ca.Function("stage_jacobian", arguments, [c, ca.densify(ca.jacobian(c, both))]),
        ca.Function("stage_hessian", [*arguments, multipliers], [ca.densify(hessian), ca.densify(gradient)]),
    )


def _gap(state: ca.SX, time: ca.SX, obstacle: ca.SX) -> Any:
    """The gap [m] between the centre of gravity and an obstacle, `time` [s] after it was where it was seen."""
    centre, velocity, semi_axes, heading = obstacle[:2], obstacle[2:4], obstacle[4:6], obstacle[6]
    away = ca.vertcat(state[X], state[Y]) - centre - time * velocity
    cos, sin = ca.cos(heading), ca.sin(heading)
    in_axes = ca.vertcat(cos * away[0] + sin * away[1], cos * away[1] - sin * away[0])
    return (ca.sumsqr(in_axes / semi_axes) - 1) * ca.fmin(semi_axes[0], semi_axes[1]) / 2
