"""Convex bodies that do not touch: a line between them, one for each interval of the grid and each obstacle.

In the obstacle's frame, with the unit normal n(theta) of the line, the obstacle's support function h and the vertices q
of the ego vehicle at both ends of the interval,

    n(theta) . q >= h(n(theta)) - s

which is exact for convex bodies. One line for both ends keeps the chord between them clear as well. The support of a
rectangle has corners, so a rectangle's four vertices v have an offset d of their own:  n . v <= d <= n . q + s.
"""

from functools import cache
from typing import Any, Final

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.conventions import PSI, X
from swerve.study.limit.blocks import Kernels, kernels
from swerve.world import Ellipse, Footprint, Obstacle, Rectangle, Shape

Array = NDArray[np.float64]

OFFSET: Final = 0.1  # [m] of a line from the obstacle, where there is room for it


def extents(shape: Shape) -> tuple[float, float]:
    """Half of an obstacle's length and width [m]: semi-axes, or half of a rectangle's sides."""
    if isinstance(shape, Ellipse):
        return shape.semi_axes
    if isinstance(shape, Rectangle):
        return shape.length / 2, shape.width / 2
    raise TypeError(f"an obstacle is an ellipse or a rectangle, got a {type(shape).__name__}")


@cache
def separation(is_ellipse: bool, n_vertices: int) -> Kernels:
    """What must not be negative in an interval [m].

    Of y = [X Y psi at its start, X Y psi at its end, theta, d, the shift D, s], and of the obstacle's pose at its start
    and at its end, its `extents`, and the vertices of the footprint.
    """
    own, line, shift, slack = ca.SX.sym("own", 3, 2), ca.SX.sym("line", 2), ca.SX.sym("D"), ca.SX.sym("s")
    poses, half, vertices = ca.SX.sym("poses", 3, 2), ca.SX.sym("half", 2), ca.SX.sym("vertices", 2, n_vertices)
    seen = [
        _turned(vertex_at[0] - pose[0] - shift, vertex_at[1] - pose[1], -pose[2])
        for x, pose in zip(ca.horzsplit(own), ca.horzsplit(poses), strict=True)
        for vertex_at in (vertex_in_world(x, vertex) for vertex in ca.horzsplit(vertices))
    ]
    y = ca.vertcat(ca.vec(own), line, shift, slack)
    numbers = ca.vertcat(ca.vec(poses), half, ca.vec(vertices))
    name = f"separation_{'ellipse' if is_ellipse else 'rectangle'}_{n_vertices}"
    return kernels(name, y, numbers, ca.vertcat(*_rows(is_ellipse, half, line, seen, slack)))


def _rows(is_ellipse: bool, half: ca.SX, line: ca.SX, seen: list[tuple[ca.SX, ca.SX]], slack: ca.SX) -> list[ca.SX]:
    n_x, n_y = ca.cos(line[0]), ca.sin(line[0])
    offset = ca.sqrt((half[0] * n_x) ** 2 + (half[1] * n_y) ** 2) if is_ellipse else line[1]
    own = [n_x * x + n_y * y + slack - offset for x, y in seen]
    if is_ellipse:
        return own
    corners = [(i * half[0], j * half[1]) for i in (-1, 1) for j in (-1, 1)]
    return [*own, *(line[1] - n_x * x - n_y * y for x, y in corners)]


@cache
def heights(n_vertices: int) -> Kernels:
    """Y of the footprint's vertices [m], of y = [psi, Y] and of the vertices."""
    y, vertices = ca.SX.sym("y", 2), ca.SX.sym("vertices", 2, n_vertices)
    pose = ca.vertcat(0, y[1], y[0])
    at = [vertex_in_world(pose, vertex)[1] for vertex in ca.horzsplit(vertices)]
    return kernels(f"heights_{n_vertices}", y, ca.vec(vertices), ca.vertcat(*at))


def vertex_in_world(pose: ca.SX, vertex: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Where a vertex of the footprint is [m], for a pose [X, Y, psi]."""
    right, up = _turned(vertex[0], vertex[1], pose[2])
    return pose[0] + right, pose[1] + up


def _turned(x: Any, y: Any, angle: Any) -> tuple[Any, Any]:
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
