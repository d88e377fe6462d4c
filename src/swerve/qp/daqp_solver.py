"""DAQP: a dual active-set method (Arnstroem, Bemporad and Axehill, IEEE TAC 67, 2022), exact up to rounding.

It counts an infinite bound as 1e30 and takes the active set of a warm start from the signs of its multipliers. Its
method works on G H^-1 G': with H singular there is none, and with H nearly so, rows look parallel that are not, and a
problem infeasible that is not. Both cases go through DAQP's slower proximal iteration, which adds to H and takes away.
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
PROXIMAL: Final = {"eps_prox": 1e-3, "eta_prox": 1e-9}  # what each pass adds to H; stationarity to reach

INFEASIBLE: Final = -1
NOT_POSITIVE_DEFINITE: Final = -5
STATUS: Final = {
    1: (Status.SOLVED, ""),
    INFEASIBLE: (Status.INFEASIBLE, ""),
    -2: (Status.FAILED, "the active set cycles"),
    -3: (Status.FAILED, "the cost is unbounded below"),
    -4: (Status.ITERATION_LIMIT, ""),
    NOT_POSITIVE_DEFINITE: (Status.FAILED, "the Hessian is not positive semidefinite"),
    -6: (Status.INFEASIBLE, ""),  # the equalities contradict each other
}


def solve_daqp(problem: Problem, warm_start: WarmStart | None, iteration_limit: int) -> Solution:
    """Solve the equilibrated `problem`, beginning with the active set of `warm_start`."""
    terms = (  # DAQP reads on from the first element of each array: they must be contiguous
        np.ascontiguousarray(problem.hessian, np.float64),
        np.ascontiguousarray(problem.gradient, np.float64),
        np.ascontiguousarray(problem.rows, np.float64),
        np.minimum(np.concatenate((problem.upper, problem.row_upper), dtype=np.float64), INFINITY),
        np.maximum(np.concatenate((problem.lower, problem.row_lower), dtype=np.float64), -INFINITY),
    )
    settings = {
        "primal_tol": PRIMAL_TOLERANCE,
        "iter_limit": iteration_limit + 1,  # DAQP stops one short of its limit
        "dual_start": None if warm_start is None else warm_start.multipliers,
        "eq_reduction": daqp.EQ_REDUCTION_OFF,  # in 0.11 it overlooks crossed limits
    }
    x, _, flag, info = daqp.solve(*terms, **settings, **STRICTLY_CONVEX)
    if flag == INFEASIBLE or (flag == NOT_POSITIVE_DEFINITE and is_convex(problem.hessian)):
        x, _, flag, info = daqp.solve(*terms, **settings, **PROXIMAL)

    iterations = min(info["iterations"], iteration_limit)
    status, reason = STATUS.get(flag, (Status.FAILED, f"exit flag {flag}"))
    if status is not Status.SOLVED:
        return Solution.without_answer(problem, status, iterations, "daqp", reason)
    n = problem.gradient.size
    return Solution(problem, x, info["lam"][:n], info["lam"][n:], status, iterations, "daqp")
