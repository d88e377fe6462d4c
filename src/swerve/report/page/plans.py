"""What the controller intended in each step, and what else it tried.

Words and numbers are those of the log. Paths are those of the plans, which a run that was read from its files has not.
"""

from math import isfinite
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swerve.control import Plan
from swerve.conventions import PSI, WHEELS, X, Y
from swerve.report.page.rounding import ANGLE, CENTIMETRE, SHARE, TIME, rounded
from swerve.report.tried import TRIED, Tried
from swerve.simulate import Run

Array = NDArray[np.float64]
Json = dict[str, Any]

MOST_POINTS = 24  # of a path that is drawn
NOWHERE = np.empty((0, 3))


def steps_json(run: Run) -> Json:
    """Columns over the controller's steps: what was commanded, how long it took, what was decided."""
    steps = run.log.steps
    return {
        "time": rounded(steps["time"], TIME),
        "delta": rounded(steps["delta"], 5),
        "step_time": rounded(steps["step_time"], 7),
        "name": steps["branch"].tolist(),
        "fallback": steps["fallback"].tolist(),
    }


def plans_json(run: Run, *, is_ghost: bool = False) -> list[Json]:
    """Each step's plan and the ways that were tried, with their paths as X, Y, psi, one after the other.

    Of a ghost only the way that was taken has a path: no other one is drawn.
    """
    steps = run.log.steps
    uses = rounded(steps.stack(*(f"friction_use_{wheel}" for wheel in WHEELS)), SHARE)
    plans = run.plans or (None,) * len(uses)
    rows = zip(plans, uses, steps["reason"].tolist(), steps["active"].tolist(), steps["branches"], strict=True)
    return [
        {"reason": reason, "active": active, "use": use, **_paths(plan, TRIED.validate_json(tried), is_ghost)}
        for plan, use, reason, active, tried in rows
    ]


def _paths(plan: Plan | None, tried: list[Tried], is_ghost: bool) -> Json:
    """The way that is taken, by its place in the list, and where each one leads."""
    if plan is None:
        return {"path": [], "taken": None, "branches": [_branch(each, NOWHERE) for each in tried]}
    own = plan.states[:, [X, Y, PSI]]
    taken = _taken(plan, own)
    poses = [NOWHERE if is_ghost and i != taken else branch.poses for i, branch in enumerate(plan.branches)]
    return {"path": _path(own), "taken": taken, "branches": list(map(_branch, tried, poses))}


def _taken(plan: Plan, own: Array) -> int | None:
    """The way on whose path the plan ends; the name alone does not tell, as two ways may have the same one."""
    through = (i for i, branch in enumerate(plan.branches) if (branch.poses == own[-1:]).all(axis=1).any())
    return next((i for i in through if plan.branches[i].name == plan.name), None)


def _branch(tried: Tried, poses: Array) -> Json:
    told = {"cost": tried.cost, "violation": tried.violation, "off_road": tried.off_road}
    numbers = {key: value if isfinite(value) else None for key, value in told.items()}
    return {"name": tried.name, **numbers, "impact_speed": tried.impact_speed, "path": _path(poses)}


def _path(poses: Array) -> list[float]:
    """Poses (n, 3) up to the first that is not finite, thinned, in a row."""
    sane = np.isfinite(poses).all(axis=1)
    kept = poses[: len(poses) if sane.all() else int(np.argmin(sane))]
    rows = np.unique(np.linspace(0, max(0, len(kept) - 1), MOST_POINTS).round().astype(int))
    thin = kept[rows[rows < len(kept)]]
    parts = np.column_stack([np.round(thin[:, :2], CENTIMETRE), np.round(thin[:, 2], ANGLE - 1)])
    flat: list[float] = parts.ravel().tolist()
    return flat
