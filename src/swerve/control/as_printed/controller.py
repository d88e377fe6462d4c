"""Sec. 4 of the paper to the letter, misprints included, each with a switch that puts it right.

It is the reference that everything is compared with; as printed it drives into the obstacle.
What the paper leaves open: u_max (the vehicle's steering lock and share of the friction circle, static loads), R (the
scenario's weights), and what is done when the program has no solution: the last command is held.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.as_printed.discretisation import euler, exact
from swerve.control.as_printed.linearisation import kernel_function
from swerve.control.as_printed.program import INPUT_SCALE, OUTPUTS, canonical, obstacle_rows, response
from swerve.control.as_printed.settings import AsPrintedSettings
from swerve.control.plan import Fallback, Plan, Side
from swerve.control.protocol import Controller
from swerve.control.settings import Goal, Horizon, Weights
from swerve.conventions import N_INPUTS, N_STATES, X, Y
from swerve.kernel import Kernel
from swerve.qp import Solution, solve
from swerve.signals import Command, Measurement, Observation
from swerve.vehicle import Vehicle
from swerve.vehicle.two_track import Parameters
from swerve.world import Ellipse

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Memory:
    """The input that acts now, u_k (5,)."""

    command: Array


class AsPrintedController(Controller[Memory]):
    """The paper's controller, for a point ego and elliptical obstacles (5)."""

    def __init__(
        self,
        vehicle: Vehicle,
        friction: float,
        goal: Goal,
        horizon: Horizon,
        weights: Weights,
        settings: AsPrintedSettings,
    ) -> None:
        """Build the kernel for this set of corrections; a first time compiles it."""
        self._vehicle, self._friction, self._horizon = vehicle, friction, horizon
        self._corrections = frozenset(settings.corrections)
        self._parameters = Parameters.of(vehicle, friction).as_array()
        self._reference = np.array([goal.speed, 0.0, goal.lateral_offset])
        self._Q = np.array([weights.speed, weights.lateral_speed, weights.lateral_offset])
        self._R = np.array([weights.steering_rate] + 4 * [weights.force_rate])
        full, with_mass = "jacobian" in self._corrections, "mass" in self._corrections
        self._linearise = Kernel(kernel_function(full=full, with_mass=with_mass))

    def start(self) -> Memory:
        """Wheels straight, no force."""
        return Memory(np.zeros(N_INPUTS))

    def step(self, measurement: Measurement, memory: Memory) -> tuple[Command, Plan, Memory]:
        """One sample: linearise at the measured state, solve, command the first change."""
        if not measurement.is_finite:
            return self._hold(measurement.time, memory, Fallback.NOT_FINITE)
        if measurement.time - measurement.stamp > self._horizon.sample_time / 2:
            return self._hold(measurement.time, memory, Fallback.LATE)
        free, W = self._predict(measurement, memory.command)
        solution = self._solve(measurement, memory.command, free, W)
        if not solution.is_solved:
            return self._hold(measurement.time, memory, Fallback.NO_SOLUTION, solver_failures=1)
        return self._command(measurement, memory.command, solution, free, W)

    def _predict(self, measurement: Measurement, u: Array) -> tuple[Array, Array]:
        f, A, B = self._linearise(measurement.state, u, measurement.wheel_loads, self._parameters)
        discretise = exact if "discretisation" in self._corrections else euler
        model = discretise(f, A, B, self._horizon.sample_time)
        return response(
            model, self._horizon, with_drift="drift" in self._corrections, hold_input="hold-input" in self._corrections
        )

    def _solve(self, measurement: Measurement, u: Array, free: Array, W: Array) -> Solution:
        largest = np.append(
            self._vehicle.steering_limit, self._vehicle.force_limit * self._friction * measurement.wheel_loads
        )
        ahead = self._horizon.sample_time * np.arange(1.0, self._horizon.prediction + 1.0)
        rho, gradient = _linearised_rho(measurement, ahead)
        rows = obstacle_rows(free, W, rho, gradient)
        deviation = self._reference - measurement.state[list(OUTPUTS)]
        return solve(canonical(free, W, deviation, self._Q, self._R, -largest - u, largest - u, rows))

    def _command(
        self, measurement: Measurement, u: Array, solution: Solution, free: Array, W: Array
    ) -> tuple[Command, Plan, Memory]:
        changes = solution.x.reshape(-1, N_INPUTS) * INPUT_SCALE
        deviations = np.cumsum(changes, axis=0)
        states = measurement.state + np.vstack([np.zeros(N_STATES), free + W @ deviations.ravel()])
        n_after = self._horizon.prediction - len(deviations)
        after = deviations[-1] if "hold-input" in self._corrections else np.zeros(N_INPUTS)
        inputs = u + np.vstack([deviations, np.tile(after, (n_after, 1))])
        held = solution.row_multipliers[deviations.size :]
        side = None if np.abs(held).max(initial=0.0) < 1e-9 else _side(states)
        plan = Plan(measurement.time, inputs, states, side, is_shaped=side is not None)
        return Command.from_input(inputs[0]), plan, Memory(inputs[0])

    def _hold(
        self, time: float, memory: Memory, reason: Fallback, solver_failures: int = 0
    ) -> tuple[Command, Plan, Memory]:
        inputs = np.tile(memory.command, (self._horizon.prediction, 1))
        plan = Plan(time, inputs, np.empty((0, N_STATES)), fallback=reason, solver_failures=solver_failures)
        return Command.from_input(memory.command), plan, memory


def _linearised_rho(measurement: Measurement, ahead: Array) -> tuple[Array, Array]:
    """rho^k (m, Np) and its gradient (m, Np, 2) at (X_k, Y_k), for each obstacle where it will be `ahead` [s]."""
    m = len(measurement.obstacles)
    rho, gradient = np.zeros((m, len(ahead))), np.zeros((m, len(ahead), 2))
    here = measurement.state[[X, Y]]
    for i, seen in enumerate(measurement.obstacles):
        offset = here - seen.as_obstacle().position_at(ahead)
        cos, sin = np.cos(seen.heading), np.sin(seen.heading)
        turn = np.array([[cos, sin], [-sin, cos]])
        scaled = offset @ turn.T / _semi_axes(seen)
        rho[i] = np.sum(scaled**2, axis=1)
        gradient[i] = 2 * (scaled / _semi_axes(seen)) @ turn
    return rho, gradient


def _semi_axes(seen: Observation) -> Array:
    """(a, b) of (5) [m]; a rectangle, which the paper does not know, is taken by the smallest ellipse round it."""
    if isinstance(seen.shape, Ellipse):
        return np.array(seen.shape.semi_axes)
    return np.asarray(np.sqrt(2) * seen.shape.support(np.eye(2)))


def _side(states: Array) -> Side:
    """The side to which the predicted path goes."""
    return Side.LEFT if states[-1, Y] >= states[0, Y] else Side.RIGHT
