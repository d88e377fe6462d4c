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
term the solver wanders among them. See `solve` for what becomes of it.
"""

from dataclasses import dataclass
from functools import cache, reduce
from operator import add
from typing import Any, Final

import casadi as ca
import numpy as np

from swerve.conventions import DELTA, VX, VY, X
from swerve.study.limit.blocks import Block
from swerve.study.limit.dynamics import N_NUMBERS
from swerve.study.limit.intervals import blocks_of
from swerve.study.limit.layout import DISTANCE_SCALE, STATE_SCALE, Given, Layout, Structure, given

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
    """The program of a structure, ready to be solved with any numbers.

    Attributes:
        layout: of the variables.
        rows: slice of each group of rows, by the name of what it asks.
        solver: IPOPT.
    """

    layout: Layout
    rows: dict[str, slice]
    solver: ca.Function


@cache
def program(structure: Structure) -> Program:
    """Build the program, once in a process."""
    p, layout = given(structure, N_NUMBERS), Layout.of(structure)
    x = ca.MX.sym("x", layout.n)
    blocks, linear = blocks_of(structure, layout, x, p), _linear(structure, layout, x, p)
    nexts = ca.vec(_picked(x, layout.states))
    groups = {name: ca.vertcat(*(each.rows for each in group)) for name, group in blocks.items()} | linear
    groups["dynamics"] -= nexts
    slopes = {name: ca.vertcat(*(each.jacobian for each in group)) for name, group in blocks.items()}
    slopes["dynamics"] -= ca.jacobian(nexts, x)
    rows, cost, point = ca.vertcat(*groups.values()), _cost(layout, x, p), {"x": x, "p": p.vector()}
    jacobian = ca.vertcat(*slopes.values(), ca.jacobian(ca.vertcat(*linear.values()), x))
    weighted = {"lam_f": ca.MX.sym("lam_f"), "lam_g": ca.MX.sym("lam_g", rows.numel())}
    hessian = weighted["lam_f"] * ca.triu(ca.hessian(cost, x)[0]) + _curvature(blocks, weighted["lam_g"])
    options: dict[str, Any] = {
        "print_time": False,
        "calc_lam_p": False,
        "no_nlp_grad": True,  # of no use to IPOPT, and compiled functions would have to be differentiated for it
        "ipopt": SOLVER,
        "grad_f": _function("nlp_grad_f", point, {"f": cost, "grad_f_x": ca.gradient(cost, x)}),
        "jac_g": _function("nlp_jac_g", point, {"g": rows, "jac_g_x": jacobian}),
        "hess_lag": _function("nlp_hess_l", point | weighted, {"triu_hess_gamma_x_x": hessian}),
    }
    solver = ca.nlpsol("limit", "ipopt", point | {"f": cost, "g": rows}, options)
    ends = np.cumsum([0, *(each.numel() for each in groups.values())])
    return Program(layout, {name: slice(int(ends[i]), int(ends[i + 1])) for i, name in enumerate(groups)}, solver)


def _curvature(blocks: dict[str, list[Block]], weights: ca.MX) -> ca.MX:
    """The rows' part of the Hessian, its upper triangle; blocks come first among the rows."""
    stacked = [block for group in blocks.values() for block in group]
    ends = np.cumsum([0, *(block.n_rows for block in stacked)]).tolist()
    parts = (block.hessian(weights[ends[i] : ends[i + 1]]) for i, block in enumerate(stacked))
    return reduce(add, parts)


def _function(name: str, inputs: dict[str, ca.MX], outputs: dict[str, ca.MX]) -> ca.Function:
    return ca.Function(name, list(inputs.values()), list(outputs.values()), list(inputs), list(outputs))


def _picked(x: ca.MX, where: Any) -> ca.MX:
    """Variables (n, m) at indices (m, n)."""
    return ca.reshape(x[np.ravel(where).tolist()], *np.shape(where)[::-1])


def _linear(structure: Structure, layout: Layout, x: ca.MX, p: Given) -> dict[str, ca.MX]:
    """The rows of which every interval has one or two, or only the last."""
    states = ca.diag(STATE_SCALE) @ _picked(x, layout.states)
    inputs = ca.diag(1 / structure.input_scale) @ _picked(x, layout.inputs)
    steering = (ca.DM(structure.means.directions) @ inputs)[DELTA, :]
    shift = DISTANCE_SCALE * x[int(layout.globals[0])]
    end = states[:, -1]
    return {
        "in hand": ca.vec(ca.vertcat(states[VX, :] + states[VY, :], states[VX, :] - states[VY, :])),
        "rate": ca.diff(ca.horzcat(0, steering).T),
        "end": ca.vertcat(*(CREEP + END_SIDESLIP * end[VX] + sign * end[VY] for sign in (1, -1))),
        "past": ca.vertcat(*(end[X] - shift - p[f"poses{i}"][0, -1] for i in range(len(structure.ellipses)))),
    }


def _cost(layout: Layout, x: ca.MX, p: Given) -> ca.MX:
    """What is minimised, and how far inputs and lines are from the guess's."""
    distance, mu, slack = (x[int(i)] for i in layout.globals)
    far = p["step"] * ca.sumsqr(_picked(x, layout.inputs) - p["inputs"])
    for i, each in enumerate(layout.lines):
        far += LINE_WEIGHT * ca.sumsqr(_picked(x, each) - p[f"lines{i}"])
    cost: ca.MX = ca.dot(p["cost"], ca.vertcat(DISTANCE_SCALE * distance, mu, slack)) + p["proximity"] * far
    return cost
