"""The convex program of one iteration: all terms and limits, linearised about a trajectory, as one quadratic program.

minimise    sum of the terms' models + sum of penalties over slacks s
over        z (n,) scaled changes of the free inputs, a slack s >= 0 for each soft limit, a bounded one for its comfort
subject to  bounds on z, hard rows, soft rows -s <= ... <= +s
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.limits import HardLimit, InputBox, ObstacleLimit, RoadEdge, SoftLimit
from swerve.control.unified.limits.limit import Indices, Rows
from swerve.control.unified.prediction import Trajectory
from swerve.control.unified.terms import Term
from swerve.qp import Problem, Solution

Array = NDArray[np.float64]

SMALL = 1e-3  # [1/unit^2] curvature of a comfort's price, next to nothing: a solver wants some
MOST_PLACES = 1000  # poses, samples or inputs that the rows of one limit are about
ACTIVE = 1e-6  # [1/m, 1/rad] a multiplier beyond this holds a plan


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

    def clip(self, inputs: Array) -> Array:
        """Inputs (Np, 5) within the box and the hard limits, the last free one held."""
        clipped = self.box.clip(inputs)
        for limit in self.hard:
            clipped = limit.clip(clipped)
        return self.box.blocking.hold(clipped)

    def score(self, trajectory: Trajectory) -> Score:
        """Cost and violations of a trajectory, without any linearisation; infinite where the model diverged."""
        if not trajectory.is_finite:
            return Score(np.inf, np.inf, tuple(np.inf for _ in self.soft))
        violations = tuple(limit.violation(trajectory) for limit in self.soft)
        penalty = sum(limit.penalty.of(each) for limit, each in zip(self.soft, violations, strict=True))
        return Score(sum(term.value(trajectory) for term in self.terms), penalty, violations)

    def missed_clearance(self, score: Score) -> float:
        """Largest distance by which the margin to an obstacle is missed [m]."""
        return self._missed(score, ObstacleLimit)

    def off_road(self, score: Score) -> float:
        """Largest distance by which the margin to an edge of the road is missed [m]."""
        return self._missed(score, RoadEdge)

    def _missed(self, score: Score, kind: type[ObstacleLimit] | type[RoadEdge]) -> float:
        missed = zip(self.soft, score.violations, strict=True)
        return max((limit.penalty.missed(each) for limit, each in missed if isinstance(limit, kind)), default=0.0)

    def active(self, solution: Solution) -> tuple[str, ...]:
        """The names of the soft limits, each known by its slack, that have a row with a multiplier."""
        rows = np.abs(solution.row_multipliers) > ACTIVE
        n = self.box.blocking.n
        slacks = solution.problem.rows[rows, n : n + len(self.soft)] != 0
        return tuple(limit.name for limit, held in zip(self.soft, slacks.any(axis=0), strict=True) if held)

    def convex(self, trajectory: Trajectory, sensitivities: Sensitivities, trust: Array) -> Problem:
        """The quadratic program about a trajectory, for changes within `trust` (5,) [rad, N, N, N, N]."""
        return self.labelled(trajectory, sensitivities, trust)[0]

    def labelled(self, trajectory: Trajectory, sensitivities: Sensitivities, trust: Array) -> tuple[Problem, Indices]:
        """The same, with labels (m,) by which its rows are known again in a later program of the same way."""
        n, slacks = self.box.blocking.n, self._slacks
        n_slacks = len(slacks)
        hessian, gradient = np.zeros((n + n_slacks, n + n_slacks)), np.zeros(n + n_slacks)
        for term in self.terms:
            model = term.quadratic(trajectory, sensitivities)
            hessian[:n, :n] += model.hessian
            gradient[:n] += model.gradient
        for i, slack in enumerate(slacks, start=n):
            hessian[i, i], gradient[i] = 2 * slack.quadratic, slack.linear
        rows = self._rows(trajectory, sensitivities)
        lower, upper = self.box.bounds(trajectory, trust)
        problem = Problem(
            hessian=hessian,
            gradient=gradient,
            lower=np.concatenate([lower, np.zeros(n_slacks)]),
            upper=np.concatenate([upper, [slack.largest for slack in slacks]]),
            rows=rows.matrix,
            row_lower=rows.lower,
            row_upper=rows.upper,
        )
        return problem, rows.labels

    @property
    def _slacks(self) -> list["_Slack"]:
        """One for each soft limit, then one for each that has a comfort."""
        penalties = [limit.penalty for limit in self.soft]
        faults = [_Slack(i, each.linear, each.quadratic, np.inf) for i, each in enumerate(penalties)]
        comforts = [_Slack(i, each.comfort_price, SMALL, each.comfort) for i, each in enumerate(penalties)]
        return faults + [slack for slack in comforts if slack.largest > 0]

    def _rows(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Rows:
        """All rows over (z, s); a soft one holds from below with its slacks added, from above with them taken away."""
        hard = [limit.rows(trajectory, sensitivities) for limit in self.hard]
        soft = [_one_sided(limit.rows(trajectory, sensitivities)) for limit in self.soft]
        parts = hard + [part for pair in soft for part in pair]
        n, slacks = self.box.blocking.n, self._slacks
        matrix = np.zeros((sum(len(part.lower) for part in parts), n + len(slacks)))
        np.concatenate([part.matrix for part in parts], out=matrix[:, :n])
        row = sum(len(part.lower) for part in hard)
        for i, pair in enumerate(soft):
            comforts = [n + j for j, slack in enumerate(slacks) if slack.limit == i and j >= len(soft)]
            for part, sign in zip(pair, (1.0, -1.0), strict=True):
                of_part = slice(row, row + len(part.lower))
                matrix[of_part, n + i] = sign if part.weight is None else sign * part.weight
                matrix[of_part, comforts] = sign
                row = of_part.stop
        return Rows(
            matrix,
            np.concatenate([part.lower for part in parts]),
            np.concatenate([part.upper for part in parts]),
            places=np.concatenate([MOST_PLACES * i + part.labels for i, part in enumerate(parts)]),
        )


class _Slack(NamedTuple):
    """A slack of the soft limit with this index: its price, linear and quadratic, and its largest value."""

    limit: int
    linear: float
    quadratic: float
    largest: float


def _one_sided(rows: Rows) -> tuple[Rows, Rows]:
    """The rows that hold from below, and those that hold from above; a side that is infinite is left out."""
    below, above = np.isfinite(rows.lower), np.isfinite(rows.upper)
    of_below, of_above = (None if rows.weight is None else rows.weight[side] for side in (below, above))
    labels = rows.labels
    n_below, n_above = np.count_nonzero(below), np.count_nonzero(above)
    return (
        Rows(rows.matrix[below], rows.lower[below], np.full(n_below, np.inf), of_below, labels[below]),
        Rows(rows.matrix[above], np.full(n_above, -np.inf), rows.upper[above], of_above, labels[above]),
    )
