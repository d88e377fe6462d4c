"""How much of its friction each wheel used: sqrt(Fx^2 + Fy^2) / (mu Fz), 1 at the edge of its friction circle.

mu is that of the road under the wheel. On the multibody plant a tyre can be a little beyond the edge for an instant.
"""

from collections.abc import Mapping, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.control import Plan
from swerve.conventions import WHEELS
from swerve.scenario import Scenario
from swerve.simulate.log import Table
from swerve.vehicle import Vehicle
from swerve.world import Friction, place

Array = NDArray[np.float64]

LEAST_GRIP: Final = 1.0  # mu Fz below which a wheel is in the air [N]


def friction_use_of(scenario: Scenario, motion: Table, n: int) -> Array:
    """Share of its friction that each wheel used in the first `n` rows of a run's motion (n, 4), FL FR RL RR [1]."""
    wheels = {name: motion.stack(*(f"{name}_{wheel}" for wheel in WHEELS))[:n] for name in ("Fx", "Fy", "Fz")}
    poses = motion.stack("X", "Y", "psi")[:n]
    return friction_use(wheels, friction_under(scenario.road.to_friction(), scenario.ego.to_vehicle(), poses))


def friction_under(friction: Friction, vehicle: Vehicle, poses: Array) -> Array:
    """Mu under each wheel (n, 4), FL FR RL RR, at poses (n, 3)."""
    front, rear, side = vehicle.cg_to_front_axle, -vehicle.cg_to_rear_axle, vehicle.half_track
    hubs = place(np.array([[front, side], [front, -side], [rear, side], [rear, -side]]), poses)
    return friction.at(hubs).reshape(len(poses), 4)


def friction_use(wheels: Mapping[str, Array], friction: Array) -> Array:
    """sqrt(Fx^2 + Fy^2) / (mu Fz) of each wheel (n, 4) [1]; nan for a wheel in the air."""
    grip = friction * wheels["Fz"]
    used: Array = np.hypot(wheels["Fx"], wheels["Fy"]) / np.where(grip > LEAST_GRIP, grip, np.nan)
    return used


def largest(use: Array) -> float | None:
    """The largest of shares (n, 4) [1]; None where all wheels were in the air all the time."""
    return None if np.isnan(use).all() else float(np.nanmax(use))


def mean_while_shaped(use: Array, plans: Sequence[Plan], n_substeps: int) -> float | None:
    """Mean of shares (n, 4) over wheels and time, while an obstacle shaped the plan [1]; None where none ever did."""
    shaped = np.repeat([plan.is_shaped for plan in plans], n_substeps)[: len(use)]
    shares = use[: len(shaped)][shaped]
    return None if np.isnan(shares).all() else float(np.nanmean(shares))
