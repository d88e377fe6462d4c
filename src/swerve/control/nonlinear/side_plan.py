"""The plan of one side, and which of the two is taken."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.plan import Side
from swerve.conventions import X, Y

Array = NDArray[np.float64]

CLEAR = 5e-3  # [m] a margin that is missed by less counts as kept
ALIKE = 1e-2  # [m] paths that are nowhere further apart are the same
EQUAL = 1e-4  # [1] difference of two costs, relative and absolute, that is the solver's tolerance


@dataclass(frozen=True, eq=False)
class SidePlan:
    """What is planned for one side.

    Attributes:
        side: on which it was begun; the solver may end on the other.
        inputs: (Np, 5) [rad, N, N, N, N].
        states: (Np + 1, 6), the measured one first.
        cost: violations included [1].
        missed: largest distance by which a margin to an obstacle is missed [m].
        held_by: the obstacle that shapes it most, in the measurement's order; None where none does.
        is_solved: whether the solver says that this is a local minimum.
    """

    side: Side
    inputs: Array
    states: Array
    cost: float
    missed: float
    held_by: int | None
    is_solved: bool

    @property
    def is_clear(self) -> bool:
        """Whether it keeps all margins."""
        return self.missed <= CLEAR

    def is_like(self, other: "SidePlan") -> bool:
        """Whether both are solved, to the same path."""
        apart = np.abs(self.states[:, [X, Y]] - other.states[:, [X, Y]]).max()
        return self.is_solved and other.is_solved and bool(apart < ALIKE)


def choose(plans: Mapping[Side, SidePlan], committed: Side | None, commitment: float) -> tuple[SidePlan, str]:
    """Clear before not clear, then cheaper, left when equal; a side once taken is kept while it is as good as this.

    Args:
        plans: of both sides.
        committed: the side that was taken so far.
        commitment: the other side is taken when it costs less than this share of that one [1].

    Returns:
        The plan, and why.
    """
    left, right = plans[Side.LEFT], plans[Side.RIGHT]
    if all(each.held_by is None for each in plans.values()):
        return plans[committed or Side.LEFT], "nothing is in the way of the cheapest"
    if left.is_clear != right.is_clear:
        return left if left.is_clear else right, "the only side that is clear"
    if committed is None:
        return left if left.cost <= right.cost * (1 + EQUAL) + EQUAL else right, "the cheaper side"
    here, there = plans[committed], plans[Side(-committed.value)]
    if there.cost < commitment * here.cost:
        return there, f"costs less than {commitment:.0%} of the side so far, {here.side.name.lower()}"
    return here, "the side so far, and the other is not much cheaper"
