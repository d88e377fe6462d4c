"""Contact between the vehicle, somewhere, and an obstacle that keeps the velocity and heading it is seen with."""

import numpy as np
from numpy.typing import NDArray

from swerve.study.criticality.scene import Scene, Seen
from swerve.study.criticality.span import Span, contact_span, dot, rotate, slab

Array = NDArray[np.float64]


def contact_along(scene: Scene, seen: Seen, elapsed: Array, poses: Array, along: Array) -> Span:
    """Over which lambda the footprint at `poses`, moved by lambda `along`, touches the obstacle.

    Args:
        scene: n instants.
        seen: an obstacle of it.
        elapsed: (n, m) times from the instant on, for which the obstacle is predicted [s].
        poses: (n, m, 3) of X [m], Y [m], psi [rad].
        along: (n, 2) in world axes [m for each unit of lambda].

    Returns:
        Two arrays (n, m).
    """
    heading = np.broadcast_to(seen.heading[:, np.newaxis], elapsed.shape)
    there = seen.position[:, np.newaxis] + elapsed[..., np.newaxis] * seen.velocity[:, np.newaxis]
    offset = rotate(poses[..., :2] - there, -heading)
    direction = rotate(np.broadcast_to(along[:, np.newaxis], offset.shape), -heading)
    return contact_span(scene.footprint, seen.obstacle.shape, offset, poses[..., 2] - heading, direction)


def poses_now(scene: Scene, n_times: int) -> Array:
    """The vehicle's pose at each instant, as often as there are times: (n, n_times, 3)."""
    pose = np.column_stack((scene.position, scene.heading))
    return np.repeat(pose[:, np.newaxis], n_times, axis=1)


def abreast(scene: Scene, seen: Seen, axis: Array) -> Span:
    """From and until when the outlines overlap as seen along an axis (n, 2): two arrays (n,) [s]."""
    of_ego, of_obstacle = rotate(axis, -scene.heading), rotate(axis, -seen.heading)
    shape, footprint = seen.obstacle.shape, scene.footprint
    low = -shape.support(-of_obstacle) - footprint.support(of_ego)
    high = shape.support(of_obstacle) + footprint.support(-of_ego)
    return slab(low, high, dot(scene.position - seen.position, axis), dot(scene.velocity - seen.velocity, axis))
