"""Runs made up by hand: a path that is known, as the log of a run that never happened."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swerve.control import Plan, Side
from swerve.plant import Trace
from swerve.scenario import Scenario, load
from swerve.signals import Command
from swerve.simulate import Log, Result
from swerve.simulate.log import motion_table, steps_table
from swerve.simulate.result import evaluate

Array = NDArray[np.float64]
COAST = Command(0.0, np.zeros(4))


def straight(speed: float = 20.0, seconds: float = 3.0, lateral: float = 0.0, step: float = 1e-3) -> Array:
    """States (n, 6) of a vehicle that keeps straight on at `lateral` [m]."""
    times = np.arange(round(seconds / step) + 1) * step
    states = np.zeros((len(times), 6))
    states[:, 0], states[:, 4], states[:, 5] = speed, speed * times, lateral
    return states


def trace(states: Array) -> Trace:
    """A plant's trace with these states and nothing else."""
    n = len(states)
    return Trace(states, np.zeros(n), np.zeros((n, 2)), *(np.zeros((n, 4)) for _ in range(4)))


def plan(side: Side | None = None, **named: Any) -> Plan:
    """A plan of nothing; one with a side is shaped by an obstacle unless told otherwise."""
    return Plan(0.0, np.zeros((1, 5)), np.zeros((0, 6)), side, **{"is_shaped": side is not None, **named})


def recorded(
    states: Array,
    overrides: tuple[str, ...] = (),
    commands: list[Command] | None = None,
    plans: list[Plan] | None = None,
    step: float = 1e-3,
) -> Result:
    """The result of the paper's scenario, overrides applied, had the vehicle moved through these states."""
    commands, plans = commands or [COAST], plans or [plan()]
    log = Log(
        motion_table(np.arange(len(states)) * step, [trace(states)]),
        steps_table(np.arange(len(plans)) * 0.05, commands, plans, [1e-3] * len(plans)),
    )
    return evaluate(load("paper", overrides), "unified", "planar", 7, log, commands, plans, 1.5)


@dataclass
class FakeController:
    """Commands what it is told to, and notes what it was called with."""

    scenario: Scenario
    command: Command = COAST
    calls: list[Any] = field(default_factory=list)

    def start(self) -> int:
        """The number of steps so far."""
        return 0

    def step(self, measurement: Any, memory: int) -> tuple[Command, Plan, int]:
        """Count."""
        self.calls.append((measurement, memory))
        return self.command, plan(), memory + 1
