"""The friction under each wheel: a base, and patches along the axes of which the last that holds the wheel counts."""

from typing import Any

import casadi as ca

PATCH = 5  # numbers of a patch: x from, to, y from, to [m], mu [1]


def friction_at(x: Any, y: Any, base: Any, patches: Any) -> Any:
    """mu (n,) [1] at positions (n,) [m]; `patches` is (PATCH, any number)."""
    friction = base + 0 * x
    for k in range(patches.shape[1]):
        x_from, x_to, y_from, y_to, value = ca.vertsplit(patches[:, k])
        is_inside = ca.logic_and(ca.logic_and(x >= x_from, x <= x_to), ca.logic_and(y >= y_from, y <= y_to))
        friction = ca.if_else(is_inside, value, friction)
    return friction


def wheel_positions(x: Any, lf: Any, lr: Any, lt: Any) -> tuple[Any, Any]:
    """World X and Y (4,) [m] of the wheels of a vehicle state [vx vy r psi X Y ...], flat on the road."""
    ahead, left = ca.vertcat(lf, lf, -lr, -lr), ca.vertcat(lt, -lt, lt, -lt)
    cos, sin = ca.cos(x[3]), ca.sin(x[3])
    return x[4] + ahead * cos - left * sin, x[5] + ahead * sin + left * cos
