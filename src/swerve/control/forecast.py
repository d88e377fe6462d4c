"""What the controller expects of an obstacle, from its measured positions and velocities alone.

Its acceleration is what its velocity changed by since the last step, smoothed; it is expected to last until that
component of the velocity is zero, or, where it speeds up, for LASTING. The truth may go on otherwise.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.signals import Observation
from swerve.world import Shape

Array = NDArray[np.float64]

LASTING = 1.0  # [s] that a growing speed is expected to go on growing
NOVELTY = 0.5  # [1] share of a newly seen acceleration that is believed
LARGEST = 12.0  # [m/s^2] more than any vehicle does
AT_ONCE = 1e-3  # [s] two measurements no further apart tell no acceleration


@dataclass(frozen=True, eq=False)
class Forecast:
    """An obstacle from the instant of its measurement on.

    Attributes:
        shape: in its own body frame.
        heading: held [rad].
        stamp: when it was measured [s].
        position: (2,) then, in world axes [m].
        velocity: (2,) then [m/s].
        acceleration: (2,) as estimated [m/s^2].
    """

    shape: Shape
    heading: float
    stamp: float
    position: Array
    velocity: Array
    acceleration: Array

    def position_at(self, times: Array) -> Array:
        """Positions (n, 2) [m] at times (n,) on the controller's clock [s]."""
        elapsed = (times - self.stamp)[:, np.newaxis]
        changing = self._changing(elapsed)
        gained: Array = self.position + self.velocity * elapsed
        return gained + self.acceleration * changing * (elapsed - changing / 2)

    def velocity_at(self, times: Array) -> Array:
        """Velocities (n, 2) [m/s] at times (n,) on the controller's clock [s]."""
        elapsed = (times - self.stamp)[:, np.newaxis]
        velocity: Array = self.velocity + self.acceleration * self._changing(elapsed)
        return velocity

    def _changing(self, elapsed: Array) -> Array:
        """For how much of the elapsed time (n, 1) each component of the velocity changes, (n, 2) [s]."""
        slows = self.velocity * self.acceleration < 0
        lasting = np.full(2, LASTING)
        lasting[slows] = -self.velocity[slows] / self.acceleration[slows]
        changing: Array = np.minimum(elapsed, lasting)
        return changing


def forecasts(stamp: float, seen: Sequence[Observation], before: Sequence[Forecast]) -> tuple[Forecast, ...]:
    """A forecast for each observation; `before` are those of the last step, none where their number was another."""
    known = list(before) if len(before) == len(seen) else [None] * len(seen)
    return tuple(_forecast(stamp, each, last) for each, last in zip(seen, known, strict=True))


def _forecast(stamp: float, seen: Observation, last: Forecast | None) -> Forecast:
    velocity, acceleration = np.array(seen.velocity), np.zeros(2)
    if last is not None:
        acceleration, since = last.acceleration, stamp - last.stamp
        if since > AT_ONCE:
            sudden = np.clip((velocity - last.velocity) / since, -LARGEST, LARGEST)
            acceleration = acceleration + NOVELTY * (sudden - acceleration)
    return Forecast(seen.shape, seen.heading, stamp, np.array(seen.position), velocity, acceleration)
