"""The convex program of one iteration: all terms and limits, linearised about a trajectory, as one quadratic program.

    minimise    sum of the terms' models + sum of penalties over slacks s
    over        z (n,) scaled changes of the free inputs, one slack s >= 0 for each soft limit
    subject to  bounds on z, hard rows, soft rows -s <= ... <= +s
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.limits import HardLimit, InputBox, ObstacleLimit, SoftLimit
from swerve.control.unified.limits.limit import Rows
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.terms import Term
from swerve.qp import Problem

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Score:
    """What a trajectory costs.

    Attributes:
        cost: sum of the terms [1].
        penalty: price of all violations [1].
        violations: of each soft limit, in the program's order [unit of the limit].
    """

    cost: float
    penalty: float
    violations: tuple[float, ...]

    @property
    def merit(self) -> float:
        """What the controller minimises [1]."""
        return self.cost + self.penalty


@dataclass(frozen=True)
class Program:
    """What is to be minimised, and within what; the formula of the controller as a value.

    Attributes:
        terms: of the cost.
        box: bounds on the inputs.
        hard: limits without slack.
        soft: limits with one slack each.
    """

    terms: Sequence[Term]
    box: InputBox
    hard: Sequence[HardLimit]
    soft: Sequence[SoftLimit]

    def score(self, trajectory: Trajectory) -> Score:
        """Cost and violations of a trajectory, without any linearisation; infinite where the model diverged."""
        if not trajectory.is_finite:
            return Score(np.inf, np.inf, tuple(np.inf for _ in self.soft))
        violations = tuple(limit.violation(trajectory) for limit in self.soft)
        penalty = sum(limit.penalty.of(each) for limit, each in zip(self.soft, violations, strict=True))
        return Score(sum(term.value(trajectory) for term in self.terms), penalty, violations)

    def missed_clearance(self, score: Score) -> float:
        """Largest distance by which the margin to an obstacle is missed [m]."""
        missed = zip(self.soft, score.violations, strict=True)
        return max((each for limit, each in missed if isinstance(limit, ObstacleLimit)), default=0.0)

    def convex(self, trajectory: Trajectory, sensitivities: Sensitivities, trust: Array) -> Problem:
        """The quadratic program about a trajectory, for changes within `trust` (5,) [rad, N, N, N, N]."""
        n, n_slacks = self.box.blocking.n, len(self.soft)
        hessian, gradient = np.zeros((n + n_slacks, n + n_slacks)), np.zeros(n + n_slacks)
        for term in self.terms:
            model = term.quadratic(trajectory, sensitivities)
            hessian[:n, :n] += model.hessian
            gradient[:n] += model.gradient
        blocks = [_with_slack(limit.rows(trajectory, sensitivities), None, n_slacks) for limit in self.hard]
        for i, limit in enumerate(self.soft):
            hessian[n + i, n + i] = 2 * limit.penalty.quadratic
            gradient[n + i] = limit.penalty.linear
            blocks.append(_with_slack(limit.rows(trajectory, sensitivities), i, n_slacks))
        lower, upper = self.box.bounds(trajectory, trust)
        return Problem(
            hessian=hessian,
            gradient=gradient,
            lower=np.concatenate([lower, np.zeros(n_slacks)]),
            upper=np.concatenate([upper, np.full(n_slacks, np.inf)]),
            rows=np.vstack([block.matrix for block in blocks]),
            row_lower=np.concatenate([block.lower for block in blocks]),
            row_upper=np.concatenate([block.upper for block in blocks]),
        )


def _with_slack(rows: Rows, slack: int | None, n_slacks: int) -> Rows:
    """Rows over (z, s); with a slack, each finite side becomes a row of its own: lower <= G z + s, G z - s <= upper."""
    if slack is None:
        return Rows(np.pad(rows.matrix, ((0, 0), (0, n_slacks))), rows.lower, rows.upper)
    below, above = np.isfinite(rows.lower), np.isfinite(rows.upper)
    n_below, n_above, n = int(below.sum()), int(above.sum()), rows.matrix.shape[1]
    matrix = np.zeros((n_below + n_above, n + n_slacks))
    matrix[:n_below, :n], matrix[n_below:, :n] = rows.matrix[below], rows.matrix[above]
    matrix[:n_below, n + slack], matrix[n_below:, n + slack] = 1.0, -1.0
    lower = np.concatenate([rows.lower[below], np.full(n_above, -np.inf)])
    upper = np.concatenate([np.full(n_below, np.inf), rows.upper[above]])
    return Rows(matrix, lower, upper)
