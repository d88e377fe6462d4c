"""The classical Runge-Kutta method of fourth order, with the input held."""

from collections.abc import Callable
from typing import Any


def rk4(derivative: Callable[[Any], Any], x: Any, step: Any) -> Any:
    """The state after `step` [s] from `x`, for x' = derivative(x)."""
    k1 = derivative(x)
    k2 = derivative(x + step / 2 * k1)
    k3 = derivative(x + step / 2 * k2)
    k4 = derivative(x + step * k3)
    return x + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
