"""A straight road along X: the edges that a lane's width and the lanes beside it imply.

The ego vehicle's own lane has its middle at Y = 0.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swerve.world.shapes import Footprint


@dataclass(frozen=True)
class Road:
    """Lanes of one width; without a width the road has no edges.

    Attributes:
        lane_width: of every lane [m]; None for a surface without edges.
        lanes_left: number of lanes to the left of the ego vehicle's own.
        lanes_right: number of lanes to the right of it.

    Raises:
        ValueError: a width that is not positive and finite, or a negative number of lanes.
    """

    lane_width: float | None = None
    lanes_left: int = 1
    lanes_right: int = 0

    def __post_init__(self) -> None:
        if self.lane_width is not None and not (math.isfinite(self.lane_width) and self.lane_width > 0):
            raise ValueError(f"lane_width must be positive and finite, got {self.lane_width}")
        for name, lanes in (("lanes_left", self.lanes_left), ("lanes_right", self.lanes_right)):
            if lanes < 0:
                raise ValueError(f"{name} must not be negative, got {lanes}")

    @property
    def left_edge(self) -> float | None:
        """Y of the left edge [m], None without a lane width."""
        return None if self.lane_width is None else (self.lanes_left + 0.5) * self.lane_width

    @property
    def right_edge(self) -> float | None:
        """Y of the right edge [m], None without a lane width."""
        return None if self.lane_width is None else -(self.lanes_right + 0.5) * self.lane_width

    def is_inside(self, footprint: Footprint, poses: ArrayLike) -> NDArray[np.bool_]:
        """Whether the whole footprint is between the edges, an edge included.

        Args:
            footprint: in its body frame.
            poses: (n, 3) of X [m], Y [m], psi [rad].

        Returns:
            (n,) of bool; all true where there are no edges.
        """
        pose = np.asarray(poses, dtype=float)
        if self.left_edge is None or self.right_edge is None:
            return np.ones(len(pose), dtype=bool)
        # the world's Y axis as the body sees it
        leftwards = np.column_stack((np.sin(pose[:, 2]), np.cos(pose[:, 2])))
        leftmost = pose[:, 1] + footprint.support(leftwards)
        rightmost = pose[:, 1] - footprint.support(-leftwards)
        return (leftmost <= self.left_edge) & (rightmost >= self.right_edge)
