"""What the unified controller carries from step to step."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Plan, Side

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Memory:
    """Values of the last step; nothing else is remembered.

    Attributes:
        commands: (5,) inputs that were given, the last one first; as many as still matter.
        inputs: for each side, the last plan's inputs (Np, 5); a side that was never planned is absent.
        trust: for each side, size of the trust region as a share of the full one [1].
        taken: the side taken last.
        committed: that side, if an obstacle shaped its plan.
        plan: the last plan that was no fallback.
        age: samples since that plan [1].
    """

    commands: tuple[Array, ...]
    inputs: dict[Side, Array]
    trust: dict[Side, float]
    taken: Side
    committed: Side | None
    plan: Plan | None
    age: int

    @property
    def command(self) -> Array:
        """(5,) the input that was given last."""
        return self.commands[0]

    def after(self, command: Array) -> tuple[Array, ...]:
        """The commands that the next step remembers."""
        return (command, *self.commands[:-1])


def shifted(inputs: Array, samples: int = 1) -> Array:
    """A plan's inputs (Np, 5) some samples later: its own from there on, the last one held."""
    return np.asarray(inputs[np.minimum(np.arange(len(inputs)) + samples, len(inputs) - 1)])
