"""What every QP solver must do with a problem that has no minimiser, or is none."""

from dataclasses import fields, replace

import numpy as np
import pytest

from swerve.errors import InputError
from swerve.qp import SOLVERS, Problem, Status, WarmStart, solve
from tests.qp.problems import boxed, feasible, predictive

BOX = boxed(np.eye(3), np.array([3.0, -2.0, 1.0]), -1.0, 1.0)
solvers = pytest.mark.parametrize("solver", SOLVERS)

INFEASIBLE = {
    "crossed bounds": replace(BOX, lower=np.ones(3), upper=-np.ones(3)),
    "crossed row": replace(BOX, rows=np.ones((1, 3)), row_lower=np.array([1.0]), row_upper=np.array([0.0])),
    "crossed rows without bounds": replace(
        boxed(np.eye(3), np.ones(3)), rows=np.eye(3), row_lower=np.ones(3), row_upper=-np.ones(3)
    ),
    "row out of the box": replace(BOX, rows=np.ones((1, 3)), row_lower=np.array([4.0]), row_upper=np.array([np.inf])),
    "two equalities": replace(BOX, rows=np.ones((2, 3)), row_lower=np.array([0, 1.0]), row_upper=np.array([0, 1.0])),
    "row of zeros": replace(BOX, rows=np.zeros((1, 3)), row_lower=np.array([1.0]), row_upper=np.array([2.0])),
    "predictive": replace(
        predictive(seed=5, steps=1)[0], upper=np.r_[np.ones(75), 0, 0], row_upper=np.full(140, -100.0)
    ),
}


@solvers
@pytest.mark.parametrize("problem", INFEASIBLE.values(), ids=INFEASIBLE)
def test_says_that_no_point_meets_the_constraints(solver: str, problem: Problem) -> None:
    """An infeasible problem is told from a failure, and nobody can take its x for an answer."""
    solution = solve(problem, solver)
    assert solution.status is Status.INFEASIBLE
    assert np.isnan(solution.x).all()
    assert not solution.is_optimal(1e6)
    assert solution.warm_start is None


@solvers
@pytest.mark.parametrize("name", [field.name for field in fields(Problem)])
def test_a_nan_anywhere_fails(solver: str, name: str) -> None:
    """Whatever array it stands in, at either end, a nan is noticed before a solver could pass over it."""
    problem = feasible(np.random.default_rng(0), 4, 3)
    for index in (0, -1):
        spoiled = getattr(problem, name).copy()
        spoiled.flat[index] = np.nan
        solution = solve(replace(problem, **{name: spoiled}), solver)
        assert solution.status is Status.FAILED
        assert "nan" in solution.reason
        with pytest.raises(ValueError, match="nan"):
            replace(problem, **{name: spoiled}).check()


@solvers
@pytest.mark.parametrize(
    ("name", "value"),
    [("hessian", np.inf), ("gradient", -np.inf), ("rows", np.inf), ("lower", np.inf), ("row_upper", -np.inf)],
)
def test_an_infinite_number_that_is_no_limit_fails(solver: str, name: str, value: float) -> None:
    """Infinity means no limit on the side where it lies, and nothing anywhere else."""
    problem = feasible(np.random.default_rng(0), 4, 3)
    spoiled = getattr(problem, name).copy()
    spoiled.flat[0] = value
    assert solve(replace(problem, **{name: spoiled}), solver).status is Status.FAILED


@solvers
@pytest.mark.parametrize("curvature", [-1e3, -1.0, -1e-3, -1e-6])
def test_a_cost_that_is_not_convex_fails(solver: str, curvature: float) -> None:
    """A point where a saddle is stationary is not taken for a minimiser, however slight the saddle."""
    turned, _ = np.linalg.qr(np.random.default_rng(0).normal(size=(3, 3)))
    hessian = turned @ np.diag([1.0, 0.5, curvature]) @ turned.T
    solution = solve(replace(BOX, hessian=(hessian + hessian.T) / 2), solver)
    assert solution.status is Status.FAILED
    assert "semidefinite" in solution.reason


@solvers
def test_a_cost_without_minimum_fails(solver: str) -> None:
    """A direction of no curvature that the gradient goes down and no limit ends has no minimiser."""
    solution = solve(boxed(np.diag([1.0, 0.0]), np.array([0.0, -1.0]), lower=-1.0), solver)
    assert solution.status is Status.FAILED
    assert "unbounded" in solution.reason


@solvers
def test_numbers_out_of_range_fail_quietly(solver: str) -> None:
    """Arithmetic that overflows ends in a status, not in a warning or an exception."""
    for hessian, gradient in ((1e-310, 1.0), (1e308, 1e308), (1.0, 1e308)):
        solution = solve(replace(BOX, hessian=hessian * np.eye(3), gradient=np.full(3, gradient)), solver)
        assert isinstance(solution.status, Status)
        assert solution.is_solved == np.isfinite(solution.x).all()


@solvers
@pytest.mark.parametrize("limit", [1, 2, 5])
def test_stops_at_the_iteration_limit(solver: str, limit: int) -> None:
    """A limit that is too low gives its own status after that many iterations."""
    solution = solve(predictive(seed=0, steps=1)[0], solver, iteration_limit=limit)
    assert solution.status is Status.ITERATION_LIMIT
    assert solution.iterations == limit


@solvers
def test_an_answer_that_breaks_a_row_is_not_believed(solver: str) -> None:
    """A row so small that a solver may pass over it is either met or the status says FAILED."""
    rows = np.array([[3e-6, 0.0, 0.0]])
    problem = replace(boxed(np.eye(3), np.full(3, -1e3)), rows=rows, row_lower=-np.ones(1), row_upper=np.zeros(1))
    solution = solve(problem, solver)
    assert solution.is_optimal(1e-6) or (solution.status is Status.FAILED and "violates" in solution.reason)


@solvers
def test_misuse_is_an_exception(solver: str) -> None:
    """Shapes that do not fit never reach a solver's C code, and a limit below one is refused."""
    with pytest.raises(ValueError, match=r"do not fit together.*rows \(1, 2\)"):
        solve(replace(BOX, rows=np.ones((1, 2)), row_lower=np.zeros(1), row_upper=np.ones(1)), solver)
    with pytest.raises(ValueError, match="n = 0 > 0"):
        solve(boxed(np.zeros((0, 0)), np.zeros(0)), solver)
    with pytest.raises(ValueError, match="warm start"):
        solve(BOX, solver, WarmStart(np.zeros(2), np.zeros(1)))
    with pytest.raises(ValueError, match="iteration_limit"):
        solve(BOX, solver, iteration_limit=0)


def test_an_unknown_solver_is_named_with_the_nearest_one() -> None:
    """A misspelt name is wrong input, answered with the right one."""
    with pytest.raises(InputError, match="did you mean daqp"):
        solve(BOX, "dapq")


def test_every_status_is_a_sentence() -> None:
    """A status can be printed for a reader as it is."""
    assert all(status.sentence.endswith(".") and status.sentence[0].isupper() for status in Status)
