"""One door to all solvers: it refuses numbers that are none, hides the units, and believes no infeasible answer."""

from collections.abc import Callable
from typing import Final

import numpy as np

from swerve.errors import InputError, unknown
from swerve.qp.daqp_solver import solve_daqp
from swerve.qp.equilibration import Equilibration
from swerve.qp.piqp_solver import solve_piqp
from swerve.qp.problem import Problem
from swerve.qp.solution import Solution, Status, WarmStart

Solver = Callable[[Problem, WarmStart | None, int], Solution]

SOLVERS: Final[dict[str, Solver]] = {"daqp": solve_daqp, "piqp": solve_piqp}
ITERATION_LIMIT: Final = 1000
FEASIBILITY: Final = 1e-6  # [1 + max |x|] violation up to which an answer counts as feasible


def solve(
    problem: Problem,
    solver: str = "daqp",
    warm_start: WarmStart | None = None,
    iteration_limit: int = ITERATION_LIMIT,
) -> Solution:
    """Solve `problem`; whatever its numbers are, the answer is a Solution whose status says what happened.

    Args:
        problem: what to solve.
        solver: a name in `SOLVERS`.
        warm_start: multipliers of a similar problem, as `Solution.warm_start` gives them.
        iteration_limit: iterations after which the status is ITERATION_LIMIT, at least 1.

    Raises:
        InputError: there is no such solver.
        ValueError: shapes do not fit, or the iteration limit is less than 1.
    """
    if solver not in SOLVERS:
        raise InputError(unknown("solver", solver, SOLVERS))
    if iteration_limit < 1:
        raise ValueError(f"iteration_limit must be at least 1, got {iteration_limit}")
    problem.check_shapes()
    if warm_start is not None:
        warm_start.check_shapes(problem)
    with np.errstate(all="ignore"):  # numbers that overflow end as nan or infinite, and those end as FAILED
        scales = Equilibration.of(problem)
        scaled = scales.scaled(problem)
        if not scaled.is_finite:
            return Solution.without_answer(problem, Status.FAILED, 0, solver, "a number in it is nan or infinite")
        return _doubted(scales.unscaled(SOLVERS[solver](scaled, warm_start, iteration_limit), problem))


def _doubted(solution: Solution) -> Solution:
    """Return the solution itself, unless it is said to be solved and violates a constraint: then its failure."""
    if not solution.is_solved:
        return solution
    violation = solution.primal_residual
    if violation <= FEASIBILITY * (1.0 + float(np.abs(solution.x).max())):
        return solution
    reason = f"the answer violates a constraint by {violation:.3g}; choose units that make rows of the order of one"
    return Solution.without_answer(solution.problem, Status.FAILED, solution.iterations, solution.solver, reason)
