"""The reduced tyre against the full one in motion: Fig. 5 of the paper.

A double lane change at 120 km/h on friction 0.6, driven by the multibody plant; its course is `SmoothLaneChange`, for
the paper does not print its own. The lateral force of each wheel of that plant, which has combined slip by another rule
and a relaxation length, against eq. (4) at the same slip angle, load and longitudinal force.
"""

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import WHEELS
from swerve.simulate import Table
from swerve.study.manoeuvres import ManoeuvreRun, SmoothLaneChange, run_manoeuvre
from swerve.vehicle import Vehicle, vehicle_named
from swerve.vehicle.tyre import lateral_force

Array = NDArray[np.float64]

PLANT: Final = "multibody"


@dataclass(frozen=True, eq=False)
class WheelComparison:
    """One wheel.

    Attributes:
        wheel: one of `WHEELS`.
        full: lateral force of the plant's tyre (n,) [N].
        reduced: that of eq. (4) (n,) [N].
    """

    wheel: str
    full: Array
    reduced: Array

    @property
    def peak(self) -> float:
        """Largest lateral force of the plant's tyre [N]."""
        return float(np.abs(self.full).max())

    @property
    def rms_error(self) -> float:
        """Root of the mean square of the difference [N]."""
        return float(np.sqrt(np.mean((self.reduced - self.full) ** 2)))

    @property
    def largest_error(self) -> float:
        """Of the difference [N]."""
        return float(np.abs(self.reduced - self.full).max())

    @property
    def relative_error(self) -> float:
        """`rms_error` over `peak` [1]."""
        return self.rms_error / self.peak


@dataclass(frozen=True, eq=False)
class TyreComparison:
    """All four.

    Attributes:
        run: of the manoeuvre.
        wheels: in the order of `WHEELS`.
    """

    run: ManoeuvreRun
    wheels: tuple[WheelComparison, ...]

    def to_json(self) -> dict[str, dict[str, float]]:
        """The errors of each wheel, in SI."""
        names = ("peak", "rms_error", "largest_error", "relative_error")
        return {each.wheel: {name: getattr(each, name) for name in names} for each in self.wheels}


def compare_tyres(vehicle: Vehicle | None = None, manoeuvre: SmoothLaneChange | None = None) -> TyreComparison:
    """Drive the lane change on the multibody plant, and set eq. (4) beside its tyres.

    Args:
        vehicle: of the library; the paper's unless said.
        manoeuvre: at 120 km/h on friction 0.6 unless said.
    """
    car, change = vehicle or vehicle_named("d-class-sedan"), manoeuvre or SmoothLaneChange()
    run = run_manoeuvre(change, car, PLANT)
    return TyreComparison(run, tuple(_compare(run.motion, car, change.friction, wheel) for wheel in WHEELS))


def _compare(motion: Table, vehicle: Vehicle, friction: float, wheel: str) -> WheelComparison:
    slip, load, longitudinal = (motion[f"{name}_{wheel}"] for name in ("alpha", "Fz", "Fx"))
    return WheelComparison(wheel, motion[f"Fy_{wheel}"], reduced_force(vehicle, slip, longitudinal, friction, load))


def reduced_force(vehicle: Vehicle, slip: Array, longitudinal: Array, friction: float, load: Array) -> Array:
    """Eq. (4) over a whole motion (n,) [N]."""
    return np.array(lateral_force(vehicle.tyre, slip, longitudinal, friction, load), dtype=float).ravel()
