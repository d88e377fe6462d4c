"""A manoeuvre of last resort, driven by the two-track model of eq. (1) from each instant on.

Roll-outs are of N_STEPS Runge-Kutta steps, so a step is longer where a manoeuvre takes longer. The tyres' fastest pole
near standstill is proportional to friction and to 1 / v0 (two_track.py); v0 is taken so large that the step is stable.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import N_STATES, PSI, X, Y
from swerve.study.criticality.driver import N_STEPS, last_resort
from swerve.study.criticality.manoeuvre import SLOWEST, Manoeuvre
from swerve.study.criticality.scene import Scene
from swerve.vehicle import Vehicle
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters
from swerve.vehicle.tyre import factors

Array = NDArray[np.float64]

REFINEMENT: Final = 2  # poses for each step, on straight lines between its ends
STANDSTILL: Final = 0.01  # [1] of the first speed, below which a brake's force falls in proportion to the speed
LARGEST_POLE: Final = 2.0  # [1] of the model times the step; Runge-Kutta is stable up to 2.8
AFTERWARDS_STEP: Final = 0.05  # [s] between poses after the roll-out


@dataclass(frozen=True, eq=False)
class Path:
    """Where a manoeuvre that begins at the instant itself leads, from n instants on.

    Attributes:
        elapsed: (n, m) from the instant on [s].
        poses: (n, m, 3) of X [m], Y [m], psi [rad].
        states: (n, N_STEPS + 1, 6) of the roll-out.
        velocity: (n, m, 2) over ground [m/s].
    """

    elapsed: Array
    poses: Array
    states: Array
    velocity: Array


def roll_out(scene: Scene, manoeuvre: Manoeuvre) -> Path:
    """Drive a manoeuvre from each instant of a scene."""
    states = np.array([_drive(scene, manoeuvre, i) for i in range(len(scene.times))])
    poses = states[..., [X, Y, PSI]]
    cos, sin = np.cos(poses[..., 2]), np.sin(poses[..., 2])
    vx, vy = states[..., 0], states[..., 1]
    velocity = np.stack((vx * cos - vy * sin, vx * sin + vy * cos), axis=-1)
    elapsed = manoeuvre.duration[:, np.newaxis] * np.linspace(0, 1, N_STEPS + 1)
    parts = _refined(elapsed[..., np.newaxis]), _refined(poses), _refined(velocity)
    course = np.stack((np.cos(manoeuvre.course), np.sin(manoeuvre.course)), axis=-1)
    return _followed(*parts, course, states, manoeuvre.afterwards)


def _refined(values: Array) -> Array:
    """Values (n, m, k) at REFINEMENT times as many instants."""
    share = np.arange(REFINEMENT)[:, np.newaxis] / REFINEMENT
    between = values[:, :-1, np.newaxis] + share * np.diff(values, axis=1)[:, :, np.newaxis]
    return np.concatenate((between.reshape(len(values), -1, values.shape[2]), values[:, -1:]), axis=1)


def _followed(elapsed: Array, poses: Array, velocity: Array, course: Array, states: Array, afterwards: float) -> Path:
    """The path, and what follows it: the last speed, along the course (n, 2)."""
    more = np.arange(AFTERWARDS_STEP, afterwards, AFTERWARDS_STEP)[:, np.newaxis]
    speed = np.einsum("ni,ni->n", velocity[:, -1], course)
    on = np.repeat((speed[:, np.newaxis] * course)[:, np.newaxis], len(more), axis=1)
    later = np.repeat(poses[:, -1:], len(more), axis=1)
    later[..., :2] += more * on
    return Path(
        np.concatenate((elapsed, elapsed[:, -1:] + more), axis=1)[..., 0],
        np.concatenate((poses, later), axis=1),
        states,
        np.concatenate((velocity, on), axis=1),
    )


def _drive(scene: Scene, manoeuvre: Manoeuvre, i: int) -> Array:
    """States (N_STEPS + 1, 6) from instant i on."""
    vehicle, step = scene.vehicle, manoeuvre.duration[i] / N_STEPS
    friction = float(scene.friction[i])
    floor = max(step * friction * _pole_times_speed(vehicle) / LARGEST_POLE, SLOWEST)
    p = Parameters.of(vehicle, friction, floor)
    peaks = [vehicle.tyre.peak_slip(wheel_loads(p)[wheel]) for wheel in (0, 2)]
    slowest = STANDSTILL * max(float(scene.speed[i]), SLOWEST)
    orders = (manoeuvre.braking * vehicle.force_limit, manoeuvre.side, manoeuvre.hold[i], manoeuvre.course[i])
    limits = (*peaks, slowest, vehicle.steering_limit, vehicle.steering_rate_limit)
    start = np.array([*scene.states[i], scene.steering[i], 0.0])
    (ends,) = last_resort()(start, np.array(orders), np.array(limits), p.as_array(), step)
    return np.vstack((start[:N_STATES], ends[:N_STATES].T))


def _pole_times_speed(vehicle: Vehicle) -> float:
    """Of eq. (1), linear, on friction 1: a bound of its fastest pole times the speed [m/s^2]."""
    loads = wheel_loads(Parameters.of(vehicle, 1.0))
    stiffness = [load * float(np.prod(factors(vehicle.tyre, load))) for load in loads]
    arms = [vehicle.cg_to_front_axle] * 2 + [vehicle.cg_to_rear_axle] * 2
    turning = sum(c * arm**2 for c, arm in zip(stiffness, arms, strict=True)) / vehicle.yaw_inertia
    return float(turning + sum(stiffness) / vehicle.mass)
