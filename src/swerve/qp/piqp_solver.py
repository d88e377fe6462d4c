"""PIQP: a proximal interior-point method (Schwan, Jiang, Kuhn and Jones, CDC 2023), dense.

It takes equalities apart from inequalities, counts a limit of 1e30 as infinite and writes to standard error about a
row without any, so such rows are left out. It does not look whether H is positive semidefinite; that is checked here.
"""

from typing import Final

import numpy as np
import piqp

from swerve.qp.convexity import is_convex
from swerve.qp.problem import Problem
from swerve.qp.solution import Solution, Status, WarmStart

INFINITY: Final = 1e30
ABSOLUTE: Final = 1e-10  # residual and duality gap to reach; x is off by about the root of the gap
RELATIVE: Final = 1e-11  # the same, of the largest term
CERTIFICATE: Final = 1e-8  # of no solution; at its own 1e-4 it also finds some for problems that have one

STATUS: Final = {
    piqp.PIQP_SOLVED: (Status.SOLVED, ""),
    piqp.PIQP_MAX_ITER_REACHED: (Status.ITERATION_LIMIT, ""),
    piqp.PIQP_PRIMAL_INFEASIBLE: (Status.INFEASIBLE, ""),
    piqp.PIQP_DUAL_INFEASIBLE: (Status.FAILED, "the cost is unbounded below"),
    piqp.PIQP_NUMERICS: (Status.FAILED, "the factorisation broke down"),
}


def solve_piqp(problem: Problem, warm_start: WarmStart | None, iteration_limit: int) -> Solution:
    """Solve the equilibrated `problem`; an interior-point method has no use for the hint `warm_start`."""
    if not is_convex(problem.hessian):
        reason = "the Hessian is not positive semidefinite"
        return Solution.without_answer(problem, Status.FAILED, 0, "piqp", reason)

    equal = problem.row_lower == problem.row_upper
    limited = ~equal & ((problem.row_lower > -INFINITY) | (problem.row_upper < INFINITY))
    solver = piqp.DenseSolver()
    solver.settings.max_iter = iteration_limit + 1  # PIQP stops one short of its limit
    solver.settings.eps_abs = solver.settings.eps_duality_gap_abs = ABSOLUTE
    solver.settings.eps_primal_inf = solver.settings.eps_dual_inf = CERTIFICATE
    solver.settings.eps_rel = solver.settings.eps_duality_gap_rel = RELATIVE
    solver.setup(
        problem.hessian,
        problem.gradient,
        problem.rows[equal],
        problem.row_upper[equal],
        problem.rows[limited],
        problem.row_lower[limited],
        problem.row_upper[limited],
        problem.lower,
        problem.upper,
    )
    flag = solver.solve()
    result = solver.result
    iterations = min(result.info.iter, iteration_limit)
    status, reason = STATUS.get(flag, (Status.FAILED, str(flag)))
    if status is not Status.SOLVED:
        return Solution.without_answer(problem, status, iterations, "piqp", reason)
    row_multipliers = np.zeros(problem.row_lower.size)
    row_multipliers[equal] = result.y
    row_multipliers[limited] = result.z_u - result.z_l
    bound_multipliers = result.z_bu - result.z_bl
    return Solution(problem, result.x.copy(), bound_multipliers, row_multipliers, status, iterations, "piqp")
