"""Why a run went as it did: the steps at which the decision changed, with all that was tried in them."""

from collections.abc import Iterator, Sequence

import numpy as np

from swerve.control import Branch, Plan
from swerve.simulate import Run

CLEAR = 0.0005  # [m] what is missed of a margin and prints as 0.000


def explanation(run: Run) -> str:
    """A paragraph for each moment at which the way, or whether anything shaped it, changed."""
    changes = list(_changes(run.plans))
    of = f"{len(changes)} {'moment' if len(changes) == 1 else 'moments'} in {len(run.plans)} steps"
    return "\n".join([f"decisions: {of}", *(_paragraph(plan) for plan in changes)])


def _changes(plans: Sequence[Plan]) -> Iterator[Plan]:
    last: tuple[object, ...] = ()
    for plan in plans:
        now = (plan.name, plan.is_shaped, plan.fallback)
        if now != last:
            yield plan
        last = now


def _paragraph(plan: Plan) -> str:
    why = plan.reason if plan.fallback is None else f"fallback: {plan.fallback.value}"
    lines = [f"{plan.time:7.2f} s  {plan.name}: {why or 'nothing is in the path'}"]
    lines += [f"           {_branch(branch)}" for branch in plan.branches]
    if plan.active:
        lines.append(f"           held by {', '.join(plan.active)}")
    if np.isfinite(plan.friction_use).all():
        use = " ".join(f"{100 * share:.0f}" for share in plan.friction_use)
        lines.append(f"           friction in use: {use} % (fl fr rl rr)")
    return "\n".join(lines)


def _branch(branch: Branch) -> str:
    faults = []
    if branch.violation > CLEAR:
        faults.append(f"misses a margin by {branch.violation:.3f} m")
    if branch.impact_speed is not None:
        faults.append(f"touches at {branch.impact_speed:.1f} m/s")
    if branch.off_road > CLEAR:
        faults.append(f"{branch.off_road:.2f} m off the road")
    return f"{branch.name}: costs {branch.cost:.4g}, {', '.join(faults) or 'clear'}"
