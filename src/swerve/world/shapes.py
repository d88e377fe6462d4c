"""Convex shapes in their own body frame: x forward, y to the left [m].

A shape K is known by its support function, h(n) = max over p in K of n . p, which for a unit normal n is how far the
shape reaches in the direction n. Half-planes, road edges and bounding boxes all follow from it.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

OUTLINE_VERTICES = 64  # on a curved outline, enough for a drawing


def _require_lengths(name: str, lengths: Sequence[float]) -> None:
    if len(lengths) == 0 or not all(math.isfinite(length) and length > 0 for length in lengths):
        raise ValueError(f"{name} must be positive and finite, got {lengths}")


@dataclass(frozen=True)
class Point:
    """The origin of the body frame and nothing else."""

    def support(self, directions: ArrayLike) -> NDArray[np.float64]:
        """Support function [m], shape (n,): zero for each of the (n, 2) unit directions."""
        return np.zeros(np.asarray(directions, dtype=float).shape[:-1])

    def outline(self, n_vertices: int = OUTLINE_VERTICES) -> NDArray[np.float64]:
        """The single vertex [m], shape (1, 2); `n_vertices` concerns curved shapes only."""
        return np.zeros((1, 2))


@dataclass(frozen=True)
class Rectangle:
    """A box along the body axes.

    Attributes:
        length: along x [m].
        width: along y [m].
        centre: of the box in the body frame [m]; a car's centre of gravity is seldom the centre of its box.

    Raises:
        ValueError: a length or width that is not positive and finite, or a centre that is not finite.
    """

    length: float
    width: float
    centre: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        _require_lengths("length and width", (self.length, self.width))
        if not all(map(math.isfinite, self.centre)):
            raise ValueError(f"centre must be finite, got {self.centre}")

    def support(self, directions: ArrayLike) -> NDArray[np.float64]:
        """Support function [m], shape (n,), for (n, 2) unit directions in the body frame."""
        n = np.asarray(directions, dtype=float)
        half = np.array([self.length, self.width]) / 2
        reach: NDArray[np.float64] = np.abs(n) @ half + n @ np.asarray(self.centre)
        return reach

    def outline(self, n_vertices: int = OUTLINE_VERTICES) -> NDArray[np.float64]:
        """The four corners [m], shape (4, 2), anticlockwise; `n_vertices` concerns curved shapes only."""
        signs = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]])
        corners: NDArray[np.float64] = signs * (self.length / 2, self.width / 2) + np.asarray(self.centre)
        return corners


@dataclass(frozen=True)
class Ellipse:
    """An ellipse about the origin, (x / a)^2 + (y / b)^2 <= 1: the obstacle of eq. (5).

    Attributes:
        semi_axes: (a, b) along x and along y [m].

    Raises:
        ValueError: a semi-axis that is not positive and finite.
    """

    semi_axes: tuple[float, float]

    def __post_init__(self) -> None:
        _require_lengths("semi_axes", self.semi_axes)

    def support(self, directions: ArrayLike) -> NDArray[np.float64]:
        """Support function sqrt((a n_x)^2 + (b n_y)^2) [m], shape (n,), for (n, 2) unit directions."""
        scaled = np.asarray(directions, dtype=float) * self.semi_axes
        return np.hypot(scaled[..., 0], scaled[..., 1])

    def outline(self, n_vertices: int = OUTLINE_VERTICES) -> NDArray[np.float64]:
        """Points on the ellipse [m], shape (n_vertices, 2), anticlockwise from (a, 0)."""
        angle = np.linspace(0.0, 2 * np.pi, n_vertices, endpoint=False)
        points: NDArray[np.float64] = np.column_stack((np.cos(angle), np.sin(angle))) * self.semi_axes
        return points


Shape = Point | Rectangle | Ellipse
Footprint = Point | Rectangle  # what the ego vehicle covers
