"""The driver of last resort in the two-track model of eq. (1), as one compiled function of a whole roll-out.

The front wheels take, within lock and rate, the angle at which the front axle's slip is

    alpha = share alpha_peak,    share = side                                     as long as the swerve goes out
                                 share = (course - psi - PREVIEW r) / BAND        from then on

clipped to +-1, and further to (+-1 - rear) / REAR_BAND, where rear is the rear axle's slip as a share of its peak,
predicted. Both look ahead by PREVIEW or REAR_PREVIEW and the time that the steering takes to turn by alpha_peak more.
The second clip keeps the vehicle in hand: with the front axle at its peak and the rear one beyond its own, a car spins
as it is steered back.
"""

from functools import cache
from typing import Any, Final

import casadi as ca

from swerve.conventions import PSI, VX, R
from swerve.kernel import Kernel
from swerve.vehicle.integrate import rk4
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters, axle_slip_angle, quasi_static_loads, symbols, two_track

N_STEPS: Final = 250  # of a roll-out
PREVIEW: Final = 0.25  # [s]
BAND: Final = 0.1  # [rad] of heading error at which the front tyres are at their peak
REAR_PREVIEW: Final = 0.2  # [s]
REAR_BAND: Final = 0.3  # [1] of its peak, within which the rear axle's slip holds the front axle's back


@cache
def last_resort() -> Kernel:
    """(start, orders, limits, parameters, step) -> states at the end of each of N_STEPS steps, (8, N_STEPS).

    start: [vx vy r psi X Y, steering angle [rad], time since the manoeuvre began [s]]; a state is the same.
    orders: braking share of mu Fz [1], side [1], time that the swerve goes out [s], course [rad].
    limits: peak slip of front and rear axle [rad], speed below which brakes fade [m/s], lock [rad], its rate [rad/s].
    """
    step = _step()
    inputs = [ca.MX.sym(step.name_in(i), *step.size_in(i)) for i in range(step.n_in())]
    held = [ca.repmat(each, 1, N_STEPS) for each in inputs[1:]]
    return Kernel(ca.Function("last_resort", inputs, [step.mapaccum("last_resort_steps", N_STEPS)(inputs[0], *held)]))


def _step() -> ca.Function:
    xi, _, _, p = symbols()
    steering, time, h = ca.SX.sym("steering"), ca.SX.sym("time"), ca.SX.sym("h")
    orders, limits = ca.SX.sym("orders", 4), ca.SX.sym("limits", 5)
    slowest, lock, rate = limits[2], limits[3], limits[4]
    wanted = _clipped(_steering(xi, steering, time, orders, limits, p), -lock, lock)
    reached = steering + _clipped(wanted - steering, -rate * h, rate * h)
    mean = (steering + reached) / 2
    share = -orders[0] * _clipped(xi[VX] / slowest)
    # the static loads brake the car as much as the true ones do, so they shift as much of its weight
    loads = quasi_static_loads(xi, ca.vertcat(mean, *(share * p.mu * load for load in wheel_loads(p))), p)
    acting = ca.vertcat(mean, *(share * p.mu * load for load in loads))
    end = rk4(lambda x: ca.vertcat(*two_track(x, acting, loads, p).derivative), xi, h)
    state = ca.vertcat(xi, steering, time)
    next_state = ca.vertcat(end, reached, time + h)
    return ca.Function("last_resort_step", [state, orders, limits, ca.vertcat(*p), h], [next_state])


def _steering(xi: ca.SX, steering: ca.SX, time: ca.SX, orders: ca.SX, limits: ca.SX, p: Parameters) -> Any:
    """The steering angle that gives the front axle the slip of this module's law [rad]."""
    side, hold, course = orders[1], orders[2], orders[3]
    peak, peak_rear, rate = limits[0], limits[1], limits[4]
    back = _clipped((course - xi[PSI] - (PREVIEW + peak / rate) * xi[R]) / BAND)
    turning = two_track(xi, ca.vertcat(steering, 0, 0, 0, 0), wheel_loads(p), p).derivative
    soon = xi + (REAR_PREVIEW + peak / rate) * ca.vertcat(0, *turning[1:3], 0, 0, 0)
    rear = axle_slip_angle(soon, -p.lr, 0.0, p) / peak_rear
    low, high = (_clipped((end - rear) / REAR_BAND) for end in (-1, 1))
    share = _clipped(ca.if_else(time < hold, side, back), low, high)
    return peak * share - axle_slip_angle(xi, p.lf, 0.0, p)


def _clipped(value: Any, low: Any = -1, high: Any = 1) -> Any:
    return ca.fmax(low, ca.fmin(high, value))
