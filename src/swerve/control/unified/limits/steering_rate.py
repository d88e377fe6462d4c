"""The steering angle changes no faster than the actuator can: | delta(k+j) - delta(k+j-1) | <= rate Ts."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.unified.condensing import INPUT_SCALE, Blocking, Sensitivities
from swerve.control.unified.limits.limit import Rows
from swerve.control.unified.prediction import Trajectory
from swerve.conventions import DELTA, N_INPUTS

Array = NDArray[np.float64]


@dataclass(frozen=True)
class SteeringRateLimit:
    """The limit for one actuator, where it is free.

    Attributes:
        largest_change: rate limit times sample time [rad].
        previous: steering angle that acts now [rad].
        blocking: of the free inputs.
    """

    largest_change: float
    previous: float
    blocking: Blocking

    def clip(self, inputs: Array) -> Array:
        """Each steering angle as far towards its own value as the rate lets it go."""
        clipped, reached = inputs.copy(), self.previous
        for k, wanted in enumerate(inputs[:, DELTA]):
            reached += min(max(wanted - reached, -self.largest_change), self.largest_change)
            clipped[k, DELTA] = reached
        return clipped

    def rows(self, trajectory: Trajectory, sensitivities: Sensitivities) -> Rows:
        """One row a free input, in units of the scaled steering angle."""
        steering = self.blocking.free(trajectory.inputs)[:, DELTA]
        change = np.diff(steering, prepend=self.previous) / INPUT_SCALE[DELTA]
        steps = self.blocking.embedding()[DELTA::N_INPUTS]
        matrix = np.diff(steps, axis=0, prepend=0)
        limit = self.largest_change / INPUT_SCALE[DELTA]
        return Rows(matrix, -limit - change, limit - change)
