"""The unified controller: one optimisation decides and drives. Each way through the scene - brake, left, right, and for
several obstacles their combinations - is a program of its own (`formulation.py`); the best of their plans is taken.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from swerve.control.fallback import shifted
from swerve.control.forecast import forecasts
from swerve.control.plan import Fallback, Plan
from swerve.control.protocol import Controller
from swerve.control.unified.answer import plan_of
from swerve.control.unified.assistance import Lead
from swerve.control.unified.choice import ON_ROAD, Candidate, choose
from swerve.control.unified.compensation import is_late, n_commands
from swerve.control.unified.deadline import Clock, Deadline
from swerve.control.unified.fallback import Ladder
from swerve.control.unified.formulation import Formulation
from swerve.control.unified.improve import WayPlan
from swerve.control.unified.memory import Memory, is_same
from swerve.control.unified.planning import Planning, leaves_a_way
from swerve.control.unified.situation import CLEAR
from swerve.signals import Command, Measurement
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters

Array = NDArray[np.float64]

Answer = tuple[Command, Plan, Memory]


class UnifiedController(Controller[Memory]):
    """Collision avoidance by sequential convex programming, for one vehicle on a road of known friction."""

    def __init__(self, formulation: Formulation, clock: Clock | None = None) -> None:
        """A controller whose steps keep their deadline by a clock [s]; without one, by counting their work."""
        self._formulation, self._clock = formulation, clock

    def start(self) -> Memory:
        """No force, no plan; wheels straight, or as they are stuck."""
        formulation = self._formulation
        n = n_commands(formulation.latency, formulation.horizon.sample_time)
        return Memory((formulation.actuation.fixed,) * n)

    def step(self, measurement: Measurement, memory: Memory) -> Answer:
        """One sample: the ways planned, the best one taken, its first input commanded."""
        with np.errstate(all="ignore"):  # a motion that diverges scores inf, and a program with nan fails
            return self._step(measurement, memory)

    def _step(self, measurement: Measurement, memory: Memory) -> Answer:
        (first, share), *others = self._formulation.assistance.leads(measurement)
        allowed = self._formulation.settings.deadline * self._formulation.horizon.sample_time
        deadline = Deadline(allowed * share, self._clock)
        if measurement.is_finite:
            memory = replace(memory, wheel_loads=measurement.wheel_loads)
        reason = self._unusable(measurement)
        if reason is not None:
            return self._fall_back(measurement, reason, memory)
        formulation = self._formulation
        memory = replace(memory, forecasts=forecasts(measurement.stamp, measurement.obstacles, memory.forecasts))
        scene = formulation.scene(measurement, memory)
        planning, plans = _planned(Planning(formulation, scene, measurement, memory, deadline, first))
        for lead, share in others:
            if leaves_a_way(plans):
                break
            deadline = planning.deadline.again(allowed * share)
            if deadline.is_over:
                break
            planning, plans = _planned(replace(planning, deadline=deadline, lead=lead))
        if any(plan.n_solved for plan in plans):
            return self._take(planning, plans, measurement, memory)
        reason = Fallback.NO_SOLUTION if any(plan.n_failed for plan in plans) else Fallback.DEADLINE
        return self._fall_back(measurement, reason, memory, plans)

    def _take(self, planning: Planning, plans: list[WayPlan], measurement: Measurement, memory: Memory) -> Answer:
        """The best plan as command, and what the next step is to know."""
        formulation, scene = self._formulation, planning.scene
        candidates = [self._candidate(planning, plan) for plan in plans]
        so_far = (each for each in candidates if is_same(memory.committed, each.plan.way.passing, scene.threats))
        committed = next(so_far, None) if memory.committed is not None else None
        choice = choose(candidates, committed, formulation.settings.commitment)
        plan = plan_of(measurement, candidates, choice, formulation.place.friction)
        plan = formulation.assistance.told(plan, planning.lead, measurement)
        taken = choice.candidate.plan.way.passing
        is_shaped = any(each.is_shaped or each.violation > CLEAR or each.off_road > ON_ROAD for each in plans)
        after = Memory(
            memory.after(plan.inputs[0]),
            {each.way.passing: each.step.trajectory.inputs for each in plans},
            {each.way.passing: each.trust for each in plans},
            {each.way.passing: each.held for each in plans if each.held is not None},
            taken,
            taken if is_shaped else None,
            memory.forecasts,
            scene.threats,
            plan,
            0,
            memory.count + 1,
            memory.wheel_loads,
            formulation.assistance.deviation(plan.inputs[0], measurement),
        )
        return Command.from_input(plan.inputs[0]), plan, after

    def _candidate(self, planning: Planning, plan: WayPlan) -> Candidate:
        """Where a driver leads, what is beyond the horizon is the driver's affair."""
        scene, is_free = planning.scene, planning.lead is Lead.NOBODY
        impact_speed = plan.situation.impact_speed(plan.step) if plan.violation > CLEAR else None
        cost = self._formulation.total(plan) if is_free else plan.step.merit
        leaves_lane = is_free and scene.leaves_lane(plan.step.trajectory.poses)
        return Candidate(plan, cost, impact_speed, leaves_lane, scene.is_leaving)

    def _unusable(self, measurement: Measurement) -> Fallback | None:
        """Why a measurement can't be planned from, if it can't."""
        if not measurement.is_finite:
            return Fallback.NOT_FINITE
        formulation = self._formulation
        late = is_late(measurement, formulation.latency, formulation.horizon.sample_time)
        return Fallback.LATE if late else None

    def _fall_back(
        self, measurement: Measurement, reason: Fallback, memory: Memory, plans: Sequence[WayPlan] = ()
    ) -> Answer:
        """The command of the documented fallback; the memory's plans move on by one sample.

        `plans` are the ways of this step from the measured state on, none where it can't be planned from.
        """
        formulation = self._formulation
        standing = np.array(wheel_loads(Parameters.of(formulation.vehicle, formulation.place.friction)))
        loads = standing if memory.wheel_loads is None else memory.wheel_loads
        ladder = Ladder(formulation.actuators(loads, memory), formulation.model, loads, memory, plans)
        plan, samples = ladder.plan(measurement.time, reason)
        after = replace(
            memory,
            commands=memory.after(plan.inputs[0]),
            deviation=formulation.assistance.deviation(plan.inputs[0], measurement),
            inputs={key: shifted(inputs) for key, inputs in memory.inputs.items()},
            plan=memory.plan if samples else plan,
            age=samples,
            count=memory.count + 1,
        )
        return Command.from_input(plan.inputs[0]), plan, after


def _planned(planning: Planning) -> tuple[Planning, list[WayPlan]]:
    """The plans of a planning, or of one that sees what it thought out of the path."""
    plans = planning.unsolved() if planning.deadline.is_over else planning.plans()
    again = planning.overlooked(plans)
    if again is not None and not planning.deadline.is_over:
        return again, again.plans()
    return planning, plans
