"""A driver whose input is known beforehand: piecewise linear over time, as a recording or as a test's script has it."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.signals import DriverInput

Array = NDArray[np.float64]
Series = Sequence[tuple[float, float]]

NOTHING: Series = ((0.0, 0.0),)


@dataclass(frozen=True)
class DriverSeries:
    """Inputs at instants, in the order of time; between two of them linear, before the first and after the last held.

    Attributes:
        steering: (time [s], road-wheel angle [rad]) each.
        force: (time [s], demand of longitudinal force, all wheels together [N]) each.
    """

    steering: Series = NOTHING
    force: Series = NOTHING

    def __call__(self, time: float, state: Array) -> DriverInput:
        """The input at `time` [s], whatever the vehicle state (6,)."""
        return DriverInput(_at(time, self.steering), _at(time, self.force))


def _at(time: float, series: Series) -> float:
    return float(np.interp(time, [instant for instant, _ in series], [value for _, value in series]))
