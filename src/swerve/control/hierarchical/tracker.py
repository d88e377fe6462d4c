"""The tracker: linear time-varying predictive control of the two-track model along a manoeuvre.

minimise    distance from the path and the speed profile (`path_tracking`), changes of the inputs, wheel forces
over        steering angle and four wheel forces of Nc samples
subject to  the model (1), linearised along the shifted plan of the last step, steering lock and rate,
            wheel forces that leave room for the lateral demand, slip angles below the tyre's peak (soft)

A quadratic program in each of a few iterations; a change is taken as far as the nonlinear roll-out confirms it.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.actuation import Actuation
from swerve.control.hierarchical.manoeuvre import Manoeuvre
from swerve.control.hierarchical.path_tracking import PathTracking
from swerve.control.hierarchical.settings import HierarchicalSettings
from swerve.control.settings import Horizon, Weights
from swerve.control.unified.acceptance import Step, accept
from swerve.control.unified.condensing import Blocking, condense
from swerve.control.unified.limits import InputBox, Penalty, SlipLimit, SteeringRateLimit
from swerve.control.unified.prediction import PredictionModel, Trajectory
from swerve.control.unified.program import Program
from swerve.control.unified.terms import InputRate, WheelForce
from swerve.conventions import DELTA, VX
from swerve.qp import solve
from swerve.vehicle import Vehicle

Array = NDArray[np.float64]

FORCE_WEIGHT = 1e-8  # [1/N^2] settles the forces that the motion does not see
TRUST = np.array([0.08, 4e3, 4e3, 4e3, 4e3])  # [rad, N, N, N, N] largest change in an iteration
NOTHING = 1e-6  # [1] relative fall of the cost that is not worth a roll-out


@dataclass(frozen=True, eq=False)
class Tracked:
    """What the tracker found.

    Attributes:
        trajectory: that it would drive.
        cost: of it: the tracker's own, what limits are missed by included [1].
        n_solved: quadratic programs solved.
        n_failed: quadratic programs without an answer.
    """

    trajectory: Trajectory
    cost: float
    n_solved: int
    n_failed: int


class Tracker:
    """The tracker of one vehicle on a road of known friction."""

    def __init__(
        self,
        model: PredictionModel,
        vehicle: Vehicle,
        friction: float,
        weights: Weights,
        settings: HierarchicalSettings,
        actuation: Actuation,
    ) -> None:
        """With the model's horizon, the inputs that there are, and the weights on them that every controller has."""
        self._model, self._vehicle, self._friction = model, vehicle, friction
        self._horizon: Horizon = model.horizon
        self._blocking = Blocking(self._horizon, actuation)
        self._input_rate = InputRate.of(np.array([weights.steering_rate] + 4 * [weights.force_rate]), self._blocking)
        self._force = WheelForce(FORCE_WEIGHT, self._blocking)
        self._weights = np.array([settings.lateral_offset, settings.heading, settings.speed])
        penalty = Penalty(settings.slip_penalty, settings.slip_penalty_quadratic)
        self._slip, self._iterations = SlipLimit(settings.slip_limit, penalty), settings.iterations
        self._times = self._horizon.sample_time * np.arange(1.0, self._horizon.prediction + 1.0)

    def __call__(self, manoeuvre: Manoeuvre, state: Array, command: Array, guess: Array, loads: Array) -> Tracked:
        """Inputs that follow a manoeuvre.

        Args:
            manoeuvre: to follow.
            state: (6,) where it begins.
            command: (5,) input given last.
            guess: (Np, 5) inputs to begin with.
            loads: (4,) of the wheels [N].
        """
        program = self._program(manoeuvre, state, command, loads)

        def roll_out(inputs: Array) -> Step:
            trajectory = self._model.roll_out(state, program.clip(inputs), loads)
            return Step(trajectory, program.score(trajectory))

        step, n_solved = roll_out(guess), 0
        for _ in range(self._iterations):
            linear = self._model.linearise(step.trajectory, loads)
            solution = solve(program.convex(step.trajectory, condense(linear, self._blocking), TRUST))
            if not solution.is_solved:
                return Tracked(step.trajectory, step.merit, n_solved, 1)
            n_solved += 1
            promise = step.score.penalty - solution.cost
            if promise < NOTHING * (1 + step.merit):
                break
            step = accept(step, self._blocking.spread(solution.x[: self._blocking.n]), promise, roll_out)
        return Tracked(step.trajectory, step.merit, n_solved, 0)

    def _program(self, manoeuvre: Manoeuvre, state: Array, command: Array, loads: Array) -> Program:
        """Cost and limits of this step."""
        path = PathTracking(manoeuvre.lateral, manoeuvre.speeds(float(state[VX]), self._times), self._weights)
        box = InputBox.of(self._vehicle, self._friction, loads, self._blocking)
        rate = self._vehicle.steering_rate_limit * self._horizon.sample_time
        hard = [SteeringRateLimit(rate, float(command[DELTA]), self._blocking)] if np.isfinite(rate) else []
        return Program((path, self._input_rate.after(command), self._force), box, hard, (self._slip,))
