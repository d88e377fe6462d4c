"""Lines that separate the footprint from an obstacle, passed in a given way, so that nothing cuts between two poses.

A point and an ellipse that takes several poses to pass: one tangent a pose (`tangents.py`), for poses that are close to
each other. Rectangles, and what one step could leap over: one line for each pair of neighbouring poses, both behind it,
so that the straight motion between them is too (`lines.py`).

A line for passing on the left never pushes to the right: n_Y >= 0 in world axes; n_Y = 0 says stay behind or ahead.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Passing
from swerve.control.unified.lines import Lines
from swerve.control.unified.tangents import Tangents
from swerve.world import Ellipse, Footprint, Point, Shape

Array = NDArray[np.float64]


class Planes(NamedTuple):
    """Half-planes, each for one pose: normal . (pose - obstacle's centre) - reaches of both >= margin.

    Attributes:
        normal: (k, 2) unit vectors from obstacle to footprint, in world axes, for each pose but the first.
        gap: (k,) left side of the inequality [m].
        turning: (k,) derivative of the gap by the pose's psi [m/rad].
    """

    normal: Array
    gap: Array
    turning: Array


class Separation:
    """The half-planes between one footprint and obstacles of any shape."""

    def __init__(self, footprint: Footprint, n_poses: int, n_fine: int) -> None:
        """For sequences of `n_poses` poses, of which the first `n_fine` are close enough for tangents."""
        self._lines = Lines(footprint, n_poses - 1)
        self._tangents = Tangents(n_poses, n_fine) if isinstance(footprint, Point) else None

    def planes(self, shape: Shape, heading: float, poses: Array, passing: Passing) -> Planes:
        """The half-planes for a sequence of poses.

        Args:
            shape: of the obstacle.
            heading: of its x axis [rad].
            poses: (n_poses, 3) of the footprint's origin from the obstacle's centre at that time, in world axes [m],
                and psi [rad].
            passing: how the obstacle is passed.
        """
        if self._tangents is not None and isinstance(shape, Ellipse) and passing is not Passing.BEHIND:
            found = self._tangents.along(shape, heading, poses, passing)
            if found is not None:
                normal, gap = found
                return Planes(normal, gap, np.zeros(len(gap)))
        normals, gaps, turnings = self._lines.between(shape, heading, poses, passing.value)
        return _nearer(Planes(normals, gaps[:, 1], turnings[:, 1]), Planes(normals[1:], gaps[1:, 0], turnings[1:, 0]))


def _nearer(later: Planes, earlier: Planes) -> Planes:
    """Of the two lines that a pose has, as the later one of its pair and as the earlier of the next, the nearer one.

    The very first pose is measured: it can't be moved and has none. The last one is no earlier one.
    """
    which = np.flatnonzero(earlier.gap < later.gap[:-1])
    normal, gap, turning = (np.array(each) for each in later)
    normal[which], gap[which], turning[which] = earlier.normal[which], earlier.gap[which], earlier.turning[which]
    return Planes(normal, gap, turning)
