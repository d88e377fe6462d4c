"""Plans and obstacles of before several obstacles were planned for, read as those of after.

This file goes when `swerve.control.plan.Branch` has a path and `swerve.world.Obstacle` a `heading_at`.
"""

from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def plan_of(plan: Any) -> Any:
    """The plan with a name, a reason and branches with paths."""
    if hasattr(plan, "is_shaped"):
        return plan
    name = "keep" if plan.side is None else plan.side.name.lower()
    branches = [
        SimpleNamespace(
            name=each.side.name.lower(),
            cost=each.cost,
            violation=each.violation,
            off_road=0.0,
            impact_speed=None,
            poses=np.empty((0, 3)),
        )
        for each in plan.branches
    ]
    named = {"name": name, "is_shaped": plan.side is not None, "branches": branches, "reason": "", "active": ()}
    return SimpleNamespace(states=plan.states, fallback=plan.fallback, **named)


def heading_at(obstacle: Any, times: Array) -> Array:
    """The obstacle's heading (n,) [rad] at times (n,) [s]."""
    if hasattr(obstacle, "heading_at"):
        heading: Array = obstacle.heading_at(times)
        return heading
    return np.full(len(times), obstacle.heading)
