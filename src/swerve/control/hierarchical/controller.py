"""The hierarchical controller: a decision, then a path, then a tracker: what the paper sets its one program against.

Each layer knows no more of the next than it is told: the decision (`decision`) takes paths to be driven as they are
drawn, with a share of mu g as all it knows of the tyres; the tracker (`tracker`) knows nothing of obstacles.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from swerve.control.actuation import Actuation
from swerve.control.appraisal import Appraisal
from swerve.control.fallback import fallback_plan, full_braking, shifted
from swerve.control.forecast import forecasts
from swerve.control.friction_use import friction_use
from swerve.control.hierarchical.decision import Decision
from swerve.control.hierarchical.manoeuvre import Manoeuvre
from swerve.control.hierarchical.memory import Memory
from swerve.control.hierarchical.scene import Scene
from swerve.control.hierarchical.settings import HierarchicalSettings
from swerve.control.hierarchical.tracker import Tracked, Tracker
from swerve.control.plan import KEEP, Fallback, Plan
from swerve.control.protocol import Controller
from swerve.control.settings import Goal, Horizon, Latency, Weights
from swerve.control.unified.compensation import is_late, n_commands, state_at_effect
from swerve.control.unified.prediction import PredictionModel
from swerve.control.wheel_loads import falling_loads
from swerve.conventions import FORCES, N_INPUTS, VX
from swerve.signals import Command, Measurement
from swerve.vehicle import Vehicle
from swerve.world import Footprint, Road

Array = NDArray[np.float64]

STANDSTILL = 0.2  # [m/s] below, a vehicle that is to stand is held
HOLD = 0.3  # [1] share of full braking that holds it


class HierarchicalController(Controller[Memory]):
    """Decision, polynomial path and predictive tracker, for one vehicle on a road of known friction."""

    def __init__(
        self,
        vehicle: Vehicle,
        footprint: Footprint,
        friction: float,
        road: Road,
        goal: Goal,
        horizon: Horizon,
        weights: Weights,
        latency: Latency,
        settings: HierarchicalSettings,
        actuation: Actuation,
    ) -> None:
        """Build the kernels; a first time compiles them. Of the inputs there must be steering and brakes."""
        self._footprint, self._friction, self._road = footprint, friction, road
        self._horizon, self._latency, self._actuation = horizon, latency, actuation
        self._appraisal = Appraisal(footprint, road, settings.margin, horizon)
        self._model = PredictionModel(vehicle, friction, horizon)
        self._decide = Decision(goal, settings)
        self._track = Tracker(self._model, vehicle, friction, weights, settings, actuation)
        self._braking = full_braking(vehicle, friction, horizon.prediction, actuation)

    def start(self) -> Memory:
        """Wheels straight, no force, no plan."""
        commands = (np.zeros(N_INPUTS),) * n_commands(self._latency, self._horizon.sample_time)
        return Memory(commands, (), None, None, None, 0)

    def step(self, measurement: Measurement, memory: Memory) -> tuple[Command, Plan, Memory]:
        """One sample: decide, then track."""
        with np.errstate(all="ignore"):  # a motion that diverges scores inf, and a program with nan fails
            if not measurement.is_finite:
                return self._fall_back(measurement.time, Fallback.NOT_FINITE, memory)
            if is_late(measurement, self._latency, self._horizon.sample_time):
                return self._fall_back(measurement.time, Fallback.LATE, memory)
            return self._drive(measurement, memory)

    def _drive(self, measurement: Measurement, memory: Memory) -> tuple[Command, Plan, Memory]:
        delay = self._latency.effect(float(measurement.state[VX]))
        state = state_at_effect(measurement, memory.commands, delay, self._model)
        state[VX] = max(state[VX], 0.0)  # the model takes a brake's force for a motor's and turns the wheels back
        if not np.isfinite(state).all():
            return self._fall_back(measurement.time, Fallback.NO_SOLUTION, memory)
        seen = forecasts(measurement.stamp, measurement.obstacles, memory.forecasts)
        place = self._footprint, self._friction, self._actuation.braking, self._road
        scene = Scene(state, measurement.time + delay, *place, seen)
        manoeuvre = self._decide(scene, memory.manoeuvre)
        guess = np.zeros((self._horizon.prediction, N_INPUTS)) if memory.plan is None else shifted(memory.plan.inputs)
        loads = falling_loads(measurement.wheel_loads, memory.wheel_loads)
        tracked = self._track(manoeuvre, state, memory.commands[0], guess, loads)
        memory = replace(memory, forecasts=seen, wheel_loads=measurement.wheel_loads, manoeuvre=manoeuvre)
        if tracked.n_solved == 0:
            return self._fall_back(measurement.time, Fallback.NO_SOLUTION, memory, tracked.n_failed)
        return self._take(measurement, scene, manoeuvre, tracked, memory)

    def _take(
        self, measurement: Measurement, scene: Scene, manoeuvre: Manoeuvre, tracked: Tracked, memory: Memory
    ) -> tuple[Command, Plan, Memory]:
        """The tracker's first input as command, or the brakes that hold a vehicle which is to stand."""
        trajectory, name = tracked.trajectory, manoeuvre.name
        inputs, grip = trajectory.inputs, self._friction * measurement.wheel_loads
        if max(float(measurement.state[VX]), manoeuvre.speed) < STANDSTILL:
            inputs = inputs.copy()
            inputs[:, FORCES] = HOLD * self._braking[:, FORCES]
        plan = Plan(
            measurement.time,
            inputs,
            trajectory.states,
            manoeuvre.side,
            name,
            is_shaped=name != KEEP,
            branches=(self._appraisal.branch(name, tracked.cost, trajectory.states, scene.time, scene.forecasts),),
            reason=manoeuvre.reason,
            friction_use=friction_use(inputs[0], trajectory.lateral_demand[0], grip),
            solver_failures=tracked.n_failed,
        )
        command = inputs[0]
        return Command.from_input(command), plan, replace(memory, commands=memory.after(command), plan=plan, age=0)

    def _fall_back(
        self, time: float, reason: Fallback, memory: Memory, n_failed: int = 0
    ) -> tuple[Command, Plan, Memory]:
        """The command of the documented fallback."""
        age = memory.age + 1
        plan = replace(fallback_plan(time, reason, memory.plan, age, self._braking), solver_failures=n_failed)
        commands = memory.after(plan.inputs[0])
        return Command.from_input(plan.inputs[0]), plan, replace(memory, commands=commands, age=age)
