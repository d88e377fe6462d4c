"""What the hierarchical controller carries from step to step."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.forecast import Forecast
from swerve.control.hierarchical.manoeuvre import Manoeuvre
from swerve.control.plan import Plan

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Memory:
    """Values of the last step; nothing else is remembered.

    Attributes:
        commands: (5,) inputs that were given, the last one first; as many as still matter.
        forecasts: of the obstacles.
        wheel_loads: (4,) as measured, None before the first measurement [N].
        manoeuvre: that was decided on, None before the first decision.
        plan: the last plan that was no fallback.
        age: samples since that plan [1].
    """

    commands: tuple[Array, ...]
    forecasts: tuple[Forecast, ...]
    wheel_loads: Array | None
    manoeuvre: Manoeuvre | None
    plan: Plan | None
    age: int

    def after(self, command: Array) -> tuple[Array, ...]:
        """The commands that the next step remembers."""
        return (command, *self.commands[:-1])
