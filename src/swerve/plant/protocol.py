"""What a plant is: it takes a command and moves for one controller sample. It knows nothing of controllers."""

from abc import abstractmethod
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from swerve.signals import Command

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PlantState:
    """All of a plant at one instant.

    Attributes:
        vehicle: (6,) state [vx vy r psi X Y].
        wheel_loads: (4,) vertical tyre loads [N].
        inner: what else the plant has: actuators, suspension, wheels; its length and meaning are the plant's.
    """

    vehicle: Array
    wheel_loads: Array
    inner: Array


@dataclass(frozen=True, eq=False)
class Trace:
    """What happened in n plant steps; each row is at the start of its step.

    Attributes:
        states: (n, 6) [vx vy r psi X Y].
        steering: (n,) road-wheel angle [rad].
        acceleration: (n, 2) ax, ay of the centre of gravity in body axes [m/s^2].
        wheel_loads: (n, 4) [N].
        slip_angles: (n, 4) [rad].
        longitudinal: (n, 4) tyre forces Fx [N].
        lateral: (n, 4) tyre forces Fy [N].
    """

    states: Array
    steering: Array
    acceleration: Array
    wheel_loads: Array
    slip_angles: Array
    longitudinal: Array
    lateral: Array


class Plant(Protocol):
    """A vehicle that is driven by commands."""

    @abstractmethod
    def start(self, vehicle: Array) -> PlantState:
        """At rest in everything but the vehicle state (6,): wheels straight, no force."""

    @abstractmethod
    def advance(self, state: PlantState, command: Command) -> tuple[PlantState, Trace]:
        """One controller sample with the command held. A motion that diverges ends in nan, not in an exception."""
