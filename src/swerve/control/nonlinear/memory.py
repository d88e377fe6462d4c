"""What the nonlinear controller carries from step to step."""

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
        inputs: of each side, the last plan's inputs (Np, 5).
        missed: of each side, for how many steps its plan has not been clear [1].
        committed: the side taken last, if an obstacle shaped its plan.
        plan: the last plan that was no fallback.
        age: samples since that plan [1].
    """

    commands: tuple[Array, ...]
    inputs: dict[Side, Array]
    missed: dict[Side, int]
    committed: Side | None
    plan: Plan | None
    age: int

    @property
    def is_of_one_mind(self) -> bool:
        """Whether both sides came to the same plan."""
        return self.inputs[Side.LEFT] is self.inputs[Side.RIGHT]

    def after(self, command: Array) -> tuple[Array, ...]:
        """The commands that the next step remembers."""
        return (command, *self.commands[:-1])
