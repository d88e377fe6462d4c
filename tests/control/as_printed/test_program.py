"""Sec. 4.3 against the recursion that it condenses, and the quadratic program against the cost that it stands for."""

from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swerve.control import Horizon
from swerve.control.as_printed.discretisation import Discrete
from swerve.control.as_printed.program import INPUT_SCALE, canonical, obstacle_rows, response
from swerve.qp import solve

HORIZON = Horizon(7, 4, 0.05)
SWITCHES = [dict(zip(("with_drift", "hold_input"), each, strict=True)) for each in product([False, True], repeat=2)]
seeds = st.integers(0, 2**32 - 1)


def a_model(random: np.random.Generator) -> Discrete:
    """Any sampled model, not far from the identity."""
    return Discrete(np.eye(6) + 0.1 * random.normal(size=(6, 6)), random.normal(size=(6, 5)), random.normal(size=6))


def recursion(model: Discrete, u: np.ndarray, *, with_drift: bool, hold_input: bool) -> np.ndarray:
    """Eq. (9), one sample after the other, from a deviation of zero."""
    x, states = np.zeros(6), []
    for k in range(HORIZON.prediction):
        acting = u[k] if k < HORIZON.control else u[-1] if hold_input else np.zeros(5)
        x = model.A @ x + model.B @ acting + (model.d if with_drift else 0)
        states.append(x)
    return np.array(states)


@pytest.mark.parametrize("switches", SWITCHES)
@settings(max_examples=20)
@given(seed=seeds)
def test_the_response_is_the_recursion(switches: dict[str, bool], seed: int) -> None:
    """free + W U is eq. (9) carried out, with the drift or without, the last input held or not."""
    random = np.random.default_rng(seed)
    model, u = a_model(random), random.normal(size=(4, 5))
    free, W = response(model, HORIZON, **switches)
    assert (free.shape, W.shape) == ((7, 6), (7, 6, 20))
    np.testing.assert_allclose(free + W @ u.ravel(), recursion(model, u, **switches), atol=1e-10)


def test_w_is_the_papers() -> None:
    """Without corrections W's last row is (A^Np-1 B, ..., A^Np-Nc B): after Nc the input falls back."""
    model = a_model(np.random.default_rng(1))
    free, W = response(model, HORIZON, with_drift=False, hold_input=False)
    assert (free == 0).all()
    for block in range(4):
        power = np.linalg.matrix_power(model.A, 6 - block)
        np.testing.assert_allclose(W[-1][:, 5 * block : 5 * block + 5], power @ model.B, atol=1e-9)


def test_each_switch_changes_what_it_says() -> None:
    """The drift moves the free response alone; holding moves the last block alone, and only after Nc."""
    model = a_model(np.random.default_rng(2))
    plain = response(model, HORIZON, with_drift=False, hold_input=False)
    drift = response(model, HORIZON, with_drift=True, hold_input=False)
    held = response(model, HORIZON, with_drift=False, hold_input=True)
    np.testing.assert_array_equal(drift[1], plain[1])
    assert np.abs(drift[0]).min(axis=1).max() > 0
    np.testing.assert_array_equal(held[0], plain[0])
    changed = np.abs(held[1] - plain[1]).max(axis=1) > 1e-12
    assert not changed[:4].any()
    assert not changed[:, :15].any()
    assert changed[4:, 15:].any(axis=1).all()


@settings(max_examples=20)
@given(seeds)
def test_obstacle_rows_are_the_linearised_distance(seed: int) -> None:
    """matrix U >= bound says rho + p1 X~ + p2 Y~ >= 1 for each obstacle in each sample."""
    random = np.random.default_rng(seed)
    free, W = response(a_model(random), HORIZON, with_drift=True, hold_input=True)
    rho, gradient, u = random.uniform(0, 50, (2, 7)), random.normal(size=(2, 7, 2)), random.normal(size=20)
    matrix, bound = obstacle_rows(free, W, rho, gradient)
    states = free + W @ u
    for i, k in product(range(2), range(7)):
        left = rho[i, k] + gradient[i, k] @ states[k, 4:] - 1
        assert matrix[7 * i + k] @ u - bound[7 * i + k] == pytest.approx(left, abs=1e-9)


@settings(max_examples=20)
@given(seeds)
def test_the_program_is_the_cost_10(seed: int) -> None:
    """Up to a constant the program costs sum |eta - eta_ref|_Q^2 + sum |dU|_R^2, over dU in units of INPUT_SCALE."""
    random = np.random.default_rng(seed)
    free, W = response(a_model(random), HORIZON, with_drift=True, hold_input=False)
    deviation, Q, R = random.normal(size=3), random.uniform(0, 10, 3), random.uniform(0, 2, 5)
    none = np.zeros((0, 20)), np.zeros(0)
    problem = canonical(free, W, deviation, Q, R, np.full(5, -1e9), np.full(5, 1e9), none)
    problem.check()

    def cost(changes: np.ndarray) -> float:
        steps = changes.reshape(4, 5) * INPUT_SCALE
        u = np.cumsum(steps, axis=0)
        eta = (free + W @ u.ravel())[:, [0, 1, 5]] - deviation
        return float(np.sum(Q * eta**2) + np.sum(R * steps**2))

    changes = random.normal(0, 1e-2, 20)
    assert problem.cost(changes) == pytest.approx(cost(changes) - cost(np.zeros(20)), rel=1e-7, abs=1e-6)


@settings(max_examples=20)
@given(seeds)
def test_the_inputs_stay_within_their_limits(seed: int) -> None:
    """(14) by N2 as in (17): the sums of the changes up to each sample lie between u_min - u_k and u_max - u_k."""
    random = np.random.default_rng(seed)
    free, W = response(a_model(random), HORIZON, with_drift=True, hold_input=False)
    lower, upper = -random.uniform(0.01, 1, 5) * INPUT_SCALE, random.uniform(0.01, 1, 5) * INPUT_SCALE
    none = np.zeros((0, 20)), np.zeros(0)
    problem = canonical(free, W, np.full(3, 100.0), np.ones(3), np.full(5, 1e-9), lower, upper, none)
    solution = solve(problem)
    assert solution.is_solved
    u = np.cumsum(solution.x.reshape(4, 5) * INPUT_SCALE, axis=0)
    assert (u >= lower - 1e-6 * INPUT_SCALE).all()
    assert (u <= upper + 1e-6 * INPUT_SCALE).all()
    assert (np.isclose(u, upper, atol=1e-5 * INPUT_SCALE) | np.isclose(u, lower, atol=1e-5 * INPUT_SCALE)).any()
