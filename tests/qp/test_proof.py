"""Residuals, duality gap and the verdict that they make: they must notice every way of being wrong."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.qp import Problem, Solution, Status, solve
from tests.qp.problems import boxed, distance, feasible, predictive

SOLUTION = solve(predictive(seed=1, steps=1)[0])
steps = st.floats(1e-4, 1.0)


@given(step=steps, seed=st.integers(0, 2**32 - 1))
def test_a_moved_point_is_noticed(step: float, seed: int) -> None:
    """Away from the minimiser in any direction, the residuals grow and the proof fails."""
    direction = np.random.default_rng(seed).normal(size=77)
    moved = replace(SOLUTION, x=SOLUTION.x + step * direction)
    assert moved.is_solved
    assert moved.dual_residual > 1e3 * SOLUTION.dual_residual
    assert not moved.is_optimal()


@given(step=steps)
def test_the_residuals_grow_with_the_error(step: float) -> None:
    """Twice as far past its limits, x violates them by twice as much."""
    held = SOLUTION.bound_multipliers
    assert np.count_nonzero(held) > 5
    once, twice = (replace(SOLUTION, x=SOLUTION.x + k * step * np.sign(held)).primal_residual for k in (1, 2))
    assert once >= step - 1e-9
    assert once < twice


def test_wrong_multipliers_are_noticed() -> None:
    """Multipliers that are scaled, on the wrong side or missing fail the proof."""
    for factor in (0.0, 0.999, 1.001, -1.0):
        assert not replace(SOLUTION, row_multipliers=factor * SOLUTION.row_multipliers).is_optimal()
        assert not replace(SOLUTION, bound_multipliers=factor * SOLUTION.bound_multipliers).is_optimal()


def test_a_feasible_stationary_point_that_is_no_minimiser_has_a_gap() -> None:
    """Inside the box, holding x by a multiplier is stationary; only the gap tells that nothing holds it there."""
    problem = boxed(np.eye(1), np.array([-1.0]), -2.0, 2.0)
    held = Solution(problem, np.zeros(1), np.ones(1), np.zeros(0), Status.SOLVED, 1, "by hand")
    assert held.primal_residual == 0.0
    assert held.dual_residual == 0.0
    assert held.duality_gap == pytest.approx(2.0)
    assert not held.is_optimal()


def test_a_multiplier_against_no_limit_is_a_dual_residual() -> None:
    """Nothing can push where there is no limit."""
    problem = boxed(np.eye(1), np.array([-1.0]), lower=-2.0)
    held = Solution(problem, np.zeros(1), np.ones(1), np.zeros(0), Status.SOLVED, 1, "by hand")
    assert held.dual_residual == 1.0
    assert held.duality_gap == 0.0


def test_a_nan_is_never_optimal() -> None:
    """Residuals of a nan are nan, and no tolerance accepts them."""
    spoiled = SOLUTION.x.copy()
    spoiled[3] = np.nan
    for wrong in (replace(SOLUTION, x=spoiled), replace(SOLUTION, bound_multipliers=spoiled)):
        assert np.isnan(wrong.dual_residual)
        assert not wrong.is_optimal(1e9)
    assert np.isnan(replace(SOLUTION, x=spoiled).primal_residual)


def test_the_gap_bounds_what_a_point_costs_too_much() -> None:
    """Between a feasible point and the minimum there is no more than the gap that their multipliers show."""
    rng = np.random.default_rng(0)
    best = solve(boxed(feasible(rng, 5, 0).hessian, 3 * rng.normal(size=5), -1.0, 1.0))
    for _ in range(20):
        x = rng.uniform(-1, 1, 5)
        problem = best.problem
        multipliers = -(problem.hessian @ x + problem.gradient)
        guess = replace(best, x=x, bound_multipliers=multipliers)
        assert guess.cost - best.cost <= guess.duality_gap + 1e-9


def test_both_solvers_agree_at_the_size_of_a_predictive_controller() -> None:
    """An active-set and an interior-point method, by different authors, find the same point and cost."""
    for seed in range(4):
        for problem in predictive(seed, steps=5):
            daqp, piqp = solve(problem, "daqp"), solve(problem, "piqp")
            assert distance(daqp, piqp) < 1e-4
            assert daqp.cost == pytest.approx(piqp.cost, rel=1e-8, abs=1e-8)


def test_a_warm_start_saves_iterations() -> None:
    """Along the steps of a predictive controller DAQP needs less than half of the iterations, in all."""
    cold = warm = 0
    start = None
    for problem in predictive(seed=2):
        cold += solve(problem).iterations
        solution = solve(problem, warm_start=start)
        warm += solution.iterations
        start = solution.warm_start
    assert warm < cold / 2


def test_the_same_problem_gives_the_same_bits() -> None:
    """Nothing is remembered between two calls."""
    problem, other = predictive(seed=3, steps=2)
    first = solve(problem)
    solve(other)
    assert distance(solve(problem), first) == 0.0


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"gradient": np.zeros(4)}, r"n = 4 .*hessian \(3, 3\)"),
        ({"upper": np.zeros(2)}, r"upper \(2,\)"),
        ({"rows": np.zeros((2, 3))}, r"m = 0 .*rows \(2, 3\)"),
        ({"gradient": np.zeros(3, dtype=int)}, "gradient must be of float64, got int"),
        ({"hessian": np.triu(np.ones((3, 3)))}, "hessian is not symmetric: .* by 1"),
    ],
)
def test_check_names_what_is_wrong(changes: dict[str, np.ndarray], message: str) -> None:
    """The check of a problem names the array and what it is."""
    problem: Problem = boxed(np.eye(3), np.zeros(3))
    problem.check()
    with pytest.raises(ValueError, match=message):
        replace(problem, **changes).check()
