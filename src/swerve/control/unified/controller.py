"""The unified controller: one optimisation decides and drives, side by side for left and right, the cheaper one taken.

minimise  sum_i |eta(k+i) - eta_ref|_Q^2 + sum_j |du(k+j)|_R^2 + w sum |Fx|^2 + penalties            (10)
with      the nonlinear two-track model (1), linearised along each side's shifted plan               (12), (13)
within    steering lock, wheel forces that leave room for the lateral demand                         (14)
          half-planes between footprint and obstacles, slip angles below the tyre's peak             (15)
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Branch, Fallback, Plan, Side
from swerve.control.protocol import Controller
from swerve.control.settings import Goal, Horizon, Latency, Weights
from swerve.control.unified.acceptance import Step
from swerve.control.unified.branch import TRUST_AFTER_A_STEP, SidePlan, Situation, improve
from swerve.control.unified.choice import CLEAR, choose
from swerve.control.unified.compensation import is_late, n_commands, state_at_effect
from swerve.control.unified.condensing import Blocking
from swerve.control.unified.fallback import fallback_plan
from swerve.control.unified.limits import InputBox, ObstacleLimit, Penalty, SlipLimit, SteeringRateLimit
from swerve.control.unified.memory import Memory, shifted
from swerve.control.unified.prediction import PredictionModel
from swerve.control.unified.program import Program
from swerve.control.unified.seeds import seeds
from swerve.control.unified.settings import UnifiedSettings
from swerve.control.unified.tail import Tail
from swerve.control.unified.terms import InputRate, Tracking, WheelForce
from swerve.conventions import DELTA, N_INPUTS, VX, VY, Y
from swerve.signals import Command, Measurement
from swerve.vehicle import Vehicle
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters
from swerve.world import Footprint

Array = NDArray[np.float64]

NEARLY = 0.1  # [m] a margin missed by less is mended by more iterations, by more with new guesses


class UnifiedController(Controller[Memory]):
    """Collision avoidance by sequential convex programming, for one vehicle on a road of known friction."""

    def __init__(
        self,
        vehicle: Vehicle,
        footprint: Footprint,
        friction: float,
        goal: Goal,
        horizon: Horizon,
        weights: Weights,
        latency: Latency,
        settings: UnifiedSettings,
    ) -> None:
        """Build the kernels; a first time compiles them."""
        self._vehicle, self._footprint, self._friction = vehicle, footprint, friction
        self._horizon, self._latency, self._settings = horizon, latency, settings
        self._model = PredictionModel(vehicle, friction, horizon)
        self._blocking = Blocking(horizon)
        self._times = np.arange(2 * horizon.prediction + 1) * horizon.sample_time / 2
        self._tail = Tail.of(friction, horizon.prediction, horizon.sample_time)
        self._tracking = (
            Tracking(VX, goal.speed, weights.speed),
            Tracking(VY, 0.0, weights.lateral_speed),
            Tracking(Y, goal.lateral_offset, weights.lateral_offset),
        )
        rates = np.array([weights.steering_rate] + 4 * [weights.force_rate])
        self._input_rate = InputRate.of(rates, self._blocking)
        self._force = WheelForce(settings.force_weight, self._blocking)
        self._trust = np.array([settings.trust_steering] + 4 * [settings.trust_force])
        self._clearance = Penalty(settings.clearance_penalty, settings.clearance_penalty_quadratic)
        self._slip = SlipLimit(settings.slip_limit, Penalty(settings.slip_penalty, settings.slip_penalty_quadratic))

    def start(self) -> Memory:
        """Wheels straight, no force, no plan."""
        nothing = (np.zeros(N_INPUTS),) * n_commands(self._latency, self._horizon.sample_time)
        return Memory(nothing, {}, {}, Side.LEFT, None, None, 0)

    def step(self, measurement: Measurement, memory: Memory) -> tuple[Command, Plan, Memory]:
        """One sample: both sides improved, the better one taken, its first input commanded."""
        with np.errstate(all="ignore"):  # a motion that diverges scores inf, and a program with nan fails
            return self._step(measurement, memory)

    def _step(self, measurement: Measurement, memory: Memory) -> tuple[Command, Plan, Memory]:
        reason = self._unusable(measurement)
        if reason is not None:
            return self._fall_back(measurement.time, reason, memory)
        sides = self._plan_sides(measurement, memory)
        if not any(plan.n_solved for plan in sides.values()):
            n_failed = sum(plan.n_failed for plan in sides.values())
            return self._fall_back(measurement.time, Fallback.NO_SOLUTION, memory, n_failed)
        return self._take(measurement.time, sides, memory)

    def _plan_sides(self, measurement: Measurement, memory: Memory) -> dict[Side, SidePlan]:
        """The plan of each side, the committed one first.

        Where no obstacle is in reach of a plan both sides are one program, solved once; beside a committed side that
        is clear the other one is a spare.
        """
        first = memory.taken
        situation = self._situation(first, measurement, memory)
        step = self._shifted(situation, memory)
        is_shared = not situation.is_near(step)
        sides = {first: self._plan_side(situation, step, memory, is_spare=False)}
        other = Side(-first.value)
        if is_shared and not situation.is_near(sides[first].step):
            return {first: sides[first], other: replace(sides[first], side=other, n_solved=0, n_failed=0)}
        situation = self._situation(other, measurement, memory)
        is_spare = memory.committed is not None and sides[first].violation <= CLEAR
        sides[other] = self._plan_side(situation, self._shifted(situation, memory), memory, is_spare=is_spare)
        return sides

    def _shifted(self, situation: Situation, memory: Memory) -> Step:
        """The last plan of a side one sample later, from the measured state; all zeros when there is none."""
        known = memory.inputs.get(situation.side)
        nothing = np.zeros((self._horizon.prediction, N_INPUTS))
        return situation.roll_out(nothing if known is None else shifted(known))

    def _plan_side(self, situation: Situation, step: Step, memory: Memory, *, is_spare: bool) -> SidePlan:
        """The plan of one side, from its shifted plan on; a spare one gets a single iteration and no seeds."""
        trust = max(memory.trust.get(situation.side, 1.0), TRUST_AFTER_A_STEP)
        is_new = situation.side not in memory.inputs and situation.missed_clearance(step) > CLEAR
        plan = improve(situation, step, trust, 0 if is_new else 1 if is_spare else self._settings.iterations)
        if is_spare or plan.violation <= CLEAR:
            return plan
        if plan.violation <= NEARLY:
            again = improve(situation, plan.step, plan.trust, self._settings.iterations)
        else:
            again = improve(situation, self._best_guess(situation, plan.step), 1.0, self._settings.first_iterations)
        return replace(
            again, is_shaped=True, n_solved=plan.n_solved + again.n_solved, n_failed=plan.n_failed + again.n_failed
        )

    def _best_guess(self, situation: Situation, step: Step) -> Step:
        """The step or the first guess for this side, whichever costs less when it is rolled out."""
        speed, n_samples = float(situation.start[VX]), self._horizon.prediction
        limit = self._settings.slip_limit
        guesses = seeds(self._vehicle, self._friction, limit, speed, situation.side, n_samples)
        rolled = [step, *(situation.roll_out(inputs) for inputs in guesses)]
        return min(rolled, key=lambda each: each.merit)

    def _situation(self, side: Side, measurement: Measurement, memory: Memory) -> Situation:
        """Cost and limits of this step for passing on one side."""
        box = InputBox.of(self._vehicle, self._friction, measurement.wheel_loads, self._blocking)
        delay = self._latency.effect(float(measurement.state[VX]))
        start = state_at_effect(measurement, memory.commands, delay, self._model)
        times = self._times + (measurement.time - measurement.stamp + delay)
        obstacles = [
            ObstacleLimit(
                seen.as_obstacle(),
                self._footprint,
                side,
                times,
                self._tail,
                self._settings.clearance_margin,
                self._clearance,
            )
            for seen in measurement.obstacles
        ]
        rate = self._vehicle.steering_rate_limit * self._horizon.sample_time
        hard = [SteeringRateLimit(rate, float(memory.command[DELTA]), self._blocking)] if np.isfinite(rate) else []
        terms = (*self._tracking, self._input_rate.after(memory.command), self._force)
        program = Program(terms, box, hard, (*obstacles, self._slip))
        return Situation(side, program, self._model, start, measurement.wheel_loads, self._trust)

    def _take(self, time: float, sides: dict[Side, SidePlan], memory: Memory) -> tuple[Command, Plan, Memory]:
        """The better side's plan as command, and what the next step is to know."""
        taken = choose(sides, memory.committed, self._settings.commitment)
        is_shaped = any(plan.is_shaped or plan.violation > CLEAR for plan in sides.values())
        plan = Plan(
            time,
            taken.step.trajectory.inputs,
            taken.step.trajectory.states,
            taken.side if taken.is_shaped else None,
            tuple(Branch(each.side, each.step.merit, each.violation) for each in sides.values()),
            solver_failures=sum(each.n_failed for each in sides.values()),
        )
        inputs = {side: each.step.trajectory.inputs for side, each in sides.items()}
        trust = {side: each.trust for side, each in sides.items()}
        return (
            Command.from_input(plan.inputs[0]),
            plan,
            Memory(memory.after(plan.inputs[0]), inputs, trust, taken.side, taken.side if is_shaped else None, plan, 0),
        )

    def _unusable(self, measurement: Measurement) -> Fallback | None:
        """Why a measurement can't be planned from, if it can't."""
        if not measurement.is_finite:
            return Fallback.NOT_FINITE
        return Fallback.LATE if is_late(measurement, self._latency, self._horizon.sample_time) else None

    def _fall_back(
        self, time: float, reason: Fallback, memory: Memory, solver_failures: int = 0
    ) -> tuple[Command, Plan, Memory]:
        """The command of the documented fallback; the memory's plans move on by one sample."""
        loads = np.array(wheel_loads(Parameters.of(self._vehicle, self._friction)))
        largest = InputBox.of(self._vehicle, self._friction, loads, self._blocking).largest
        plan = fallback_plan(time, reason, memory, largest, self._horizon.prediction)
        moved = {side: shifted(inputs) for side, inputs in memory.inputs.items()}
        return (
            Command.from_input(plan.inputs[0]),
            replace(plan, solver_failures=solver_failures),
            replace(memory, commands=memory.after(plan.inputs[0]), inputs=moved, age=memory.age + 1),
        )
