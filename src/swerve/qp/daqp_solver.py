"""DAQP: a dual active-set method (Arnstroem, Bemporad and Axehill, IEEE TAC 67, 2022), exact up to rounding.

It counts an infinite limit as 1e30 and takes the active set of a warm start from the signs of its multipliers. The
method needs an invertible H; with one that nearly is not, rows look parallel that are not, and it may cycle or take the
problem for infeasible. What fails so is tried once more by its proximal iteration, slower and with a well-conditioned
H: each pass adds to H what costs nothing near the pass before.
"""

from typing import Final

import daqp
import numpy as np

from swerve.qp.convexity import is_convex
from swerve.qp.problem import Problem
from swerve.qp.solution import Solution, Status, WarmStart

INFINITY: Final = 1e30
PRIMAL_TOLERANCE: Final = 1e-8  # [unit of the row or bound]
STRICTLY_CONVEX: Final = {"eps_prox": 0.0}
PROXIMAL: Final = {"eps_prox": 1e-2, "eta_prox": 1e-9}  # what a pass adds to the diagonal of H; stationarity to reach

SOLVED: Final = 1
ITERATION_LIMIT: Final = -4
NOT_POSITIVE_DEFINITE: Final = -5
STATUS: Final = {
    SOLVED: (Status.SOLVED, ""),
    -1: (Status.INFEASIBLE, ""),
    -2: (Status.FAILED, "the active set cycles"),
    -3: (Status.FAILED, "the cost is unbounded below"),
    ITERATION_LIMIT: (Status.ITERATION_LIMIT, ""),
    NOT_POSITIVE_DEFINITE: (Status.FAILED, "the Hessian is not positive semidefinite"),
    -6: (Status.INFEASIBLE, ""),  # the equalities contradict each other
}


def solve_daqp(problem: Problem, warm_start: WarmStart | None, iteration_limit: int) -> Solution:
    """Solve the equilibrated `problem`, beginning with the active set of `warm_start`."""
    terms = (  # DAQP reads on from the first element of each array: they must be contiguous
        np.ascontiguousarray(problem.hessian),
        np.ascontiguousarray(problem.gradient),
        np.ascontiguousarray(problem.rows),
        np.minimum(np.concatenate((problem.upper, problem.row_upper)), INFINITY),
        np.maximum(np.concatenate((problem.lower, problem.row_lower)), -INFINITY),
    )
    settings = {
        "primal_tol": PRIMAL_TOLERANCE,
        "iter_limit": iteration_limit + 1,  # DAQP stops one short of its limit
        "dual_start": None if warm_start is None else warm_start.multipliers,
        "eq_reduction": daqp.EQ_REDUCTION_OFF,  # in 0.11 it overlooks crossed limits
    }
    x, _, flag, info = daqp.solve(*terms, **settings, **STRICTLY_CONVEX)
    if flag not in (SOLVED, ITERATION_LIMIT) and is_convex(problem.hessian):
        again = daqp.solve(*terms, **settings, **PROXIMAL)
        if flag == NOT_POSITIVE_DEFINITE or again[2] == SOLVED:
            x, _, flag, info = again

    iterations = min(info["iterations"], iteration_limit)
    status, reason = STATUS.get(flag, (Status.FAILED, f"exit flag {flag}"))
    if status is not Status.SOLVED:
        return Solution.without_answer(problem, status, iterations, "daqp", reason)
    n = problem.gradient.size
    return Solution(problem, x, info["lam"][:n], info["lam"][n:], status, iterations, "daqp")
