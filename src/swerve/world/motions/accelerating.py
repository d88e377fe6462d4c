"""Constant velocity, then constant acceleration up to a speed, and that speed from then on: a car that brakes.

    v(t) = v_0 + a clip(t - t_a, 0, T),        T = (v_f - |v_0|) / (a . u),        u = v_0 / |v_0|

The acceleration may have any direction; it ends when the velocity's component along the initial one is v_f. One that
brakes ends at v_f = 0 unless told otherwise, and so never reverses; one that speeds up never ends unless told so. From
rest, u is the direction of the acceleration.
"""

from dataclasses import dataclass
from math import hypot, inf

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swerve.world.motions.motion import Pair, require_finite


@dataclass(frozen=True)
class Accelerating:
    """A motion that changes its velocity once.

    Attributes:
        position: at time zero [m].
        velocity: v_0 in world axes, until it accelerates [m/s].
        heading: of the body's x axis from the world's X axis, anticlockwise, constant [rad].
        acceleration: a in world axes [m/s^2].
        accelerates_at: t_a, when the acceleration begins [s].
        final_speed: v_f along the initial velocity, at which it ends; None: 0 where it brakes, else no end [m/s].

    Raises:
        ValueError: a number that is not finite, or a final speed that the acceleration never reaches.
    """

    position: Pair
    velocity: Pair
    heading: float
    acceleration: Pair
    accelerates_at: float = 0.0
    final_speed: float | None = None

    def __post_init__(self) -> None:
        for name in ("position", "velocity", "acceleration"):
            require_finite(name, getattr(self, name))
        for name in ("heading", "accelerates_at"):
            require_finite(name, (getattr(self, name),))
        if self.final_speed is not None:
            require_finite("final_speed", (self.final_speed,))
            if (self.final_speed - hypot(*self.velocity)) * self._along <= 0:
                speeds = f"{hypot(*self.velocity):g} m/s at {self._along:+g} m/s^2 along its direction"
                raise ValueError(f"final_speed of {self.final_speed:g} m/s is never reached from {speeds}")

    @property
    def duration(self) -> float:
        """T, how long it accelerates; infinite where it never ends [s]."""
        if self.final_speed is None and self._along >= 0:
            return inf
        return ((self.final_speed or 0.0) - hypot(*self.velocity)) / self._along

    def position_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """Position (..., 2) [m] at times (...) [s]."""
        time, lasted = np.asarray(times, dtype=float), self._lasted(times)
        coasted = time[..., np.newaxis] * np.asarray(self.velocity)
        # by the acceleration: a s^2 / 2 while it lasts, then a s for each second after it
        after = np.maximum(time - self.accelerates_at, 0.0) - lasted
        gained = (lasted * (lasted / 2 + after))[..., np.newaxis] * np.asarray(self.acceleration)
        position: NDArray[np.float64] = np.asarray(self.position) + coasted + gained
        return position

    def velocity_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """Velocity (..., 2) [m/s] at times (...) [s]."""
        gained = self._lasted(times)[..., np.newaxis] * np.asarray(self.acceleration)
        velocity: NDArray[np.float64] = np.asarray(self.velocity) + gained
        return velocity

    def heading_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """The heading (...) [rad], the same at all times (...) [s]."""
        return np.full(np.shape(times), self.heading, dtype=float)

    @property
    def _along(self) -> float:
        """The acceleration's component a . u [m/s^2]."""
        speed = hypot(*self.velocity)
        if speed == 0:
            return hypot(*self.acceleration)
        return sum(a * (v / speed) for a, v in zip(self.acceleration, self.velocity, strict=True))

    def _lasted(self, times: ArrayLike) -> NDArray[np.float64]:
        """For how long it has accelerated (...) [s] at times (...) [s]."""
        lasted: NDArray[np.float64] = np.clip(np.asarray(times, dtype=float) - self.accelerates_at, 0.0, self.duration)
        return lasted
