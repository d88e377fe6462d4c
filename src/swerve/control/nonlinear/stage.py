"""One sample of the full nonlinear program as CasADi functions, with first and second derivatives.

    c(x_k, u_k) = [x_k+1; gap_k+1/2 and gap_k+1 of each pair; alpha_front(x_k, u_k); alpha_rear(x_k+1)]

by the controller's own discretisation of eq. (1), two Runge-Kutta steps a sample. A pair is a point of the ego vehicle
and an ellipse of eq. (5), as it is:

    gap = (rho - 1) min(a, b) / 2

which is the distance from a circle [m] to first order at contact, and smooth everywhere.

The gaps depend on two poses q alone, so their derivatives are put together from those of one pair and one pose, and the
code stays as long with many pairs as with one:

    d gap/d[x; u] = (d gap/dq) (dq/d[x; u]),   Hessian = (dq/d[x; u])' H_q (dq/d[x; u]) + sum_i (d gap/dq_i) H(q_i)
"""

from typing import Any, NamedTuple

import casadi as ca
import numpy as np

from swerve.conventions import N_INPUTS, N_STATES, N_WHEELS, PSI, X, Y
from swerve.vehicle.integrate import rk4
from swerve.vehicle.two_track import Parameters, axle_slip_angle, symbols, two_track

N_PAIR = 9  # point in the body frame [m]; centre X, Y [m], its velocity [m/s], semi-axes [m], heading [rad]
N_BOTH = N_STATES + N_INPUTS  # variables of a sample, [x; u]
N_SLIPS = 2  # front, rear
POSE = [X, Y, PSI]
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


def n_data(n_pairs: int) -> int:
    """Length of data = [wheel loads; vehicle and road; Ts; each pair]."""
    return N_WHEELS + len(Parameters._fields) + 1 + N_PAIR * n_pairs


def stage(n_pairs: int) -> Stage:
    """The sample for a number of pairs."""
    jacobian, hessian = _motion()
    x, u, k, data = (
        ca.MX.sym(name, n) for name, n in zip("xukd", (N_STATES, N_INPUTS, 1, n_data(n_pairs)), strict=True)
    )
    arguments, own, pairs = [x, u, k, data], data[: n_data(0)], ca.reshape(data[n_data(0) :], N_PAIR, n_pairs)
    y, y_both = jacobian(x, u, own)
    end, middle, slips = y[:N_STATES], y[N_STATES:-N_SLIPS], y[-N_SLIPS:]
    duration = data[n_data(0) - 1]
    at_middle = _gaps(middle, (k + 0.5) * duration, pairs)
    at_end = _gaps(end[POSE], (k + 1.0) * duration, pairs)

    of_end = y_both[POSE, :]
    of_middle = y_both[N_STATES:-N_SLIPS, :]
    gaps = ca.vec(ca.vertcat(at_middle.value, at_end.value))
    by_pair = [
        ca.vertcat(at_middle.gradient[:, i].T @ of_middle, at_end.gradient[:, i].T @ of_end) for i in range(n_pairs)
    ]
    c = ca.vertcat(end, gaps, slips)
    c_both = ca.vertcat(y_both[:N_STATES, :], *by_pair, y_both[-N_SLIPS:, :])

    multipliers = ca.MX.sym("lambda", c.numel())
    on_gaps = ca.reshape(multipliers[N_STATES:-N_SLIPS], 2, n_pairs)
    on_end = multipliers[:N_STATES] + _placed(at_end.gradient @ on_gaps[1, :].T)
    on_y = ca.vertcat(on_end, at_middle.gradient @ on_gaps[0, :].T, multipliers[-N_SLIPS:])
    bent = hessian(x, u, own, on_y)
    bent += of_middle.T @ ca.reshape(at_middle.hessian @ on_gaps[0, :].T, 3, 3) @ of_middle
    bent += of_end.T @ ca.reshape(at_end.hessian @ on_gaps[1, :].T, 3, 3) @ of_end
    return Stage(
        ca.Function("stage", arguments, [c]),
        ca.Function("stage_jacobian", arguments, [c, c_both]),
        ca.Function("stage_hessian", [*arguments, multipliers], [bent, y_both.T @ on_y]),
    )


