"""Nonlinear model predictive control: left and right solved to convergence, the cheaper one taken.

Cost (10), limits, horizons, weights and first guesses are those of `unified`; what differs is that each step's program
is solved until it is solved, with exact second derivatives, in place of a few convex ones, and that it goes on beyond
the horizon. When a side has no solution within the iteration limit the cheapest motion of the model that was met on the
way stands in; when both have none, or the measurement is no use, the plan says so by its `fallback`.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from swerve.control.actuation import Actuation
from swerve.control.appraisal import Appraisal
from swerve.control.fallback import fallback_plan, full_braking, shifted
from swerve.control.forecast import forecasts
from swerve.control.friction_use import friction_use
from swerve.control.nonlinear.memory import Memory
from swerve.control.nonlinear.program import NonlinearProgram
from swerve.control.nonlinear.settings import NonlinearSettings
from swerve.control.nonlinear.side_plan import SidePlan, choose
from swerve.control.nonlinear.sides import Sides
from swerve.control.nonlinear.values import Question
from swerve.control.plan import Fallback, Plan, Side
from swerve.control.protocol import Controller
from swerve.control.settings import Goal, Horizon, Latency, Weights
from swerve.control.unified.compensation import is_late, n_commands, state_at_effect
from swerve.control.unified.way import Way
from swerve.conventions import N_INPUTS, VX
from swerve.signals import Command, Measurement
from swerve.vehicle import Vehicle
from swerve.world import Footprint, Obstacle, Road, Shape, Steady

Array = NDArray[np.float64]


class NonlinearController(Controller[Memory]):
    """Collision avoidance by nonlinear programming, for one vehicle on a road of known friction."""

    def __init__(
        self,
        vehicle: Vehicle,
        footprint: Footprint,
        road: Road,
        friction: float,
        goal: Goal,
        horizon: Horizon,
        weights: Weights,
        latency: Latency,
        settings: NonlinearSettings,
        shapes: Sequence[Shape],
        actuation: Actuation,
    ) -> None:
        """Compile the program; the arguments, and what is raised, are those of `NonlinearProgram`.

        Of the road's edges its plans tell, but it does not watch them.
        """
        self._friction, self._commitment, self._latency = friction, settings.commitment, latency
        limits = weights, settings, shapes, actuation
        self.program = NonlinearProgram(vehicle, footprint, friction, goal, horizon, *limits)
        self._horizon = self.program.horizon
        self._sides = Sides(self.program, vehicle, friction, settings, horizon.prediction)
        self._appraisal = Appraisal(footprint, road, settings.clearance_margin, self._horizon)
        self._braking = full_braking(vehicle, friction, self._horizon.prediction, actuation)

    def start(self) -> Memory:
        """Wheels straight, no force, no plan."""
        commands = (np.zeros(N_INPUTS),) * n_commands(self._latency, self._horizon.sample_time)
        nothing = np.zeros((self._horizon.prediction, N_INPUTS))
        return Memory(commands, dict.fromkeys(Side, nothing), dict.fromkeys(Side, 0), None, None, 0)

    def step(self, measurement: Measurement, memory: Memory) -> tuple[Command, Plan, Memory]:
        """One sample: both sides solved, the better one's first input commanded."""
        with np.errstate(all="ignore"):  # a guess that diverges costs nan or inf, and is not taken
            if not measurement.is_finite:
                return self._fall_back(measurement.time, Fallback.NOT_FINITE, memory)
            if is_late(measurement, self._latency, self._horizon.sample_time):
                return self._fall_back(measurement.time, Fallback.LATE, memory)
            question = self._question(measurement, memory)
            plans = self._sides.plans(question, memory)
            if not all(np.isfinite(each.inputs).all() for each in plans.values()):
                return self._fall_back(measurement.time, Fallback.NO_SOLUTION, memory, n_failed=len(plans))
            return self._take(measurement, question, plans, memory)

    def _question(self, measurement: Measurement, memory: Memory) -> Question:
        """What to plan from: the vehicle and the obstacles where they are when this step's command begins to act."""
        delay = self._latency.effect(float(measurement.state[VX]))
        state = state_at_effect(measurement, memory.commands, delay, self.program.model)
        after = measurement.time - measurement.stamp + delay
        obstacles = tuple(_later(seen.as_obstacle(), after) for seen in measurement.obstacles)
        return Question(state, memory.commands[0], measurement.wheel_loads, obstacles)

    def _take(
        self, measurement: Measurement, question: Question, plans: Mapping[Side, SidePlan], memory: Memory
    ) -> tuple[Command, Plan, Memory]:
        """The better side's plan as command, and what the next step is to know."""
        taken, reason = choose(plans, memory.committed, self._commitment)
        n_failed = sum(not each.is_solved for each in plans.values())
        seen = forecasts(measurement.stamp, measurement.obstacles, ())
        start = measurement.time + self._latency.effect(float(measurement.state[VX]))
        branches = {
            each.side: self._appraisal.branch(each.side.name.lower(), each.cost, each.states, start, seen)
            for each in plans.values()
        }
        passing = branches[taken.side].passing
        way = Way(passing, () if taken.held_by is None else (taken.held_by,))
        demand = self.program.model.roll_out(question.state, taken.inputs, question.wheel_loads).lateral_demand[0]
        plan = Plan(
            measurement.time,
            taken.inputs,
            taken.states,
            way.side,
            way.name,
            taken.held_by is not None,
            tuple(branches[side] for side in Side),
            reason,
            friction_use=friction_use(taken.inputs[0], demand, self._friction * question.wheel_loads),
            fallback=Fallback.NO_SOLUTION if n_failed == len(plans) else None,
            solver_failures=n_failed,
        )
        command = plan.inputs[0]
        is_shaped = any(each.held_by is not None for each in plans.values())
        memory = Memory(
            memory.after(command),
            {side: each.inputs for side, each in plans.items()},
            {side: 0 if each.is_clear else memory.missed[side] + 1 for side, each in plans.items()},
            taken.side if is_shaped else None,
            plan,
            0,
        )
        return Command.from_input(command), plan, memory

    def _fall_back(
        self, time: float, reason: Fallback, memory: Memory, n_failed: int = 0
    ) -> tuple[Command, Plan, Memory]:
        """The command of the documented fallback; the memory's plans move on by one sample."""
        age = memory.age + 1
        plan = replace(fallback_plan(time, reason, memory.plan, age, self._braking), solver_failures=n_failed)
        command = plan.inputs[0]
        moved = {side: shifted(inputs) for side, inputs in memory.inputs.items()}
        memory = replace(memory, commands=memory.after(command), inputs=moved, age=age)
        return Command.from_input(command), plan, memory


def _later(obstacle: Obstacle, after: float) -> Obstacle:
    """The obstacle with `after` [s] as its time zero."""
    (x, y), (vx, vy) = obstacle.position_at(after).tolist(), obstacle.velocity_at(after).tolist()
    return replace(obstacle, motion=Steady((x, y), (vx, vy), float(obstacle.heading_at(after))))
