"""What a manoeuvre is: a driver without a controller, and what a test standard reads off the motion."""

from abc import abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

from swerve.plant import PlantState
from swerve.signals import Command
from swerve.simulate import Table
from swerve.vehicle import Vehicle
from swerve.world import Friction

Array = NDArray[np.float64]
Driver = Callable[[float, PlantState], Command]  # (time [s], state) -> command; a pure function
Measures = Mapping[str, "Measure"]


@dataclass(frozen=True)
class Measure:
    """A characteristic value.

    Attributes:
        value: nan where the motion never came to it.
        unit: "1" for a number without a dimension; a verdict is 1 or 0.
        meaning: in a few words.
    """

    value: float
    unit: str
    meaning: str


@dataclass(frozen=True)
class Car:
    """What is tested.

    Attributes:
        vehicle: its parameters.
        plant: name of the plant that stands for it.
        road: that it drives on.
    """

    vehicle: Vehicle
    plant: str
    road: Friction


class Manoeuvre(Protocol):
    """A test, by its numbers; each is a frozen dataclass whose fields carry their dimension and unit.

    The vehicle starts straight ahead at `speed`, at X = Y = 0 unless `start` says otherwise.
    """

    name: ClassVar[str]
    description: ClassVar[str]
    source: ClassVar[str]

    @property
    def speed(self) -> float:
        """At the start [m/s]."""

    @property
    def friction(self) -> float:
        """Of the road [1]."""

    @property
    @abstractmethod
    def duration(self) -> float:
        """The longest that it takes [s]; it is over before when the vehicle stands still."""

    @abstractmethod
    def driver(self, car: Car) -> Driver:
        """Who drives this car."""

    @abstractmethod
    def measure(self, motion: Table, car: Car) -> Measures:
        """The characteristic values of a motion, by name."""

    def road(self) -> Friction:
        """The friction everywhere."""
        return Friction(self.friction)

    def start(self) -> Array:
        """The vehicle state (6,) at time zero."""
        return np.array([self.speed, 0.0, 0.0, 0.0, 0.0, 0.0])
