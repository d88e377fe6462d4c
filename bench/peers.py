"""The nonlinear program as a peer: on what the unified controller measured, and in a closed loop of its own."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from bench.stopwatch import Step, Stopwatch
from swerve.control import Controller
from swerve.control.nonlinear import NonlinearController
from swerve.control.nonlinear.memory import Memory
from swerve.scenario import Scenario
from swerve.signals import Measurement
from swerve.simulate import Result, run
from swerve.simulate.assemble import controller_named

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Replay:
    """A controller on measurements of another's run.

    Attributes:
        steps: part "solve" has two calls in each, left and right, with all first guesses that they need.
        n_unsolved: calls that ended without a solution.
    """

    steps: list[Step]
    n_unsolved: int


def with_solver(scenario: Scenario, solver: str) -> Scenario:
    """The scenario with another solver of the nonlinear program."""
    settings = scenario.controller.nonlinear.model_copy(update={"solver": solver})
    return scenario.model_copy(update={"controller": scenario.controller.model_copy(update={"nonlinear": settings})})


def nonlinear_controller(scenario: Scenario) -> Controller[Memory]:
    """The nonlinear controller for a scenario, on the plant that the unified controller is measured on."""
    return controller_named("nonlinear", scenario, "planar")


def replay(controller: Controller[Memory], measured: Sequence[tuple[Measurement, Array]]) -> Replay:
    """Each step from the last one's plans and the measurement and command of the record."""
    watch, memory, n_unsolved = Stopwatch(), controller.start(), 0
    with watch.watching((NonlinearController, "step"), {"solve": [(NonlinearController, "_plan")]}):
        for measurement, command in measured:
            known = replace(memory, commands=(command, *memory.commands[1:]))
            _, plan, memory = controller.step(measurement, known)
            n_unsolved += plan.solver_failures
    return Replay(watch.steps, n_unsolved)


def closed_loop(scenario: Scenario) -> Result:
    """A run in which the peer drives."""
    return run(scenario, "nonlinear", "planar").result
