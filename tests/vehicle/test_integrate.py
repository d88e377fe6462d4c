"""The classical Runge-Kutta method against solutions in closed form."""

import numpy as np
import pytest
from scipy.linalg import expm

from swerve.vehicle.integrate import rk4


def test_fourth_order() -> None:
    """Halving the step leaves a sixteenth of the error of an oscillation, over a fixed time."""
    A, start = np.array([[0.0, 1.0], [-4.0, -0.3]]), np.array([1.0, 0.0])
    errors = []
    for n in (40, 80, 160):
        x = start
        for _ in range(n):
            x = rk4(lambda y: A @ y, x, 2.0 / n)
        errors.append(np.abs(x - expm(2.0 * A) @ start).max())
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    np.testing.assert_allclose(orders, 4.0, atol=0.1)


def test_one_step_of_a_linear_equation() -> None:
    """One step of x' = x multiplies by 1 + h + h^2/2 + h^3/6 + h^4/24."""
    assert rk4(lambda x: x, 1.0, 0.5) == pytest.approx(1 + 0.5 + 0.125 + 0.125 / 6 + 0.0625 / 24)
