"""What a term of the cost is: a weighted sum of squares, known by its value and its Gauss-Newton model."""

from abc import abstractmethod
from typing import NamedTuple, Protocol

from numpy import float64
from numpy.typing import NDArray

from swerve.control.unified.condensing import Sensitivities
from swerve.control.unified.prediction import Trajectory


class Quadratic(NamedTuple):
    """Second-order model of a cost over scaled changes z (n,): value + gradient' z + 1/2 z' hessian z."""

    hessian: NDArray[float64]
    gradient: NDArray[float64]


class Term(Protocol):
    """A sum of squares r' r of residuals r that are affine in states and inputs."""

    @abstractmethod
    def value(self, trajectory: Trajectory) -> float:
        """r' r along a trajectory [1]."""

    @abstractmethod
    def quadratic(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Quadratic:
        """Gauss-Newton model about a trajectory: hessian 2 J' J, gradient 2 J' r."""
