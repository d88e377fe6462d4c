"""What the decision hands to the tracker: a path and a speed profile, with a name."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.hierarchical.quintic import Quintic
from swerve.control.path import Path
from swerve.control.plan import Side

Array = NDArray[np.float64]

STEP = 0.5  # [m] between two poses of a path


@dataclass(frozen=True, eq=False)
class Manoeuvre:
    """One manoeuvre.

    Attributes:
        name: "keep", "brake", "left" or "right".
        lateral: the path.
        speed: towards which the vehicle goes [m/s].
        rate: at which its speed changes, at least 0 [m/s^2].
        reason: why it is decided on, a sentence.
    """

    name: str
    lateral: Quintic
    speed: float
    rate: float
    reason: str

    @property
    def side(self) -> Side | None:
        """The side to which it swerves, None for keeping the lane and braking."""
        return {"left": Side.LEFT, "right": Side.RIGHT}.get(self.name)

    def path(self, x: float, reach: float) -> Path:
        """The path from `x` on, over `reach` along the road [m]."""
        along = x + np.arange(0.0, reach + STEP, STEP)
        y, slope, _ = self.lateral.at(along)
        lengths = np.append(0.0, np.cumsum(np.hypot(np.diff(along), np.diff(y))))
        return Path(lengths, np.column_stack([along, y, np.arctan(slope)]))

    def speeds(self, now: float, times: Array) -> Array:
        """The speed profile (n,) at times (n,) [s] from the speed `now` on [m/s]."""
        change = np.clip(self.speed - now, -self.rate * times, self.rate * times)
        return np.asarray(now + change)
