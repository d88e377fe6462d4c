"""The plan that goes with a command: what was tried, what was taken, what holds it, and why."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from swerve.control.friction_use import friction_use
from swerve.control.plan import Branch, Plan
from swerve.control.unified.choice import Candidate, Choice
from swerve.control.unified.improve import WayPlan
from swerve.control.unified.situation import CLEAR
from swerve.conventions import WHEELS
from swerve.signals import Measurement

Array = NDArray[np.float64]

AT_THE_LIMIT = 0.999  # [1] share of an input's largest magnitude that counts as all of it


def plan_of(measurement: Measurement, candidates: Sequence[Candidate], choice: Choice, friction: float) -> Plan:
    """The chosen plan, with all that were tried and the reason; `friction` is mu [1]."""
    taken = choice.candidate.plan
    trajectory = taken.step.trajectory
    return Plan(
        time=measurement.time,
        inputs=trajectory.inputs,
        states=trajectory.states,
        side=taken.way.side if taken.is_shaped else None,
        name=taken.way.name,
        is_shaped=taken.is_shaped or taken.violation > CLEAR,
        branches=tuple(_branch(each) for each in candidates),
        reason=choice.reason,
        active=taken.active + _inputs_at_limit(taken),
        friction_use=friction_use(
            trajectory.inputs[0], trajectory.lateral_demand[0], friction * measurement.wheel_loads
        ),
        solver_failures=sum(each.plan.n_failed for each in candidates),
    )


def _branch(candidate: Candidate) -> Branch:
    plan = candidate.plan
    return Branch(
        name=plan.way.name,
        passing=plan.way.passing,
        cost=candidate.cost,
        violation=plan.violation,
        off_road=plan.off_road,
        impact_speed=candidate.impact_speed,
        poses=plan.step.trajectory.poses,
    )


def _inputs_at_limit(plan: WayPlan) -> tuple[str, ...]:
    """The inputs that their first command takes to the limit."""
    first, largest = np.abs(plan.step.trajectory.inputs[0]), plan.situation.program.box.largest
    names = ("steering lock", *(f"force {wheel}" for wheel in WHEELS))
    at_limit = first >= AT_THE_LIMIT * largest
    return tuple(name for name, held in zip(names, at_limit, strict=True) if held)
