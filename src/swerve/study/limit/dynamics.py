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
from swerve.vehicle import Vehicle
from swerve.vehicle.integrate import rk4
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import SLIP_SPEED_FLOOR, Parameters, two_track

Array = NDArray[np.float64]

SUBSTEPS: Final = 2  # Runge-Kutta steps of an interval
POLE: Final = 430.0  # [1/s m/s] of the fastest motion, times v0 / mu
STABLE: Final = 2.8  # [1] of Runge-Kutta's method, for a real pole


@cache
def dynamics(vehicle: Vehicle) -> ca.Function:
    """(x, w, mu, h, v0) -> the state after an interval."""
    x, shares = ca.SX.sym("x", N_STATES), ca.SX.sym("w", N_INPUTS)
    mu, step, floor = (ca.SX.sym(name) for name in ("mu", "h", "v0"))
    model = Parameters.of(vehicle, friction=1.0)._replace(mu=mu, v0=floor)
    loads = wheel_loads(model)
    forces = (vehicle.force_limit * mu * loads[i] * shares[1 + i] for i in range(N_WHEELS))
    u = [vehicle.steering_limit * shares[0], *forces]
    end = x
    for _ in range(SUBSTEPS):
        end = rk4(lambda xi: ca.vertcat(*two_track(xi, u, loads, model).derivative), end, step / SUBSTEPS)
    return ca.Function("step", [x, shares, mu, step, floor], [end])


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
