"""Lines that separate the footprint from an obstacle, passed in a given way, so that nothing cuts between two poses.

A point and an ellipse that takes several poses to pass: one tangent a pose, where the ray from the centre leaves the
ellipse (in the scaled plane in which the ellipse is the unit circle). Two points outside a circle of radius
1 / cos(phi / 2), seen from its centre under an angle phi, have a chord outside the unit circle: so far the ellipse is
blown up.

Rectangles, and what one step could leap over: one line for each pair of neighbouring poses, both behind it, so that the
straight motion between them is too (`lines.py`).

A line for passing on the left never pushes to the right: n_Y >= 0 in world axes; n_Y = 0 says stay behind or ahead.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Passing
from swerve.control.unified.lines import Lines
from swerve.world import Ellipse, Footprint, Point, Shape

Array = NDArray[np.float64]

LONGEST_STEP = 1.0  # [1] in the scaled plane; neighbours outside the unit circle are then less than 60 deg apart
COSINE_OF_CHORD = 0.5  # [1] of the widest chord: neighbours further apart are inside, and kept out as they are
SMALLEST = 1e-12  # [1] keeps a pose in the obstacle's centre from dividing by zero


class Planes(NamedTuple):
    """Half-planes, each for one pose: normal . (pose - obstacle's centre) - reaches of both >= margin.

    Attributes:
        pose: (k,) index of the pose, at least 1: the first pose is measured and can't be moved.
        normal: (k, 2) unit vectors from obstacle to footprint, in world axes.
        gap: (k,) left side of the inequality [m].
        turning: (k,) derivative of the gap by the pose's psi [m/rad].
        smallest: the smallest gap, of both ends of a pair where a line is for a pair [m].
    """

    pose: NDArray[np.intp]
    normal: Array
    gap: Array
    turning: Array
    smallest: float


class Separation:
    """The half-planes between one footprint and obstacles of any shape."""

    def __init__(self, footprint: Footprint, n_poses: int, n_fine: int) -> None:
        """For sequences of `n_poses` poses, of which the first `n_fine` are close enough for tangents."""
        self._is_point = isinstance(footprint, Point)
        self._n_fine = n_fine
        self._lines = Lines(footprint, n_poses - 1)
        self._coarse_lines = Lines(footprint, n_poses - n_fine)

    def planes(self, shape: Shape, heading: float, poses: Array, passing: Passing) -> Planes:
        """The half-planes for a sequence of poses.

        Args:
            shape: of the obstacle.
            heading: of its x axis [rad].
            poses: (n_poses, 3) of the footprint's origin from the obstacle's centre at that time, in world axes [m],
                and psi [rad].
            passing: how the obstacle is passed.
        """
        if passing is not Passing.BEHIND and isinstance(shape, Ellipse) and self._is_point:
            fine = poses[: self._n_fine]
            scaled = _turned(fine[:, :2], -heading) / shape.semi_axes
            steps = scaled[1:] - scaled[:-1]
            if (steps * steps).sum(axis=1).max() <= LONGEST_STEP**2:
                near = _tangents(heading, np.asarray(shape.semi_axes), scaled, fine, passing)
                return _joined(near, self._coarse(shape, heading, poses, passing))
        return _of_pairs(*self._lines.between(shape, heading, poses, passing.value), 0)

    def _coarse(self, shape: Shape, heading: float, poses: Array, passing: Passing) -> Planes:
        first = self._n_fine - 1
        return _of_pairs(*self._coarse_lines.between(shape, heading, poses[first:], passing.value), first)


def _joined(near: Planes, far: Planes) -> Planes:
    pose, normal, gap, turning = (np.concatenate(pair) for pair in zip(near[:4], far[:4], strict=True))
    return Planes(pose, normal, gap, turning, min(near.smallest, far.smallest))


def _of_pairs(normal: Array, gaps: Array, turnings: Array, first: int) -> Planes:
    """A half-plane for the later one of each pair of poses; the very first pose can't be moved and does not count."""
    later = gaps[:, 1]
    smallest = min(float(later.min()), float(gaps[0 if first else 1 :, 0].min(initial=np.inf)))
    return Planes(np.arange(first + 1, first + 1 + len(normal)), normal, later, turnings[:, 1], smallest)


def _tangents(heading: float, semi_axes: Array, scaled: Array, poses: Array, passing: Passing) -> Planes:
    """One tangent for each pose but the first; `scaled` (n, 2) are the poses in the plane of the unit circle."""
    distance = np.hypot(scaled[:, 0], scaled[:, 1])
    cosine = (scaled[1:] * scaled[:-1]).sum(axis=1) / np.maximum(distance[1:] * distance[:-1], SMALLEST)
    narrowest = np.maximum(cosine, COSINE_OF_CHORD)
    narrowest[:-1] = np.minimum(narrowest[:-1], narrowest[1:])
    blown_up = np.sqrt(2 / (1 + narrowest))  # 1 / cos(phi / 2)
    outwards = scaled[1:] / semi_axes
    length = np.hypot(outwards[:, 0], outwards[:, 1])
    centred = length == 0
    outwards[centred], length[centred] = (-1.0, 0.0), 1.0
    normal = _to_side(_turned(outwards / length[:, np.newaxis], heading), passing.value)
    across = _turned(normal, -heading) * semi_axes
    reach = np.hypot(across[:, 0], across[:, 1]) * blown_up
    gap = (normal * poses[1:, :2]).sum(axis=1) - reach
    return Planes(np.arange(1, len(scaled)), normal, gap, np.zeros(len(gap)), float(gap.min()))


def _to_side(normals: Array, side: int) -> Array:
    """Normals that would push to the other side are turned along the road."""
    wrong = normals[:, 1] * side < 0
    if not wrong.any():
        return normals
    along = np.zeros_like(normals)
    along[:, 0] = np.where(normals[:, 0] > 0, 1.0, -1.0)
    return np.where(wrong[:, np.newaxis], along, normals)


def _turned(vectors: Array, angle: float) -> Array:
    """Vectors (n, 2) turned anticlockwise by an angle [rad]."""
    if angle == 0:
        return vectors
    as_complex = np.ascontiguousarray(vectors).view(np.complex128)[..., 0]
    turned = np.asarray(as_complex * np.exp(1j * angle))
    return turned[..., np.newaxis].view(np.float64)