def _motion() -> tuple[ca.Function, ca.Function]:
    """(x, u, own data) -> y = [x_k+1; pose half way; slip angles] and dy/d[x; u]; and the Hessian of lambda' y."""
    x, u, loads, p = symbols()
    duration = ca.SX.sym("Ts")
    inputs = [u[i] * INPUT_SCALE[i] for i in range(N_INPUTS)]
    wheel_loads = [loads[i] for i in range(N_WHEELS)]

    def derivative(state: ca.SX) -> Any:
        return ca.vertcat(*two_track(state, inputs, wheel_loads, p).derivative)

    middle = rk4(derivative, x, duration / 2)
    end = rk4(derivative, middle, duration / 2)
    slips = (axle_slip_angle(x, p.lf, inputs[0], p), axle_slip_angle(end, -p.lr, 0.0, p))
    y, both, arguments = (
        ca.vertcat(end, middle[POSE], *slips),
        ca.vertcat(x, u),
        [x, u, ca.vertcat(loads, *p, duration)],
    )
    multipliers = ca.SX.sym("lambda", y.numel())
    return (
        ca.Function("motion_jacobian", arguments, [y, ca.densify(ca.jacobian(y, both))]),
        ca.Function(
            "motion_hessian", [*arguments, multipliers], [ca.densify(ca.hessian(ca.dot(multipliers, y), both)[0])]
        ),
    )


class Gaps(NamedTuple):
    """The gaps of n pairs at one pose.

    Attributes:
        value: (1, n) [m].
        gradient: (3, n) by the pose.
        hessian: (9, n) second derivatives by the pose, column after column.
    """

    value: Any
    gradient: Any
    hessian: Any


def _gaps(pose: ca.MX, time: ca.MX, pairs: ca.MX) -> Gaps:
    """All gaps at a pose X, Y, psi, `time` [s] after the ellipses were where they are now."""
    n = pairs.size2()
    if n == 0:
        return Gaps(ca.MX(1, 0), ca.MX(3, 0), ca.MX(9, 0))
    one = [ca.SX.sym("pose", 3), ca.SX.sym("time"), ca.SX.sym("pair", N_PAIR)]
    gap = _gap(*one)
    hessian, gradient = ca.hessian(gap, one[0])
    function = ca.Function("gap", one, [gap, ca.densify(gradient), ca.vec(ca.densify(hessian))])
    return Gaps(*function.map(n)(ca.repmat(pose, 1, n), ca.repmat(time, 1, n), pairs))


def _placed(of_pose: ca.MX) -> ca.MX:
    """A derivative by the pose (3,) as one by the state (6,)."""
    place = ca.DM(N_STATES, 3)
    for column, row in enumerate(POSE):
        place[row, column] = 1
    return place @ of_pose


def _gap(pose: ca.SX, time: ca.SX, pair: ca.SX) -> Any:
    """The gap [m] of a pair at a pose, `time` [s] after its ellipse was where it is now."""
    offset, centre, velocity, semi_axes, heading = pair[:2], pair[2:4], pair[4:6], pair[6:8], pair[8]
    point = pose[:2] + _turned(offset, pose[2])
    in_axes = _turned(point - centre - time * velocity, -heading)
    return (ca.sumsqr(in_axes / semi_axes) - 1) * ca.fmin(semi_axes[0], semi_axes[1]) / 2


def _turned(vector: ca.SX, angle: ca.SX) -> Any:
    """A vector turned anticlockwise by an angle [rad]."""
    cos, sin = ca.cos(angle), ca.sin(angle)
    return ca.vertcat(cos * vector[0] - sin * vector[1], sin * vector[0] + cos * vector[1])
