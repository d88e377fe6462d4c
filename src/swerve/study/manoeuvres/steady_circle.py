"""Steady-state circular driving, ISO 4138, by the method of constant speed and slowly increasing steer.

    delta(t) = rate t (L / v^2 + K)

with the linear vehicle's understeer gradient K, so that at first ay = rate t. From the motion, quasi-steady,

    delta - L r / vx  =  K ay:   its slope over ay in the linear range is the understeer gradient that is measured.
"""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from swerve.plant import PlantState
from swerve.signals import Command
from swerve.simulate import Table
from swerve.study.manoeuvres.manoeuvre import Car, Driver, Manoeuvre, Measure, Measures
from swerve.study.manoeuvres.readings import largest, sideslip
from swerve.study.manoeuvres.wheel_forces import hold_speed
from swerve.vehicle.quantities import check, quantity
from swerve.vehicle.steady_state import steering_per_acceleration

LEAST = 0.1  # of the linear range, where it begins [1]


@dataclass(frozen=True, kw_only=True)
class SteadyCircle(Manoeuvre):
    """A turn that tightens slowly at constant speed.

    Attributes:
        speed: that is held [m/s].
        friction: of the road [1].
        acceleration_rate: of the lateral acceleration, at first [m/s^3].
        largest_acceleration: that the steering of a linear vehicle would end at [m/s^2].
        linear_range: lateral acceleration up to which gradients are fitted [m/s^2].
    """

    name: ClassVar[str] = "steady-circle"
    description: ClassVar[str] = "steady-state circular driving: constant speed, slowly increasing steer"
    source: ClassVar[str] = "ISO 4138, constant-speed method"
    speed: float = quantity("speed", "m/s", default=100 / 3.6)
    friction: float = quantity("dimensionless", "1", default=0.85)
    acceleration_rate: float = quantity("jerk", "m/s^3", default=0.2)
    largest_acceleration: float = quantity("acceleration", "m/s^2", default=9.0)
    linear_range: float = quantity("acceleration", "m/s^2", default=2.0)

    def __post_init__(self) -> None:
        check(self)

    @property
    def duration(self) -> float:
        """Until the steering is at its largest [s]."""
        return self.largest_acceleration / self.acceleration_rate

    def driver(self, car: Car) -> Driver:
        """Steers slowly, holds the speed."""
        rate = self.acceleration_rate * steering_per_acceleration(car.vehicle, self.friction, self.speed)
        return lambda time, state: Command(rate * time, self._forces(car, state))

    def _forces(self, car: Car, state: PlantState) -> np.ndarray:
        return hold_speed(car.vehicle, state, self.speed)

    def measure(self, motion: Table, car: Car) -> Measures:
        """Gradients of the linear range, and the limit."""
        ay, steering = motion["ay"], motion["delta"]
        kinematic = car.vehicle.wheelbase * motion["r"] / motion["vx"]
        linear = (ay >= LEAST * self.linear_range) & (np.maximum.accumulate(ay) <= self.linear_range)
        understeer, slip, gain = (
            _slope(x[linear], y[linear])
            for x, y in ((ay, steering - kinematic), (ay, sideslip(motion)), (steering, motion["r"]))
        )
        characteristic = np.sqrt(car.vehicle.wheelbase / understeer) if understeer > 0 else np.nan
        error = motion["vx"][ay <= 0.9 * ay.max()] - self.speed
        return {
            "understeer_gradient": Measure(understeer, "rad s^2/m", "slope of delta - L r / vx over ay, linear range"),
            "yaw_rate_gain": Measure(gain, "1/s", "slope of the yaw rate over the steering angle, linear range"),
            "sideslip_gradient": Measure(slip, "rad s^2/m", "slope of the sideslip angle over ay, linear range"),
            "characteristic_speed": Measure(float(characteristic), "m/s", "sqrt(L / understeer gradient)"),
            "largest_lateral_acceleration": Measure(float(ay.max()), "m/s^2", "that was reached"),
            "steering_at_largest": Measure(float(steering[ay.argmax()]), "rad", "road-wheel angle at that"),
            "speed_error": Measure(largest(error), "m/s", "largest, up to 90 % of that"),
        }


def _slope(x: np.ndarray, y: np.ndarray) -> float:
    """Of the least-squares line; nan of fewer than two points."""
    return float(np.polyfit(x, y, 1)[0]) if len(x) > 1 else float("nan")
