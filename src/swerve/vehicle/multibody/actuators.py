"""Actuators: from a commanded steering angle and wheel forces to what acts on the vehicle.

First order, with limits; over a step h in which its target stands still a lag moves by exactly 1 - exp(-h / lag):

    steering     target: the command within the lock; the step it moves no larger than rate h
    motor        target: T = Fx Rt (sec. 5 of the paper) within +-torque limit and +-power limit / |w|; when it brakes,
                 fading below FADE_SPEED, where nothing is left to recover and a motor could turn the wheel back
    brake        target: what braking torque the motor's target leaves, up to the brake's limit; it only ever resists

So the motor brakes first, then the friction brake; what a motor cannot drive is lost. An actuator without a lag takes
one plant step to get there.
"""

from dataclasses import dataclass
from math import exp, inf
from typing import Any, NamedTuple

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.vehicle.parameters import Vehicle
from swerve.vehicle.quantities import check, quantity

N_ACTUATORS = 9  # steering angle, four motor torques, four brake torques
FADE_SPEED = 1.0  # [m/s] of the tread, below which a motor brakes less and less
SLOWEST_SPIN = 1.0  # [rad/s] below, its power limit is no limit


@dataclass(frozen=True, kw_only=True)
class Actuators:
    """Lags and limits; a lag of 0 and a limit of inf are none. The steering's lock is the vehicle's.

    Attributes:
        delay: from a command to the actuators, a whole number of plant steps [s].
        steering_lag: of the road-wheel angle [s].
        steering_rate_limit: of the road-wheel angle; the vehicle's own holds too [rad/s].
        motor_lag: of a motor's torque [s].
        motor_torque_limit: of one wheel's motor, driving and braking [N m].
        motor_power_limit: of one wheel's motor, driving and braking [W].
        brake_lag: of a friction brake's torque [s].
        brake_torque_limit: of one wheel's friction brake [N m].

    Raises:
        ValueError: a number has the wrong sign, or is not finite where it must be.
    """

    delay: float = quantity("time", "s", sign="not negative", default=0.0)
    steering_lag: float = quantity("time", "s", sign="not negative", default=0.0)
    steering_rate_limit: float = quantity("angular speed", "rad/s", default=inf)
    motor_lag: float = quantity("time", "s", sign="not negative", default=0.0)
    motor_torque_limit: float = quantity("torque", "N m", default=inf)
    motor_power_limit: float = quantity("power", "W", default=inf)
    brake_lag: float = quantity("time", "s", sign="not negative", default=0.0)
    brake_torque_limit: float = quantity("torque", "N m", default=inf)

    def __post_init__(self) -> None:
        check(self)


class Limits(NamedTuple):
    """What a kernel takes of the actuators, for one step: shares of the way to the target [1], and limits.

    Attributes:
        steering, lock, turn: share, lock [rad], largest change in a step [rad].
        motor, torque, power: share, limits [N m], [W].
        brake, strength: share, limit [N m].
        R: rolling radius [m].
    """

    steering: Any
    lock: Any
    turn: Any
    motor: Any
    torque: Any
    power: Any
    brake: Any
    strength: Any
    R: Any

    @classmethod
    def of(cls, actuators: Actuators, vehicle: Vehicle, step: float) -> "Limits":
        """For steps of `step` [s]."""
        a = actuators
        turn = step * min(a.steering_rate_limit, vehicle.steering_rate_limit)
        return cls(
            *(_share(a.steering_lag, step), vehicle.steering_limit, turn),
            *(_share(a.motor_lag, step), a.motor_torque_limit, a.motor_power_limit),
            *(_share(a.brake_lag, step), a.brake_torque_limit, vehicle.wheel_radius),
        )

    @classmethod
    def symbolic(cls) -> "Limits":
        """A CasADi symbol for each."""
        return cls(*(ca.SX.sym(name) for name in cls._fields))

    def as_array(self) -> NDArray[np.float64]:
        """The vector that kernels take."""
        return np.array(self, dtype=float)


def actuate(state: Any, command: Any, spin: Any, limits: Limits) -> Any:
    """The actuators (N_ACTUATORS,) after a step: steering [rad], motor torques, brake torques [N m].

    Args:
        state: (N_ACTUATORS,) before it.
        command: u = [delta Fx_fl Fx_fr Fx_rl Fx_rr] [rad, N].
        spin: of the wheels (4,) [rad/s].
        limits: of the step.
    """
    a = limits
    way = a.steering * (ca.fmax(-a.lock, ca.fmin(a.lock, command[0])) - state[0])
    moved = [state[0] + ca.fmax(-a.turn, ca.fmin(a.turn, way))]
    wanted = command[1:] * a.R
    within = ca.fmin(a.torque, a.power / ca.fmax(ca.fabs(spin), SLOWEST_SPIN))
    within = ca.fmin(within, ca.fabs(wanted))
    recovering = ca.fmax(0.0, ca.fmin(1.0, spin * a.R / FADE_SPEED))
    motor = ca.if_else(wanted < 0, -recovering * within, within)
    brake = ca.fmax(0.0, ca.fmin(a.strength, motor - wanted))
    torques, brakes = state[1:5], state[5:9]
    return ca.vertcat(*moved, torques + a.motor * (motor - torques), brakes + a.brake * (brake - brakes))


def _share(lag: float, step: float) -> float:
    """Of the way to the target that a lag goes in a step [1]."""
    return 1.0 if lag == 0 else 1 - exp(-step / lag)
