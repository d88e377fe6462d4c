"""What every QP solver must do with a problem that has a minimiser: find it, and prove it."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swerve.qp import SOLVERS, Status, solve
from tests.qp.brute_force import minimiser
from tests.qp.problems import boxed, feasible, predictive, unrelated

pytestmark = pytest.mark.parametrize("solver", SOLVERS)

seeds = st.integers(0, 2**32 - 1)
PREDICTIVE = predictive(seed=0)


@settings(max_examples=60, deadline=None)
@given(seed=seeds, n=st.integers(1, 3), m=st.integers(0, 4))
def test_agrees_with_trying_every_active_set(solver: str, seed: int, n: int, m: int) -> None:
    """It finds the minimiser that brute force finds, and says infeasible when there is none."""
    problem = unrelated(np.random.default_rng(seed), n, m)
    expected = minimiser(problem)
    solution = solve(problem, solver)
    if expected is None:
        assert solution.status is Status.INFEASIBLE
    else:
        assert solution.status is Status.SOLVED
        np.testing.assert_allclose(solution.x, expected, atol=1e-4)


@settings(max_examples=60, deadline=None)
@given(seed=seeds, n=st.integers(1, 12), m=st.integers(0, 14))
def test_proves_its_answer(solver: str, seed: int, n: int, m: int) -> None:
    """Residuals and duality gap of an answer are small, and its multipliers start the same problem again."""
    problem = feasible(np.random.default_rng(seed), n, m)
    solution = solve(problem, solver)
    assert solution.is_solved
    assert solution.is_optimal(1e-7)
    again = solve(problem, solver, solution.warm_start)
    assert again.is_optimal(1e-7)


def test_proves_its_answer_at_the_size_of_a_predictive_controller(solver: str) -> None:
    """77 variables and 140 rows are solved to the same accuracy."""
    for problem in PREDICTIVE:
        problem.check()
        solution = solve(problem, solver)
        assert solution.is_optimal(1e-8), (solution.status, solution.primal_residual, solution.dual_residual)


def test_without_limits_it_is_a_linear_system(solver: str) -> None:
    """An unconstrained problem has the solution of H x = -f and no multipliers."""
    problem = feasible(np.random.default_rng(1), 8, 0)
    problem = boxed(problem.hessian, problem.gradient)
    solution = solve(problem, solver)
    np.testing.assert_allclose(solution.x, np.linalg.solve(problem.hessian, -problem.gradient), atol=1e-7)
    assert not solution.bound_multipliers.any()


@pytest.mark.parametrize(("pull", "multiplier"), [(3.0, 2.0), (-3.0, -2.0)])
def test_a_multiplier_is_positive_at_the_upper_limit(solver: str, pull: float, multiplier: float) -> None:
    """Of 1/2 x^2 - pull x within [-1, 1] the limit takes pull - x, as a bound and as a row."""
    one, pulled = np.ones(1), np.array([-pull])
    as_bound = solve(boxed(np.eye(1), pulled, -1.0, 1.0), solver)
    as_row = solve(replace(boxed(np.eye(1), pulled), rows=np.eye(1), row_lower=-one, row_upper=one), solver)
    assert as_bound.bound_multipliers == pytest.approx([multiplier], abs=1e-6)
    assert as_row.row_multipliers == pytest.approx([multiplier], abs=1e-6)
    assert as_row.cost == pytest.approx(0.5 - 3.0, abs=1e-6)


def test_equality_rows_hold(solver: str) -> None:
    """Rows with equal limits are met exactly, with the multipliers of the linear system that they make."""
    rng = np.random.default_rng(2)
    free = feasible(rng, 7, 0)
    rows, values = rng.normal(size=(3, 7)), rng.normal(size=3)
    problem = replace(boxed(free.hessian, free.gradient), rows=rows, row_lower=values, row_upper=values)
    matrix = np.block([[problem.hessian, rows.T], [rows, np.zeros((3, 3))]])
    expected = np.linalg.solve(matrix, np.concatenate((-problem.gradient, values)))
    solution = solve(problem, solver)
    np.testing.assert_allclose(solution.x, expected[:7], atol=1e-6)
    np.testing.assert_allclose(solution.row_multipliers, expected[7:], atol=1e-6)


def test_a_variable_without_weight_is_decided_by_its_price(solver: str) -> None:
    """A slack that only has a linear price, so that H is singular, takes up what the rows demand and no more."""
    problem = PREDICTIVE[0]
    hessian, gradient = problem.hessian.copy(), problem.gradient.copy()
    hessian[-2:] = hessian[:, -2:] = 0.0
    gradient[-2:] = 1e3
    solution = solve(replace(problem, hessian=hessian, gradient=gradient), solver)
    assert solution.is_optimal(1e-7)
    assert solution.x[-2:].max() > 0.01


def test_a_nearly_singular_problem_is_not_called_infeasible(solver: str) -> None:
    """A Hessian of condition 1e10, or of rank one, changes nothing in whether the limits can be met."""
    rng = np.random.default_rng(3)
    for _ in range(100):
        problem = feasible(rng, 3, 9)
        direction = rng.normal(size=3)
        turned, _ = np.linalg.qr(rng.normal(size=(3, 3)))
        ill = turned @ np.diag([1.0, 1e-4, 1e-10]) @ turned.T
        for hessian in (np.outer(direction, direction), (ill + ill.T) / 2):
            box = {"lower": np.maximum(problem.lower, -9.0), "upper": np.minimum(problem.upper, 9.0)}
            solution = solve(replace(problem, hessian=hessian, **box), solver)
            assert solution.is_solved, (solution.status, solution.reason)


def test_a_fixed_variable_is_not_called_infeasible(solver: str) -> None:
    """Equal bounds beside a singular Hessian leave the other variable to its bounds."""
    lower, upper = np.array([-5.0, -0.1]), np.array([16.0, -0.1])
    problem = replace(boxed(np.array([[1.0, -1.0], [-1.0, 1.0]]), np.array([-3.4, 50.9])), lower=lower, upper=upper)
    np.testing.assert_allclose(solve(problem, solver).x, [3.3, -0.1], atol=1e-5)


def test_the_iteration_limit_is_how_many_it_may_take(solver: str) -> None:
    """With as many iterations as it needs it is solved, with one less it is not."""
    needed = solve(PREDICTIVE[0], solver).iterations
    assert solve(PREDICTIVE[0], solver, iteration_limit=needed).is_solved
    assert solve(PREDICTIVE[0], solver, iteration_limit=needed - 1).status is Status.ITERATION_LIMIT
