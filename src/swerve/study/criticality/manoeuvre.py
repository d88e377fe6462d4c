"""The manoeuvres of last resort: full braking, and a swerve at the tyres' peak.

    braking     every wheel asks for force_limit mu Fz against the motion; the wheels are steered to keep the course
    swerve      the front axle is held at the slip angle of its largest lateral force, sideways for a time T, then as
                hard back until the vehicle is along its course again; a point mass would be shifted by a T^2 = w,
                a = mu g. There is a swerve for every w of SHIFTS, and between them where more is in the way; the best
                counts.

The steering angle never leaves lock and rate. Along its course means along the road where the road has edges, along
the path at the instant where it has none.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swerve.conventions import GRAVITY
from swerve.study.criticality.scene import Scene
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters

Array = NDArray[np.float64]

SHIFTS: Final = (0.35, 0.5, 0.7, 1.0, 1.5, 2.5, 5.0)  # [m] that a point mass would be shifted by
LARGEST_TURN: Final = np.pi / 3  # [rad] of the path, after which the swerve is steered back whatever the shift
SETTLING: Final = 2.0  # [s] that a swerve is followed beyond its two turns
STANDING: Final = 30.0  # [s] that the vehicle stands after braking, for others to run into it
FOLLOWING: Final = 5.0  # [s] that it drives straight on after a swerve
STOPPING_MARGIN: Final = 1.05  # [1] of the stopping time that braking is followed
SLOWEST: Final = 0.1  # [m/s] below which times of manoeuvres are no longer scaled


@dataclass(frozen=True, eq=False)
class Manoeuvre:
    """What the driver of last resort does from each of n instants on.

    Attributes:
        braking: share of the full braking force [1].
        side: 1 to the left, -1 to the right, 0 for no swerve.
        hold: (n,) how long it steers to the side before it steers back [s].
        course: (n,) heading that it then holds [rad].
        duration: (n,) how long it is simulated [s].
        afterwards: for which it then keeps its velocity along the course [s].
    """

    braking: float
    side: int
    hold: Array
    course: Array
    duration: Array
    afterwards: float


def full_braking(scene: Scene) -> Manoeuvre:
    """On the course of the instant, to standstill."""
    none = np.zeros(len(scene.times))
    stopping = np.maximum(scene.speed, SLOWEST) / available_deceleration(scene)
    return Manoeuvre(1.0, 0, none, scene.course, STOPPING_MARGIN * stopping, STANDING)


def swerve(scene: Scene, side: int, shift: ArrayLike) -> Manoeuvre:
    """To a side (1 left, -1 right), by as much as shifts a point mass by `shift` (n,) or () [m]."""
    grip = scene.friction * GRAVITY
    hold = np.minimum(np.sqrt(np.asarray(shift) / grip), LARGEST_TURN * np.maximum(scene.speed, SLOWEST) / grip)
    course = scene.course
    if scene.road.left_edge is not None:
        course = np.pi * np.round(course / np.pi)
    return Manoeuvre(0.0, side, hold, course, 2 * hold + SETTLING, FOLLOWING)


def available_deceleration(scene: Scene) -> Array:
    """Of full braking: force_limit mu g, (n,) [m/s^2]."""
    return scene.vehicle.force_limit * scene.friction * GRAVITY


def available_lateral_acceleration(scene: Scene) -> Array:
    """mu sum(D Fz) / m over the wheels' static loads: every tyre at its peak, (n,) [m/s^2]."""
    vehicle = scene.vehicle
    loads = wheel_loads(Parameters.of(vehicle, 1.0))
    peak = sum((vehicle.tyre.d0 + vehicle.tyre.d1 * load) * load for load in loads) / vehicle.mass
    return np.asarray(scene.friction * peak)
