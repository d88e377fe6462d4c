"""Tangents that keep a point out of an ellipse: one for each pose, where the ray from the centre leaves the ellipse.

In the scaled plane in which the ellipse is the unit circle, two points outside a circle of radius 1 / cos(phi / 2),
seen from its centre under an angle phi, have a chord outside the unit circle: so far the ellipse is blown up. What
follows in larger steps is kept out by lines for pairs (`lines.py`).
"""

from functools import cache
from typing import Final

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Passing
from swerve.control.unified.lines import pair, turned
from swerve.kernel import Kernel
from swerve.world import Ellipse

Array = NDArray[np.float64]

LONGEST_STEP: Final = 1.0  # [1] in the scaled plane; neighbours outside the unit circle are then less than 60 deg apart
COSINE_OF_CHORD: Final = 0.5  # [1] of the widest chord: neighbours further apart are inside, and kept out as they are
SMALLEST: Final = 1e-12  # [1] keeps a pose in the obstacle's centre from dividing by zero


class Tangents:
    """The tangents for a number of poses, compiled."""

    def __init__(self, n_poses: int, n_fine: int) -> None:
        """The first `n_fine` poses have tangents, the others lines for pairs."""
        self._along = Kernel(_along(n_poses, n_fine))

    def along(self, shape: Ellipse, heading: float, poses: Array, passing: Passing) -> tuple[Array, Array] | None:
        """Normals (n - 1, 2) and gaps (n - 1,) [m] of each pose but the first.

        Args:
            shape: of the obstacle.
            heading: of its x axis [rad].
            poses: (n, 3) of a point from the obstacle's centre at that time [m], and psi.
            passing: on which side it is passed.

        Returns:
            None where two fine poses are too far apart for tangents.
        """
        fixed = np.array([heading, *shape.semi_axes, 1.0, 0.0, 0.0, 0.0, 0.0, passing.value])
        normals, gaps, longest = self._along(poses.T, fixed)
        return None if longest[0] > LONGEST_STEP**2 else (normals.T, gaps)


@cache
def _along(n_poses: int, n_fine: int) -> ca.Function:
    """(poses (3, n), p of `lines.pair`) -> normals, gaps, square of the longest fine step."""
    poses, p = ca.MX.sym("poses", 3, n_poses), ca.MX.sym("p", 9)
    fine, after = poses[:, :n_fine], ca.horzcat(poses[:, 2:n_fine], poses[:, n_fine - 1])
    tangents = _tangent().map("tangents", "serial", n_fine - 1, [3], [])(fine[:, :-1], fine[:, 1:], after, p)
    normals, gaps = tangents[:2, :], tangents[2, :]
    if n_poses > n_fine:
        pairs = pair().map("pairs", "serial", n_poses - n_fine, [2], [])
        lines = pairs(poses[:, n_fine - 1 : -1], poses[:, n_fine:], p)
        later, earlier = ca.horzcat(gaps, lines[3, :]), ca.horzcat(gaps[:-1], lines[2, :], lines[3, -1])
        nearer = ca.repmat(earlier < later, 2, 1)  # a pose has a line as the later of a pair, and one as the earlier
        ends = ca.horzcat(normals, lines[:2, :]), ca.horzcat(normals[:, :-1], lines[:2, :], lines[:2, -1])
        normals, gaps = nearer * ends[1] + (1 - nearer) * ends[0], ca.fmin(later, earlier)
    return ca.Function("tangents_along", [poses, p], [normals, gaps.T, ca.mmax(tangents[3, :])])


def _tangent() -> ca.Function:
    """(pose before, pose, pose after, p) -> [normal, gap, square of the step to it in the scaled plane]."""
    before, here, after, p = ca.SX.sym("before", 3), ca.SX.sym("here", 3), ca.SX.sym("after", 3), ca.SX.sym("p", 9)
    heading, semi_axes, side = p[0], p[1:3], p[8]
    last, now, then = (turned(pose[:2], -heading) / semi_axes for pose in (before, here, after))
    narrowest = ca.fmax(ca.fmin(_cosine(last, now), _cosine(now, then)), COSINE_OF_CHORD)
    blown_up = ca.sqrt(2 / (1 + narrowest))  # 1 / cos(phi / 2)
    outwards = now / semi_axes
    length = ca.sqrt(ca.sumsqr(outwards))
    outwards = ca.if_else(length > 0, outwards / ca.fmax(length, SMALLEST), ca.SX([-1, 0]))
    normal = turned(outwards, heading)
    along = ca.vertcat(ca.if_else(normal[0] > 0, 1, -1), 0)
    normal = ca.if_else(normal[1] * side < 0, along, normal)  # what would push to the other side
    across = turned(normal, -heading) * semi_axes
    gap = ca.dot(normal, here[:2]) - ca.sqrt(ca.sumsqr(across)) * blown_up
    return ca.Function("tangent", [before, here, after, p], [ca.cse(ca.vertcat(normal, gap, ca.sumsqr(now - last)))])


def _cosine(one: ca.SX, other: ca.SX) -> ca.SX:
    return ca.dot(one, other) / ca.fmax(ca.sqrt(ca.sumsqr(one)) * ca.sqrt(ca.sumsqr(other)), SMALLEST)
