"""Left and right, each solved from the guesses that are worth it.

A program has many local minima: a side that is not clear is held against those of other first guesses, at once when it
first misses and from then on in every `SELDOM`-th step. Where nothing holds the first side's plan there is no side to
speak of, and it stands for both; so it does while both sides have come to the same motion, as long as that is clear.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from swerve.control.fallback import shifted
from swerve.control.nonlinear.memory import Memory
from swerve.control.nonlinear.program import NonlinearProgram
from swerve.control.nonlinear.settings import NonlinearSettings
from swerve.control.nonlinear.side_plan import CLEAR, SidePlan
from swerve.control.nonlinear.values import Answer, Guess, Question
from swerve.control.plan import Passing, Side
from swerve.control.unified.seeds import seeds
from swerve.control.unified.way import Way
from swerve.conventions import N_INPUTS, VX
from swerve.vehicle import Vehicle

Array = NDArray[np.float64]

TRIES = 3  # first guesses of a side from which it is solved at most
SELDOM = 10  # steps between two looks at all of them; of 266 looks near the limit two found what was any better
ACTIVE = 1e-2  # [1/m] a multiplier beyond this holds the plan off an obstacle


class Sides:
    """What plans both sides, for one program."""

    def __init__(
        self, program: NonlinearProgram, vehicle: Vehicle, friction: float, settings: NonlinearSettings, n_tracked: int
    ) -> None:
        """Of a vehicle on a road of friction mu [1]; `n_tracked` samples of the program are no tail."""
        self._program, self._settings = program, settings
        self._vehicle, self._friction, self._n_tracked = vehicle, friction, n_tracked

    def plans(self, question: Question, memory: Memory) -> dict[Side, SidePlan]:
        """Of each side, the side that was taken so far first."""
        first = memory.committed or Side.LEFT
        guess = self._goes_on(first, question, memory)
        here = self._plan(first, guess, question, memory)
        is_one = here.held_by is None or (_is_clear(guess) and here.is_clear and memory.is_of_one_mind)
        if here.is_solved and is_one:
            return {side: replace(here, side=side) for side in Side}
        other = Side(-first.value)
        there = self._plan(other, self._goes_on(other, question, memory), question, memory)
        if here.is_like(there):
            there = replace(here, side=there.side)
        return {side: here if side is first else there for side in Side}

    def _goes_on(self, side: Side, question: Question, memory: Memory) -> Guess:
        """The last plan of a side one sample later."""
        return self._program.guess(question, shifted(memory.inputs[side]))

    def _plan(self, side: Side, goes_on: Guess, question: Question, memory: Memory) -> SidePlan:
        """The first solution that is clear, else the best that was found."""
        found = []
        for guess in islice(self._guesses(side, goes_on, question), TRIES):
            found.append(self._plan_from(guess, side, question))
            if found[-1].is_solved and (found[-1].is_clear or memory.missed[side] % SELDOM):
                break
        return min(found, key=lambda each: (not each.is_clear, each.cost))

    def _plan_from(self, guess: Guess, side: Side, question: Question) -> SidePlan:
        """What the solver finds from a guess; where it finds nothing, the cheaper of the guess and what it came to."""
        if not guess.is_sane:
            return SidePlan(side, guess.inputs, guess.states, np.inf, np.inf, _missed_most(guess, question), False)
        answer = self._program.solve(question, guess)
        if answer.is_solved:
            held_by = self._held_by(answer, question)
            return SidePlan(side, answer.inputs, answer.states, answer.cost, answer.missed_clearance, held_by, True)
        ended = self._program.guess(question, answer.inputs)
        best = ended if ended.is_sane and ended.cost < guess.cost else guess
        held_by = _missed_most(best, question)
        return SidePlan(side, best.inputs, best.states, best.cost, best.missed_clearance, held_by, False)

    def _held_by(self, answer: Answer, question: Question) -> int | None:
        """The obstacle that shapes a solution most, None where none does."""
        multipliers = np.abs(self._program.gap_multipliers(answer)).max(axis=(0, 2), initial=0.0)
        if multipliers.max(initial=0.0) <= ACTIVE:
            return _missed_most(answer, question)
        return _largest(multipliers, question)

    def _guesses(self, side: Side, goes_on: Guess, question: Question) -> Iterator[Guess]:
        """The last plan if that is clear; else, or if there is nothing in that, it and the first guesses by cost."""
        if _is_clear(goes_on):
            yield goes_on
        speed, limit = float(question.state[VX]), self._settings.slip_limit
        way, largest = Way((Passing(side.value),), (0,)), self._program.largest(question)
        pulses = seeds(self._vehicle, self._friction, limit, speed, way, largest, self._n_tracked)
        rolling = np.zeros((self._settings.tail, N_INPUTS))
        others = (goes_on, *(self._program.guess(question, np.vstack([each, rolling])) for each in pulses))
        yield from sorted(others, key=lambda each: each.cost if np.isfinite(each.cost) else np.inf)


def _missed_most(found: Guess | Answer, question: Question) -> int | None:
    """The obstacle that a motion misses the margin to, None where it keeps all."""
    if _is_clear(found):
        return None
    return _largest(found.violations[:-1], question)


def _largest(of_obstacles: Array, question: Question) -> int | None:
    """The obstacle with the largest of numbers (n_obstacles,); None where the program's place for one is empty."""
    place = int(of_obstacles.argmax())
    return question.nearest[place] if place < len(question.obstacles) else None


def _is_clear(found: Guess | Answer) -> bool:
    """Whether it keeps all margins."""
    return found.missed_clearance <= CLEAR
