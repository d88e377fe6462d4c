"""Severe double lane change, ISO 3888-2: through a course of cones and back, the accelerator released at its entry.

The standard's driver is a human being; here it is the preview driver, so a speed that is passed says no more than that
it can be driven. Passed is what knocks over no cone.
"""

from dataclasses import dataclass
from math import inf
from typing import ClassVar, Final

import numpy as np

from swerve.conventions import X
from swerve.driver.preview import preview_steering
from swerve.plant import PlantState
from swerve.signals import Command
from swerve.simulate import Table
from swerve.study.manoeuvres.course import Course
from swerve.study.manoeuvres.manoeuvre import Array, Car, Driver, Manoeuvre, Measure, Measures
from swerve.study.manoeuvres.readings import largest, sideslip
from swerve.study.manoeuvres.wheel_forces import hold_speed
from swerve.vehicle.quantities import check, quantity

RUN_UP: Final = 20.0  # before the course [m]
RUN_OUT: Final = 10.0  # behind it, so that the whole car has left it [m]
RELEASE: Final = 2.0  # behind the entry the accelerator is released [m]


@dataclass(frozen=True, kw_only=True)
class DoubleLaneChange(Manoeuvre):
    """A drive through the course.

    Attributes:
        speed: at its entry [m/s].
        friction: of the road [1].
        preview: time that the driver looks ahead [s].
        exit_width: of the last lane [m]; inf is the standard's 1.3 b + 0.25, which not all take (some have 3 m).
    """

    name: ClassVar[str] = "double-lane-change"
    description: ClassVar[str] = "severe double lane change between cones, by a preview driver: passed or not"
    source: ClassVar[str] = "ISO 3888-2; driver of Guo and Guan, Vehicle System Dynamics 22 (1993)"
    speed: float = quantity("speed", "m/s", default=45 / 3.6)
    friction: float = quantity("dimensionless", "1", default=0.85)
    preview: float = quantity("time", "s", default=0.5)
    exit_width: float = quantity("length", "m", default=inf, unlimited=True)

    def __post_init__(self) -> None:
        check(self)

    @property
    def duration(self) -> float:
        """In which the course is left even at two thirds of the speed [s]."""
        return 1.5 * (RUN_UP + self.course(0.0).end + RUN_OUT) / self.speed

    def course(self, width: float) -> Course:
        """For a car of `width` [m]."""
        return Course.iso_3888_2(width, None if self.exit_width == inf else self.exit_width)

    def start(self) -> Array:
        """In the middle of the first lane, before it."""
        return np.array([self.speed, 0.0, 0.0, 0.0, -RUN_UP, 0.0])

    def driver(self, car: Car) -> Driver:
        """Steers along the middles of the lanes, and coasts from the entry on."""
        path = self.course(car.vehicle.width).path()

        def command(time: float, state: PlantState) -> Command:
            angle = preview_steering(car.vehicle, self.friction, path, self.preview, state.vehicle)
            coasts = state.vehicle[X] >= RELEASE
            return Command(angle, np.zeros(4) if coasts else hold_speed(car.vehicle, state, self.speed))

        return command

    def measure(self, motion: Table, car: Car) -> Measures:
        """The cones, the verdict, and what the car did for it."""
        course = self.course(car.vehicle.width)
        clearances = course.clearances(car.vehicle, motion.stack("X", "Y", "psi"))
        x, speed = motion["X"], motion["vx"]
        n_hit, is_through = int((clearances <= 0).sum()), bool(x.max() >= course.end)
        at_entry, at_exit = (float(np.interp(end, x, speed)) for end in (0.0, course.end))
        return {
            "entry_speed": Measure(at_entry, "m/s", "centre of gravity at the entry"),
            "exit_speed": Measure(at_exit if is_through else float("nan"), "m/s", "centre of gravity at the exit"),
            "cones_hit": Measure(float(n_hit), "1", f"of {len(clearances)}"),
            "least_clearance": Measure(float(clearances.min()), "m", "of the body to a cone; below zero it is hit"),
            "largest_steering": Measure(largest(motion["delta"]), "rad", "road-wheel angle"),
            "largest_lateral_acceleration": Measure(largest(motion["ay"]), "m/s^2", "of the centre of gravity"),
            "largest_yaw_rate": Measure(largest(motion["r"]), "rad/s", "of the whole run"),
            "largest_sideslip": Measure(largest(sideslip(motion)), "rad", "of the whole run"),
            "passed": Measure(float(n_hit == 0 and is_through), "1", "1 when no cone is hit and the exit reached"),
        }
