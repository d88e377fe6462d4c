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
        lanes_oncoming: how many of the lanes to the left, outermost first, carry traffic that comes towards it.

    Raises:
        ValueError: a width that is not positive and finite, a negative number of lanes, or more oncoming lanes than
            there are to the left.
    """

    lane_width: float | None = None
    lanes_left: int = 1
    lanes_right: int = 0
    lanes_oncoming: int = 0

    def __post_init__(self) -> None:
        if self.lane_width is not None and not (math.isfinite(self.lane_width) and self.lane_width > 0):
            raise ValueError(f"lane_width must be positive and finite, got {self.lane_width}")
        for name in ("lanes_left", "lanes_right", "lanes_oncoming"):
            if getattr(self, name) < 0:
                raise ValueError(f"{name} must not be negative, got {getattr(self, name)}")
        if self.lanes_oncoming > self.lanes_left:
            raise ValueError(f"lanes_oncoming must be at most lanes_left, {self.lanes_left}, got {self.lanes_oncoming}")

    @property
    def left_edge(self) -> float | None:
        """Y of the left edge [m], None without a lane width."""
        return None if self.lane_width is None else (self.lanes_left + 0.5) * self.lane_width

    @property
    def right_edge(self) -> float | None:
        """Y of the right edge [m], None without a lane width."""
        return None if self.lane_width is None else -(self.lanes_right + 0.5) * self.lane_width

    @property
    def oncoming_edge(self) -> float | None:
        """Y of the line between the lanes of both directions [m], None without a lane width or oncoming lanes."""
        if self.lane_width is None or self.lanes_oncoming == 0:
            return None
        return (self.lanes_left - self.lanes_oncoming + 0.5) * self.lane_width

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
        return (_leftmost(footprint, pose) <= self.left_edge) & (_rightmost(footprint, pose) >= self.right_edge)

    def is_oncoming(self, footprint: Footprint, poses: ArrayLike) -> NDArray[np.bool_]:
        """Whether any part of the footprint is beyond the oncoming edge.

        Args:
            footprint: in its body frame.
            poses: (n, 3) of X [m], Y [m], psi [rad].

        Returns:
            (n,) of bool; all false where there are no oncoming lanes.
        """
        pose = np.asarray(poses, dtype=float)
        if self.oncoming_edge is None:
            return np.zeros(len(pose), dtype=bool)
        return _leftmost(footprint, pose) > self.oncoming_edge


def _leftmost(footprint: Footprint, poses: NDArray[np.float64]) -> NDArray[np.float64]:
    """Largest Y of the footprint at each pose, (n,) [m]."""
    return poses[:, 1] + footprint.support(_leftwards(poses))


def _rightmost(footprint: Footprint, poses: NDArray[np.float64]) -> NDArray[np.float64]:
    """Smallest Y of the footprint at each pose, (n,) [m]."""
    return poses[:, 1] - footprint.support(-_leftwards(poses))


def _leftwards(poses: NDArray[np.float64]) -> NDArray[np.float64]:
    """The world's Y axis as the body sees it at each pose, (n, 2)."""
    return np.column_stack((np.sin(poses[:, 2]), np.cos(poses[:, 2])))
