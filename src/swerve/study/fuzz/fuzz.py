"""Many steps of the controller, each at a random measurement, with the memory of whatever came before.

A step is wrong where it raises, where its command is not finite, or where it exceeds a limit: the steering lock, the
steering rate, and for each wheel the share of the friction that a wheel force may take. That is taken at the loads
of the last finite measurement, and at static ones before the first.
"""

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from swerve.control import Controller
from swerve.conventions import N_INPUTS
from swerve.scenario import load
from swerve.simulate.assemble import controller_named
from swerve.study.fuzz.limits import Held, Limits, static_loads
from swerve.study.fuzz.measurements import measurement

Progress = Callable[[float], None]  # takes the share that is done, from 0 to 1

CONTROLLER: Final = "unified"
PLANT: Final = "multibody"  # whose delays and steering rate the controller is told
N_STEPS: Final = 100_000
FORGETS: Final = 0.05  # share of the steps that begin with an empty memory [1]

# What the controllers are told: a wide road and a narrow one, grip and none, a point and a body.
SETTINGS: Final[tuple[tuple[str, ...], ...]] = (
    (),
    ("ego.footprint=rectangle", "road.lane_width=3.5", "road.lanes_right=1"),
    ("road.friction=0.1", "ego.footprint=rectangle"),
    ("road.friction=1.2", "road.lane_width=2.5", "sensing.delay=0.05", "goal.lateral_offset=2.5"),
)


@dataclass(frozen=True)
class Fault:
    """A step that was wrong: its number, the controller's settings, and what was wrong."""

    step: int
    settings: tuple[str, ...]
    sentence: str


@dataclass(frozen=True)
class Fuzz:
    """What became of the steps.

    Attributes:
        seed: of the measurements.
        n_steps: that were made.
        faults: of them.
        answers: how many steps had a plan, and how many each fallback.
    """

    seed: int
    n_steps: int
    faults: tuple[Fault, ...]
    answers: dict[str, int]


def fuzz(seed: int, progress: Progress, n_steps: int = N_STEPS) -> Fuzz:
    """Make so many steps, an equal share of them with each of SETTINGS.

    Args:
        seed: of the measurements.
        progress: called with the share that is done [1].
        n_steps: altogether.
    """
    faults: list[Fault] = []
    answers: Counter[str] = Counter()
    each, n_settings = n_steps // len(SETTINGS), len(SETTINGS)
    for i, settings in enumerate(SETTINGS):
        for k, (answer, wrong) in enumerate(_steps(settings, np.random.default_rng([seed, i]), each)):
            answers[answer] += 1
            faults += [Fault(k, settings, wrong)] if wrong else []
            progress((i * each + k + 1) / (each * n_settings))
    return Fuzz(seed, each * n_settings, tuple(faults), dict(answers))


def _steps(settings: tuple[str, ...], random: np.random.Generator, n: int) -> Iterator[tuple[str, str | None]]:
    """Of each step how it was answered, and what is wrong with it."""
    scenario = load("paper", settings)
    controller: Controller[Any] = controller_named(CONTROLLER, scenario, PLANT)
    start = Held(np.zeros(N_INPUTS), static_loads(scenario))
    memory, held, limits = controller.start(), start, Limits.of(scenario)
    for k in range(n):
        if random.random() < FORGETS:
            memory, held = controller.start(), start
        given = measurement(random, k * scenario.controller.sample_time)
        if given.is_finite:
            held = Held(held.last, np.maximum(given.wheel_loads, 0.0))
        try:
            command, plan, memory = controller.step(given, memory)
        except Exception as error:  # whatever it is, it is a fault
            yield "exception", f"{type(error).__name__}: {error}"
            memory, held = controller.start(), start
            continue
        yield plan.fallback.name.lower() if plan.fallback else "plan", limits.fault(command.as_input(), held)
        held = Held(command.as_input(), held.loads)
