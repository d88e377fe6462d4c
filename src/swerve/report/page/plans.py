"""What the controller intended in each step, and what else it tried."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swerve.control import Plan
from swerve.conventions import PSI, X, Y
from swerve.report.page.interim import plan_of
from swerve.report.page.rounding import ANGLE, CENTIMETRE, TIME, rounded
from swerve.simulate import Run

Array = NDArray[np.float64]

MOST_POINTS = 24  # of a path that is drawn


def steps_json(run: Run) -> dict[str, Any]:
    """Columns over the controller's steps: what was commanded, how long it took, what was decided."""
    steps, plans = run.log.steps, [plan_of(plan) for plan in run.plans]
    return {
        "time": rounded(steps["time"], TIME),
        "delta": rounded(steps["delta"], 5),
        "step_time": rounded(steps["step_time"], 7),
        "name": [plan.name for plan in plans],
        "fallback": [plan.fallback.value if plan.fallback else "" for plan in plans],
    }


def plans_json(plans: Sequence[Plan]) -> list[dict[str, Any]]:
    """Each step's plan and branches, with their paths as X, Y, psi, one after the other."""
    return [_plan(plan_of(plan)) for plan in plans]


def _plan(plan: Any) -> dict[str, Any]:
    return {
        "reason": plan.reason,
        "active": list(plan.active),
        "path": _path(plan.states[:, [X, Y, PSI]]),
        "branches": [_branch(branch) for branch in plan.branches],
    }


def _branch(branch: Any) -> dict[str, Any]:
    numbers = {"cost": branch.cost, "violation": branch.violation, "off_road": branch.off_road}
    return {
        "name": branch.name,
        **{name: value if np.isfinite(value) else None for name, value in numbers.items()},
        "impact_speed": branch.impact_speed,
        "path": _path(branch.poses),
    }


def _path(poses: Array) -> list[float]:
    """Poses (n, 3) up to the first that is not finite, thinned, in a row."""
    sane = np.isfinite(poses).all(axis=1)
    kept = poses[: len(poses) if sane.all() else int(np.argmin(sane))]
    rows = np.unique(np.linspace(0, max(0, len(kept) - 1), MOST_POINTS).round().astype(int))
    thin = kept[rows[rows < len(kept)]]
    parts = np.column_stack([np.round(thin[:, :2], CENTIMETRE), np.round(thin[:, 2], ANGLE - 1)])
    flat: list[float] = parts.ravel().tolist()
    return flat
