"""Step steer, ISO 7401: the steering is turned as fast as a driver can, and held.

    delta(t) = clip(rate (t - t0), 0, delta_s),   delta_s: that of the steady turn at the lateral acceleration asked for

Times count from the instant at which the steering has gone half its way.
"""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from swerve.signals import Command
from swerve.simulate import Table
from swerve.study.manoeuvres.characteristic import steering_for
from swerve.study.manoeuvres.manoeuvre import Array, Car, Driver, Manoeuvre, Measure, Measures
from swerve.study.manoeuvres.readings import first_time, sideslip
from swerve.study.manoeuvres.wheel_forces import hold_speed
from swerve.vehicle.quantities import check, quantity

SETTLED = 1.0  # at the end, over which steady values are means [s]
LEAST_PEAK = 0.01  # overshoot of the yaw rate that counts as a peak [1]
REACHED = 0.9  # of the steady value, at which a response time ends [1]


@dataclass(frozen=True, kw_only=True)
class StepSteer(Manoeuvre):
    """A step of the steering at constant speed.

    Attributes:
        speed: that is held [m/s].
        friction: of the road [1].
        lateral_acceleration: of the steady turn [m/s^2].
        steering_rate: of the road wheels; 500 deg/s of a steering wheel with a ratio of 16 [rad/s].
        steering_time: when it begins [s].
        hold: for which the steering is held [s].
    """

    name: ClassVar[str] = "step-steer"
    description: ClassVar[str] = "step input: how fast and how well damped the car answers the steering"
    source: ClassVar[str] = "ISO 7401, step input"
    speed: float = quantity("speed", "m/s", default=80 / 3.6)
    friction: float = quantity("dimensionless", "1", default=0.85)
    lateral_acceleration: float = quantity("acceleration", "m/s^2", default=4.0)
    steering_rate: float = quantity("angular speed", "rad/s", default=0.545)
    steering_time: float = quantity("time", "s", default=0.5)
    hold: float = quantity("time", "s", default=4.5)

    def __post_init__(self) -> None:
        check(self)

    @property
    def duration(self) -> float:
        """Of all [s]."""
        return self.steering_time + self.hold

    def driver(self, car: Car) -> Driver:
        """Steers to the angle of the steady turn, holds the speed."""
        angle = steering_for(car, self.speed, self.lateral_acceleration)
        return lambda time, state: Command(self._steering(time, angle), hold_speed(car.vehicle, state, self.speed))

    def _steering(self, time: float, angle: float) -> float:
        return float(np.clip(self.steering_rate * (time - self.steering_time), 0.0, angle))

    def measure(self, motion: Table, car: Car) -> Measures:
        """Steady values, response times and overshoots of yaw rate and lateral acceleration."""
        time, steering = motion["time"], motion["delta"]
        late = time > time[-1] - SETTLED
        steady = {name: float(values[late].mean()) for name, values in _responses(motion).items()}
        reference = first_time(time, steering >= steady["steering"] / 2)
        yaw_rate = motion["r"]
        has_peak = yaw_rate.max() >= (1 + LEAST_PEAK) * steady["yaw_rate"]
        peak_time = float(time[yaw_rate.argmax()]) - reference if has_peak else float("nan")
        measures = {
            "steady_steering": Measure(steady["steering"], "rad", "road-wheel angle at the end"),
            "steady_yaw_rate": Measure(steady["yaw_rate"], "rad/s", "mean of the last second"),
            "steady_lateral_acceleration": Measure(steady["lateral_acceleration"], "m/s^2", "mean of the last second"),
            "steady_sideslip": Measure(steady["sideslip"], "rad", "mean of the last second"),
            "yaw_rate_gain": Measure(steady["yaw_rate"] / steady["steering"], "1/s", "steady yaw rate over steering"),
            "peak_response_time": Measure(peak_time, "s", "of the yaw rate, from half of the steering to its peak"),
            "tb_factor": Measure(peak_time * steady["sideslip"], "rad s", "peak response time times steady sideslip"),
        }
        for name in ("yaw_rate", "lateral_acceleration"):
            values = _responses(motion)[name]
            response = first_time(time, values >= REACHED * steady[name]) - reference
            overshoot = float(values.max()) / steady[name] - 1
            measures[f"{name}_response_time"] = Measure(response, "s", "from half of the steering to 90 % of steady")
            measures[f"{name}_overshoot"] = Measure(overshoot, "1", "largest over steady value, less 1")
        return measures


def _responses(motion: Table) -> dict[str, Array]:
    return {
        "steering": motion["delta"],
        "yaw_rate": motion["r"],
        "lateral_acceleration": motion["ay"],
        "sideslip": sideslip(motion),
    }
