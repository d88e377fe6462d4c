"""The unified controller: one optimisation decides and drives. Each way through the scene - brake, left, right, and for
several obstacles their combinations - is a program of its own (`formulation.py`); the best of their plans is taken.
"""

from collections.abc import Callable
from dataclasses import replace
from time import thread_time

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Fallback, Plan
from swerve.control.protocol import Controller
from swerve.control.unified.answer import plan_of
from swerve.control.unified.choice import CLEAR, ON_ROAD, Candidate, choose
from swerve.control.unified.compensation import is_late, n_commands
from swerve.control.unified.fallback import fallback_plan
from swerve.control.unified.forecast import forecasts
from swerve.control.unified.formulation import Formulation
from swerve.control.unified.improve import WayPlan
from swerve.control.unified.limits import InputBox
from swerve.control.unified.memory import Memory, is_same, shifted
from swerve.control.unified.planning import Planning
from swerve.control.unified.scene import Scene
from swerve.conventions import N_INPUTS
from swerve.signals import Command, Measurement
from swerve.vehicle.loads import wheel_loads
from swerve.vehicle.two_track import Parameters

Array = NDArray[np.float64]

Answer = tuple[Command, Plan, Memory]


class UnifiedController(Controller[Memory]):
    """Collision avoidance by sequential convex programming, for one vehicle on a road of known friction."""

    def __init__(self, formulation: Formulation, clock: Callable[[], float] = thread_time) -> None:
        """The controller of a formulation.

        Args:
            formulation: of its programs.
            clock: that its deadline is kept by [s]; by default it counts the processor's time for this thread, as a
                simulation shares the processor and a controller in a vehicle does not.
        """
        self._formulation, self._clock = formulation, clock

    def start(self) -> Memory:
        """Wheels straight, no force, no plan."""
        formulation = self._formulation
        n = n_commands(formulation.latency, formulation.horizon.sample_time)
        return Memory((np.zeros(N_INPUTS),) * n)

    def step(self, measurement: Measurement, memory: Memory) -> Answer:
        """One sample: the ways planned, the best one taken, its first input commanded."""
        with np.errstate(all="ignore"):  # a motion that diverges scores inf, and a program with nan fails
            return self._step(measurement, memory)

    def _step(self, measurement: Measurement, memory: Memory) -> Answer:
        begun = self._clock()
        reason = self._unusable(measurement)
        if reason is not None:
            return self._fall_back(measurement, reason, memory)
        formulation = self._formulation
        memory = replace(memory, forecasts=forecasts(measurement.stamp, measurement.obstacles, memory.forecasts))
        scene = formulation.scene(measurement, memory.forecasts, memory)
        planning = Planning(formulation, scene, measurement, memory, lambda: self._is_over(begun))
        plans = planning.plans()
        if any(plan.n_solved for plan in plans):
            return self._take(scene, plans, measurement, memory)
        n_failed = sum(plan.n_failed for plan in plans)
        reason = Fallback.NO_SOLUTION if n_failed else Fallback.DEADLINE
        return self._fall_back(measurement, reason, memory, n_failed)

    def _is_over(self, begun: float) -> bool:
        """Whether the step has used up its time."""
        horizon, settings = self._formulation.horizon, self._formulation.settings
        return self._clock() - begun > settings.deadline * horizon.sample_time

    def _take(self, scene: Scene, plans: list[WayPlan], measurement: Measurement, memory: Memory) -> Answer:
        """The best plan as command, and what the next step is to know."""
        formulation = self._formulation
        candidates = [self._candidate(plan) for plan in plans]
        so_far = (each for each in candidates if is_same(memory.committed, each.plan.way.passing, scene.threats))
        committed = next(so_far, None) if memory.committed is not None else None
        choice = choose(candidates, committed, formulation.settings.commitment)
        plan = plan_of(measurement, candidates, choice, formulation.place.friction)
        taken = choice.candidate.plan.way.passing
        is_shaped = any(each.is_shaped or each.violation > CLEAR or each.off_road > ON_ROAD for each in plans)
        after = Memory(
            memory.after(plan.inputs[0]),
            {each.way.passing: each.step.trajectory.inputs for each in plans},
            {each.way.passing: each.trust for each in plans},
            taken,
            taken if is_shaped else None,
            memory.forecasts,
            plan,
            0,
            memory.count + 1,
        )
        return Command.from_input(plan.inputs[0]), plan, after

    def _candidate(self, plan: WayPlan) -> Candidate:
        impact_speed = plan.situation.impact_speed(plan.step) if plan.violation > CLEAR else None
        return Candidate(plan, self._formulation.total(plan), impact_speed)

    def _unusable(self, measurement: Measurement) -> Fallback | None:
        """Why a measurement can't be planned from, if it can't."""
        if not measurement.is_finite:
            return Fallback.NOT_FINITE
        formulation = self._formulation
        late = is_late(measurement, formulation.latency, formulation.horizon.sample_time)
        return Fallback.LATE if late else None

    def _fall_back(
        self, measurement: Measurement, reason: Fallback, memory: Memory, solver_failures: int = 0
    ) -> Answer:
        """The command of the documented fallback; the memory's plans move on by one sample."""
        formulation = self._formulation
        vehicle, friction = formulation.vehicle, formulation.place.friction
        loads = np.array(wheel_loads(Parameters.of(vehicle, friction)))
        largest = InputBox.of(vehicle, friction, loads, formulation.blocking).largest
        plan = fallback_plan(measurement.time, reason, memory, largest, formulation.horizon.prediction)
        moved = {key: shifted(inputs) for key, inputs in memory.inputs.items()}
        return (
            Command.from_input(plan.inputs[0]),
            replace(plan, solver_failures=solver_failures),
            replace(
                memory,
                commands=memory.after(plan.inputs[0]),
                inputs=moved,
                age=memory.age + 1,
                count=memory.count + 1,
            ),
        )
