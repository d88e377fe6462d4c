"""Where a series begins to avoid: a coarse way in from afar, then bisection on a lattice of the tolerance.

Avoiding need not be monotone in the distance, so the way in begins where stopping is easy and goes inwards through

    d_far = extent + 1.3 d_brake + 0.5 s v,    (1 + 0.05 2^j) d_swerve  below that, from the largest j to j = 0,
    d_swerve,  0.8 d_swerve,  0.64 d_swerve, ...  as far as bumper to bumper

with d_brake and d_swerve of `closed_form`: every step is at most half of what is left to d_swerve, so that what is
tried gets denser where boundaries lie. It ends after two distances in a row that are not avoided; nearer ones are not.
The boundary is the first failure from afar and the avoided distance before it, halved until they are neighbours on the
lattice. A distance avoided below the boundary makes the failures above it holes, which are told.

Where among the avoided distances the decision turns from braking alone to steering, that gap is halved as well, until
it is 2 % of the distance. If a distance tried there is not avoided, the boundary is further out, and is halved anew.
"""

from collections.abc import Generator, Iterable, Mapping
from dataclasses import dataclass
from itertools import count, pairwise
from math import ceil, floor
from typing import Final

from swerve.study.map.boundary import Boundary, Condition, RunRecord
from swerve.study.map.cell import INFINITESIMAL, Cell
from swerve.study.map.closed_form import braking_distance, swerving_distance

BRAKING_SHARE: Final = 1.3  # of the braking distance, beyond which every brake should stop [1]
REACTION: Final = 0.5  # [s] at full speed on top of that
FIRST_STEP: Final = 0.05  # [1] of the swerving distance, doubled outwards
INWARDS: Final = 0.8  # [1] ratio of the steps below it
BESIDE: Final = 0.9  # [1] of the furthest, from which on a step tells nothing new
MOST_FAILED: Final = 2  # in a row
TURN: Final = 0.02  # [1] of the distance, to which the turn of the decision is found
BRAKES: Final = "brake"  # the decision
STEERS: Final = "steer"  # is in the name of each decision that does

Search = Generator[float, RunRecord, None]  # gives the distance to try next [m], takes what became of it
Tried = Mapping[int, RunRecord]  # by the lattice's index


@dataclass(frozen=True)
class Lattice:
    """The distances of one cell.

    Attributes:
        tolerance: between neighbours [m].
        nearest: bumper to bumper [m].
        swerving: d_swerve [m].
        furthest: d_far [m].
    """

    tolerance: float
    nearest: float
    swerving: float
    furthest: float

    @classmethod
    def of(cls, cell: Cell, tolerance: float) -> "Lattice":
        """That of a cell."""
        speed, friction = cell.scene.closing, cell.condition.friction
        furthest = cell.extent + BRAKING_SHARE * braking_distance(speed, friction) + REACTION * speed
        return cls(tolerance, cell.extent, swerving_distance(speed, friction, cell.scene.room), furthest)

    def distance(self, index: int) -> float:
        """[m]."""
        return round(index * self.tolerance, INFINITESIMAL)

    @property
    def inwards(self) -> list[int]:
        """The coarse way, from the furthest on."""
        least, most = floor(self.nearest / self.tolerance) + 1, ceil(self.furthest / self.tolerance)
        places = [self.furthest, *self._outside(), *self._inside()]
        return sorted({min(max(round(each / self.tolerance), least), most) for each in places}, reverse=True)

    def _outside(self) -> Iterable[float]:
        for j in count():
            place = self.swerving * (1 + FIRST_STEP * 2**j)
            if not 0 < place < BESIDE * self.furthest:
                return
            yield place

    def _inside(self) -> Iterable[float]:
        place = min(self.swerving, self.furthest)
        while place > self.nearest:
            yield place
            place *= INWARDS
        yield self.nearest


def search(lattice: Lattice) -> Search:
    """Look for the boundary and the turn of one series, one distance after the other."""
    tried: dict[int, RunRecord] = {}
    n_failed = 0
    for index in lattice.inwards:
        tried[index] = yield lattice.distance(index)
        n_failed = 0 if tried[index].is_avoided else n_failed + 1
        if n_failed == MOST_FAILED:
            break
    while (wanted := _wanted(tried, lattice)) is not None:
        tried[wanted] = yield lattice.distance(wanted)


def boundary_of(who: str, condition: Condition, runs: Iterable[RunRecord]) -> Boundary:
    """The boundary of a controller in a cell from all of its runs there."""
    tried = dict(enumerate(sorted(runs, key=lambda each: each.distance)))
    failed, avoided = _edge(tried)
    turn = _turn(tried)
    lucky = min((i for i, each in tried.items() if each.is_avoided), default=len(tried))
    return Boundary(
        who=who,
        condition=condition,
        avoided=None if avoided is None else tried[avoided].distance,
        failed=None if failed is None else tried[failed].distance,
        decision=None if avoided is None else tried[avoided].decision,
        outcome=None if failed is None else tried[failed].outcome,
        n_runs=len(tried),
        turns=None if turn is None else tried[turn[0]].distance,
        holes=tuple(each.distance for i, each in tried.items() if i > lucky and not each.is_avoided),
    )


def _wanted(tried: Tried, lattice: Lattice) -> int | None:
    """The index to try next; None where nothing is left to refine."""
    failed, avoided = _edge(tried)
    if failed is not None and avoided is not None and avoided - failed > 1:
        return (failed + avoided) // 2
    turn = _turn(tried)
    if turn is not None and turn[1] - turn[0] > max(1.0, TURN * turn[0]):
        return sum(turn) // 2
    return None


def _edge(tried: Tried) -> tuple[int | None, int | None]:
    """The first that failed, from afar, and the last that was avoided before it."""
    avoided: int | None = None
    for index in sorted(tried, reverse=True):
        if not tried[index].is_avoided:
            return index, avoided
        avoided = index
    return None, avoided


def _turn(tried: Tried) -> tuple[int, int] | None:
    """The neighbours furthest out of which the nearer one steers and the other one brakes alone, both avoided."""
    failed, _ = _edge(tried)
    above = sorted((i for i in tried if failed is None or i > failed), reverse=True)
    decisions = {i: tried[i].decision or "" for i in above}
    turns = ((near, far) for far, near in pairwise(above) if decisions[far] == BRAKES and STEERS in decisions[near])
    return next(turns, None)
