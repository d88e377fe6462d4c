"""Through given places at given times: a cut-in, a cut-out, a vehicle that overtakes and comes towards us.

X and Y are each a piecewise cubic Hermite interpolant that keeps monotone data monotone (Fritsch and Butland 1984, SIAM
Journal on Scientific and Statistical Computing 5(2), as in scipy's PchipInterpolator): between two way-points neither
leaves the interval of their values, and two equal ones are a stretch without motion. The velocity is continuous. Before
the first way-point and after the last one it stays what it is there; what is to stop ends in the same place twice.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swerve.world.motions.motion import Pair, require_finite

AT_REST = 1e-6  # [m/s] slower than this a velocity has no direction
INSIDE = 1e-6  # [1] share of a stretch by which its end is avoided, where the velocity may be zero


@dataclass(frozen=True)
class AlongWaypoints:
    """A motion through way-points.

    Attributes:
        times: of the way-points, ascending, at least two [s].
        positions: at these times [m].
        heading: of the body's x axis, constant [rad]; None: along the velocity, at rest as it last was, before its
            first motion as it then will be, and 0 if it never moves.

    Raises:
        ValueError: fewer than two way-points, times that do not ascend, not one position for each, or a number that is
            not finite.
    """

    times: tuple[float, ...]
    positions: tuple[Pair, ...]
    heading: float | None = None

    def __post_init__(self) -> None:
        if len(self.times) < 2 or len(self.times) != len(self.positions):
            raise ValueError(f"times must be two or more, one a position, got {len(self.times)}, {len(self.positions)}")
        require_finite("times", self.times)
        require_finite("positions", [number for position in self.positions for number in position])
        if (np.diff(self.times) <= 0).any():
            raise ValueError(f"times must ascend, got {', '.join(f'{time:g}' for time in self.times)}")
        if self.heading is not None:
            require_finite("heading", (self.heading,))

    def position_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """Position (..., 2) [m] at times (...) [s]."""
        time = np.asarray(times, dtype=float)
        inside = np.clip(time, self.times[0], self.times[-1])
        beyond = (time - inside)[..., np.newaxis]
        position: NDArray[np.float64] = self._path(inside) + beyond * self._velocity(inside)
        return position

    def velocity_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """Velocity (..., 2) [m/s] at times (...) [s]."""
        velocity: NDArray[np.float64] = self._velocity(np.clip(times, self.times[0], self.times[-1]))
        return velocity

    def heading_at(self, times: ArrayLike) -> NDArray[np.float64]:
        """Heading (...) [rad] at times (...) [s]."""
        if self.heading is not None:
            return np.full(np.shape(times), self.heading, dtype=float)
        velocity = self.velocity_at(times)
        is_at_rest = np.hypot(velocity[..., 0], velocity[..., 1]) <= AT_REST
        if is_at_rest.any():
            moving = np.where(is_at_rest, self._last_moving(np.asarray(times, dtype=float)), times)
            velocity = self.velocity_at(moving)
        return np.arctan2(velocity[..., 1], velocity[..., 0])

    def _last_moving(self, times: NDArray[np.float64]) -> NDArray[np.float64]:
        """The last instants of motion before times (...), the first one for those before it [s]."""
        knots, places = np.asarray(self.times), np.asarray(self.positions)
        moving = np.flatnonzero((np.diff(places, axis=0) != 0).any(axis=1))
        if not len(moving):
            return times
        starts, ends = knots[moving], knots[moving + 1]
        stretch = np.maximum(np.searchsorted(starts, times) - 1, 0)
        margin = INSIDE * (ends - starts)
        return np.clip(times, (starts + margin)[stretch], (ends - margin)[stretch])

    @cached_property
    def _path(self) -> Any:
        from scipy.interpolate import PchipInterpolator  # as slow to import as all of swerve, and few obstacles need it

        with np.errstate(over="ignore"):  # the reciprocal of a slope of 1e-309 m/s, which then counts as 0
            return PchipInterpolator(self.times, self.positions, axis=0)

    @cached_property
    def _velocity(self) -> Any:
        return self._path.derivative()
