"""What must not change the answer of a QP solver: sides, units, memory layout and where it starts."""

from dataclasses import fields, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.qp import SOLVERS, Problem, WarmStart, solve
from tests.qp.problems import boxed, distance, feasible, mirrored, predictive

pytestmark = pytest.mark.parametrize("solver", SOLVERS)

PREDICTIVE = predictive(seed=0)


@given(seed=st.integers(0, 2**32 - 1))
def test_a_mirrored_problem_has_the_mirrored_solution(solver: str, seed: int) -> None:
    """With all limits on the other side, x and the multipliers change sign: what proves one proves the other."""
    problem = feasible(np.random.default_rng(seed), 6, 8)
    solution, reflected = solve(problem, solver), solve(mirrored(problem), solver)
    np.testing.assert_allclose(reflected.x, -solution.x, atol=1e-4)
    turned = replace(
        reflected,
        x=-solution.x,
        bound_multipliers=-solution.bound_multipliers,
        row_multipliers=-solution.row_multipliers,
    )
    assert turned.is_optimal(1e-7)


@pytest.mark.parametrize("unit_of_cost", [1e-9, 1e9])
def test_units_do_not_matter(solver: str, unit_of_cost: float) -> None:
    """The same problem in newtons instead of kilonewtons, or of any cost, has the same solution."""
    problem = PREDICTIVE[0]
    units = np.tile([1.0, 1e-3, 1e-2, 1e2, 1.0, 1e3, 1e-1], 11)
    other = Problem(
        problem.hessian * np.outer(units, units) * unit_of_cost,
        problem.gradient * units * unit_of_cost,
        problem.lower / units,
        problem.upper / units,
        problem.rows * units,
        problem.row_lower,
        problem.row_upper,
    )
    np.testing.assert_allclose(units * solve(other, solver).x, solve(problem, solver).x, atol=1e-5)


def test_any_memory_layout_will_do_and_none_is_written_to(solver: str) -> None:
    """Strided, Fortran-ordered, read-only and integer arrays give the answer of plain ones and keep their numbers."""
    problem = PREDICTIVE[0]
    expected = solve(problem, solver)
    arrays = [getattr(problem, field.name) for field in fields(problem)]
    strided = [np.repeat(a, 2, axis=-1)[..., ::2] for a in arrays]
    fortran = [np.asfortranarray(a) for a in arrays]
    frozen = [a.copy() for a in arrays]
    for array in frozen:
        array.flags.writeable = False
    for layout in (strided, fortran, frozen):
        assert distance(solve(Problem(*layout), solver), expected) == 0.0
        assert all(np.array_equal(a, b) for a, b in zip(layout, arrays, strict=True))
    whole = solve(boxed(np.eye(2, dtype=int), np.array([-4, 4]), -1, 1), solver)
    np.testing.assert_allclose(whole.x, [1.0, -1.0], atol=1e-6)


def test_a_warm_start_gives_the_same_answer(solver: str) -> None:
    """Started from the problem before, from nonsense or from nan, it finds what it finds from nothing."""
    rng = np.random.default_rng(4)
    before = solve(PREDICTIVE[0], solver)
    nonsense = WarmStart(rng.normal(size=77), rng.normal(size=140))
    nothing = WarmStart(np.full(77, np.nan), np.full(140, np.nan))
    for problem in PREDICTIVE[1:]:
        cold = solve(problem, solver)
        for start in (before.warm_start, nonsense, nothing):
            assert distance(solve(problem, solver, start), cold) < 1e-9
        warm = solve(problem, solver, before.warm_start)
        assert warm.iterations <= cold.iterations
        before = warm
