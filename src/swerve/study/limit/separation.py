"""Convex bodies that do not touch: a line between them, one for each interval of the grid and each obstacle.

In the obstacle's frame, with the unit normal n(theta) of the line, the obstacle's support function h and the vertices q
of the ego vehicle at both ends of the interval,

    n(theta) . q >= h(n(theta)) - s

which is exact for convex bodies. One line for both ends keeps the chord between them clear as well. The support of a
rectangle has corners, so a rectangle's four vertices v have an offset d of their own:  n . v <= d <= n . q + s.
"""

from typing import Any, Final

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.conventions import PSI, X
from swerve.world import Ellipse, Footprint, Obstacle, Rectangle, Shape

Array = NDArray[np.float64]

N_CORNERS: Final = 4
OFFSET: Final = 0.1  # [m] of a line from the obstacle, where there is room for it


def extents(shape: Shape) -> tuple[float, float]:
    """Half of an obstacle's length and width [m]: semi-axes, or half of a rectangle's sides."""
    if isinstance(shape, Ellipse):
        return shape.semi_axes
    if isinstance(shape, Rectangle):
        return shape.length / 2, shape.width / 2
    raise TypeError(f"an obstacle is an ellipse or a rectangle, got a {type(shape).__name__}")


def rows(is_ellipse: bool, half: Any, line: Any, seen: list[Any], slack: Any) -> list[Any]:
    """What must not be negative [m].

    Args:
        is_ellipse: or a rectangle.
        half: (2,) of `extents`.
        line: theta [rad] and d [m].
        seen: vertices of the ego vehicle in the obstacle's frame, each (2,).
        slack: s [m].
    """
    n_x, n_y = ca.cos(line[0]), ca.sin(line[0])
    offset = ca.sqrt((half[0] * n_x) ** 2 + (half[1] * n_y) ** 2) if is_ellipse else line[1]
    own = [n_x * q[0] + n_y * q[1] + slack - offset for q in seen]
    if is_ellipse:
        return own
    corners = [(i * half[0], j * half[1]) for i in (-1, 1) for j in (-1, 1)]
    return [*own, *(line[1] - n_x * x - n_y * y for x, y in corners)]


def n_rows(is_ellipse: bool, n_seen: int) -> int:
    """How many `rows` there are."""
    return n_seen + (1 if is_ellipse else N_CORNERS)


def turned(x: Any, y: Any, angle: Any) -> tuple[Any, Any]:
    """The vector (x, y) turned anticlockwise by `angle` [rad]."""
    cos, sin = ca.cos(angle), ca.sin(angle)
    return cos * x - sin * y, sin * x + cos * y


def best_lines(shape: Shape, seen: Array, n_angles: int = 180) -> Array:
    """For each interval the line with the largest gap between both bodies, of `n_angles`.

    Args:
        shape: of the obstacle, in its own frame.
        seen: (n, k, 2) vertices of the ego vehicle that the interval's line has to have beyond it [m].

    Returns:
        (n, 2): theta, continuous over the intervals [rad], and d [m].
    """
    angles = np.linspace(-np.pi, np.pi, n_angles, endpoint=False)
    normals = np.column_stack((np.cos(angles), np.sin(angles)))
    support = shape.support(normals)
    nearest = (seen @ normals.T).min(axis=1)
    best = np.argmax(nearest - support, axis=1)
    rows = np.arange(len(seen))
    gap = nearest[rows, best] - support[best]
    offsets = support[best] + np.clip(gap / 2, 0.0, OFFSET)  # stays right while the obstacle comes nearer
    return np.column_stack((np.unwrap(angles[best]), offsets))


def _seen_from(obstacle: Obstacle, footprint: Footprint, states: Array, times: Array) -> Array:
    """The footprint's vertices (n, k, 2) at each of n states in the frame of an obstacle [m]."""
    vertices, psi = footprint.outline(), states[:, PSI, np.newaxis]
    in_world = states[:, np.newaxis, X:] + _arrays_turned(vertices, psi)
    from_centre = in_world - obstacle.position_at(times)[:, np.newaxis]
    return _arrays_turned(from_centre, -obstacle.heading_at(times)[:, np.newaxis])


def gaps(obstacle: Obstacle, footprint: Footprint, states: Array, times: Array) -> tuple[Array, Array]:
    """The best line (n - 1, 2) of each interval, and how far it parts both bodies [m], negative where it does not."""
    seen = _seen_from(obstacle, footprint, states, times)
    both = np.concatenate([seen[:-1], seen[1:]], axis=1)
    lines = best_lines(obstacle.shape, both)
    normals = np.column_stack((np.cos(lines[:, 0]), np.sin(lines[:, 0])))
    nearest = np.einsum("nki,ni->nk", both, normals).min(axis=1)
    return lines, nearest - obstacle.shape.support(normals)


def _arrays_turned(vectors: Array, angle: Array) -> Array:
    cos, sin = np.cos(angle), np.sin(angle)
    x, y = vectors[..., 0], vectors[..., 1]
    return np.stack((cos * x - sin * y, sin * x + cos * y), axis=-1)
