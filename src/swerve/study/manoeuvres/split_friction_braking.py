"""Straight braking on split friction, as on the surfaces of ISO 14512: one side of the car on slippery road.

Steering held straight ahead. Each wheel is braked to a share of what the road under it gives, mu Fz, as an ideal
anti-lock system would. So the brakes turn the car towards the side that grips, with lt times the difference of forces.
"""

from dataclasses import dataclass
from typing import ClassVar, Final

import numpy as np

from swerve.conventions import GRAVITY, PSI
from swerve.plant import PlantState
from swerve.signals import Command
from swerve.simulate import Table
from swerve.study.manoeuvres.manoeuvre import Array, Car, Driver, Manoeuvre, Measure, Measures
from swerve.study.manoeuvres.readings import largest, sideslip, travelled, value_at
from swerve.study.manoeuvres.wheel_forces import hold_speed
from swerve.vehicle import Vehicle
from swerve.vehicle.quantities import check, quantity
from swerve.world import Friction

FIRST: Final = (0.2, 0.5)  # from the brakes' application, over which the yaw moment is a mean [s]
READ_AFTER: Final = 1.0  # [s] likewise, for yaw rate, heading and offset


@dataclass(frozen=True, kw_only=True)
class SplitFrictionBraking(Manoeuvre):
    """A full braking on a road that is slippery to the left of the car's line.

    Attributes:
        speed: at the brakes' application [m/s].
        friction: to the right [1].
        low_friction: to the left [1].
        brake_share: of mu Fz that the brakes take of each wheel [1].
        braking_time: when they are applied [s].
    """

    name: ClassVar[str] = "split-friction-braking"
    description: ClassVar[str] = "full braking, the left wheels on slippery road: how far the car turns, and stops"
    source: ClassVar[str] = "surfaces of ISO 14512; friction 0.8 and 0.3; steering held"
    speed: float = quantity("speed", "m/s", default=80 / 3.6)
    friction: float = quantity("dimensionless", "1", default=0.8)
    low_friction: float = quantity("dimensionless", "1", default=0.3)
    brake_share: float = quantity("dimensionless", "1", default=0.85)
    braking_time: float = quantity("time", "s", default=0.5)

    def __post_init__(self) -> None:
        check(self)
        if self.low_friction > self.friction:
            raise ValueError(f"friction must be at least low_friction, {self.low_friction:g}, got {self.friction:g}")

    @property
    def duration(self) -> float:
        """Longer than the braking can take [s]."""
        return self.braking_time + 1.5 * self.speed / (self.brake_share * self.low_friction * GRAVITY)

    def road(self) -> Friction:
        """Split along Y = 0; one friction where both sides are the same."""
        same = self.low_friction == self.friction
        return Friction(self.friction) if same else Friction.split(self.friction, self.low_friction)

    def driver(self, car: Car) -> Driver:
        """Holds the speed, then brakes; never steers."""

        def command(time: float, state: PlantState) -> Command:
            if time < self.braking_time:
                return Command(0.0, hold_speed(car.vehicle, state, self.speed))
            mu = car.road.at(_wheels(car.vehicle, state.vehicle))
            return Command(0.0, -self.brake_share * mu * state.wheel_loads)

        return command

    def measure(self, motion: Table, car: Car) -> Measures:
        """The way to rest, and how the car turns on it."""
        at, read, time = self.braking_time, self.braking_time + READ_AFTER, motion["time"]
        way = travelled(motion, at, float(time[-1]))
        first = (time >= at + FIRST[0]) & (time <= at + FIRST[1])
        left, right = (motion[f"Fx_f{side}"] + motion[f"Fx_r{side}"] for side in "lr")
        moment = float(car.vehicle.half_track * (right - left)[first].mean())
        return {
            "stopping_distance": Measure(way, "m", "along the path, from application to rest"),
            "mean_deceleration": Measure(value_at(motion, "vx", at) ** 2 / (2 * way), "m/s^2", "v^2 / (2 way)"),
            "yaw_moment": Measure(moment, "N m", "of the brakes, 0.2 to 0.5 s after application; left is positive"),
            "yaw_rate": Measure(value_at(motion, "r", read), "rad/s", "1 s after application"),
            "heading": Measure(value_at(motion, "psi", read), "rad", "1 s after application"),
            "lateral_offset": Measure(value_at(motion, "Y", read), "m", "1 s after application"),
            "largest_yaw_rate": Measure(largest(motion["r"]), "rad/s", "of the whole run"),
            "largest_sideslip": Measure(largest(sideslip(motion)[motion["vx"] > 2.0]), "rad", "over 2 m/s"),
            "final_heading": Measure(float(motion["psi"][-1]), "rad", "at rest"),
            "final_lateral_offset": Measure(float(motion["Y"][-1]), "m", "at rest"),
        }


def _wheels(vehicle: Vehicle, state: Array) -> Array:
    """Where the wheels are (4, 2) [m]."""
    v = vehicle
    front, rear, left = v.cg_to_front_axle, -v.cg_to_rear_axle, v.half_track
    places = np.array([[front, left], [front, -left], [rear, left], [rear, -left]])
    cos, sin = np.cos(state[PSI]), np.sin(state[PSI])
    where: Array = state[4:6] + places @ np.array([[cos, sin], [-sin, cos]])
    return where
