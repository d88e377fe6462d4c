"""The nonlinear program as a peer: on what the unified controller measured, and in a closed loop of its own."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from unittest.mock import patch

import numpy as np
from numpy.typing import NDArray

from bench.nonlinear_program import NonlinearController, NonlinearProgram
from bench.stopwatch import Step, Stopwatch
from swerve.control import Goal, Horizon, Weights
from swerve.control.unified import UnifiedSettings
from swerve.scenario import Scenario
from swerve.signals import Measurement
from swerve.simulate import CONTROLLERS, Result, run

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Replay:
    """A controller on measurements of another's run.

    Attributes:
        steps: part "solve" has two calls in each, left and right.
        n_unsolved: calls that ended without a solution.
    """

    steps: list[Step]
    n_unsolved: int


def nonlinear_controller(scenario: Scenario, solver: str) -> NonlinearController:
    """The nonlinear program for a scenario, with the settings of its unified controller."""
    settings = scenario.controller
    return NonlinearController(
        vehicle=scenario.ego.to_vehicle(),
        friction=scenario.road.friction,
        goal=Goal(**scenario.goal.model_dump()),
        horizon=Horizon(settings.prediction_horizon, settings.control_horizon, settings.sample_time),
        weights=Weights(**settings.weights.model_dump()),
        settings=UnifiedSettings(**settings.unified.model_dump()),
        n_obstacles=len(scenario.obstacles),
        solver=solver,
    )


def replay(controller: NonlinearController, measured: Sequence[tuple[Measurement, Array]]) -> Replay:
    """Each step from the last one's plans and the measurement and command of the record."""
    watch, memory, n_unsolved = Stopwatch(), controller.start(), 0
    with watch.watching((NonlinearController, "step"), {"solve": [(NonlinearProgram, "solve")]}):
        for measurement, command in measured:
            _, plan, memory = controller.step(measurement, replace(memory, command=command))
            n_unsolved += plan.solver_failures
    return Replay(watch.steps, n_unsolved)


def closed_loop(controller: NonlinearController, scenario: Scenario) -> Result:
    """A run in which the peer drives."""
    with patch.dict(CONTROLLERS, {"nonlinear": lambda *_: controller}):
        return run(scenario, "nonlinear", "planar").result
