"""Footprint and obstacles as pairs of a disc and an ellipse, which is what the program can keep apart smoothly.

A rectangle is covered by N_DISCS equal discs along its longer side; with pieces of half-length p and a half-width w
each has the radius sqrt(p^2 + w^2), so a cover of 4.85 m x 1.8 m stands out by 0.19 m at the side and 0.48 m at the
ends. A disc of radius r keeps off an ellipse (a, b) when its centre keeps off the ellipse (a + r, b + r), blown up by
as much as that lies inside the true offset curve:

    k = max over n of (sqrt((a nx)^2 + (b ny)^2) + r) / sqrt(((a + r) nx)^2 + ((b + r) ny)^2)
"""

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from swerve.world import Ellipse, Footprint, Obstacle, Point, Shape

Array = NDArray[np.float64]

N_DISCS = 4  # of a rectangle
N_DIRECTIONS = 181  # tried for k, a quarter turn; the largest between two of them is 1e-5 larger at most
SMALLEST = 1e-3  # [m] radius that stands for an obstacle without extent


@dataclass(frozen=True)
class Pair:
    """An ellipse that a point of the ego vehicle must not enter.

    Attributes:
        offset: of the point in the ego vehicle's body frame [m].
        centre: of the ellipse where it is now [m].
        velocity: of it [m/s].
        semi_axes: of it [m].
        heading: of it [rad].
    """

    offset: tuple[float, float]
    centre: tuple[float, float]
    velocity: tuple[float, float]
    semi_axes: tuple[float, float]
    heading: float

    def as_tuple(self) -> tuple[float, ...]:
        """The numbers in the order that the program's data have."""
        return (*self.offset, *self.centre, *self.velocity, *self.semi_axes, self.heading)


def n_parts(shape: Shape) -> int:
    """How many discs or ellipses stand for a shape."""
    return 1 if isinstance(shape, Ellipse | Point) else N_DISCS


def pairs(footprint: Footprint, obstacle: Obstacle) -> list[Pair]:
    """All pairs between a footprint and an obstacle as it is at its time zero."""
    heading, position = float(obstacle.heading_at(0.0)), obstacle.position_at(0.0)
    vx, vy = obstacle.velocity_at(0.0).tolist()
    cos, sin = np.cos(heading), np.sin(heading)
    found = []
    for offset, radius in _discs(footprint):
        for (x, y), semi_axes in _ellipses(obstacle.shape):
            centre = (float(position[0] + cos * x - sin * y), float(position[1] + sin * x + cos * y))
            blown = _blown_up(semi_axes, radius)
            found.append(Pair(offset, centre, (vx, vy), blown, heading))
    return found


def _ellipses(shape: Shape) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    """Centre [m] and semi-axes [m] of each ellipse that stands for an obstacle's shape, in its body frame."""
    if isinstance(shape, Ellipse):
        return [((0.0, 0.0), shape.semi_axes)]
    return [(centre, 2 * (max(radius, SMALLEST),)) for centre, radius in _discs(shape)]


def _discs(shape: Footprint) -> list[tuple[tuple[float, float], float]]:
    """Centre [m] and radius [m] of each disc that covers a footprint, in its body frame."""
    if isinstance(shape, Point):
        return [((0.0, 0.0), 0.0)]
    length, width = max(shape.length, shape.width), min(shape.length, shape.width)
    radius = float(np.hypot(length / (2 * N_DISCS), width / 2))
    along = (np.arange(N_DISCS) + 0.5) * length / N_DISCS - length / 2
    x, y = shape.centre
    if shape.length >= shape.width:
        return [((float(x + each), y), radius) for each in along]
    return [((x, float(y + each)), radius) for each in along]


@cache
def _blown_up(semi_axes: tuple[float, float], radius: float) -> tuple[float, float]:
    """Semi-axes [m] of an ellipse that holds all points nearer than `radius` [m] to the given one."""
    angle = np.linspace(0.0, np.pi / 2, N_DIRECTIONS)
    normals = np.column_stack((np.cos(angle), np.sin(angle)))
    larger = Ellipse((semi_axes[0] + radius, semi_axes[1] + radius))
    k = float(((Ellipse(semi_axes).support(normals) + radius) / larger.support(normals)).max())
    return k * larger.semi_axes[0], k * larger.semi_axes[1]
