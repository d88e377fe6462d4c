"""The limits that a command is held against."""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import DELTA, FORCES
from swerve.scenario import Scenario
from swerve.vehicle import Vehicle
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.multibody import completion_of
from swerve.vehicle.two_track import Parameters

Array = NDArray[np.float64]

ROUNDING: Final = 1e-9  # by which a limit may be exceeded, in its unit and as a share of it


@dataclass(frozen=True, eq=False)
class Held:
    """What the limits of a step depend on.

    Attributes:
        last: (5,) the input before it.
        loads: (4,) of the wheels in the last finite measurement; static ones before the first [N].
    """

    last: Array
    loads: Array


def static_loads(scenario: Scenario) -> Array:
    """Of the scenario's vehicle, (4,) [N]."""
    return np.array(wheel_loads(Parameters.of(scenario.ego.to_vehicle(), scenario.road.friction)))


@dataclass(frozen=True, eq=False)
class Limits:
    """Those of a vehicle on a road.

    Attributes:
        vehicle: whose lock and share of friction.
        friction: of the road [1].
        steering_step: largest change of the steering angle in a sample [rad].
    """

    vehicle: Vehicle
    friction: float
    steering_step: float

    @classmethod
    def of(cls, scenario: Scenario) -> "Limits":
        """Those of a scenario's vehicle on the multibody plant."""
        vehicle = scenario.ego.to_vehicle()
        rate = min(vehicle.steering_rate_limit, completion_of(vehicle.name)[1].steering_rate_limit)
        step = rate * scenario.controller.sample_time
        return cls(vehicle, scenario.road.friction, step)

    def fault(self, u: Array, held: Held) -> str | None:
        """What is wrong with an input (5,), or None."""
        if not np.isfinite(u).all():
            return "the command is not finite"
        if _exceeds(u[FORCES], self.vehicle.force_limit * self.friction * held.loads):
            return "a wheel force exceeds its limit"
        if _exceeds(u[DELTA], self.vehicle.steering_limit):
            return "the steering angle exceeds the lock"
        return (
            "the steering angle exceeds its rate" if _exceeds(u[DELTA] - held.last[DELTA], self.steering_step) else None
        )


def _exceeds(values: Array | float, limit: Array | float) -> bool:
    """Whether any magnitude is beyond its limit, but for rounding."""
    return bool((np.abs(values) > limit * (1 + ROUNDING) + ROUNDING).any())
