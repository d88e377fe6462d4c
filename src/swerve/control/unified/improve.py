"""Improving the plan of one way: sequential convex programming from the shifted plan of the last step."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from swerve.control.unified.acceptance import Step, accept
from swerve.control.unified.deadline import ITERATION, PROGRAM, ROW, SECOND_SOLVER
from swerve.control.unified.held import Held
from swerve.control.unified.limits.limit import Indices
from swerve.control.unified.situation import Situation
from swerve.control.unified.way import Way
from swerve.qp import Problem, Solution, solve

Array = NDArray[np.float64]

SECOND = "piqp"  # solver of what the first one fails at
CONVERGED = 5e-3  # [1] relative fall of the merit below which an iteration was the last
NOTHING = 1e-6  # [1] relative fall of the merit that is not worth a roll-out
SMALLEST_TRUST = 1 / 64  # [1] of the full trust region
TRUST_AFTER_A_STEP = 1 / 4  # [1] the region is at least this large when a new sample begins


@dataclass(frozen=True, eq=False)
class WayPlan:
    """Where the iterations of one way have led.

    Attributes:
        situation: that they worked on.
        step: the trajectory and its merit.
        trust: size of the trust region, as a share of the full one [1].
        active: the limits that held the plan in a quadratic program of this step.
        held: what held it in the last one, of this step or an earlier one; None before the first.
        n_solved: quadratic programs solved.
        n_failed: quadratic programs without an answer.
    """

    situation: Situation
    step: Step
    trust: float
    active: tuple[str, ...] = ()
    held: Held | None = None
    n_solved: int = 0
    n_failed: int = 0

    @property
    def way(self) -> Way:
        """The way itself."""
        return self.situation.way

    @property
    def violation(self) -> float:
        """Largest distance by which the margin to an obstacle is missed [m]."""
        return self.situation.program.missed_clearance(self.step.score)

    @property
    def off_road(self) -> float:
        """Largest distance beyond an edge of the road [m]."""
        return self.situation.program.off_road(self.step.score)

    @property
    def is_shaped(self) -> bool:
        """Whether an obstacle or an edge held the plan."""
        return any("obstacle" in name or "edge" in name for name in self.active)


def improve(plan: WayPlan, iterations: int) -> WayPlan:
    """At most `iterations` convex programs, each accepted as far as the nonlinear model confirms it."""
    situation, program = plan.situation, plan.situation.program
    blocking = program.box.blocking
    for _ in range(iterations):
        if plan.n_solved + plan.n_failed and situation.deadline.is_over:
            break
        step = plan.step
        trust = plan.trust * situation.full_trust
        problem, labels = program.labelled(step.trajectory, situation.sensitivities(step), trust)
        solution = _solved(problem, labels, plan.held)
        situation.deadline.count(_work(solution))
        if not solution.is_solved:
            return replace(plan, n_failed=plan.n_failed + 1)
        active = tuple(dict.fromkeys(plan.active + program.active(solution)))
        plan = replace(plan, n_solved=plan.n_solved + 1, active=active, held=Held.by(solution, labels))
        promise = step.score.penalty - solution.cost
        if promise < NOTHING * (1 + step.merit):
            break
        taken = accept(step, blocking.spread(solution.x[: blocking.n]), promise, situation.roll_out)
        plan = replace(plan, step=taken, trust=_resized(plan.trust, taken.length))
        if taken.length == 1 and step.merit - taken.merit < CONVERGED * (1 + taken.merit):
            break
    return plan


def _solved(problem: Problem, labels: Indices, held: Held | None) -> Solution:
    """By the active-set method, from what held before; where that cycles, by interior points, which do not."""
    solution = solve(problem, warm_start=None if held is None else held.start(problem.gradient.size, labels))
    return solution if solution.is_solved else solve(problem, SECOND)


def _work(solution: Solution) -> float:
    """What a program has taken [s]."""
    solving = SECOND_SOLVER if solution.solver == SECOND else ITERATION * solution.iterations
    return PROGRAM + ROW * len(solution.problem.row_lower) + solving


def _resized(trust: float, length: float) -> float:
    """The trust region grows after a whole step and shrinks after a part of one, more after none."""
    factor = 2.0 if length == 1 else 0.5 if length > 0 else 0.25
    return min(1.0, max(SMALLEST_TRUST, factor * trust))
