"""The ways of one step, planned one after the other: the one taken so far first, and as long as the step's time lasts."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from swerve.control.unified.acceptance import Step
from swerve.control.unified.choice import CLEAR, NEARLY, ON_ROAD
from swerve.control.unified.formulation import Formulation
from swerve.control.unified.improve import TRUST_AFTER_A_STEP, WayPlan, improve
from swerve.control.unified.memory import Memory, is_same, shifted
from swerve.control.unified.scene import Scene
from swerve.control.unified.seeds import seeds
from swerve.control.unified.way import Way, ways
from swerve.conventions import N_INPUTS
from swerve.signals import Measurement

MOST_PLANNED = 4  # ways in one step
DIGITS = 5  # of a price that count: mirrored ways cost the same but for rounding


@dataclass(frozen=True, eq=False)
class Planning:
    """The planning of one step.

    Attributes:
        formulation: of the programs.
        scene: of this step.
        measurement: of this step.
        memory: of the last step.
        is_over: whether the step's time is.
    """

    formulation: Formulation
    scene: Scene
    measurement: Measurement
    memory: Memory
    is_over: Callable[[], bool]

    def plans(self) -> list[WayPlan]:
        """The plans of the ways that were worth one, in the order in which equal ones are preferred.

        Where no obstacle is in reach of a plan all ways are one program, solved once; beside a way so far that is
        clear the others are spare, and one of them in turn is improved.
        """
        found = ways(self.scene.natural, self.scene.threats)
        first, *others = self._worth_planning(found)
        begun = self._begin(first)
        plan = self._plan(begun, is_new=self._is_new(begun))
        if not others or not plan.situation.is_near(plan.step):
            return [plan]
        is_spare = self._is_committed(first) and not _has_faults(plan)
        turn = self.memory.count % len(others)
        rest = [self._plan_other(way, is_spare=is_spare, in_turn=i == turn) for i, way in enumerate(others)]
        return sorted([plan, *rest], key=lambda each: found.index(each.way))

    def _worth_planning(self, found: list[Way]) -> list[Way]:
        """The way so far, or else the one with the least price, first; with the brake and the next best ones."""
        if len(found) == 1:
            return found
        so_far = next((way for way in found if self._is_committed(way)), None)
        if so_far is None or len(found) > MOST_PLANNED:
            found = sorted(found, key=lambda way: float(f"{self.formulation.price(self.scene, way):.{DIGITS}g}"))
        first = so_far or found[0]
        brake = [way for way in found if way.side is None and way is not first]
        return [first, *brake, *(way for way in found if way is not first and way not in brake)][:MOST_PLANNED]

    def _is_committed(self, way: Way) -> bool:
        return is_same(self.memory.committed, way.passing, self.scene.threats)

    def _begin(self, way: Way) -> WayPlan:
        """The last plan of a way one sample later, from the measured state; without one, that which was taken."""
        situation = self.formulation.situation(self.scene, way, self.measurement, self.memory, self.is_over)
        key = self.memory.key_of(way.passing, self.scene.threats)
        known = self.memory.inputs.get(self.memory.taken if key is None else key)
        nothing = np.zeros((self.formulation.horizon.prediction, N_INPUTS))
        step = situation.roll_out(nothing if known is None else shifted(known))
        return WayPlan(situation, step, max(self.memory.trust.get(key, 1.0), TRUST_AFTER_A_STEP))

    def _is_new(self, plan: WayPlan) -> bool:
        return self.memory.key_of(plan.way.passing, self.scene.threats) is None and _has_faults(plan)

    def _plan_other(self, way: Way, *, is_spare: bool, in_turn: bool) -> WayPlan:
        """The plan of a way beside the first; a spare one gets a single iteration in its turn, and no guesses."""
        plan = self._begin(way)
        if not is_spare:
            return self._plan(plan, is_new=self._is_new(plan))
        return improve(plan, 1) if in_turn and not self.is_over() else plan

    def _plan(self, plan: WayPlan, *, is_new: bool) -> WayPlan:
        """The plan of one way, from its shifted plan on; where that fails, from the best of the first guesses."""
        settings = self.formulation.settings
        plan = improve(plan, 0 if is_new else settings.iterations)
        if not _has_faults(plan):
            return plan
        if max(plan.violation, plan.off_road) <= NEARLY:
            return improve(plan, settings.iterations)
        return improve(replace(plan, step=self._best_guess(plan), trust=1.0), settings.first_iterations)

    def _best_guess(self, plan: WayPlan) -> Step:
        """The step or the first guess for this way, whichever costs less when it is rolled out."""
        situation, formulation = plan.situation, self.formulation
        guesses = seeds(
            formulation.vehicle,
            formulation.place.friction,
            formulation.settings.slip_limit,
            self.scene.speed,
            plan.way,
            situation.program.box.largest,
            formulation.horizon.prediction,
        )
        best = plan.step
        for inputs in guesses:
            if self.is_over():
                break
            best = min(best, situation.roll_out(inputs), key=lambda each: each.merit)
        return best


def _has_faults(plan: WayPlan) -> bool:
    return plan.violation > CLEAR or plan.off_road > ON_ROAD
