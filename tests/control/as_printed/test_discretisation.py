"""From the continuous to the sampled model: Euler's rule and the exact one, against a fine integration."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from swerve.control.as_printed.discretisation import Discrete, euler, exact

RANDOM = np.random.default_rng(0)
A = RANDOM.normal(size=(6, 6))
B = RANDOM.normal(size=(6, 5))
F = RANDOM.normal(size=6)


def after(model: Discrete, x: np.ndarray, u: np.ndarray) -> np.ndarray:
    """The deviation one sample later."""
    return model.A @ x + model.B @ u + model.d


@given(st.integers(0, 2**32 - 1), st.floats(0.001, 0.5))
def test_exact_is_the_solution_of_the_linear_equation(seed: int, sample_time: float) -> None:
    """x' = A x + B u + f over one sample, with the input held, by an integrator."""
    random = np.random.default_rng(seed)
    x, u = random.normal(size=6), random.normal(size=5)
    fine = solve_ivp(lambda _, y: A @ y + B @ u + F, (0, sample_time), x, method="DOP853", rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(after(exact(F, A, B, sample_time), x, u), fine.y[:, -1], atol=1e-9)


def test_euler_is_the_rule() -> None:
    """I + Ts A, Ts B and Ts f."""
    model = euler(F, A, B, 0.05)
    np.testing.assert_array_equal(model.A, np.eye(6) + 0.05 * A)
    np.testing.assert_array_equal(model.B, 0.05 * B)
    np.testing.assert_array_equal(model.d, 0.05 * F)


@pytest.mark.parametrize("part", ["A", "B", "d"])
def test_euler_has_second_order_in_one_sample(part: str) -> None:
    """Halving the sample time leaves a quarter of the difference to the exact model."""
    errors = []
    for sample_time in (0.02, 0.01, 0.005):
        one, other = euler(F, A, B, sample_time), exact(F, A, B, sample_time)
        errors.append(np.abs(getattr(one, part) - getattr(other, part)).max())
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    np.testing.assert_allclose(orders, 2.0, atol=0.1)


def test_euler_has_first_order_over_a_fixed_time() -> None:
    """Over one second, halving the sample time leaves half of the error; the exact model has none."""
    x0, u = np.ones(6), np.ones(5)
    true = after(exact(F, A, B, 1.0), x0, u)
    errors = []
    for n in (400, 800, 1600):
        x = y = x0
        rule, solution = euler(F, A, B, 1 / n), exact(F, A, B, 1 / n)
        for _ in range(n):
            x, y = after(rule, x, u), after(solution, y, u)
        errors.append(np.abs(x - true).max())
        np.testing.assert_allclose(y, true, rtol=1e-9)
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    np.testing.assert_allclose(orders, 1.0, atol=0.1)
