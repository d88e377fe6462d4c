"""What a limit is: linear rows about a trajectory; a soft one has a slack whose price is linear and quadratic."""

from abc import abstractmethod
from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.prediction import Trajectory

Array = NDArray[np.float64]


class Rows(NamedTuple):
    """lower <= matrix z <= upper for scaled changes z (n,): shapes (m, n), (m,), (m,); unit of the limit."""

    matrix: Array
    lower: Array
    upper: Array


@dataclass(frozen=True)
class Penalty:
    """Price of a violation v: linear v + quadratic v^2. A linear part that is large enough makes it exact."""

    linear: float
    quadratic: float

    def of(self, violation: float) -> float:
        """The price [1]."""
        return (self.linear + self.quadratic * violation) * violation


class HardLimit(Protocol):
    """A limit that every plan keeps."""

    @abstractmethod
    def clip(self, inputs: Array) -> Array:
        """Inputs (Np, 5) as the limit lets them through; those that keep it unchanged."""

    @abstractmethod
    def rows(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Rows:
        """Its linearisation about a trajectory."""


class SoftLimit(Protocol):
    """A limit whose rows share one slack: the largest violation is what costs."""

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
