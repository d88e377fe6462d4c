"""One line for each pair of neighbouring poses that separates the footprint at both from an obstacle.

    gap(n) = n . (p - c) - h(n) - h_ego(-n; psi),    the smaller one of the two poses

with p the pose, c the obstacle's centre, h and h_ego the support functions of both shapes. Of the normals away from the
centre, to the side, and of all faces, that with the widest gap is taken: two convex polygons are apart exactly when one
of their face normals separates them (separating axis theorem). What lies between the poses is apart too: both
footprints are behind one line, and so is what joins them.
"""

from functools import cache
from typing import Final

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.kernel import Kernel
from swerve.world import Ellipse, Footprint, Point, Shape

Array = NDArray[np.float64]

ANY: Final = 2  # how an obstacle is passed when it does not matter; else the value of a `Passing`
SMALLEST: Final = 1e-9  # [m] keeps what has no extent from dividing by zero
OBLIQUE: Final = 0.9  # [1] -n_X of a line for staying behind: what pushes more to a side is no such line


class Lines:
    """The lines for one footprint and a number of pairs, compiled."""

    def __init__(self, footprint: Footprint, n_pairs: int) -> None:
        """Compile, or take from the cache, the search over all normals."""
        self._lines = Kernel(_pairs(n_pairs))
        centre = (0.0, 0.0) if isinstance(footprint, Point) else footprint.centre
        half = (0.0, 0.0) if isinstance(footprint, Point) else (footprint.length / 2, footprint.width / 2)
        self._footprint = np.array([*half, *centre])

    def between(self, shape: Shape, heading: float, poses: Array, passing: int) -> tuple[Array, Array, Array]:
        """The best line of each pair.

        Args:
            shape: of the obstacle.
            heading: of its x axis [rad].
            poses: (n_pairs + 1, 3) from the obstacle's centre at that time [m], and psi [rad].
            passing: the value of a `Passing`, or ANY.

        Returns:
            normals (n_pairs, 2), gaps (n_pairs, 2) of the earlier and the later pose [m], and their derivatives by
            psi (n_pairs, 2) [m/rad].
        """
        fixed = np.array([heading, *_extent(shape), isinstance(shape, Ellipse), *self._footprint, passing])
        found = self._lines(poses[:-1].T, poses[1:].T, fixed)[0].T
        return found[:, :2], found[:, 2:4], found[:, 4:]


def _extent(shape: Shape) -> tuple[float, float]:
    """Half of the shape's length and width [m]."""
    if isinstance(shape, Ellipse):
        return shape.semi_axes
    return (0.0, 0.0) if isinstance(shape, Point) else (shape.length / 2, shape.width / 2)


@cache
def _pairs(n: int) -> ca.Function:
    """`pair` n times, with the same p."""
    return pair().map(f"lines_{n}", "serial", n, [2], [])


@cache
def pair() -> ca.Function:
    """(pose, next pose, [heading, half length and width, is ellipse, footprint's, its centre, passing]) -> line."""
    first, second, p = ca.SX.sym("first", 3), ca.SX.sym("second", 3), ca.SX.sym("p", 9)
    middle = (first + second) / 2
    best = _allowed(_vector(-1, 0), p)
    widest = _smaller_gap(best, first, second, p)
    for normal in _candidates(middle, p):
        allowed = _allowed(normal, p)
        gap = _smaller_gap(allowed, first, second, p)
        best, widest = ca.if_else(gap > widest, allowed, best), ca.fmax(gap, widest)
    (gap_1, turning_1), (gap_2, turning_2) = _gap(best, first, p), _gap(best, second, p)
    return ca.Function("lines", [first, second, p], [ca.cse(ca.vertcat(best, gap_1, gap_2, turning_1, turning_2))])


def _candidates(middle: ca.SX, p: ca.SX) -> list[ca.SX]:
    """Normals worth trying: away from the obstacle's centre, along the axes of world, obstacle and footprint."""
    heading, extent = p[0], ca.vertcat(p[1], p[2]) + p[5] + SMALLEST
    away = turned(middle[:2], -heading) / extent**2
    length = ca.sqrt(ca.sumsqr(away))
    away = ca.if_else(length > SMALLEST, turned(away / ca.fmax(length, SMALLEST), heading), _vector(-1, 0))
    axes = [_vector(*axis) for axis in ((1, 0), (0, 1), (-1, 0), (0, -1))]
    faces = [turned(axis, angle) for angle in (heading, middle[2]) for axis in axes]
    return [away, axes[1], axes[3], *faces]


def _vector(x: int, y: int) -> ca.SX:
    return ca.SX([x, y])


def _allowed(normal: ca.SX, p: ca.SX) -> ca.SX:
    """The normal itself where the passing allows it; else along the road for a side, across it for staying behind."""
    passing = p[8]
    along = ca.vertcat(ca.if_else(normal[0] > 0, 1, -1), 0)
    across = ca.vertcat(0, ca.if_else(normal[1] >= 0, 1, -1))
    to_side = ca.if_else(normal[1] * passing < 0, along, normal)
    behind = ca.if_else(normal[0] > -OBLIQUE, across, normal)
    return ca.if_else(passing == 0, behind, ca.if_else(passing == ANY, normal, to_side))


def _smaller_gap(normal: ca.SX, first: ca.SX, second: ca.SX, p: ca.SX) -> ca.SX:
    return ca.fmin(_gap(normal, first, p)[0], _gap(normal, second, p)[0])


def _gap(normal: ca.SX, pose: ca.SX, p: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Gap of one pose behind a line, and its derivative by psi."""
    across = turned(normal, -p[0])
    of_ellipse = ca.sqrt((p[1] * across[0]) ** 2 + (p[2] * across[1]) ** 2)
    reach = ca.if_else(p[3], of_ellipse, p[1] * ca.fabs(across[0]) + p[2] * ca.fabs(across[1]))
    towards = turned(-normal, -pose[2])  # in body axes; it turns by -1 rad for each rad of psi
    corner = ca.vertcat(p[6] + ca.sign(towards[0]) * p[4], p[7] + ca.sign(towards[1]) * p[5])
    turning = corner[0] * towards[1] - corner[1] * towards[0]
    return ca.dot(normal, pose[:2]) - reach - ca.dot(corner, towards), -turning


def turned(vector: ca.SX, angle: ca.SX) -> ca.SX:
    """A vector (2,) turned anticlockwise by an angle [rad]."""
    cos, sin = ca.cos(angle), ca.sin(angle)
    return ca.vertcat(cos * vector[0] - sin * vector[1], sin * vector[0] + cos * vector[1])
