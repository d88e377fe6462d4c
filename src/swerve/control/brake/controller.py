"""The emergency brake (AEB): drives its lane, and brakes as hard as the tyres let it when a contact is near.

Decision (`threat`) and driving are apart: the brake acts or it does not, and whichever it is, a lane keeper steers and
an ideal slip control (`wheels`) bounds the wheel forces. It lets go when at the present speed no contact is in sight.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from swerve.control.actuation import Actuation
from swerve.control.appraisal import Appraisal
from swerve.control.brake.driver import wanted_acceleration, wanted_speed
from swerve.control.brake.memory import Memory
from swerve.control.brake.settings import BrakeSettings
from swerve.control.brake.threat import is_alarming
from swerve.control.brake.wheels import BrakingLimits
from swerve.control.corridor import Corridor
from swerve.control.fallback import fallback_plan, full_braking
from swerve.control.forecast import Forecast, forecasts
from swerve.control.friction_use import friction_use
from swerve.control.lane_keeping import LaneKeeping
from swerve.control.path import Path
from swerve.control.plan import KEEP, Fallback, Plan
from swerve.control.protocol import Controller
from swerve.control.settings import Goal, Horizon, Latency
from swerve.control.unified.compensation import is_late, n_commands, state_at_effect
from swerve.control.unified.prediction import SLIP_SPEED_FLOOR, PredictionModel
from swerve.control.wheel_loads import falling_loads
from swerve.conventions import DELTA, FORCES, GRAVITY, N_INPUTS, N_STATES, VX
from swerve.signals import ABSURD, Command, Measurement
from swerve.vehicle import Vehicle
from swerve.vehicle.two_track import Parameters
from swerve.world import Footprint, Road

Array = NDArray[np.float64]

RELEASE_TIME = 3.0  # [s] without a contact at the present speed, after which the brake lets go
STANDSTILL = 0.2  # [m/s] below, a vehicle that is to stand is held
HOLD = 0.3  # [1] share of the largest braking force that holds it
NOTHING_WEIGHED = 0.0  # [1] cost of a plan that is the optimum of nothing


class BrakeController(Controller[Memory]):
    """An emergency brake with a lane keeper, for one vehicle on a road of known friction."""

    def __init__(
        self,
        vehicle: Vehicle,
        footprint: Footprint,
        road: Road,
        friction: float,
        goal: Goal,
        horizon: Horizon,
        latency: Latency,
        settings: BrakeSettings,
        actuation: Actuation,
    ) -> None:
        """Build the kernels; a first time compiles them.

        Of the road's edges its plans tell, but it does not watch them. Of the inputs some brake is needed.
        """
        self._vehicle, self._footprint, self._friction, self._goal = vehicle, footprint, friction, goal
        self._actuation, self._appraisal = actuation, Appraisal(footprint, road, settings.margin, horizon)
        self._horizon, self._latency, self._settings = horizon, latency, settings
        self._model = PredictionModel(vehicle, friction, horizon)
        self._lane = LaneKeeping.of(self._model, vehicle, friction, goal.lateral_offset)
        self._limits = BrakingLimits(vehicle, Parameters.of(vehicle, friction, SLIP_SPEED_FLOOR))
        self._deceleration = vehicle.force_limit * friction * GRAVITY * actuation.braking
        self._turn = vehicle.steering_rate_limit * horizon.sample_time
        self._braking = full_braking(vehicle, friction, horizon.prediction, actuation)

    def start(self) -> Memory:
        """No force, no plan; wheels straight, or as they are stuck."""
        commands = (self._actuation.fixed,) * n_commands(self._latency, self._horizon.sample_time)
        return Memory(commands, (), None, False, False, None, 0)

    def step(self, measurement: Measurement, memory: Memory) -> tuple[Command, Plan, Memory]:
        """One sample: watch, decide, drive."""
        with np.errstate(all="ignore"):  # a measurement beyond all reason may end in nan, which is caught below
            if not measurement.is_finite:
                return self._fall_back(measurement.time, Fallback.NOT_FINITE, memory)
            if is_late(measurement, self._latency, self._horizon.sample_time):
                return self._fall_back(measurement.time, Fallback.LATE, memory)
            return self._drive(measurement, memory)

    def _drive(self, measurement: Measurement, memory: Memory) -> tuple[Command, Plan, Memory]:
        delay = self._latency.effect(float(measurement.state[VX]))
        state = state_at_effect(measurement, memory.commands, delay, self._model)
        state[VX] = max(state[VX], 0.0)  # the model takes a brake's force for a motor's and turns the wheels back
        loads = measurement.wheel_loads
        falling = falling_loads(loads, memory.wheel_loads)
        seen = forecasts(measurement.stamp, measurement.obstacles, memory.forecasts)
        corridor = self._corridor(state, measurement, memory.commands[0], delay)
        # what a brake will have done by then is less sure than what is measured, so letting go waits for that
        faster = replace(corridor, speed=max(corridor.speed, float(measurement.state[VX])))
        is_alarmed = any(is_alarming(each, corridor, self._deceleration, self._settings) for each in seen)
        is_braking = is_alarmed or (
            memory.is_braking and any(faster.contact(each, 0.0, RELEASE_TIME) is not None for each in seen)
        )
        has_braked = memory.has_braked or is_braking
        wanted = wanted_speed(self._goal.speed, corridor, seen) if has_braked else self._goal.speed

        def forces(state: Array, u: Array) -> Array:
            limits = self._limits(state, u, falling)
            asked = np.append(0.0, self._forces(float(state[VX]), limits, -np.inf if is_braking else wanted))
            return self._actuation.within(asked, np.append(0.0, limits))[FORCES]

        inputs, states = self._roll_out(state, memory.commands[0], loads, forces)
        if not np.isfinite(inputs).all():
            return self._fall_back(measurement.time, Fallback.NOT_FINITE, memory)
        is_shaped = is_braking or wanted < self._goal.speed
        why = _why(is_alarmed, is_braking, is_shaped)
        plan = self._plan(measurement, corridor.start, inputs, states, seen, is_shaped, why)
        following = Memory(memory.after(inputs[0]), seen, loads, is_braking, has_braked, plan, 0)
        return Command.from_input(inputs[0]), plan, following

    def _plan(
        self,
        measurement: Measurement,
        start: float,
        inputs: Array,
        states: Array,
        seen: Sequence[Forecast],
        is_shaped: bool,
        reason: str,
    ) -> Plan:
        """What is driven from `start` [s] on, as a plan."""
        name, loads = "brake" if is_shaped else KEEP, measurement.wheel_loads
        demand = self._model.roll_out(states[0], inputs, loads).lateral_demand[0]
        return Plan(
            measurement.time,
            inputs,
            states,
            name=name,
            is_shaped=is_shaped,
            branches=(self._appraisal.branch(name, NOTHING_WEIGHED, states, start, seen),),
            reason=reason,
            friction_use=friction_use(inputs[0], demand, self._friction * loads),
        )

    def _corridor(self, state: Array, measurement: Measurement, command: Array, delay: float) -> Corridor:
        """The vehicle on the path that its lane keeper takes it along, at the present speed."""
        _, states = self._roll_out(state, command, measurement.wheel_loads, lambda state, u: np.zeros(4))
        path, start = Path.through(states), measurement.time + delay
        return Corridor(self._footprint, path, float(state[VX]), start, self._settings.margin)

    def _roll_out(
        self, state: Array, command: Array, loads: Array, forces: Callable[[Array, Array], Array]
    ) -> tuple[Array, Array]:
        """Inputs (Np, 5) and states (Np + 1, 6) of the lane keeper with wheel forces (4,) that a state asks for."""
        sample_time, reached = self._horizon.sample_time, float(command[DELTA])
        inputs, states = np.zeros((self._horizon.prediction, N_INPUTS)), [state]
        for u in inputs:
            if not (np.abs(states[-1]) <= ABSURD).all():  # diverged: no number of it is of use
                return np.full_like(inputs, np.nan), np.array(states)
            reached += min(max(self._lane.angle(states[-1]) - reached, -self._turn), self._turn)
            u[DELTA] = reached if self._actuation.steers else self._actuation.fixed[DELTA]
            u[FORCES] = forces(states[-1], u)
            felt = u.copy()
            felt[FORCES] = _until_standstill(
                u[FORCES], max(0.0, float(states[-1][VX])) * self._vehicle.mass / sample_time
            )
            states.append(self._model.advance(states[-1], felt, loads, sample_time))
        return inputs, np.array(states).reshape(-1, N_STATES)

    def _forces(self, speed: float, limits: Array, wanted: float) -> Array:
        """Wheel forces (4,) [N] at a speed [m/s] for a wanted one; all that the limits (4,) give for -inf."""
        if max(speed, wanted) < STANDSTILL:
            return -HOLD * limits
        if wanted == -np.inf:
            return -limits
        force = self._vehicle.mass * wanted_acceleration(speed, wanted)
        return np.asarray(np.clip(force * limits / limits.sum(), -limits, limits))

    def _fall_back(self, time: float, reason: Fallback, memory: Memory) -> tuple[Command, Plan, Memory]:
        """The command of the documented fallback."""
        age = memory.age + 1
        plan = fallback_plan(time, reason, memory.plan, age, self._braking)
        return (
            Command.from_input(plan.inputs[0]),
            plan,
            replace(memory, commands=memory.after(plan.inputs[0]), age=age),
        )


def _why(is_alarmed: bool, is_braking: bool, is_shaped: bool) -> str:
    """Why it does what it does."""
    if is_alarmed:
        return "a contact is so near that braking can't wait"
    if is_braking:
        return "it brakes until no contact is in sight"
    return "behind what is in front" if is_shaped else "no contact is near"


def _until_standstill(forces: Array, most: float) -> Array:
    """Wheel forces (4,) [N], braking no more than `most` [N] all together."""
    total = -float(forces.sum())
    return forces * (most / total) if total > most else forces
