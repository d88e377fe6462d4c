"""Which line separates the footprint from an obstacle, on a given side.

For an ellipse and a point the line is tangent where the ray from the centre leaves the ellipse (in the scaled plane in
which the ellipse is a circle). Rectangles add the normals of their faces, and the line with the widest gap is taken:
two convex polygons are apart exactly when one of their face normals separates them (separating axis theorem).
A line for passing on the left never pushes to the right: n_Y >= 0 in world axes; at n_Y = 0 it says stay behind or ahead.
"""

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Side
from swerve.world import Footprint, Obstacle, Point, Rectangle

Array = NDArray[np.float64]

AXES = np.array([[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]])


def separating_normals(obstacle: Obstacle, footprint: Footprint, poses: Array, side: Side) -> tuple[Array, Array]:
    """Unit normals from obstacle to footprint, and how far the obstacle reaches along each.

    Args:
        obstacle: its shape and heading; its position is not used.
        footprint: of the ego vehicle, in body axes.
        poses: (k, 3) of the footprint's origin from the obstacle's centre, in world axes [m], and heading [rad].
        side: on which the obstacle is passed.

    Returns:
        normals (k, 2) in world axes, and the obstacle's support function (k,) [m].
    """
    candidates = [_to_side(_radial(obstacle, footprint, poses), side)]
    if isinstance(obstacle.shape, Rectangle):
        faces = np.broadcast_to(_turned(AXES[:, np.newaxis], obstacle.heading), (4, len(poses), 2))
        candidates += [_to_side(face, side) for face in faces]
    if isinstance(footprint, Rectangle):
        candidates += [_to_side(_turned(axis, poses[:, 2]), side) for axis in AXES]
    reaches = [obstacle.shape.support(_turned(n, -obstacle.heading)) for n in candidates]
    if len(candidates) == 1:
        return candidates[0], reaches[0]
    gaps = [
        np.einsum("ij,ij->i", n, poses[:, :2]) - reach - footprint_reach(footprint, n, poses[:, 2])[0]
        for n, reach in zip(candidates, reaches, strict=True)
    ]
    best, each = np.argmax(gaps, axis=0), np.arange(len(poses))
    return np.stack(candidates)[best, each], np.stack(reaches)[best, each]


def footprint_reach(footprint: Footprint, normals: Array, headings: Array) -> tuple[Array, Array]:
    """How far the footprint reaches against each normal: (k,) h_ego(-n; psi) [m] and its derivative by psi [m/rad].

    Args:
        footprint: in body axes.
        normals: (k, 2) unit vectors in world axes.
        headings: (k,) psi [rad].
    """
    if isinstance(footprint, Point):
        nothing = np.zeros(len(normals))
        return nothing, nothing
    towards = _turned(-normals, -headings)  # -n in body axes; it turns by -1 rad for each rad of psi
    centre, half = np.asarray(footprint.centre), np.array([footprint.length, footprint.width]) / 2
    corner = centre + np.sign(towards) * half
    turning = corner[:, 0] * towards[:, 1] - corner[:, 1] * towards[:, 0]
    return footprint.support(towards), turning


def _radial(obstacle: Obstacle, footprint: Footprint, poses: Array) -> Array:
    """Normal of the scaled circle at each pose: exact for an ellipse and a point, a fair guess for boxes."""
    extent = obstacle.shape.support(AXES[:2])
    if isinstance(footprint, Rectangle):
        extent = extent + footprint.width / 2
    normal = _turned(poses[:, :2], -obstacle.heading) / extent**2
    length = np.hypot(normal[:, 0], normal[:, 1])
    at_centre = length == 0
    if at_centre.any():
        normal[at_centre], length[at_centre] = AXES[2], 1.0
    return _turned(normal / length[:, np.newaxis], obstacle.heading)


def _to_side(normals: Array, side: Side) -> Array:
    """Normals that would push to the other side are turned along the road."""
    wrong = normals[:, 1] * side.value < 0
    if not wrong.any():
        return normals
    along = np.zeros_like(normals)
    along[:, 0] = np.where(normals[:, 0] > 0, 1.0, -1.0)
    return np.where(wrong[:, np.newaxis], along, normals)


def _turned(vectors: Array, angle: Array | float) -> Array:
    """Vectors (..., 2) turned anticlockwise by angles that broadcast with (...) [rad]."""
    as_complex = np.ascontiguousarray(vectors).view(np.complex128)[..., 0]
    turned = np.asarray(as_complex * np.exp(1j * np.asarray(angle)))
    return turned[..., np.newaxis].view(np.float64)
