"""How far a footprint stays from an obstacle, in metres and in the paper's distance ratio.

Eq. (5): rho = (X - x_o)^2 / a^2 + (Y - y_o)^2 / b^2, with the ellipse's axes turned by its heading. The map
(x, y) -> (x / a, y / b) makes the ellipse the unit disc, so sqrt(rho) of a point is its mapped distance from the
origin, and the smallest sqrt(rho) over a footprint is the distance of the origin from the mapped footprint.
"""

import math

import numpy as np
import shapely
from numpy.typing import ArrayLike, NDArray

from swerve.world.obstacle import Obstacle
from swerve.world.shapes import Ellipse, Footprint, Shape

ELLIPSE_TOLERANCE = 5e-5  # largest distance between an ellipse and the polygon that stands for it [m]


def clearance(footprint: Shape, poses: ArrayLike, obstacle: Obstacle, times: ArrayLike) -> NDArray[np.float64]:
    """Distance between a footprint and an obstacle, 0 where they touch or overlap.

    An ellipse is replaced by a polygon around it, so the clearance is exact between points and rectangles and at most
    1e-4 m too small, never too large, where an ellipse takes part.

    Args:
        footprint: what moves, in its body frame.
        poses: (n, 3) of X [m], Y [m], psi [rad].
        obstacle: what it must not touch.
        times: (n,) of each pose [s].

    Returns:
        (n,) clearance [m]; nan for a pose that is not finite.
    """
    outlines = _in_obstacle_frame(_polygon(footprint), poses, obstacle, times)
    distances = np.full(len(outlines), np.nan)
    finite = np.isfinite(outlines).all(axis=(1, 2))  # GEOS takes no ring that is not closed, and nan closes none
    distances[finite] = shapely.distance(_geometries(_polygon(obstacle.shape)), _geometries(outlines[finite]))
    return distances


def distance_ratio(footprint: Footprint, poses: ArrayLike, obstacle: Obstacle, times: ArrayLike) -> NDArray[np.float64]:
    """Smallest sqrt(rho) of eq. (5) over a footprint: 1 is contact, 0 is a footprint over the ellipse's centre.

    Args:
        footprint: what moves, in its body frame.
        poses: (n, 3) of X [m], Y [m], psi [rad].
        obstacle: an ellipse, at rest or moving.
        times: (n,) of each pose [s].

    Returns:
        (n,) distance ratio [-]; nan for a pose that is not finite.

    Raises:
        TypeError: the obstacle is not an ellipse.
    """
    if not isinstance(obstacle.shape, Ellipse):
        raise TypeError(f"a distance ratio needs an elliptical obstacle, got a {type(obstacle.shape).__name__}")
    corners = _in_obstacle_frame(footprint.outline(), poses, obstacle, times) / obstacle.shape.semi_axes
    if corners.shape[1] == 1:
        return np.hypot(corners[:, 0, 0], corners[:, 0, 1])
    return _distance_from_origin(corners)


def _polygon(shape: Shape) -> NDArray[np.float64]:
    """Vertices (k, 2) that hold the shape, no further out than ELLIPSE_TOLERANCE [m]."""
    if not isinstance(shape, Ellipse):
        return shape.outline()
    # A tangent polygon with k vertices is the outline scaled by 1 / cos(pi / k): max(a, b) (1 / cos - 1) too far out.
    half_angle = math.acos(1 / (1 + ELLIPSE_TOLERANCE / max(shape.semi_axes)))
    n_vertices = max(4, math.ceil(math.pi / half_angle))
    return shape.outline(n_vertices) / math.cos(math.pi / n_vertices)


def _in_obstacle_frame(
    vertices: NDArray[np.float64], poses: ArrayLike, obstacle: Obstacle, times: ArrayLike
) -> NDArray[np.float64]:
    """Vertices (k, 2) of a body at each of the n poses, seen from the obstacle's body frame: (n, k, 2) [m]."""
    pose = np.asarray(poses, dtype=float)
    heading = obstacle.heading_at(times)[:, np.newaxis]
    origin = _rotate((pose[:, :2] - obstacle.position_at(times))[:, np.newaxis], -heading)
    turn = pose[:, 2, np.newaxis] - heading
    seen: NDArray[np.float64] = origin + _rotate(vertices, turn)
    return seen


def _rotate(vectors: NDArray[np.float64], angle: ArrayLike) -> NDArray[np.float64]:
    """Vectors (..., 2) turned anticlockwise by angles that broadcast with (...) [rad]."""
    cos, sin = np.cos(angle), np.sin(angle)
    x, y = vectors[..., 0], vectors[..., 1]
    return np.stack((cos * x - sin * y, sin * x + cos * y), axis=-1)


def _geometries(vertices: NDArray[np.float64]) -> object:
    """Shapely geometries, one for each (..., k, 2): points where k is 1, polygons otherwise."""
    return shapely.points(vertices[..., 0, :]) if vertices.shape[-2] == 1 else shapely.polygons(vertices)


def _distance_from_origin(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """Distance of the origin from each convex, anticlockwise polygon of (n, k, 2); 0 inside it."""
    edges = np.roll(corners, -1, axis=1) - corners
    along = -np.einsum("nki,nki->nk", corners, edges) / np.einsum("nki,nki->nk", edges, edges)
    nearest = corners + np.clip(along, 0.0, 1.0)[..., np.newaxis] * edges
    distance = np.hypot(nearest[..., 0], nearest[..., 1]).min(axis=1)
    to_the_left = edges[..., 1] * corners[..., 0] - edges[..., 0] * corners[..., 1]
    return np.where(np.all(to_the_left >= 0, axis=1), 0.0, distance)
