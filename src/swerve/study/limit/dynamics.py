"""The vehicle over one interval: eq. (1) by two Runge-Kutta steps, with static loads and inputs as shares.

Below the speed v0 slip angles are rounded off, see `two_track`; here v0 is what the interval asks for: the model's
fastest pole is near 430 mu / v0 [1/s], and a Runge-Kutta step h is stable up to 2.8 over that.
"""

from functools import cache
from typing import Final

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.conventions import DELTA, FORCES, N_INPUTS, N_STATES, N_WHEELS
from swerve.study.limit.blocks import Kernels, kernels
from swerve.study.limit.layout import STATE_SCALE
from swerve.vehicle import Vehicle
from swerve.vehicle.integrate import rk4
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import SLIP_SPEED_FLOOR, Parameters, two_track

Array = NDArray[np.float64]

SUBSTEPS: Final = 2  # Runge-Kutta steps of an interval
POLE: Final = 430.0  # [1/s m/s] of the fastest motion, times v0 / mu
STABLE: Final = 2.8  # [1] of Runge-Kutta's method, for a real pole
N_NUMBERS: Final = len(Parameters._fields) + 3  # of `model_numbers`


@cache
def dynamics() -> Kernels:
    """y = [x, w, mu] and `model_numbers` -> the state after an interval, in units of the program's variables."""
    x, shares, mu = ca.SX.sym("x", N_STATES), ca.SX.sym("w", N_INPUTS), ca.SX.sym("mu")
    model = Parameters.symbolic()
    lock, share, step = (ca.SX.sym(name) for name in ("lock", "share", "h"))
    given = ca.vertcat(*model, lock, share, step)
    model = model._replace(mu=mu)
    loads = wheel_loads(model)
    u = [lock * shares[0], *(share * mu * loads[i] * shares[1 + i] for i in range(N_WHEELS))]
    end = x
    for _ in range(SUBSTEPS):
        end = rk4(lambda xi: ca.vertcat(*two_track(xi, u, loads, model).derivative), end, step / SUBSTEPS)
    return kernels("dynamics", ca.vertcat(x, shares, mu), given, end / STATE_SCALE)


def model_numbers(vehicle: Vehicle, step: float, friction: float) -> Array:
    """(N_NUMBERS,) what the dynamics take for intervals of `step` [s] on a friction near `friction` [1]."""
    model = Parameters.of(vehicle, friction, slip_speed_floor(step, friction))
    return np.array([*model, vehicle.steering_limit, vehicle.force_limit, step])


def inputs(vehicle: Vehicle, friction: float, shares: Array) -> Array:
    """u (n, 5) of eq. (1) [rad, N, N, N, N] for shares w (n, 5)."""
    loads = np.array(wheel_loads(Parameters.of(vehicle, friction)))
    u = np.empty((len(shares), N_INPUTS))
    u[:, DELTA] = vehicle.steering_limit * shares[:, DELTA]
    u[:, FORCES] = vehicle.force_limit * friction * loads * shares[:, FORCES]
    return u


def slip_speed_floor(step: float, friction: float) -> float:
    """v0 [m/s] for an interval of `step` [s], no less than the plant's."""
    return max(SLIP_SPEED_FLOOR, POLE * friction * step / SUBSTEPS / STABLE)
