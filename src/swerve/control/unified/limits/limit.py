"""What a limit is: linear rows about a trajectory; a soft one has a slack whose price is linear and quadratic."""

from abc import abstractmethod
from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.prediction import Trajectory

Array = NDArray[np.float64]
Indices = NDArray[np.intp]


MOST_ROWS = 40  # of one limit; a solver's time grows with their number, and few of them are ever active


class Rows(NamedTuple):
    """lower <= matrix z <= upper for scaled changes z (n,): shapes (m, n), (m,), (m,); unit of the limit.

    `weight` (m,) is how much of the slack for faults counts in each row; None for all of it. `places` (m,) say which
    pose, sample or input each row is about; None for one after the other.
    """

    matrix: Array
    lower: Array
    upper: Array
    weight: Array | None = None
    places: Indices | None = None

    @property
    def labels(self) -> Indices:
        """(m,) the places, or the rows' own numbers."""
        return np.arange(len(self.lower)) if self.places is None else self.places


def nearest(gap: Array, reach: float) -> Indices:
    """Indices of the gaps (k,) that are in reach, the MOST_ROWS smallest of them, in ascending order."""
    near = np.flatnonzero(gap < reach)
    if len(near) > MOST_ROWS:
        near = np.sort(near[np.argpartition(gap[near], MOST_ROWS)[:MOST_ROWS]])
    return near


@dataclass(frozen=True)
class Penalty:
    """Price of a violation v: that of comfort for the first part of it, then linear and quadratic.

    A linear part that is large enough makes it exact.

    Attributes:
        linear: [1/unit] of what is beyond the comfort.
        quadratic: [1/unit^2] of the same.
        comfort: size of the first part, to miss which is no fault [unit].
        comfort_price: [1/unit] of it, less than `linear`.
    """

    linear: float
    quadratic: float
    comfort: float = 0.0
    comfort_price: float = 0.0

    def of(self, violation: float) -> float:
        """The price [1]."""
        missed = self.missed(violation)
        return self.comfort_price * (violation - missed) + (self.linear + self.quadratic * missed) * missed

    def missed(self, violation: float) -> float:
        """What is beyond the comfort [unit]."""
        return max(0.0, violation - self.comfort)


class HardLimit(Protocol):
    """A limit that every plan keeps."""

    @abstractmethod
    def clip(self, inputs: Array) -> Array:
        """Inputs (Np, 5) as the limit lets them through; those that keep it unchanged."""

    @abstractmethod
    def rows(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Rows:
        """Its linearisation about a trajectory."""


class SoftLimit(Protocol):
    """A limit whose rows share their slack: the largest violation is what costs."""

    @property
    @abstractmethod
    def name(self) -> str:
        """As `Plan.active` says it."""

    @property
    @abstractmethod
    def penalty(self) -> Penalty:
        """Price of the slack."""

    @abstractmethod
    def violation(self, trajectory: Trajectory) -> float:
        """Largest violation along a trajectory, at least 0 [unit of the limit]."""

    @abstractmethod
    def rows(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Rows:
        """Its linearisation about a trajectory, without the slack."""
