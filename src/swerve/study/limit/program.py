"""The optimal control problem as a nonlinear program, by direct multiple shooting.

minimise    c . (D, mu, s) + p (sum h |v_k - v'_k|^2 + 0.3 sum |line - line'|^2)
over        states x_k+1, inputs v_k (w_k = E v_k) and a line for each obstacle in each of N intervals; D, mu, s
subject to  x_k+1 = F(x_k, w_k, mu),  two Runge-Kutta steps of eq. (1) with static loads                         (1)
            the lines part the vehicle at both ends of the interval from the obstacles, shifted to D, to within s
            lower <= v_k <= upper;  |delta_k+1 - delta_k| <= rate h
            every vertex of the footprint between the road's edges, |vy| <= vx: in hand
            at the end |vy| <= 0.05 vx, |r| <= 0.1 rad/s, and past the obstacles, or behind and no faster

One of D, mu and s is free and minimised: the distance, the friction, or the violation at a distance that is given. The
primes are those of the guess, and p is how much it costs to leave it: many controls do equally well, and without that
term the solver wanders among them. See `descent` for what becomes of it.
"""

from dataclasses import dataclass
from functools import cache
from typing import Any, Final

import casadi as ca

from swerve.conventions import N_STATES, PSI, VX, VY, X, Y
from swerve.study.limit.dynamics import dynamics
from swerve.study.limit.grid import N_INTERVALS
from swerve.study.limit.layout import DISTANCE_SCALE, LOCK_SCALE, STATE_SCALE, Given, Layout, Structure, given, layout
from swerve.study.limit.separation import rows as separation_rows
from swerve.study.limit.separation import turned

LINE_WEIGHT: Final = 0.3  # [m] and [m / m^2], times p
END_SIDESLIP: Final = 0.05  # [rad]
END_YAW_RATE: Final = 0.1  # [rad/s]
CREEP: Final = 0.05  # [m/s] what counts as no faster
SOLVER: Final = {
    "print_level": 0,
    "sb": "yes",
    "max_iter": 120,
    "tol": 1e-6,
    "constr_viol_tol": 1e-6,
    "acceptable_tol": 1e-2,  # of the multipliers, which many equal controls leave loose; the rows are kept as tightly
    "acceptable_constr_viol_tol": 1e-6,
    "acceptable_obj_change_tol": 1e-6,
    "acceptable_iter": 4,
    "bound_push": 1e-3,  # the guess can be driven: it is left where it is
    "bound_frac": 1e-3,
    "mu_init": 1e-3,
}


@dataclass(frozen=True, eq=False)
class Program:
    """The program of a structure, ready to be solved with any numbers."""

    layout: Layout
    solver: ca.Function


@cache
def program(structure: Structure) -> Program:
    """Build the program, once in a process."""
    x, v, lines, (distance, mu, slack) = _variables(structure)
    p = given(structure)
    states = ca.horzcat(p["start"], ca.diag(STATE_SCALE) @ x)
    shares = ca.DM(structure.means.directions) @ v
    shares[0, :] /= LOCK_SCALE
    shift = DISTANCE_SCALE * distance
    step, clock = dynamics(structure.vehicle), (p["step"], p["slip_speed_floor"])
    ends = [step(states[:, k], shares[:, k], mu, *clock) for k in _intervals()]
    groups = {
        "dynamics": [(states[:, k + 1] - ends[k]) / STATE_SCALE for k in _intervals()],
        "separation": _separation(structure, states, lines, shift, slack, p),
        "in hand": [states[VX, k] + sign * states[VY, k] for k in _intervals(1) for sign in (1, -1)],
        "edges": [_vertex(states[:, k], p["vertices"][:, i])[1] for k in _intervals(1) for i in _vertices(structure)],
        "rate": [ca.diff(ca.horzcat(0, shares[0, :]).T)],
        "end": [CREEP + END_SIDESLIP * states[VX, -1] + sign * states[VY, -1] for sign in (1, -1)],
        "past": [states[X, -1] - shift - p[f"poses{i}"][0, -1] for i in range(len(structure.ellipses))],
    }
    variables = ca.vertcat(ca.vec(x), ca.vec(v), *(ca.vec(each) for each in lines), distance, mu, slack)
    cost = ca.dot(p["cost"], ca.vertcat(shift, mu, slack)) + p["proximity"] * _far(v, lines, p)
    rows = {name: ca.vertcat(*group) for name, group in groups.items()}
    problem = {"x": variables, "p": p.vector(), "f": cost, "g": ca.vertcat(*rows.values())}
    options: dict[str, Any] = {"print_time": False, "calc_lam_p": False, "ipopt": SOLVER}
    solver = ca.nlpsol("limit", "ipopt", problem, options)
    return Program(layout(structure, rows), solver)


def _variables(structure: Structure) -> tuple[ca.SX, ca.SX, list[ca.SX], list[ca.SX]]:
    lines = [ca.SX.sym(f"line{i}", 2, N_INTERVALS) for i in range(len(structure.ellipses))]
    x, v = ca.SX.sym("x", N_STATES, N_INTERVALS), ca.SX.sym("v", structure.n_inputs, N_INTERVALS)
    return x, v, lines, [ca.SX.sym(name) for name in ("D", "mu", "s")]


def _far(v: ca.SX, lines: list[ca.SX], p: Given) -> ca.SX:
    """How far inputs and lines are from the guess's."""
    far: ca.SX = p["step"] * ca.sumsqr(v - p["inputs"])
    for i, each in enumerate(lines):
        far += LINE_WEIGHT * ca.sumsqr(each - p[f"lines{i}"])
    return far


def _intervals(first: int = 0) -> range:
    return range(first, N_INTERVALS + first)


def _vertices(structure: Structure) -> range:
    return range(structure.n_vertices)


def _vertex(x: ca.SX, vertex: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Where a vertex of the footprint is in the world [m]."""
    right, up = turned(vertex[0], vertex[1], x[PSI])
    return x[X] + right, x[Y] + up


def _separation(
    structure: Structure, states: ca.SX, lines: list[ca.SX], shift: ca.SX, slack: ca.SX, p: Given
) -> list[ca.SX]:
    """Rows of each obstacle in each interval, not negative [m]."""
    found: list[ca.SX] = []
    for i, is_ellipse in enumerate(structure.ellipses):
        seen = [_seen(states[:, k], p[f"poses{i}"][:, k], shift, p["vertices"]) for k in range(N_INTERVALS + 1)]
        for k in _intervals():
            found += separation_rows(is_ellipse, p[f"half{i}"], lines[i][:, k], seen[k] + seen[k + 1], slack)
    return found


def _seen(x: ca.SX, pose: ca.SX, shift: ca.SX, vertices: ca.SX) -> list[tuple[ca.SX, ca.SX]]:
    """The footprint's vertices in the frame of an obstacle with `pose`, shifted."""
    found = []
    for vertex in ca.horzsplit(vertices):
        at_x, at_y = _vertex(x, vertex)
        found.append(turned(at_x - pose[0] - shift, at_y - pose[1], -pose[2]))
    return found
