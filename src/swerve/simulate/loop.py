"""One run: sense, control, move, again. The main idea of swerve is these few lines; the rest are its parts.

Two clocks: the controller's sample time, and the plant's step, of which a sample has a whole number.
"""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from swerve.control import Controller, Plan
from swerve.plant import Plant, Trace
from swerve.scenario import Scenario
from swerve.sensing import Past, Truth
from swerve.signals import Command, DriverInput, Measurement
from swerve.simulate.assemble import DEFAULT_CONTROLLER, DEFAULT_PLANT, controller_named, plant_named, sensor_of
from swerve.simulate.failures import Failures
from swerve.simulate.log import Log, motion_table, steps_table
from swerve.simulate.result import Result, evaluate
from swerve.world import Obstacle

Until = Callable[[float, Trace], bool]  # start [s] and trace of a sample: whether the run is over
Sense = Callable[[float, Past, Sequence[Obstacle], np.random.Generator], Measurement]


@dataclass(frozen=True, eq=False)
class Run:
    """A run that is over.

    Attributes:
        scenario: what was run.
        log: what was recorded.
        plans: of each controller step.
        result: the numbers.
    """

    scenario: Scenario
    log: Log
    plans: tuple[Plan, ...]
    result: Result


def run(
    scenario: Scenario,
    controller: str = DEFAULT_CONTROLLER,
    plant: str = DEFAULT_PLANT,
    seed: int = 0,
    progress: Callable[[float], None] | None = None,
    sense: Sense | None = None,
    until: Until | None = None,
) -> Run:
    """Run a scenario to its end, or to the sample in which the motion stops being finite.

    Args:
        scenario: what happens.
        controller: name of the controller.
        plant: name of the plant.
        seed: of all random numbers of the run.
        progress: called after each sample with the share that is done [1].
        sense: time, past truth, obstacles, random generator -> measurement; that of the scenario by default.
        until: start and trace of each sample -> whether the run ends with it; never before its time by default.

    Raises:
        InputError: no such controller or plant.
    """
    started = time.perf_counter()
    built = controller_named(controller, scenario, plant), plant_named(plant, scenario)
    sensing = sense or sensor_of(scenario).measure, np.random.default_rng(seed)
    watched = progress or (lambda share: None), until or (lambda start, trace: False)
    traces, commands, plans, step_times, drivers = _drive(scenario, *built, *sensing, *watched)
    step, sample_time = scenario.plant.step, scenario.controller.sample_time
    n_rows = sum(len(trace.states) for trace in traces)
    log = Log(
        motion_table(step * np.arange(float(n_rows)), traces),
        steps_table(sample_time * np.arange(float(len(plans))), commands, plans, step_times, drivers),
    )
    wall_time = time.perf_counter() - started
    return Run(
        scenario, log, tuple(plans), evaluate(scenario, controller, plant, seed, log, commands, plans, wall_time)
    )


def _drive(
    scenario: Scenario,
    controller: Controller[Any],
    plant: Plant,
    sense: Sense,
    generator: np.random.Generator,
    progress: Callable[[float], None],
    until: Until,
) -> tuple[list[Trace], list[Command], list[Plan], list[float], list[DriverInput | None]]:
    """The loop: traces of the plant, and command, plan, time and driver's input of each controller step."""
    ego, sample_time = scenario.ego, scenario.controller.sample_time
    obstacles = [obstacle.to_world() for obstacle in scenario.obstacles]
    failures = Failures(scenario.actuation.failed, scenario.actuation.steering_stuck)
    state = plant.start(np.array([ego.speed, 0.0, 0.0, ego.heading, *ego.position]))
    past = Past(scenario.plant.step, scenario.n_substeps, Truth(state.vehicle, state.wheel_loads, np.zeros(2)))
    memory = controller.start()
    traces: list[Trace] = []
    commands: list[Command] = []
    plans: list[Plan] = []
    step_times: list[float] = []
    drivers: list[DriverInput | None] = []
    for k in range(scenario.n_samples):
        measurement = sense(k * sample_time, past, obstacles, generator)
        began = time.perf_counter()
        command, plan, memory = controller.step(measurement, memory)
        step_times.append(time.perf_counter() - began)
        state, trace = plant.advance(state, failures.acting(command))
        now = Truth(state.vehicle, state.wheel_loads, trace.acceleration[-1])
        past.grow(trace.states, trace.wheel_loads, trace.acceleration, now)
        traces.append(trace)
        commands.append(command)
        plans.append(plan)
        drivers.append(measurement.driver)
        progress((k + 1) / scenario.n_samples)
        if not np.isfinite(state.vehicle).all() or until(k * sample_time, trace):
            break
    _, last = plant.advance(state, failures.acting(commands[-1]))
    traces.append(_first_row(last))
    return traces, commands, plans, step_times, drivers


def _first_row(trace: Trace) -> Trace:
    """The instant at which a trace begins: here the end of the run."""
    return Trace(**{name: values[:1] for name, values in vars(trace).items()})
