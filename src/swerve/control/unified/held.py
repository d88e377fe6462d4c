"""What held a plan: the multipliers of one program of a way, from which the solver of the next one begins.

Rows come and go as the trajectory moves, so each is known by a label. Half of a solver's work is to find out what
holds; most of that is the same from one iteration to the next, and from one sample to the next.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.qp import Solution, WarmStart


@dataclass(frozen=True, eq=False)
class Held:
    """Multipliers of bounds (n,) and, by their labels, of those rows that held."""

    bounds: NDArray[np.float64]
    rows: dict[int, float]

    @classmethod
    def by(cls, solution: Solution, labels: NDArray[np.intp]) -> "Held":
        """What holds a solution, the rows of which have labels (m,)."""
        holding = np.flatnonzero(solution.row_multipliers)
        multipliers = solution.row_multipliers[holding].tolist()
        return cls(solution.bound_multipliers, dict(zip(labels[holding].tolist(), multipliers, strict=True)))

    def start(self, n: int, labels: NDArray[np.intp]) -> WarmStart:
        """For a program with n variables and rows with labels (m,), whatever it has in common with this one."""
        bounds = self.bounds if len(self.bounds) == n else np.zeros(n)
        return WarmStart(bounds, np.array([self.rows.get(label, 0.0) for label in labels.tolist()]))
