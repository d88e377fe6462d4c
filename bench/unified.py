"""The unified controller in a closed loop: its step part by part, its kernels, its quadratic programs by themselves."""

from collections.abc import Mapping, Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from bench.statistic import Statistic, durations
from bench.stopwatch import Step, Stopwatch, Target, recording
from swerve.control.unified import Formulation, UnifiedController, improve, situation
from swerve.control.unified.prediction import PredictionModel
from swerve.control.unified.program import Program
from swerve.control.unified.tail import Tail
from swerve.conventions import N_INPUTS
from swerve.kernel import Kernel
from swerve.plant import PlanarPlant
from swerve.qp import Problem, solve
from swerve.scenario import Scenario
from swerve.signals import Measurement
from swerve.simulate import Run, run

Array = NDArray[np.float64]

STEP: Final[Target] = (UnifiedController, "step")
PARTS: Final[Mapping[str, Sequence[Target]]] = {
    "look at the scene": [(Formulation, "scene")],
    "price the ways": [(Formulation, "price")],
    "set up the ways": [(Formulation, "situation")],
    "roll out guesses": [(situation.Situation, "roll_out")],
    "linearise": [(PredictionModel, "linearise")],
    "condense": [(situation, "condense")],
    "derive the tail": [(Tail, "sensitivities")],
    "build the QP": [(Program, "labelled")],
    "solve the QP": [(improve, "solve")],
    "accept": [(improve, "accept")],
}
KERNELS: Final[Mapping[str, Target]] = {
    "roll-out": (PredictionModel, "roll_out"),
    "linearisation": (PredictionModel, "linearise"),
    "one sample of the plant": (PlanarPlant, "advance"),
}


def drive(scenario: Scenario) -> Run:
    """One run: the controller whose parts are timed, on the plant for which the limits are meant."""
    return run(scenario, "unified", "planar")


def steps(scenario: Scenario, n_runs: int) -> list[list[Step]]:
    """The steps of each run, after one run to warm up."""
    drive(scenario)
    runs = []
    for _ in range(n_runs):
        watch = Stopwatch()
        with watch.watching(STEP, PARTS):
            drive(scenario)
        runs.append(watch.steps)
    return runs


def kernel_calls(scenario: Scenario) -> dict[str, tuple[Statistic, Statistic]]:
    """Of each compiled function: the call of the kernel, and the call of the method around it, over a run."""
    calls = {}
    for name, method in KERNELS.items():
        watch = Stopwatch()
        with watch.watching(method, {"kernel": [(Kernel, "__call__")]}):
            drive(scenario)
        kernel, whole = [step.total("kernel") for step in watch.steps], [step.duration for step in watch.steps]
        calls[name] = Statistic.of(kernel), Statistic.of(whole)
    return calls


def problems(scenario: Scenario) -> list[Problem]:
    """The quadratic programs of one run, in order."""
    with recording((improve, "solve")) as calls:
        drive(scenario)
    return [problem for problem, *_ in calls]


def solver_times(recorded: Sequence[Problem], solver: str, n_repeats: int) -> Statistic:
    """How long a solver takes over the problems, each at its best of some repeats."""
    return Statistic.of([min(durations(n_repeats, solve, each, solver)) for each in recorded])


def measured(scenario: Scenario) -> list[tuple[Measurement, Array]]:
    """Of each step of one run: what the controller measured, and the input (5,) that acted then."""
    with recording(STEP) as calls:
        plans = drive(scenario).plans
    commands = [np.zeros(N_INPUTS), *(plan.inputs[0] for plan in plans)]
    return [(measurement, command) for (_, measurement, _), command in zip(calls, commands, strict=False)]
