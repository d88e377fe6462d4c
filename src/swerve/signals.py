"""The values that cross between sensing, control and plant: what was seen, and what is to be done.

Each is frozen; the arrays inside are read-only by agreement.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swerve.conventions import DELTA, FORCES, N_INPUTS
from swerve.world import Obstacle, Shape, Steady

Array = NDArray[np.float64]

ABSURD = 1e5  # [SI] no position, speed, angle, load or time that is larger is one


@dataclass(frozen=True)
class Command:
    """What the controller asks of the actuators until its next sample.

    Attributes:
        steering_angle: road-wheel angle delta of the front axle [rad].
        wheel_forces: (4,) longitudinal tyre forces, order FL FR RL RR [N]; torque is force times rolling radius.
    """

    steering_angle: float
    wheel_forces: Array

    @classmethod
    def from_input(cls, u: Array) -> "Command":
        """The command in an input vector u = [delta Fx_fl Fx_fr Fx_rl Fx_rr], (5,)."""
        return cls(float(u[DELTA]), np.array(u[FORCES], dtype=float))

    def as_input(self) -> Array:
        """The input vector u of eq. (1), (5,) [rad, N, N, N, N]."""
        u = np.empty(N_INPUTS)
        u[DELTA] = self.steering_angle
        u[FORCES] = self.wheel_forces
        return u


@dataclass(frozen=True)
class DriverInput:
    """What a driver asks for; its numbers may be any, nan included.

    Attributes:
        steering_angle: road-wheel angle delta that the steering wheel stands for [rad].
        force: longitudinal force of all wheels together that the pedals stand for; braking is negative [N].
    """

    steering_angle: float
    force: float

    @property
    def is_finite(self) -> bool:
        """Whether both numbers are finite, and neither larger than ABSURD."""
        return _is_sane([self.steering_angle, self.force])


Driver = Callable[[float, Array], DriverInput]  # (time [s], true vehicle state (6,)) -> input; a pure function


@dataclass(frozen=True)
class Observation:
    """One obstacle as it was seen; its numbers may be any, nan included.

    Attributes:
        shape: in its own body frame.
        position: of its centre in world axes [m].
        velocity: in world axes [m/s].
        heading: of its x axis [rad].
    """

    shape: Shape
    position: tuple[float, float]
    velocity: tuple[float, float]
    heading: float

    @property
    def is_finite(self) -> bool:
        """Whether every number in it is finite, and none larger than ABSURD."""
        return _is_sane([*self.position, *self.velocity, self.heading])

    def as_obstacle(self) -> Obstacle:
        """The obstacle that keeps on as seen; ValueError when a number is not finite."""
        return Obstacle(self.shape, Steady(self.position, self.velocity, self.heading))


@dataclass(frozen=True)
class Measurement:
    """What the controller knows when it is called.

    Attributes:
        time: the controller's clock at this call [s].
        stamp: when the values were taken [s]; `time - stamp` is their age.
        state: (6,) vehicle state [vx vy r psi X Y].
        wheel_loads: (4,) vertical tyre loads [N].
        obstacles: as seen at `stamp`; nothing of their future.
        driver: what the driver asked for at `stamp`; None where nobody sits at the wheel.
    """

    time: float
    stamp: float
    state: Array
    wheel_loads: Array
    obstacles: tuple[Observation, ...]
    driver: DriverInput | None = None

    @property
    def is_finite(self) -> bool:
        """Whether every number in it is finite, and none larger than ABSURD."""
        own = np.concatenate([self.state, self.wheel_loads, (self.time, self.stamp)])
        seen = (*self.obstacles, *(() if self.driver is None else (self.driver,)))
        return _is_sane(own) and all(each.is_finite for each in seen)


def _is_sane(numbers: ArrayLike) -> bool:
    """Whether all are finite and no larger than ABSURD; a comparison with nan is false."""
    return bool((np.abs(numbers) <= ABSURD).all())
