"""Sine with dwell, FMVSS 126 (49 CFR 571.126; ISO 19365 is the like): the test of electronic stability control.

A sine of 0.7 Hz that rests for 500 ms at its second peak; its amplitude is a multiple of A, the steering angle that
gives 0.3 g at 80 km/h. The car coasts. With T0 the completion of steer (1 / f + dwell after its beginning):

    |r(T0 + 1.00 s)| <= 35 % and |r(T0 + 1.75 s)| <= 20 % of the second peak of r,
    lateral displacement 1.07 s after the beginning of steer >= 1.83 m (asked for from 5 A on)
"""

from dataclasses import dataclass
from math import pi, sin
from typing import ClassVar, Final

import numpy as np

from swerve.conventions import GRAVITY
from swerve.plant import PlantState
from swerve.signals import Command
from swerve.simulate import Table
from swerve.study.manoeuvres.characteristic import steering_for
from swerve.study.manoeuvres.manoeuvre import Car, Driver, Manoeuvre, Measure, Measures
from swerve.study.manoeuvres.readings import largest, sideslip, value_at
from swerve.study.manoeuvres.wheel_forces import hold_speed
from swerve.vehicle.quantities import check, quantity

CHARACTERISTIC: Final = 0.3 * GRAVITY  # lateral acceleration that defines A [m/s^2], S7.6.1
RATIOS: Final = ((1.0, 0.35), (1.75, 0.20))  # after completion [s], of the second peak [1], S5.2.1 and S5.2.2
DISPLACEMENT: Final = (1.07, 1.83)  # after the beginning [s], at least [m], S5.2.3, up to 3500 kg


@dataclass(frozen=True, kw_only=True)
class SineWithDwell(Manoeuvre):
    """One run of the series.

    Attributes:
        speed: at the beginning of steer, held up to there [m/s].
        friction: of the road [1].
        amplitude: as a multiple of A [1].
        frequency: of the sine [Hz].
        dwell: at the second peak [s].
        steering_time: when it begins [s].
    """

    name: ClassVar[str] = "sine-with-dwell"
    description: ClassVar[str] = "sine with dwell: whether the car stays stable and still goes where it is steered"
    source: ClassVar[str] = "FMVSS 126, 49 CFR 571.126 S5.2 and S7"
    speed: float = quantity("speed", "m/s", default=80 / 3.6)
    friction: float = quantity("dimensionless", "1", default=0.85)
    amplitude: float = quantity("dimensionless", "1", default=5.0)
    frequency: float = quantity("frequency", "Hz", default=0.7)
    dwell: float = quantity("time", "s", default=0.5)
    steering_time: float = quantity("time", "s", default=0.5)

    def __post_init__(self) -> None:
        check(self)

    @property
    def completion(self) -> float:
        """When the steering is back [s]."""
        return self.steering_time + 1 / self.frequency + self.dwell

    @property
    def duration(self) -> float:
        """Until the last reading, and a little more [s]."""
        return self.completion + 2.0

    def shape(self, time: float) -> float:
        """Steering angle over its amplitude at a time [s]: [1]."""
        since, peak = time - self.steering_time, 0.75 / self.frequency
        if not 0 <= since <= self.completion - self.steering_time:
            return 0.0
        moving = min(since, peak) + max(since - peak - self.dwell, 0.0)
        return sin(2 * pi * self.frequency * moving)

    def driver(self, car: Car) -> Driver:
        """Holds the speed up to the beginning of steer, then steers and coasts."""
        angle = self.amplitude * steering_for(car, self.speed, CHARACTERISTIC)

        def command(time: float, state: PlantState) -> Command:
            forces = np.zeros(4) if time >= self.steering_time else hold_speed(car.vehicle, state, self.speed)
            return Command(angle * self.shape(time), forces)

        return command

    def measure(self, motion: Table, car: Car) -> Measures:
        """The three criteria, the verdict, and how far the car came from going straight."""
        angle = steering_for(car, self.speed, CHARACTERISTIC)
        time, yaw_rate = motion["time"], motion["r"]
        reversed_ = (time >= self.steering_time + 0.5 / self.frequency) & (time <= self.completion)
        peak = -float(yaw_rate[reversed_].min()) if reversed_.any() else float("nan")
        ratios = [-value_at(motion, "r", self.completion + after) / peak for after, _ in RATIOS]
        displacement = value_at(motion, "Y", self.steering_time + DISPLACEMENT[0])
        is_stable = all(ratio <= limit for ratio, (_, limit) in zip(ratios, RATIOS, strict=True))
        is_responsive = displacement >= DISPLACEMENT[1]
        return {
            "characteristic_steering": Measure(angle, "rad", "A, the road-wheel angle at 0.3 g"),
            "second_peak_yaw_rate": Measure(-peak, "rad/s", "after the steering has been reversed"),
            "yaw_rate_ratio_1_00": Measure(ratios[0], "1", "1 s after completion of steer; at most 0.35"),
            "yaw_rate_ratio_1_75": Measure(ratios[1], "1", "1.75 s after completion of steer; at most 0.20"),
            "lateral_displacement": Measure(displacement, "m", "1.07 s after the beginning of steer; at least 1.83"),
            "largest_sideslip": Measure(largest(sideslip(motion)), "rad", "of the whole run"),
            "is_stable": Measure(float(is_stable), "1", "1 when both ratios are met"),
            "is_responsive": Measure(float(is_responsive), "1", "1 when the displacement is met"),
            "passed": Measure(float(is_stable and is_responsive), "1", "1 when all three are met"),
        }
