"""A way through a scene, its homotopy class: for each obstacle, how it is passed; and all that are worth a look.

Only obstacles in the path, those that the vehicle would touch if it just went on, are decided about. The others keep
the side on which they are passed anyway, but for ways on which all are passed on one side.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby, product

from swerve.control.plan import KEEP, Passing, Side

MOST_DECIDED = 3  # obstacles in the path, the first ones, for which all combinations of sides are tried

WORDS = {Passing.LEFT: "left", Passing.RIGHT: "right", Passing.BEHIND: "brake"}


@dataclass(frozen=True)
class Way:
    """How each obstacle is passed.

    Attributes:
        passing: of each obstacle, in the measurement's order.
        threats: indices of the obstacles in the path, the first to be met first.
    """

    passing: tuple[Passing, ...]
    threats: tuple[int, ...]

    @property
    def decided(self) -> tuple[Passing, ...]:
        """How the obstacles in the path are passed, the first one first."""
        return tuple(self.passing[i] for i in self.threats)

    @property
    def name(self) -> str:
        """As in "brake" or "left, then right"."""
        return ", then ".join(WORDS[each] for each, _ in groupby(self.decided)) or KEEP

    @property
    def side(self) -> Side | None:
        """The side on which it passes the first obstacle that it passes, None where it passes none."""
        return next((each.side for each in self.decided if each.side is not None), None)

    @property
    def is_straight(self) -> bool:
        """Whether it brakes and passes nothing that is in the path."""
        return self.brakes and self.side is None

    @property
    def brakes(self) -> bool:
        """Whether it stays behind an obstacle in the path."""
        return Passing.BEHIND in self.decided


def ways(natural: Sequence[Passing], threats: Sequence[int], companions: Sequence[int]) -> list[Way]:
    """All ways that are worth a look, without repetition; a single one where nothing is in the path.

    Args:
        natural: how each obstacle is passed by going on as before; of those in the path it does not matter.
        threats: indices of the obstacles in the path, the first to be met first.
        companions: indices of those beside it, which may be passed on the other side too.
    """
    if not threats:
        return [Way(tuple(natural), ())]
    found = [Way(passing, tuple(threats)) for passing in _passings(natural, threats, companions)]
    return list(dict.fromkeys(found))


def _passings(
    natural: Sequence[Passing], threats: Sequence[int], companions: Sequence[int]
) -> Iterator[tuple[Passing, ...]]:
    sides = (Passing.LEFT, Passing.RIGHT)
    decided = threats[:MOST_DECIDED]
    yield _with(natural, threats, (Passing.BEHIND,) * len(threats))
    for choice in product(sides, repeat=len(decided)):
        rest = (choice[-1],) * (len(threats) - len(decided))
        yield _with(natural, threats, choice + rest)
    for side in sides:
        beside = [i for i in companions if natural[i] is not Passing.BEHIND]
        yield _with(natural, [*threats, *beside], [side] * (len(threats) + len(beside)))
        if len(threats) > 1:
            yield _with(natural, threats, (side, *(Passing.BEHIND,) * (len(threats) - 1)))


def _with(natural: Sequence[Passing], threats: Sequence[int], choice: Sequence[Passing]) -> tuple[Passing, ...]:
    chosen = dict(zip(threats, choice, strict=True))
    return tuple(chosen.get(i, each) for i, each in enumerate(natural))
