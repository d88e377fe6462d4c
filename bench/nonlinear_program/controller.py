"""The nonlinear program in a receding horizon: left and right solved to convergence, the cheaper one taken.

A peer to measure the unified controller against, with its cost, limits and first guesses, and no more than a peer
needs: it takes measurements to be finite and current, and knows no commitment to a side.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bench.nonlinear_program.program import NonlinearProgram
from bench.nonlinear_program.values import Guess, Question
from swerve.control import Branch, Controller, Fallback, Goal, Horizon, Plan, Side, Weights
from swerve.control.unified import UnifiedSettings
from swerve.control.unified.memory import shifted
from swerve.control.unified.seeds import seeds
from swerve.conventions import N_INPUTS, VX
from swerve.signals import Command, Measurement
from swerve.vehicle import Vehicle

Array = NDArray[np.float64]

CLEAR = 5e-3  # [m] a guess that misses a margin by less needs no other
EQUAL = 1e-4  # [1] difference of two costs, relative and absolute, that is the solver's tolerance
ACTIVE = 1e-2  # [1/m] a multiplier beyond this holds the plan off an obstacle


@dataclass(frozen=True, eq=False)
class Memory:
    """Values of the last step.

    Attributes:
        command: (5,) input that acts now.
        inputs: of each side, the last plan's inputs (Np, 5).
    """

    command: Array
    inputs: dict[Side, Array]


class NonlinearController(Controller[Memory]):
    """Collision avoidance by nonlinear programming, for one vehicle and one number of obstacles."""

    def __init__(
        self,
        vehicle: Vehicle,
        friction: float,
        goal: Goal,
        horizon: Horizon,
        weights: Weights,
        settings: UnifiedSettings,
        n_obstacles: int,
        solver: str,
    ) -> None:
        """Compile the program; the arguments, and what is raised, are those of `NonlinearProgram`."""
        self._vehicle, self._friction = vehicle, friction
        self._slip_limit, self._n_samples = settings.slip_limit, horizon.prediction
        self._program = NonlinearProgram(vehicle, friction, goal, horizon, weights, settings, n_obstacles, solver)

    def start(self) -> Memory:
        """Wheels straight, no force, no plan."""
        nothing = np.zeros((self._n_samples, N_INPUTS))
        return Memory(nothing[0], dict.fromkeys(Side, nothing))

    def step(self, measurement: Measurement, memory: Memory) -> tuple[Command, Plan, Memory]:
        """One sample: both sides solved, the cheaper one's first input commanded."""
        obstacles = tuple(seen.as_obstacle() for seen in measurement.obstacles)
        question = Question(measurement.state, memory.command, measurement.wheel_loads, obstacles)
        plans = [self._plan(side, question, memory) for side in Side]
        taken = plans[0] if plans[0].cost <= plans[1].cost * (1 + EQUAL) + EQUAL else plans[1]
        n_failed = sum(not plan.is_solved for plan in plans)
        plan = Plan(
            measurement.time,
            taken.inputs,
            taken.states,
            taken.side if taken.is_shaped else None,
            tuple(Branch(each.side, each.cost, each.violation) for each in plans),
            fallback=Fallback.NO_SOLUTION if n_failed == len(plans) else None,
            solver_failures=n_failed,
        )
        command = plan.inputs[0]
        return Command.from_input(command), plan, Memory(command, {each.side: each.inputs for each in plans})

    def _plan(self, side: Side, question: Question, memory: Memory) -> "_SidePlan":
        """The plan of one side: what the solver found, or what it started from."""
        guess = self._guess(side, question, memory)
        answer = self._program.solve(question, guess)
        if not answer.is_solved:
            return _SidePlan(side, guess.inputs, guess.states, guess.cost, guess.missed_clearance, False, False)
        is_shaped = bool((np.abs(self._program.gap_multipliers(answer)) > ACTIVE).any())
        return _SidePlan(side, answer.inputs, answer.states, answer.cost, answer.missed_clearance, is_shaped, True)

    def _guess(self, side: Side, question: Question, memory: Memory) -> Guess:
        """The last plan of a side one sample later; where that is not clear, the cheapest of it and first guesses."""
        guess = self._program.guess(question, shifted(memory.inputs[side]))
        if guess.missed_clearance <= CLEAR:
            return guess
        speed = float(question.state[VX])
        pulses = seeds(self._vehicle, self._friction, self._slip_limit, speed, side, self._n_samples)
        return min((guess, *(self._program.guess(question, each) for each in pulses)), key=lambda each: each.cost)


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
