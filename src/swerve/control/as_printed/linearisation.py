"""Sec. 4.2: the Jacobians A_k, B_k of eq. (8) as printed, term by term, and the full ones.

The printed ones freeze the lateral tyre force against state and steering angle. MISPRINT 2: with Fx = 0, running
straight, the steering column of B_k is zero, since dFy/dalpha dalpha/d(vx, vy, r, delta) is missing from A_k and B_k.
MISPRINT 3: b11 and b21 lack 1/m, b31 lacks 1/Izz.
"""

import casadi as ca

from swerve.vehicle.two_track import Motion, Parameters, symbols, two_track
from swerve.vehicle.tyre import magic_formula


def kernel_function(*, full: bool, with_mass: bool) -> ca.Function:
    """(xi, u, Fz, p) -> f (6,), A (6, 6), B (6, 5).

    Args:
        full: Jacobians by automatic differentiation ("jacobian"), else the printed ones.
        with_mass: 1/m and 1/Izz in the printed steering column ("mass"); the full Jacobian has them anyway.
    """
    xi, u, loads, p = symbols()
    fz = [loads[i] for i in range(4)]
    motion = two_track(xi, u, fz, p)
    f = ca.vertcat(*motion.derivative)
    if full:
        A, B = ca.jacobian(f, xi), ca.jacobian(f, u)
    else:
        A, B = _printed_state_jacobian(xi), _printed_input_jacobian(u, fz, p, motion, with_mass=with_mass)
    return ca.Function("as_printed", [xi, u, loads, ca.vertcat(*p)], [f, ca.densify(A), ca.densify(B)])


def _printed_state_jacobian(xi: ca.SX) -> ca.SX:
    """A_k of (8)."""
    vx, vy, r, psi = xi[0], xi[1], xi[2], xi[3]
    cos, sin = ca.cos(psi), ca.sin(psi)
    return ca.vertcat(
        ca.horzcat(0, r, vy, 0, 0, 0),
        ca.horzcat(-r, 0, -vx, 0, 0, 0),
        ca.SX.zeros(1, 6),
        ca.horzcat(0, 0, 1, 0, 0, 0),
        ca.horzcat(cos, -sin, 0, -vx * sin - vy * cos, 0, 0),
        ca.horzcat(sin, cos, 0, vx * cos - vy * sin, 0, 0),
    )


def _printed_input_jacobian(u: ca.SX, fz: list[ca.SX], p: Parameters, motion: Motion, *, with_mass: bool) -> ca.SX:
    """B_k of (8), b11 to b35."""
    cos, sin = ca.cos(u[0]), ca.sin(u[0])
    fx_fl, fx_fr = u[1], u[2]
    fy_fl, fy_fr, _, _ = motion.lateral
    # M(alpha) Fx / sqrt((mu Fz)^2 - Fx^2) = -dFy/dFx of eq. (4)
    loss = [
        magic_formula(p, motion.slip_angles[i], fz[i]) * u[1 + i] / ca.sqrt((p.mu * fz[i]) ** 2 - u[1 + i] ** 2)
        for i in range(4)
    ]
    per_m, per_izz = (1 / p.m, 1 / p.Izz) if with_mass else (1.0, 1.0)  # MISPRINT 3
    b11 = (-fx_fl * sin - fy_fl * cos - fx_fr * sin - fy_fr * cos) * per_m
    b21 = (fx_fl * cos - fy_fl * sin + fx_fr * cos - fy_fr * sin) * per_m
    b31 = (
        (fx_fl * sin + fy_fl * cos - fx_fr * sin - fy_fr * cos) * p.lt
        + (fx_fl * cos - fy_fl * sin + fx_fr * cos - fy_fr * sin) * p.lf
    ) * per_izz
    row1 = [b11, *((cos + loss[i] * sin) / p.m for i in (0, 1)), 1 / p.m, 1 / p.m]
    row2 = [b21, *((sin - loss[i] * cos) / p.m for i in (0, 1)), -loss[2] / p.m, -loss[3] / p.m]
    row3 = [
        b31,
        (p.lf * sin - p.lf * loss[0] * cos - p.lt * cos - p.lt * loss[0] * sin) / p.Izz,
        (p.lf * sin - p.lf * loss[1] * cos + p.lt * cos + p.lt * loss[1] * sin) / p.Izz,
        (-p.lt + p.lr * loss[2]) / p.Izz,
        (p.lt + p.lr * loss[3]) / p.Izz,
    ]
    return ca.vertcat(ca.horzcat(*row1), ca.horzcat(*row2), ca.horzcat(*row3), ca.SX.zeros(3, 5))
