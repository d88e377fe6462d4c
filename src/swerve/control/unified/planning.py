"""The ways of one step, planned one after the other: that taken so far first, and as long as the time lasts."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from swerve.control.fallback import shifted
from swerve.control.unified.acceptance import Step
from swerve.control.unified.assistance import Lead
from swerve.control.unified.choice import HOPELESS, NEARLY, ON_ROAD
from swerve.control.unified.deadline import Deadline
from swerve.control.unified.formulation import Formulation
from swerve.control.unified.improve import TRUST_AFTER_A_STEP, WayPlan, improve
from swerve.control.unified.memory import Memory, is_same
from swerve.control.unified.scene import Scene
from swerve.control.unified.seeds import seeds
from swerve.control.unified.situation import CLEAR
from swerve.control.unified.way import Way, ways
from swerve.conventions import N_INPUTS
from swerve.signals import Measurement

STOPPING = 2.0  # [m/s] a stop that is nearly done is not given up: from so slow nothing is passed within sight
Array = NDArray[np.float64]

MOST_PLANNED = 4  # ways in one step
SELDOM = 4  # steps between two looks at a way that is spare and misses too much to be mended, or that is left out
DIGITS = 5  # of a price that count: mirrored ways cost the same but for rounding


@dataclass(frozen=True, eq=False)
class Planning:
    """The planning of one step.

    Attributes:
        formulation: of the programs.
        scene: of this step.
        measurement: of this step.
        memory: of the last step.
        deadline: of this step.
        lead: of its plans.
    """

    formulation: Formulation
    scene: Scene
    measurement: Measurement
    memory: Memory
    deadline: Deadline
    lead: Lead = Lead.NOBODY

    def plans(self) -> list[WayPlan]:
        """The plans of the ways that were worth one, in the order in which equal ones are preferred.

        Where no obstacle is in reach of a plan all ways are one program, solved once; beside a way so far that is
        clear, or nearly, the others are spare.
        """
        found = self._ways()
        first, *others = self._worth_planning(found)
        plan = self._plan(self._begin(first))
        if not others or not plan.situation.is_near(plan.step):
            return [plan]
        is_spare = self._is_committed(first) and max(plan.violation, plan.off_road) <= NEARLY
        begun = [self._begin(way) for way in others]
        rest = self._spare(begun) if is_spare else self._others(begun)
        return sorted([plan, *rest], key=lambda each: found.index(each.way))

    def overlooked(self, plans: list[WayPlan]) -> "Planning | None":
        """The planning with what was thought out of the path and is in the way of the only plan; None without."""
        if self.scene.threats or not _has_faults(plans[0]):
            return None
        threats = plans[0].situation.touched(plans[0].step)
        return replace(self, scene=replace(self.scene, threats=threats)) if threats else None

    def unsolved(self) -> list[WayPlan]:
        """What the ways begin with, for a step that has no time for a program."""
        return [self._begin(way) for way in self._worth_planning(self._ways())]

    def _ways(self) -> list[Way]:
        """The ways of the scene that the vehicle has inputs for."""
        actuation = self.formulation.actuation
        found = ways(self.scene.natural, self.scene.threats, self.scene.companions)
        possible = [
            way for way in found if (actuation.braking or not way.brakes) and (actuation.turning or way.side is None)
        ]
        return possible or found

    def _worth_planning(self, found: list[Way]) -> list[Way]:
        """The way so far, or else the one with the least price, first; with the brake and the next best ones.

        Prices change slowly: where there are too many ways, those of the last step stay for a few steps.
        """
        if len(found) == 1:
            return found
        so_far = next((way for way in found if self._is_committed(way)), None)
        if so_far is not None and so_far.is_straight and self.scene.speed < STOPPING:
            return [so_far]
        planned = [way for way in found if way.passing in self.memory.inputs]
        if so_far is not None and len(planned) == MOST_PLANNED and self.memory.count % SELDOM:
            found = planned
        elif so_far is None or len(found) > MOST_PLANNED:
            found = sorted(found, key=lambda way: float(f"{self.formulation.price(self.scene, way):.{DIGITS}g}"))
        first = so_far or found[0]
        brake = [way for way in found if way.side is None and way is not first]
        return [first, *brake, *(way for way in found if way is not first and way not in brake)][:MOST_PLANNED]

    def _is_committed(self, way: Way) -> bool:
        return is_same(self.memory.committed, way.passing, self.scene.threats)

    def _begin(self, way: Way) -> WayPlan:
        """The last plan of a way one sample later, from the measured state; without one, that which was taken."""
        of_step = self.measurement, self.memory, self.deadline, self.lead
        situation = self.formulation.situation(self.scene, way, *of_step)
        key = self.memory.key_of(way.passing, self.scene.threats)
        known = self.memory.inputs.get(key or self.memory.taken or ())
        nothing = np.zeros((self.formulation.horizon.prediction, N_INPUTS))
        step = situation.roll_out(nothing if known is None else shifted(known))
        trust = max(self.memory.trust.get(key or (), 1.0), TRUST_AFTER_A_STEP)
        return WayPlan(situation, step, trust, held=self.memory.held.get(key or ()))

    def _is_new(self, plan: WayPlan) -> bool:
        return self.memory.key_of(plan.way.passing, self.scene.threats) is None and _has_faults(plan)

    def _others(self, begun: list[WayPlan]) -> list[WayPlan]:
        """The plans of ways that are asked for, as that so far fails; one that failed before is begun anew in turn.

        What is new and whose turn it is come first, as the time may not last for all.
        """
        turn = self._turn(begun)
        order = sorted(range(len(begun)), key=lambda i: (i != turn and not self._is_new(begun[i]), i))
        found = {i: self._plan(begun[i], is_thorough=i == turn or self._is_new(begun[i])) for i in order}
        return [found[i] for i in range(len(begun))]

    def _spare(self, plans: list[WayPlan]) -> list[WayPlan]:
        """The same plans, of which one in turn has had a single iteration."""
        turn = self._turn(plans)
        if turn is None or self.deadline.is_over:
            return plans
        plan = plans[turn]
        if plan.way.is_straight and _has_faults(plan):
            plan = replace(plan, step=self._best_guess(plan))
        return [*plans[:turn], improve(plan, 1), *plans[turn + 1 :]]

    def _turn(self, plans: list[WayPlan]) -> int | None:
        """Whose turn it is, for most of the time among those that may go; None where it is nobody's."""
        hopeless = [i for i, plan in enumerate(plans) if plan.violation > HOPELESS]
        going = [i for i in range(len(plans)) if i not in hopeless]
        round_, rest = divmod(self.memory.count, SELDOM)
        if hopeless and rest == 0:
            return hopeless[round_ % len(hopeless)]
        return going[self.memory.count % len(going)] if going else None

    def _plan(self, plan: WayPlan, *, is_thorough: bool = True) -> WayPlan:
        """The plan of one way, from its shifted plan on; where that fails, from the best of the first guesses."""
        settings = self.formulation.settings
        if self._is_new(plan):
            plan = replace(plan, step=self._best_guess(plan))
        plan = improve(plan, settings.iterations)
        if not _has_faults(plan):
            return plan
        if max(plan.violation, plan.off_road) <= NEARLY:
            return improve(plan, settings.iterations)
        if plan.way.is_straight:
            return self._mildest(plan)
        if not is_thorough:
            return plan
        guess = plan.step if self._is_new(plan) else self._best_guess(plan)
        return improve(replace(plan, step=guess, trust=1.0), settings.first_iterations - settings.iterations)

    def _mildest(self, plan: WayPlan) -> WayPlan:
        """The stop with the least impact speed, of the plan itself and the first guesses, as none is in time."""
        steps = [plan.step, *map(plan.situation.roll_out, self._guesses(plan))]
        impacts = [plan.situation.impact_speed(step) for step in steps]
        mildest = min(range(len(steps)), key=lambda i: (impacts[i] is not None, impacts[i] or 0.0))
        return replace(plan, step=steps[mildest])

    def _best_guess(self, plan: WayPlan) -> Step:
        """The step or the first guess for this way, whichever costs less when it is rolled out."""
        best = plan.step
        for inputs in self._guesses(plan):
            if self.deadline.is_over:
                break
            best = min(best, plan.situation.roll_out(inputs), key=lambda each: each.merit)
        return best

    def _guesses(self, plan: WayPlan) -> list[Array]:
        situation, formulation = plan.situation, self.formulation
        return seeds(
            formulation.vehicle,
            formulation.place.friction,
            formulation.settings.slip_limit,
            self.scene.speed,
            plan.way,
            situation.program.box.largest,
            formulation.horizon.prediction,
            formulation.actuation.steers,
        )


def leaves_a_way(plans: list[WayPlan]) -> bool:
    """Whether any of the plans is clear, and as clear of the road's edges."""
    return any(max(plan.violation, plan.off_road) <= CLEAR for plan in plans)


def _has_faults(plan: WayPlan) -> bool:
    return plan.violation > CLEAR or plan.off_road > ON_ROAD
