"""The last instant at which a manoeuvre can begin and still touch nothing.

Until it begins, vehicle and obstacles keep velocity and heading, so begun later by tau it leads along the same path,
moved by v tau, and meets obstacles that have moved by w tau. For each pose of the path, the tau of a contact are one
interval (span.py); all of them together are forbidden. The last start is the largest tau up to the collision that is
in none: the lower end of the chain of overlapping intervals in which the collision lies. It is exact for the poses of
the path, where a search by bisection would have to trust that there is but one such end.
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.study.criticality.encounter import contact_along
from swerve.study.criticality.roll_out import Path
from swerve.study.criticality.scene import Scene
from swerve.study.criticality.span import Span, rotate

Array = NDArray[np.float64]

ROUNDING: Final = 1e-9  # [s] by which two intervals may miss each other and still be one


def last_start(scene: Scene, path: Path, deadline: Array, on_road: bool) -> Array:
    """Latest tau in [0, deadline] at which the manoeuvre of `path` touches nothing, (n,) [s]; -inf where none does.

    Args:
        scene: n instants.
        path: where the manoeuvre leads when it begins at once.
        deadline: (n,) time to collision [s].
        on_road: whether it must also stay between the road's edges.
    """
    spans = [_with_obstacle(scene, path, i) for i in range(len(scene.obstacles))]
    if on_road:
        spans += _with_edges(scene, path)
    first = np.concatenate([span[0] for span in spans], axis=1)
    last = np.concatenate([span[1] for span in spans], axis=1)
    latest = _below_chain(first, last, deadline)
    return np.asarray(np.where(latest >= 0, latest, -np.inf))


def _below_chain(first: Array, last: Array, deadline: Array) -> Array:
    """The largest value up to the deadline (n,) that is in none of the intervals (n, m)."""
    latest = deadline
    while True:
        covering = (first <= latest[:, np.newaxis] + ROUNDING) & (last >= latest[:, np.newaxis] - ROUNDING)
        earlier: Array = np.minimum(latest, np.where(covering, first, np.inf).min(axis=1))
        if (earlier >= latest - ROUNDING).all():
            return earlier
        latest = earlier


def _with_obstacle(scene: Scene, path: Path, i: int) -> Span:
    seen = scene.obstacles[i]
    return contact_along(scene, seen, path.elapsed, path.poses, scene.velocity - seen.velocity)


def _with_edges(scene: Scene, path: Path) -> list[Span]:
    """Where the footprint is beyond the left edge, and where beyond the right one."""
    left, right = scene.road.left_edge, scene.road.right_edge
    if left is None or right is None:
        return []
    poses = path.poses
    leftwards = rotate(np.broadcast_to([0.0, 1.0], (*poses.shape[:2], 2)), -poses[..., 2])
    over = poses[..., 1] + scene.footprint.support(leftwards) - left
    under = right - poses[..., 1] + scene.footprint.support(-leftwards)
    rate = scene.velocity[:, 1, np.newaxis]
    return [_positive(over, rate), _positive(under, -rate)]


def _positive(value: Array, rate: Array) -> Span:
    """Where value + tau rate > 0."""
    rates = np.broadcast_to(rate, value.shape)
    zero = -value / np.where(rates == 0, 1.0, rates)
    never = (rates == 0) & (value <= 0)
    first = np.where(rates > 0, zero, -np.inf)
    last = np.where(rates < 0, zero, np.inf)
    return np.where(never, np.inf, first), np.where(never, -np.inf, last)
