"""Improving the plan of one side: sequential convex programming from the shifted plan of the last step."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Side
from swerve.control.unified.acceptance import Step, accept
from swerve.control.unified.condensing import condense
from swerve.control.unified.limits import ObstacleLimit
from swerve.control.unified.prediction import PredictionModel
from swerve.control.unified.program import Program
from swerve.qp import Solution, solve

Array = NDArray[np.float64]

CONVERGED = 5e-3  # [1] relative fall of the merit below which an iteration was the last
NOTHING = 1e-6  # [1] relative fall of the merit that is not worth a roll-out
SMALLEST_TRUST = 1 / 64  # [1] of the full trust region
TRUST_AFTER_A_STEP = 1 / 4  # [1] the region is at least this large when a new sample begins
ACTIVE = 1e-6  # [1/m] a multiplier beyond this holds the plan off an obstacle


@dataclass(frozen=True, eq=False)
class SidePlan:
    """Where the iterations of one side have led.

    Attributes:
        side: on which obstacles are passed.
        step: the trajectory and its merit.
        violation: largest distance by which it misses the margin to an obstacle [m].
        is_shaped: whether an obstacle held the plan in a quadratic program of this step.
        trust: size of the trust region, as a share of the full one [1].
        n_solved: quadratic programs solved.
        n_failed: quadratic programs without an answer.
    """

    side: Side
    step: Step
    violation: float
    is_shaped: bool
    trust: float
    n_solved: int
    n_failed: int


@dataclass(frozen=True, eq=False)
class Situation:
    """What the iterations of one side work on.

    Attributes:
        side: on which obstacles are passed.
        program: cost and limits.
        model: of the vehicle.
        start: (6,) measured state.
        loads: (4,) wheel loads [N].
        full_trust: (5,) trust region at its largest [rad, N, N, N, N].
    """

    side: Side
    program: Program
    model: PredictionModel
    start: Array
    loads: Array
    full_trust: Array

    def roll_out(self, inputs: Array) -> Step:
        """The step that inputs (Np, 5) make, clipped to what the actuators can do."""
        trajectory = self.model.roll_out(self.start, self.program.clip(inputs), self.loads)
        return Step(trajectory, self.program.score(trajectory))

    def missed_clearance(self, step: Step) -> float:
        """Largest distance by which a step misses the margin to an obstacle [m]."""
        return self.program.missed_clearance(step.score)

    def is_near(self, step: Step) -> bool:
        """Whether an obstacle is in reach of a step, so that the side matters."""
        limits = (limit for limit in self.program.soft if isinstance(limit, ObstacleLimit))
        return any(limit.is_near(step.trajectory) for limit in limits)


def improve(situation: Situation, step: Step, trust: float, iterations: int) -> SidePlan:
    """At most `iterations` convex programs, each accepted as far as the nonlinear model confirms it."""
    program, blocking = situation.program, situation.program.box.blocking
    is_shaped, n_solved, n_failed = False, 0, 0
    for _ in range(iterations):
        jacobians = situation.model.linearise(step.trajectory, situation.loads)
        problem = program.convex(step.trajectory, condense(jacobians, blocking), trust * situation.full_trust)
        solution = solve(problem)
        if not solution.is_solved:
            n_failed += 1
            break
        n_solved += 1
        is_shaped = is_shaped or _is_shaped(program, solution, blocking.n)
        promise = step.score.penalty - solution.cost
        if promise < NOTHING * (1 + step.merit):
            break
        before = step.merit
        step = accept(step, blocking.spread(solution.x[: blocking.n]), promise, situation.roll_out)
        trust = _resized(trust, step.length)
        if step.length > 0 and before - step.merit < CONVERGED * (1 + step.merit):
            break
    return SidePlan(situation.side, step, situation.missed_clearance(step), is_shaped, trust, n_solved, n_failed)


def _resized(trust: float, length: float) -> float:
    """The trust region grows after a whole step and shrinks after a part of one, more after none."""
    factor = 2.0 if length == 1 else 0.5 if length > 0 else 0.25
    return min(1.0, max(SMALLEST_TRUST, factor * trust))


def _is_shaped(program: Program, solution: Solution, n: int) -> bool:
    """Whether a row of an obstacle, known by its slack, has a multiplier."""
    slacks = [n + i for i, limit in enumerate(program.soft) if isinstance(limit, ObstacleLimit)]
    of_obstacles = (solution.problem.rows[:, slacks] != 0).any(axis=1)
    return bool((np.abs(solution.row_multipliers[of_obstacles]) > ACTIVE).any())
