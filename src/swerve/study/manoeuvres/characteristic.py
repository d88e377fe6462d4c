"""The steering angle that gives a lateral acceleration, as FMVSS 126 (S7.6) finds it: from slowly increasing steer."""

from functools import lru_cache

import numpy as np

from swerve.errors import InputError
from swerve.study.manoeuvres.manoeuvre import Car
from swerve.study.manoeuvres.run import drive
from swerve.study.manoeuvres.steady_circle import SteadyCircle


@lru_cache(maxsize=32)
def steering_for(car: Car, speed: float, acceleration: float) -> float:
    """Road-wheel angle [rad] at which the car turns with a lateral acceleration [m/s^2] at a speed [m/s].

    Raises:
        InputError: it cannot turn that hard on this road.
    """
    motion = drive(SteadyCircle(speed=speed, friction=car.road.base), car)
    ay = np.maximum.accumulate(motion["ay"])
    if not ay[-1] >= acceleration:
        cure = "ask for a lower lateral acceleration, or take more friction"
        raise InputError(
            f"{car.vehicle.name} reaches no more than {ay[-1]:.2f} m/s^2 at {speed:.4g} m/s on friction "
            f"{car.road.base:g}, and is to turn with {acceleration:.4g} m/s^2; {cure}"
        )
    return float(motion["delta"][np.argmax(ay >= acceleration)])
