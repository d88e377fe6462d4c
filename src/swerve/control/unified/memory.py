"""What the unified controller carries from step to step."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from swerve.control.forecast import Forecast
from swerve.control.plan import Passing, Plan
from swerve.control.unified.held import Held
from swerve.conventions import N_INPUTS

Array = NDArray[np.float64]

Key = tuple[Passing, ...]  # how each obstacle is passed: what a way is known by from step to step


@dataclass(frozen=True, eq=False)
class Memory:
    """Values of the last step; nothing else is remembered.

    Attributes:
        commands: (5,) inputs that were given, the last one first; as many as still matter.
        inputs: for each way that was planned, its plan's inputs (Np, 5).
        trust: for each of these ways, size of the trust region as a share of the full one [1].
        held: what held each of these plans.
        taken: the way taken last; None before the first step.
        committed: that way, if an obstacle shaped a plan.
        forecasts: of each obstacle.
        threats: indices of the obstacles that were in the path.
        plan: that is followed: the last one that was no fallback, or full braking that was taken after it.
        age: samples since that plan [1].
        count: steps so far [1].
        wheel_loads: (4,) of the last measurement that was finite [N]; None before the first.
        deviation: (5,) of the last command from the driver's input; zero without a driver [rad, N, N, N, N].
    """

    commands: tuple[Array, ...]
    inputs: dict[Key, Array] = field(default_factory=dict)
    trust: dict[Key, float] = field(default_factory=dict)
    held: dict[Key, Held] = field(default_factory=dict)
    taken: Key | None = None
    committed: Key | None = None
    forecasts: tuple[Forecast, ...] = ()
    threats: tuple[int, ...] = ()
    plan: Plan | None = None
    age: int = 0
    count: int = 0
    wheel_loads: Array | None = None
    deviation: Array = field(default_factory=lambda: np.zeros(N_INPUTS))

    @property
    def command(self) -> Array:
        """(5,) the input that was given last."""
        return self.commands[0]

    def after(self, command: Array) -> tuple[Array, ...]:
        """The commands that the next step remembers."""
        return (command, *self.commands[:-1])

    def key_of(self, passing: Key, threats: tuple[int, ...]) -> Key | None:
        """The remembered way that passes the obstacles in the path in this way, the very same one before others."""
        if passing in self.inputs:
            return passing
        return next((key for key in self.inputs if is_same(key, passing, threats)), None)


def is_same(key: Key | None, passing: Key, threats: tuple[int, ...]) -> bool:
    """Whether two ways pass the obstacles in the path alike."""
    return key is not None and len(key) == len(passing) and all(key[i] is passing[i] for i in threats)
