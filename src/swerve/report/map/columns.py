"""The columns of a map's table, for HTML and Markdown alike: a row is a condition."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial

from swerve.report.map.summary import BOTH, INDIVIDUAL, avoided, bought, conditions_of, panels, ratio
from swerve.study.map.boundary import Condition, Map


@dataclass(frozen=True)
class Column:
    """One of them.

    Attributes:
        title: with its unit in brackets.
        decimals: that are shown; None for as many as there are.
        of: the value of a condition; None where it has none.
    """

    title: str
    decimals: int | None
    of: Callable[[Condition], float | None]

    def shown(self, condition: Condition) -> str:
        """The value as text; a dash where there is none."""
        value = self.of(condition)
        if value is None:
            return "\N{EN DASH}"
        return f"{value:g}" if self.decimals is None else f"{value:.{self.decimals}f}"


def rows(found: Map) -> list[Condition]:
    """The conditions, panel by panel, by speed."""
    return [each for panel in panels(found) for each in conditions_of(found, panel)]


def columns(found: Map) -> list[Column]:
    """Keys; the last avoided distance of each controller and its ratio to the limit; the limits; turns and holes."""
    return [*_keys(found), *_controllers(found), *_limits(found), *_turns(found), *_holes(found)]


def _keys(found: Map) -> Iterator[Column]:
    yield Column("friction", None, lambda each: each.friction)
    if len({each.offset for each in found.conditions}) > 1:
        yield Column("offset [m]", None, lambda each: each.offset)
    yield Column("speed [m/s]", None, lambda each: each.speed)


def _controllers(found: Map) -> Iterator[Column]:
    for who in found.controllers:
        yield Column(f"{who} [m]", 2, partial(avoided, found, who))
        if INDIVIDUAL in found.limits:
            yield Column(f"{who} / limit", 3, partial(ratio, found, who))


def _limits(found: Map) -> Iterator[Column]:
    for who in found.limits:
        yield Column(f"{who} [m]", 2, partial(avoided, found, who))
    if {BOTH, INDIVIDUAL} <= {*found.limits}:
        yield Column("four wheel torques buy [m]", 2, partial(bought, found))


def _turns(found: Map) -> Iterator[Column]:
    for who in found.controllers:
        if any(each.turns is not None for each in found.boundaries if each.who == who):
            yield Column(f"{who} turns to steering at [m]", 2, partial(_turn, found, who))


def _turn(found: Map, who: str, condition: Condition) -> float | None:
    boundary = found.boundary(who, condition)
    return None if boundary is None else boundary.turns


def _holes(found: Map) -> Iterator[Column]:
    """How many distances were not avoided though a smaller one was; none where there are no such."""
    for who in found.controllers:
        if any(each.holes for each in found.boundaries if each.who == who):
            yield Column(f"{who} holes", 0, partial(_n_holes, found, who))


def _n_holes(found: Map, who: str, condition: Condition) -> float | None:
    boundary = found.boundary(who, condition)
    return None if boundary is None else len(boundary.holes)
