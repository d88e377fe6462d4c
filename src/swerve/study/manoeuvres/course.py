"""The course of ISO 3888-2: three lanes of cones, the middle one to the left, and whether a car hits any of them.

    section     1              2      3         4      5
    length [m]  12             13.5   11        12.5   12
    width [m]   1.1 b + 0.25   -      b + 1     -      1.3 b + 0.25, or as given

b is the car's width. The right edge of section 3 is 1 m left of the left edge of section 1; sections 1 and 5 share
their right edge. X is along the course from its entry, Y = 0 in the middle of section 1.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.study.manoeuvres.path import LanePath
from swerve.vehicle import Vehicle

Array = NDArray[np.float64]

LENGTHS: Final = (12.0, 13.5, 11.0, 12.5, 12.0)  # [m]
OFFSET: Final = 1.0  # between the lanes' edges [m]
MOST_BETWEEN: Final = 3.0  # two cones of an edge [m]


@dataclass(frozen=True)
class Lane:
    """A section with cones on both sides [m]."""

    start: float
    end: float
    right: float
    left: float

    @property
    def middle(self) -> float:
        """Y of its middle [m]."""
        return (self.left + self.right) / 2

    def cones(self) -> Array:
        """Where the cones touch the lane, both ends and evenly between: (n, 2) [m]."""
        n = int(np.ceil((self.end - self.start) / MOST_BETWEEN)) + 1
        x = np.linspace(self.start, self.end, n)
        return np.concatenate([np.column_stack([x, np.full(n, y)]) for y in (self.right, self.left)])


@dataclass(frozen=True)
class Course:
    """The three lanes, in the order in which they are driven."""

    lanes: tuple[Lane, Lane, Lane]

    @classmethod
    def iso_3888_2(cls, width: float, exit_width: float | None = None) -> "Course":
        """For a car of `width` [m]; `exit_width` is that of section 5 [m] in place of 1.3 b + 0.25."""
        x = np.concatenate([[0.0], np.cumsum(LENGTHS)]).tolist()
        right = -(1.1 * width + 0.25) / 2
        aside = -right + OFFSET
        last = 1.3 * width + 0.25 if exit_width is None else exit_width
        return cls(
            (
                Lane(x[0], x[1], right, -right),
                Lane(x[2], x[3], aside, aside + width + 1.0),
                Lane(x[4], x[5], right, right + last),
            )
        )

    @property
    def end(self) -> float:
        """X of the exit [m]."""
        return self.lanes[-1].end

    def path(self) -> LanePath:
        """The middles of the lanes, joined."""
        return LanePath(tuple((lane.start, lane.end, lane.middle) for lane in self.lanes))

    def cones(self) -> Array:
        """All of them, (n, 2) [m]."""
        return np.concatenate([lane.cones() for lane in self.lanes])

    def clearances(self, vehicle: Vehicle, poses: Array) -> Array:
        """How near the car's body comes to each cone over all poses (m, 3): (n,) [m], below zero in its inside."""
        cones, nearest = self.cones(), []
        cos, sin = np.cos(poses[:, 2]), np.sin(poses[:, 2])
        middle = vehicle.cg_to_front_end - vehicle.length / 2
        for cone in cones:
            dx, dy = cone[0] - poses[:, 0], cone[1] - poses[:, 1]
            ahead = np.abs(cos * dx + sin * dy - middle) - vehicle.length / 2
            aside = np.abs(cos * dy - sin * dx) - vehicle.width / 2
            outside = np.hypot(np.maximum(ahead, 0), np.maximum(aside, 0))
            nearest.append((outside + np.minimum(np.maximum(ahead, aside), 0)).min())
        return np.array(nearest)
