"""Braking in a turn, ISO 7975: from a steady circle of about 100 m the brakes are applied, the steering held.

The car is steered to the angle of a steady turn in one second, then settles. The brakes share the deceleration over the
wheels as their loads are. The reference is the circle driven before, of radius R0 = vx / r at the brakes' application:

    r_ref(t) = vx(t) / R0
"""

from dataclasses import dataclass
from math import sqrt
from typing import ClassVar, Final

import numpy as np

from swerve.plant import PlantState
from swerve.signals import Command
from swerve.simulate import Table
from swerve.study.manoeuvres.characteristic import steering_for
from swerve.study.manoeuvres.manoeuvre import Car, Driver, Manoeuvre, Measure, Measures
from swerve.study.manoeuvres.readings import largest, sideslip, travelled, value_at
from swerve.study.manoeuvres.wheel_forces import accelerate, hold_speed
from swerve.vehicle.quantities import check, quantity

READ_AFTER: Final = 1.0  # from the brakes' application, when the standard reads most of its values [s]
JUST_BEFORE: Final = 0.01  # [s] that the turn before is read before the brakes' application
TURN_IN: Final = 1.0  # [s] in which the steering goes to its angle


@dataclass(frozen=True, kw_only=True)
class BrakingInATurn(Manoeuvre):
    """A braking from a steady turn.

    Attributes:
        speed: of the turn; 5 m/s^2 on a radius of 100 m [m/s].
        friction: of the road [1].
        lateral_acceleration: of the turn [m/s^2].
        deceleration: that the brakes are asked for [m/s^2].
        braking_time: when they are applied [s].
    """

    name: ClassVar[str] = "braking-in-a-turn"
    description: ClassVar[str] = "braking in a turn, steering held: whether the car keeps its course"
    source: ClassVar[str] = "ISO 7975, open loop"
    speed: float = quantity("speed", "m/s", default=sqrt(5.0 * 100.0))
    friction: float = quantity("dimensionless", "1", default=0.85)
    lateral_acceleration: float = quantity("acceleration", "m/s^2", default=5.0)
    deceleration: float = quantity("acceleration", "m/s^2", default=4.0)
    braking_time: float = quantity("time", "s", default=5.0)

    def __post_init__(self) -> None:
        check(self)

    @property
    def duration(self) -> float:
        """Longer than the braking can take [s]."""
        return self.braking_time + 2 * self.speed / self.deceleration

    def driver(self, car: Car) -> Driver:
        """Turns in, holds the speed up to the braking, and the steering throughout."""
        angle = steering_for(car, self.speed, self.lateral_acceleration)

        def command(time: float, state: PlantState) -> Command:
            if time < self.braking_time:
                return Command(angle * min(time / TURN_IN, 1.0), hold_speed(car.vehicle, state, self.speed))
            return Command(angle, accelerate(car.vehicle, state, -self.deceleration))

        return command

    def measure(self, motion: Table, car: Car) -> Measures:
        """Steady turn before, yaw rate and sideslip a second after, and the way to rest."""
        at, read = self.braking_time, self.braking_time + READ_AFTER
        r0, v0 = value_at(motion, "r", at), value_at(motion, "vx", at)
        r1, v1 = value_at(motion, "r", read), value_at(motion, "vx", read)
        end = float(motion["time"][-1])
        braking = motion["time"] >= at
        way = travelled(motion, at, end)
        reference = v1 * r0 / v0
        return {
            "radius": Measure(v0 / r0, "m", "of the turn before"),
            "initial_lateral_acceleration": Measure(
                value_at(motion, "ay", at - JUST_BEFORE), "m/s^2", "of the turn before"
            ),
            "initial_yaw_rate": Measure(r0, "rad/s", "of the turn before"),
            "yaw_rate_ratio": Measure(r1 / r0, "1", "1 s after application over before"),
            "yaw_rate_deviation": Measure(r1 - reference, "rad/s", "1 s after, from that of the circle at that speed"),
            "sideslip_change": Measure(_sideslip(motion, read) - _sideslip(motion, at), "rad", "in that second"),
            "largest_sideslip": Measure(largest(sideslip(motion)[braking & (motion["vx"] > 2.0)]), "rad", "over 2 m/s"),
            "largest_yaw_rate_ratio": Measure(float(np.max(motion["r"][braking]) / r0), "1", "of all the braking"),
            "mean_deceleration": Measure(v0**2 / (2 * way), "m/s^2", "v^2 / (2 way)"),
            "stopping_distance": Measure(way, "m", "along the path, from application to rest"),
        }


def _sideslip(motion: Table, time: float) -> float:
    return float(np.interp(time, motion["time"], sideslip(motion)))
