"""Nonlinear model predictive control: left and right solved to convergence, the cheaper one taken.

Cost (10), limits, horizons, weights and first guesses are those of `unified`; what differs is that each step's program
is solved until it is solved, with exact second derivatives, in place of a few convex ones, and that it goes on beyond
the horizon. A program has many local minima: one that is not clear is held against those of other first guesses. When a
side has no solution within the iteration limit the cheapest motion of the model that was met on the way stands in; when
both have none, or the measurement is no use, the plan says so by its `fallback`.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice

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
from swerve.control.nonlinear.values import Guess, Question
from swerve.control.plan import KEEP, Fallback, Passing, Plan, Side
from swerve.control.protocol import Controller
from swerve.control.settings import Goal, Horizon, Latency, Weights
from swerve.control.unified.compensation import is_late, n_commands, state_at_effect
from swerve.control.unified.seeds import seeds
from swerve.control.unified.way import Way
from swerve.conventions import N_INPUTS, VX
from swerve.signals import Command, Measurement
from swerve.vehicle import Vehicle
from swerve.world import Footprint, Obstacle, Road, Shape, Steady

Array = NDArray[np.float64]

CLEAR = 5e-3  # [m] a margin that is missed by less counts as kept
EQUAL = 1e-4  # [1] difference of two costs, relative and absolute, that is the solver's tolerance
TRIES = 3  # first guesses of a side from which it is solved at most
ACTIVE = 1e-2  # [1/m] a multiplier beyond this holds the plan off an obstacle


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
        self._vehicle, self._friction, self._settings = vehicle, friction, settings
        self._latency, limits = latency, (weights, settings, shapes, actuation)
        self.program = NonlinearProgram(vehicle, footprint, friction, goal, horizon, *limits)
        self._horizon, self._n_tracked = self.program.horizon, horizon.prediction
        self._appraisal = Appraisal(footprint, road, settings.clearance_margin, self._horizon)
        self._braking = full_braking(vehicle, friction, self._horizon.prediction, actuation)

    def start(self) -> Memory:
        """Wheels straight, no force, no plan."""
        commands = (np.zeros(N_INPUTS),) * n_commands(self._latency, self._horizon.sample_time)
        nothing = np.zeros((self._horizon.prediction, N_INPUTS))
        return Memory(commands, dict.fromkeys(Side, nothing), None, None, 0)

    def step(self, measurement: Measurement, memory: Memory) -> tuple[Command, Plan, Memory]:
        """One sample: both sides solved, the better one's first input commanded."""
        with np.errstate(all="ignore"):  # a guess that diverges costs nan or inf, and is not taken
            if not measurement.is_finite:
                return self._fall_back(measurement.time, Fallback.NOT_FINITE, memory)
            if is_late(measurement, self._latency, self._horizon.sample_time):
                return self._fall_back(measurement.time, Fallback.LATE, memory)
            question = self._question(measurement, memory)
            plans = {side: self._plan(side, question, memory) for side in Side}
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
        self, measurement: Measurement, question: Question, plans: "Mapping[Side, _SidePlan]", memory: Memory
    ) -> tuple[Command, Plan, Memory]:
        """The better side's plan as command, and what the next step is to know."""
        taken, reason = _choose(plans, memory.committed, self._settings.commitment)
        n_failed = sum(not each.is_solved for each in plans.values())
        seen = forecasts(measurement.stamp, measurement.obstacles, ())
        start = measurement.time + self._latency.effect(float(measurement.state[VX]))
        of_side = (self._appraisal.branch(each.name, each.cost, each.states, start, seen) for each in plans.values())
        demand = self.program.model.roll_out(question.state, taken.inputs, question.wheel_loads).lateral_demand[0]
        plan = Plan(
            measurement.time,
            taken.inputs,
            taken.states,
            taken.side if taken.is_shaped else None,
            taken.name if taken.is_shaped else KEEP,
            taken.is_shaped,
            tuple(of_side),
            reason if taken.is_shaped else "nothing is in the way of the cheapest",
            friction_use=friction_use(taken.inputs[0], demand, self._friction * question.wheel_loads),
            fallback=Fallback.NO_SOLUTION if n_failed == len(plans) else None,
            solver_failures=n_failed,
        )
        command = plan.inputs[0]
        inputs = {side: each.inputs for side, each in plans.items()}
        committed = taken.side if any(each.is_shaped for each in plans.values()) else None
        return Command.from_input(command), plan, Memory(memory.after(command), inputs, committed, plan, 0)

    def _plan(self, side: Side, question: Question, memory: Memory) -> "_SidePlan":
        """The plan of one side: the first solution that is clear, else the best that was found."""
        found = []
        for guess in islice(self._guesses(side, question, memory), TRIES):
            found.append(self._plan_from(guess, side, question))
            if found[-1].is_solved and found[-1].is_clear:
                break
        return min(found, key=lambda each: (not each.is_clear, each.cost))

    def _plan_from(self, guess: Guess, side: Side, question: Question) -> "_SidePlan":
        """What the solver finds from a guess; where it finds nothing, the cheaper of the guess and what it came to."""
        if not guess.is_sane:
            return _SidePlan(side, guess.inputs, guess.states, np.inf, np.inf, True, False)
        answer = self.program.solve(question, guess)
        if not answer.is_solved:
            ended = self.program.guess(question, answer.inputs)
            cheaper = ended if ended.is_sane and ended.cost < guess.cost else guess
            missed = cheaper.missed_clearance
            return _SidePlan(side, cheaper.inputs, cheaper.states, cheaper.cost, missed, missed > CLEAR, False)
        is_held = bool((np.abs(self.program.gap_multipliers(answer)) > ACTIVE).any())
        missed = answer.missed_clearance
        return _SidePlan(side, answer.inputs, answer.states, answer.cost, missed, is_held or missed > CLEAR, True)

    def _guesses(self, side: Side, question: Question, memory: Memory) -> Iterator[Guess]:
        """The last plan of a side one sample later, if that is clear; else it and the first guesses, cheapest first."""
        guess = self.program.guess(question, shifted(memory.inputs[side]))
        if guess.missed_clearance <= CLEAR:
            yield guess
        speed, limit = float(question.state[VX]), self._settings.slip_limit
        way, largest = Way((Passing(side.value),), (0,)), self.program.largest(question)
        pulses = seeds(self._vehicle, self._friction, limit, speed, way, largest, self._n_tracked)
        rolling = np.zeros((self._settings.tail, N_INPUTS))
        others = (guess, *(self.program.guess(question, np.vstack([each, rolling])) for each in pulses))
        yield from sorted(others, key=lambda each: each.cost if np.isfinite(each.cost) else np.inf)

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


