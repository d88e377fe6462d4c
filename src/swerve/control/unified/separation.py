"""Lines that separate the footprint from an obstacle, on a given side, so that nothing cuts between two poses.

A point and an ellipse that takes several poses to pass: one tangent a pose, where the ray from the centre leaves the
ellipse (in the scaled plane in which the ellipse is the unit circle). Two points outside a circle of radius
1 / cos(phi / 2), seen from its centre under an angle phi, have a chord outside the unit circle: so far the ellipse is
blown up.

Rectangles, and ellipses that one step could leap over: one line for each pair of neighbouring poses, both behind it, so
that the straight motion between them is too. Of the normals of all faces that with the widest gap is taken: two convex
polygons are apart exactly when one of their face normals separates them (separating axis theorem).

A line for passing on the left never pushes to the right: n_Y >= 0 in world axes; n_Y = 0 says stay behind or ahead.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Side
from swerve.world import Ellipse, Footprint, Obstacle, Point, Rectangle

Array = NDArray[np.float64]

AXES = np.array([[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]])
LONGEST_STEP = (
    1.0  # [1] of neighbours in the scaled plane; outside the unit circle they are then less than 60 deg apart
)
COSINE_OF_CHORD = 0.5  # [1] of the widest chord: neighbours further apart are inside, and kept out as they are
SMALLEST = 1e-12  # [1] keeps a pose in the obstacle's centre from dividing by zero


class Planes(NamedTuple):
    """Half-planes, each for one pose: normal . (pose - obstacle's centre) >= reach + the footprint's own reach.

    Attributes:
        pose: (k,) index of the pose, at least 1: the first pose is measured and can't be moved.
        normal: (k, 2) unit vectors from obstacle to footprint, in world axes.
        reach: (k,) of the obstacle along the normal [m].
    """

    pose: NDArray[np.intp]
    normal: Array
    reach: Array


def separating_planes(obstacle: Obstacle, footprint: Footprint, poses: Array, side: Side) -> Planes:
    """The half-planes for a sequence of poses.

    Args:
        obstacle: its shape and heading; its position is not used.
        footprint: of the ego vehicle, in body axes.
        poses: (n, 3) of the footprint's origin from the obstacle's centre at that time, in world axes [m], and psi.
        side: on which the obstacle is passed.
    """
    if isinstance(obstacle.shape, Ellipse) and isinstance(footprint, Point):
        heading = float(obstacle.heading_at(0.0))
        scaled = _turned(poses[:, :2], -heading) / obstacle.shape.semi_axes
        steps = scaled[1:] - scaled[:-1]
        if (steps * steps).sum(axis=1).max() <= LONGEST_STEP**2:
            return _tangents(heading, np.asarray(obstacle.shape.semi_axes), scaled, side)
    return _shared(obstacle, footprint, poses, side)


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
    half = np.array([footprint.length, footprint.width]) / 2
    corner = footprint.centre + np.sign(towards) * half
    turning = corner[:, 0] * towards[:, 1] - corner[:, 1] * towards[:, 0]
    return footprint.support(towards), turning


def _tangents(heading: float, semi_axes: Array, scaled: Array, side: Side) -> Planes:
    """One tangent for each pose but the first; `scaled` (n, 2) are the poses in the plane of the unit circle."""
    distance = np.hypot(scaled[:, 0], scaled[:, 1])
    cosine = (scaled[1:] * scaled[:-1]).sum(axis=1) / np.maximum(distance[1:] * distance[:-1], SMALLEST)
    narrowest = np.maximum(cosine, COSINE_OF_CHORD)
    narrowest[:-1] = np.minimum(narrowest[:-1], narrowest[1:])
    blown_up = np.sqrt(2 / (1 + narrowest))  # 1 / cos(phi / 2)
    outwards = scaled[1:] / semi_axes
    length = np.hypot(outwards[:, 0], outwards[:, 1])
    centred = length == 0
    outwards[centred], length[centred] = AXES[2], 1.0
    normal = _to_side(_turned(outwards / length[:, np.newaxis], heading), side)
    across = _turned(normal, -heading) * semi_axes
    reach = np.hypot(across[:, 0], across[:, 1])
    return Planes(np.arange(1, len(scaled)), normal, reach * blown_up)


def _shared(obstacle: Obstacle, footprint: Footprint, poses: Array, side: Side) -> Planes:
    """One line for each pair of neighbours, as two half-planes: for its later pose, and for its earlier one."""
    normals = _candidates(obstacle, footprint, (poses[:-1] + poses[1:]) / 2, side)
    heading = float(obstacle.heading_at(0.0))
    reaches = [obstacle.shape.support(_turned(n, -heading)) for n in normals]
    gaps = [_smaller_gap(footprint, n, reach, poses) for n, reach in zip(normals, reaches, strict=True)]
    best, pair = np.argmax(gaps, axis=0), np.arange(len(poses) - 1)
    normal, reach = np.stack(normals)[best, pair], np.stack(reaches)[best, pair]
    return Planes(np.append(pair + 1, pair[1:]), np.concatenate([normal, normal[1:]]), np.append(reach, reach[1:]))


def _smaller_gap(footprint: Footprint, normals: Array, reach: Array, poses: Array) -> Array:
    """The smaller gap of each pair of neighbours (n - 1,) [m]."""
    gaps = [
        np.einsum("ij,ij->i", normals, end[:, :2]) - reach - footprint_reach(footprint, normals, end[:, 2])[0]
        for end in (poses[:-1], poses[1:])
    ]
    return np.asarray(np.minimum(*gaps))


def _candidates(obstacle: Obstacle, footprint: Footprint, poses: Array, side: Side) -> list[Array]:
    """Normals (n, 2) worth trying at each pose: away from the obstacle's centre, to the side, those of all faces."""
    heading, extent = float(obstacle.heading_at(0.0)), obstacle.shape.support(AXES[:2])
    if isinstance(footprint, Rectangle):
        extent = extent + footprint.width / 2
    away = _turned(poses[:, :2], -heading) / extent**2
    away[~away.any(axis=1)] = AXES[2]
    candidates = [_turned(away / np.hypot(away[:, 0], away[:, 1])[:, np.newaxis], heading)]
    candidates.append(np.broadcast_to(side.value * AXES[1], (len(poses), 2)))
    if isinstance(obstacle.shape, Rectangle):
        candidates += [np.broadcast_to(_turned(axis, heading), (len(poses), 2)) for axis in AXES]
    if isinstance(footprint, Rectangle):
        candidates += [_turned(axis, poses[:, 2]) for axis in AXES]
    return [_to_side(each, side) for each in candidates]


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
    if isinstance(angle, float) and angle == 0:
        return vectors
    as_complex = np.ascontiguousarray(vectors).view(np.complex128)[..., 0]
    turned = np.asarray(as_complex * np.exp(1j * np.asarray(angle)))
    return turned[..., np.newaxis].view(np.float64)
