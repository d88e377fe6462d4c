"""Which way is taken: clear before not clear, on the road before off it, in its lane before out of it, then the cheaper
one; and no dithering.

Where no way is clear, the one with the least impact speed, weighed by how much it misses: a collision that can't be
avoided is to be a mild one, and one that nearly can be is better tried.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, isfinite

from swerve.control.unified.improve import WayPlan
from swerve.control.unified.situation import CLEAR

NEARLY = 0.1  # [m] a margin missed by less may still be mended; by more on every way, and a collision is expected
ON_ROAD = 0.05  # [m] beyond an edge that does not count
EQUAL = 1e-2  # [1] relative difference of two costs that says nothing
HOPELESS = 0.5  # [m] of margin missed from which on nothing can be mended
MILDER = 0.5  # [m/s] by which an impact must be milder to be worth another way


FAULTS = ("touches an obstacle", "leaves the road", "leaves the lane")


@dataclass(frozen=True, eq=False)
class Candidate:
    """A plan that may be taken.

    Attributes:
        plan: of one way.
        cost: of it, horizon and beyond [1].
        impact_speed: relative to the obstacle, None where nothing is touched [m/s].
        leaves_lane: whether the path does.
        is_leaving: whether the vehicle is about to: then it is too late to stay.
    """

    plan: WayPlan
    cost: float
    impact_speed: float | None
    leaves_lane: bool = False
    is_leaving: bool = False

    @property
    def faults(self) -> tuple[int, bool, bool]:
        """Whether it is clear (0), nearly (1) or not (2), leaves the road, and, where it is clear, the lane."""
        missed = self.plan.violation
        grade = 0 if missed <= CLEAR else 1 if missed <= NEARLY else 2
        return grade, self.plan.off_road > ON_ROAD, grade == 0 and self.leaves_lane

    @property
    def grave_faults(self) -> tuple[int, bool, bool]:
        """The same, but for what the next steps may still mend, and for a lane that is being left already."""
        grade = 0 if self.plan.violation <= NEARLY else 2
        return grade, self.plan.off_road > NEARLY, grade == 0 and self.leaves_lane and not self.is_leaving

    @property
    def severity(self) -> float:
        """The impact speed, less as there is hope that what is missed can still be mended [m/s]."""
        if not isfinite(self.plan.violation):
            return inf
        speed = 0.0 if self.impact_speed is None else self.impact_speed
        hopeless = self.plan.situation.outlook.is_blocked
        return speed if hopeless else speed * min(1.0, self.plan.violation / HOPELESS)


@dataclass(frozen=True, eq=False)
class Choice:
    """The candidate that is taken, and why."""

    candidate: Candidate
    reason: str


def choose(candidates: Sequence[Candidate], committed: Candidate | None, commitment: float) -> Choice:
    """The way to take.

    Args:
        candidates: of the ways that were planned, at least one; of equal ones the first is taken.
        committed: that of them which was taken so far while an obstacle shaped the plan, None if there was none.
        commitment: share of the committed one's cost that another must stay below to be taken [1].
    """
    if len(candidates) == 1:
        return Choice(candidates[0], "the only way")
    if min(each.plan.violation for each in candidates) > NEARLY:
        return _mildest(candidates, committed)
    best = _best(candidates)
    if committed is None or best is committed:
        return Choice(best, _why(best, candidates))
    if best.faults < committed.grave_faults:
        what = next(word for word, fault in zip(FAULTS, committed.grave_faults, strict=True) if fault)
        return Choice(best, f"the way so far, {committed.plan.way.name}, {what}")
    if best.plan.way.is_straight and best.faults[0] == 0 < committed.faults[0]:
        return Choice(best, f"the way so far, {committed.plan.way.name}, hardly goes, and there is room to stop")
    if best.faults <= committed.faults and _is_much_cheaper(best, committed, commitment):
        return Choice(best, f"costs less than {commitment:.0%} of the way so far, {committed.plan.way.name}")
    return Choice(committed, "the way so far, and none is much better")


def _is_much_cheaper(best: Candidate, committed: Candidate, commitment: float) -> bool:
    """Whether both within the horizon and with what is beyond: the latter alone swings while a swerve is under way."""
    within = best.plan.step.merit < commitment * committed.plan.step.merit
    return within and best.cost < commitment * committed.cost


def _best(candidates: Sequence[Candidate]) -> Candidate:
    best = candidates[0]
    for each in candidates[1:]:
        is_cheaper = each.cost < (best.cost - EQUAL * (1 + abs(best.cost)) if isfinite(best.cost) else inf)
        if each.faults < best.faults or (each.faults == best.faults and is_cheaper):
            best = each
    return best


def _mildest(candidates: Sequence[Candidate], committed: Candidate | None) -> Choice:
    mildest = min(candidates, key=lambda each: each.severity)
    if committed is not None and committed.severity <= mildest.severity + MILDER:
        mildest = committed
    speed = "none" if mildest.impact_speed is None else f"{mildest.impact_speed:.1f} m/s"
    return Choice(mildest, f"no way is clear: the least impact speed, {speed}")


def _why(best: Candidate, candidates: Sequence[Candidate]) -> str:
    better = [each for each in candidates if each.faults == best.faults]
    if len(better) > 1:
        return "the cheapest that is clear" if not best.faults[0] else "the cheapest, though none is clear"
    return "the only one that is clear" if not best.faults[0] else "the one that misses least"
