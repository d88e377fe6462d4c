"""Left or right: clear before not clear, then cheaper, left when equal; and no dithering once a side is taken."""

from swerve.control.plan import Side
from swerve.control.unified.branch import SidePlan

CLEAR = 5e-3  # [m] a margin missed by less counts as kept
EQUAL = 1e-6  # [1] relative difference of two merits that is rounding


def choose(sides: dict[Side, SidePlan], committed: Side | None, commitment: float) -> SidePlan:
    """The side to take.

    Args:
        sides: the plan of each side.
        committed: the side taken so far while an obstacle shaped the plan, None if there was none.
        commitment: share of the committed side's merit that the other one must stay below to be taken [1].
    """
    left, right = sides[Side.LEFT], sides[Side.RIGHT]
    if committed is None:
        if _is_clear(left) != _is_clear(right):
            return left if _is_clear(left) else right
        return left if left.step.merit <= right.step.merit * (1 + EQUAL) + EQUAL else right
    here, there = (left, right) if committed is Side.LEFT else (right, left)
    if _is_clear(here) and not _is_clear(there):
        return here
    is_rescue = _is_clear(there) and not _is_clear(here)
    return there if is_rescue or there.step.merit < commitment * here.step.merit else here


def _is_clear(plan: SidePlan) -> bool:
    return plan.violation <= CLEAR
