"""Plants and their peer on one manoeuvre: how many seconds of driving they simulate in a second of the processor.

A step steer of the BMW 320i: at 20 m/s the front wheels turn at 0.4 rad/s to 0.02 rad and stay there, 5 s in all. The
peer is the multi-body model of commonroad-vehicle-models with scipy's `odeint` at its own tolerances, as its examples
integrate it, read out every millisecond; its right-hand side writes into its argument and gets a copy.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import odeint
from vehiclemodels.init_mb import init_mb
from vehiclemodels.vehicle_dynamics_mb import vehicle_dynamics_mb
from vehiclemodels.vehicle_parameters import setup_vehicle_parameters

from bench.statistic import durations
from swerve.plant import MultibodyPlant, PlanarPlant, Plant, PlantState
from swerve.signals import Command
from swerve.vehicle import vehicle_named
from swerve.vehicle.multibody import completion_of
from swerve.world import Friction

Array = NDArray[np.float64]

SPEED, ANGLE, RATE = 20.0, 0.02, 0.4  # [m/s], [rad], [rad/s]
SECONDS, STEP, N_SUBSTEPS = 5.0, 1e-3, 50  # [s], [s], steps in a sample of the controller
N_SAMPLES: Final = round(SECONDS / STEP / N_SUBSTEPS)
CAR, NAME = 2, "bmw-320i"  # there and here


@dataclass(frozen=True)
class Speed:
    """Of one model.

    Attributes:
        real_time: simulated seconds in a second of the processor, of the fastest run [1].
        kernel: the same of the compiled function by itself; None where there is none [1].
        yaw_rate: at the end, which shows that it is the same manoeuvre [rad/s].
    """

    real_time: float
    kernel: float | None
    yaw_rate: float


def speeds(n_runs: int) -> dict[str, Speed]:
    """Both plants, and the peer, each in so many runs."""
    vehicle = vehicle_named(NAME)
    chassis, actuators = completion_of(NAME)
    rolling = replace(chassis, drag_area=0.0, tyre=replace(chassis.tyre, rolling_resistance=0.0))  # as theirs does
    limited = vehicle.with_changes({"steering_rate_limit": RATE})
    return {
        "multibody": _of_plant(MultibodyPlant(vehicle, rolling, actuators, Friction(1.0), STEP, N_SUBSTEPS), n_runs),
        "planar": _of_plant(PlanarPlant(limited, 1.0, STEP, N_SUBSTEPS), n_runs),
        "commonroad-vehicle-models": Speed(_fastest(theirs, n_runs), None, theirs()),
    }


def theirs() -> float:
    """Yaw rate at the end of the manoeuvre [rad/s], by commonroad-vehicle-models."""
    parameters = setup_vehicle_parameters(vehicle_id=CAR)
    times = np.linspace(0.0, SECONDS, round(SECONDS / STEP) + 1)
    turned = round(ANGLE / RATE / STEP)
    state = init_mb([0, 0, 0, SPEED, 0, 0, 0], parameters)

    def derivative(x: Array, _: float, u: list[float]) -> list[float]:
        rates: list[float] = vehicle_dynamics_mb(list(x), u, parameters)
        return rates

    for part, rate in ((times[: turned + 1], RATE), (times[turned:], 0.0)):
        state = odeint(derivative, state, part, args=([rate, 0.0],))[-1]
    return float(state[5])


def ours(plant: Plant) -> PlantState:
    """The end of the manoeuvre, sample by sample as a run goes through it."""
    state, command = plant.start(np.array([SPEED, 0, 0, 0, 0, 0])), Command(ANGLE, np.zeros(4))
    for _ in range(N_SAMPLES):
        state, _ = plant.advance(state, command)
    return state


def _of_plant(plant: MultibodyPlant | PlanarPlant, n_runs: int) -> Speed:
    end = ours(plant)
    kernel = min(durations(n_runs * N_SAMPLES, plant._advance._evaluate))  # on what the last call left in its buffers
    return Speed(_fastest(lambda: ours(plant), n_runs), N_SUBSTEPS * STEP / kernel, float(end.vehicle[2]))


def _fastest(simulate: Callable[[], object], n_runs: int) -> float:
    return SECONDS / min(durations(n_runs, simulate))
