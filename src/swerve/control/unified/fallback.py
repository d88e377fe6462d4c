"""What is commanded when this step has no plan of its own: a ladder, of which the first rung that holds is taken.

1. The best plan of this step, however few programs were solved: that is no fallback.
2. The plan that is followed, as many samples further on as have passed.
3. Full braking: that plan's steering, and on each wheel as much as its lateral demand leaves (limits/input_box.py);
   loads as in the last finite measurement. Where the plan has been used up, or there is none, the wheels are straight:
   a plan ends along its lane, and a car that sees nothing any more is to stop in the direction in which it goes.

When the measurement is usable and only a program is missing, both 2 and 3 are rolled out from the measured state, and 3
is taken if it is clear of the obstacles and 2 is not; of two that are not, if its impact is milder or it misses less of
the margin. Whatever it is, it is within what the actuators can do.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.fallback import shifted
from swerve.control.plan import Fallback, Plan
from swerve.control.unified.acceptance import Step
from swerve.control.unified.improve import WayPlan
from swerve.control.unified.memory import Memory
from swerve.control.unified.prediction import PredictionModel
from swerve.control.unified.program import Program
from swerve.control.unified.situation import CLEAR, Situation
from swerve.conventions import DELTA, FORCES, N_INPUTS, N_STATES, N_WHEELS

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Ladder:
    """The ladder of one step.

    Attributes:
        actuators: what they can do, after the last command.
        model: of the vehicle.
        loads: (4,) of the last finite measurement, static ones before the first [N].
        memory: of the last step.
        plans: the ways of this step, from the measured state on; none where it can't be planned from.
    """

    actuators: Program
    model: PredictionModel
    loads: Array
    memory: Memory
    plans: Sequence[WayPlan]

    def plan(self, time: float, reason: Fallback) -> tuple[Plan, int]:
        """The plan to follow at `time` [s] instead, and how many samples of it are over."""
        failures = sum(plan.n_failed for plan in self.plans)
        inputs, states = self._full_braking()
        last = self.memory.plan
        if last is None or self._is_used_up or self._faults(inputs) < self._faults(self._followed):
            return Plan(time, inputs, states, name="full braking", fallback=reason, solver_failures=failures), 0
        states = last.states[self._samples :]
        of_last = last.side, last.name, last.is_shaped
        return Plan(time, self._followed, states, *of_last, fallback=reason, solver_failures=failures), self._samples

    @property
    def _samples(self) -> int:
        """How old the followed plan is now."""
        return self.memory.age + 1

    @property
    def _is_used_up(self) -> bool:
        return self._samples >= self.model.horizon.prediction

    @property
    def _followed(self) -> Array:
        """Inputs (Np, 5) of the followed plan from now on; none without one."""
        if self.memory.plan is None:
            return np.zeros((self.model.horizon.prediction, N_INPUTS))
        return self.actuators.clip(shifted(self.memory.plan.inputs, self._samples))

    def _full_braking(self) -> tuple[Array, Array]:
        """Inputs (Np, 5) and, where a start is known, the predicted states; else (0, 6)."""
        inputs = np.zeros((self.model.horizon.prediction, N_INPUTS))
        if self.memory.plan is not None and not self._is_used_up:
            left = self.memory.plan.inputs[self._samples :, DELTA]
            inputs[: len(left), DELTA] = left
        start, demand = self._start(), np.zeros((len(inputs), N_WHEELS))
        if start is not None:
            rolling = self.model.roll_out(start, self.actuators.clip(inputs), self.loads)
            demand = np.where(np.isfinite(rolling.lateral_demand), rolling.lateral_demand, 1.0)
        inputs[:, FORCES] = -self.actuators.box.limit(demand)[:, FORCES]
        inputs = self.actuators.clip(inputs)
        if start is None:
            return inputs, np.empty((0, N_STATES))
        return inputs, self.model.roll_out(start, inputs, self.loads).states

    def _start(self) -> Array | None:
        """The measured state, else the one that the followed plan predicts for now, (6,)."""
        if self.plans:
            return self.plans[0].situation.start
        if self.memory.plan is None or self._samples >= len(self.memory.plan.states):
            return None
        return np.asarray(self.memory.plan.states[self._samples])

    def _faults(self, inputs: Array) -> tuple[bool, float, float]:
        """How bad inputs are in the way that suits them best: not clear, impact speed [m/s], missed margin [m]."""
        steps = [(plan.situation, plan.situation.roll_out(inputs)) for plan in self.plans]
        return min((_faults(situation, step) for situation, step in steps), default=(False, 0.0, 0.0))


def _faults(situation: Situation, step: Step) -> tuple[bool, float, float]:
    missed = situation.program.missed_clearance(step.score)
    if missed <= CLEAR:
        return False, 0.0, 0.0
    return True, (situation.impact_speed(step) or 0.0) if step.trajectory.is_finite else np.inf, missed
