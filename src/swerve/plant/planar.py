"""The planar plant: the two-track model of eq. (1) by Runge-Kutta steps, with quasi-static wheel loads.

It is the controller's own model on a finer clock, so it tells what the controller does, not how well its model fits.
Steering follows the command at the vehicle's rate limit and stops at its lock; wheel forces are there at once, as far
as the friction circle goes. A negative one is a brake's: against the motion, and ending with it. The loads are those
of the step's start (with a centre of gravity at height 0: static).
"""

from functools import cache

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from swerve.conventions import DELTA, N_INPUTS, N_STATES, VX
from swerve.kernel import Kernel
from swerve.plant.protocol import Plant, PlantState, Trace
from swerve.signals import Command
from swerve.vehicle import Vehicle
from swerve.vehicle.integrate import rk4
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters, quasi_static_loads, symbols, two_track

Array = NDArray[np.float64]

STANDSTILL = 0.1  # [m/s] below this speed a brake's force falls in proportion to it

N_OUTPUTS = 19  # of a step: steering, ax, ay, and for each wheel load, slip angle, Fx, Fy


class PlanarPlant(Plant):
    """The plant for one vehicle, friction and pair of clocks."""

    def __init__(self, vehicle: Vehicle, friction: float, step: float, n_substeps: int) -> None:
        """Compile, or take from the cache, the kernel of one controller sample: `n_substeps` of `step` [s]."""
        self._parameters = Parameters.of(vehicle, friction)
        self._actuator = np.array([vehicle.steering_limit, vehicle.steering_rate_limit])
        self._step = step
        self._advance = Kernel(_sample(n_substeps))

    def start(self, vehicle: Array) -> PlantState:
        """In the vehicle state (6,), wheels straight."""
        return PlantState(np.array(vehicle, dtype=float), np.array(wheel_loads(self._parameters)), np.zeros(1))

    def advance(self, state: PlantState, command: Command) -> tuple[PlantState, Trace]:
        """One controller sample with the command held."""
        start = np.append(state.vehicle, state.inner)
        p = self._parameters.as_array()
        end, states, outputs = self._advance(start, command.as_input(), p, self._actuator, self._step)
        rows = outputs.reshape(N_OUTPUTS, -1).T  # a single step is a column, (19,), of its own
        steering, acceleration, loads, slips, longitudinal, lateral = np.split(rows, (1, 3, 7, 11, 15), axis=1)
        trace = Trace(states.reshape(N_STATES, -1).T, steering[:, 0], acceleration, loads, slips, longitudinal, lateral)
        return PlantState(end[:N_STATES], loads[-1], end[N_STATES:]), trace


@cache
def _sample(n_substeps: int) -> ca.Function:
    """(state, u, p, actuator, h) -> state at the end; vehicle states and outputs at the start of each step."""
    step = _step()
    start, u = ca.MX.sym("state", N_STATES + 1), ca.MX.sym("u", N_INPUTS)
    held = [ca.MX.sym(f"held{i}", *step.size_in(i)) for i in range(2, step.n_in())]
    repeated = [ca.repmat(each, 1, n_substeps) for each in (u, *held)]
    ends, outputs = step.mapaccum("planar", n_substeps).call([start, *repeated])
    states = ca.horzcat(start, ends[:, :-1])[:N_STATES, :]
    return ca.Function("planar", [start, u, *held], [ends[:, -1], states, outputs])


def _step() -> ca.Function:
    """(state, u, p, actuator, h) -> state after h; [steering, ax, ay, loads, slip angles, Fx, Fy] at its start."""
    xi, u, _, p = symbols()
    steering, actuator, h = ca.SX.sym("steering"), ca.SX.sym("actuator", 2), ca.SX.sym("h")
    lock, rate = actuator[0], actuator[1]
    wanted = ca.fmax(-lock, ca.fmin(lock, u[DELTA]))
    reached = steering + ca.fmax(-rate * h, ca.fmin(rate * h, wanted - steering))
    direction = ca.fmax(-1, ca.fmin(1, xi[VX] / STANDSTILL))
    forces = [ca.if_else(u[i] < 0, direction * u[i], u[i]) for i in range(1, N_INPUTS)]
    acting = ca.vertcat(reached, *forces)
    loads = quasi_static_loads(xi, acting, p)
    now = two_track(xi, acting, loads, p)
    end = rk4(lambda x: ca.vertcat(*two_track(x, acting, loads, p).derivative), xi, h)
    outputs = ca.vertcat(reached, *now.acceleration, *loads, *now.slip_angles, *now.longitudinal, *now.lateral)
    return ca.Function(
        "step", [ca.vertcat(xi, steering), u, ca.vertcat(*p), actuator, h], [ca.vertcat(end, reached), outputs]
    )
