"""What has been true so far, on the plant's time grid: what a delayed sensor can look back at."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Truth:
    """The vehicle at one instant.

    Attributes:
        vehicle: (6,) state [vx vy r psi X Y].
        wheel_loads: (4,) [N].
        acceleration: (2,) ax, ay of the centre of gravity in body axes [m/s^2].
    """

    vehicle: Array
    wheel_loads: Array
    acceleration: Array


class Past:
    """The truth from time zero on; it grows by one controller sample at a time."""

    def __init__(self, step: float, n_substeps: int, start: Truth) -> None:
        """Rows are `step` [s] apart, `n_substeps` of them in a sample; `start` is the truth at time zero."""
        self._step, self._n = step, n_substeps
        self._samples: list[tuple[Array, Array, Array]] = []
        self._now = start

    def grow(self, vehicle: Array, wheel_loads: Array, acceleration: Array, now: Truth) -> None:
        """One more sample: rows (n, 6), (n, 4), (n, 2), each at the start of its step, and the truth at its end."""
        self._samples.append((vehicle, wheel_loads, acceleration))
        self._now = now

    def at(self, time: float) -> Truth:
        """The truth at `time` [s], to the nearest step; at time zero for what was before it."""
        sample, row = divmod(max(0, round(time / self._step)), self._n)
        if sample >= len(self._samples):
            return self._now
        vehicle, wheel_loads, acceleration = self._samples[sample]
        return Truth(vehicle[row], wheel_loads[row], acceleration[row])