@dataclass(frozen=True, eq=False)
class _SidePlan:
    """What is planned for one side."""

    side: Side
    inputs: Array
    states: Array
    cost: float
    violation: float
    is_shaped: bool
    is_solved: bool

    @property
    def is_clear(self) -> bool:
        """Whether it keeps all margins."""
        return self.violation <= CLEAR

    @property
    def name(self) -> str:
        """The side in a word."""
        return self.side.name.lower()


def _choose(plans: Mapping[Side, _SidePlan], committed: Side | None, commitment: float) -> tuple[_SidePlan, str]:
    """Clear before not clear, then cheaper, left when equal; a side once taken is kept while it is as good as this."""
    left, right = plans[Side.LEFT], plans[Side.RIGHT]
    if left.is_clear != right.is_clear:
        return left if left.is_clear else right, "the only side that is clear"
    if committed is None:
        return left if left.cost <= right.cost * (1 + EQUAL) + EQUAL else right, "the cheaper side"
    here, there = plans[committed], plans[Side(-committed.value)]
    if there.cost < commitment * here.cost:
        return there, f"costs less than {commitment:.0%} of the side so far, {here.name}"
    return here, "the side so far, and the other is not much cheaper"


def _later(obstacle: Obstacle, after: float) -> Obstacle:
    """The obstacle with `after` [s] as its time zero."""
    (x, y), (vx, vy) = obstacle.position_at(after).tolist(), obstacle.velocity_at(after).tolist()
    return replace(obstacle, motion=Steady((x, y), (vx, vy), float(obstacle.heading_at(after))))
