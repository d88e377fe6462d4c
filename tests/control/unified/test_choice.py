"""Which way is taken: the rules, one by one, and over random candidates."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.control.plan import Passing
from swerve.control.unified.acceptance import Step
from swerve.control.unified.choice import EQUAL, HOPELESS, MILDER, NEARLY, ON_ROAD, Candidate, choose
from swerve.control.unified.improve import WayPlan
from swerve.control.unified.limits import ObstacleLimit, RoadEdge
from swerve.control.unified.program import Score
from swerve.control.unified.situation import CLEAR, Situation
from tests.control.unified.situations import AHEAD, BOX_CAR, LANES, situation

LEFT, RIGHT, BEHIND = Passing.LEFT, Passing.RIGHT, Passing.BEHIND
WAYS = (BEHIND, LEFT, RIGHT)
HIT = 1.0  # [m] of missed margin


@dataclass(frozen=True)
class Told:
    """What a candidate is to be like."""

    cost: float
    violation: float = 0.0
    off_road: float = 0.0
    impact_speed: float | None = None
    way: Passing = LEFT


@cache
def _situation(way: Passing) -> tuple[Situation, Step]:
    found = situation((way,), AHEAD, of=(*BOX_CAR, *LANES))
    return found, found.roll_out(np.zeros((20, 5)))


def candidate(told: Told) -> Candidate:
    """A candidate with a plan that is like this; merit within the horizon and cost are the same."""
    found, step = _situation(told.way)
    violations = [
        told.violation + limit.penalty.comfort
        if isinstance(limit, ObstacleLimit)
        else told.off_road
        if isinstance(limit, RoadEdge)
        else 0.0
        for limit in found.program.soft
    ]
    plan = WayPlan(found, replace(step, score=Score(told.cost, 0.0, tuple(violations))), 1.0, n_solved=1)
    return Candidate(plan, told.cost, told.impact_speed)


def chosen(told: Sequence[Told], committed: int | None = None, commitment: float = 0.5) -> int:
    """Index of the candidate that is taken; the reason is always a sentence."""
    candidates = [candidate(each) for each in told]
    choice = choose(candidates, None if committed is None else candidates[committed], commitment)
    assert choice.reason
    return candidates.index(choice.candidate)


costs = st.floats(0.0, 1e6)
misses = st.sampled_from([0.0, CLEAR, 2 * CLEAR, NEARLY, 2 * NEARLY, HIT])
edges = st.sampled_from([0.0, ON_ROAD, 2 * ON_ROAD, 1.0])
told = st.builds(Told, costs, misses, edges, st.none() | st.floats(0.0, 40.0), st.sampled_from(WAYS))


def test_a_candidate_is_what_it_was_told() -> None:
    """The helper above makes what it says."""
    plan = candidate(Told(3.0, 0.2, 0.3)).plan
    assert (plan.violation, plan.off_road, plan.step.merit) == (pytest.approx(0.2), 0.3, 3.0)


def test_a_single_way_is_taken() -> None:
    """However bad it is."""
    assert chosen([Told(1e9, HIT, HIT, 30.0)]) == 0


def test_the_cheapest_clear_one_is_taken() -> None:
    """All clear and on the road: the lowest cost wins, wherever it stands."""
    for order in ([3.0, 1.0, 2.0], [1.0, 2.0, 3.0], [3.0, 2.0, 1.0]):
        assert chosen([Told(cost * 100) for cost in order]) == order.index(1.0)


@given(costs, costs, edges)
def test_clear_comes_before_everything(clear: float, other: float, off_road: float) -> None:
    """A way that keeps its margin is taken before one that misses it, at any cost, and even off the road."""
    assert chosen([Told(other, HIT), Told(clear, 0.0, off_road)]) == 1
    assert chosen([Told(clear, 0.0, off_road), Told(other, HIT)]) == 0


@given(costs, costs)
def test_on_the_road_comes_before_cheap(on: float, off: float) -> None:
    """Both clear: the one that stays on the road, at any cost."""
    assert chosen([Told(off, 0.0, 1.0), Told(on)]) == 1
    assert chosen([Told(on), Told(off, 0.0, 1.0)]) == 0


@pytest.mark.parametrize("cost", [0.0, 1e-9, 1.0, 1e5])
def test_of_equal_ones_the_first(cost: float) -> None:
    """At costs whose difference says nothing the first is taken."""
    assert chosen([Told(cost)] * 3) == 0
    assert chosen([Told(cost * (1 + EQUAL / 2)), Told(cost), Told(cost)]) == 0
    assert chosen([Told(cost, HIT, 0.0, 9.0)] * 3) == 0


def _is_plain(candidates: Sequence[Told]) -> bool:
    """Whether no two are so much alike that their order matters."""
    costs = sorted(each.cost for each in candidates)
    made = [candidate(each) for each in candidates]
    severities = sorted(each.severity for each in made)
    near = any(b - a <= 2 * EQUAL * (1 + b) for a, b in pairwise(costs))
    return not near and all(b - a > 1e-9 for a, b in pairwise(severities))


@given(st.lists(told, min_size=2, max_size=4), st.randoms(), st.integers(-1, 3))
def test_the_order_matters_in_ties_alone(candidates: list[Told], random: object, committed: int) -> None:
    """Any permutation of candidates that are different takes the same one."""
    if not _is_plain(candidates):
        return
    so_far = committed if 0 <= committed < len(candidates) else None
    taken = candidates[chosen(candidates, so_far)]
    for shift in range(1, len(candidates)):
        turned = candidates[shift:] + candidates[:shift]
        place = None if so_far is None else (so_far - shift) % len(candidates)
        assert turned[chosen(turned, place)] is taken


@given(st.lists(told, min_size=2, max_size=4))
def test_nothing_better_is_left(candidates: list[Told]) -> None:
    """At first sight nothing with fewer faults is left, and nothing as good that is much cheaper."""
    made = [candidate(each) for each in candidates]
    taken = made[chosen(candidates)]
    if min(each.plan.violation for each in made) > NEARLY:
        assert taken.severity == min(each.severity for each in made)
        return
    assert taken.faults == min(each.faults for each in made)
    cheapest = min(each.cost for each in made if each.faults == taken.faults)
    assert taken.cost <= (1 + 4 * EQUAL) * cheapest + 4 * EQUAL


# No dithering


@given(costs, costs, st.sampled_from([0, 1]), st.floats(0.0, 1.0))
def test_a_way_is_kept_unless_another_is_much_cheaper(mine: float, other: float, place: int, share: float) -> None:
    """All clear, a way once taken is left only for one that costs less than the settings' share of it."""
    candidates = [Told(other), Told(other)]
    candidates[place] = Told(mine)
    stays = chosen(candidates, place, share) == place
    is_cheaper = other < mine - EQUAL * (1 + mine)
    if abs(other - mine) > 3 * EQUAL * (1 + max(mine, other)):
        assert stays == (not (other < share * mine and is_cheaper))


@given(costs, costs, st.sampled_from([0, 1]))
def test_a_clear_way_is_not_left_for_one_that_is_not(mine: float, other: float, place: int) -> None:
    """However cheap the other one looks."""
    for fault in (Told(other, 2 * CLEAR), Told(other, HIT), Told(other, 0.0, 1.0)):
        candidates = [fault, fault]
        candidates[place] = Told(mine)
        assert chosen(candidates, place) == place


@given(costs, costs, st.sampled_from([0, 1]))
def test_rescue(mine: float, other: float, place: int) -> None:
    """When the way so far touches an obstacle or leaves the road by much and another does not, it changes."""
    for fault in (Told(mine, 2 * NEARLY), Told(mine, 0.0, 2 * NEARLY)):
        candidates = [Told(other), Told(other)]
        candidates[place] = fault
        assert chosen(candidates, place) != place


@given(costs, st.sampled_from([0, 1]))
def test_what_may_be_mended_is_kept(cost: float, place: int) -> None:
    """A way that misses its margin by a little is not given up for another that costs as much."""
    candidates = [Told(cost), Told(cost)]
    candidates[place] = Told(cost, NEARLY / 2)
    assert chosen(candidates, place) == place


# Where a collision can't be avoided


def test_the_mildest_collision() -> None:
    """Where nothing is clear it is the least impact speed, not the least cost."""
    assert chosen([Told(1.0, HIT, 0.0, 15.0), Told(1e6, HIT, 0.0, 5.0), Told(10.0, HIT, 0.0, 10.0)]) == 1


def test_hope_makes_it_milder() -> None:
    """What misses by little may still be mended: a fast graze is tried before a slow hit in the middle."""
    assert chosen([Told(1.0, HIT, 0.0, 8.0), Told(1.0, 0.3 * HOPELESS, 0.0, 15.0)]) == 1
    assert chosen([Told(1.0, HIT, 0.0, 8.0), Told(1.0, 0.9 * HOPELESS, 0.0, 15.0)]) == 0


@pytest.mark.parametrize(("speed", "taken"), [(10.0 - MILDER / 2, 0), (10.0 - 2 * MILDER, 1)])
def test_a_little_milder_is_no_reason(speed: float, taken: int) -> None:
    """The way so far is kept where another impact is hardly milder."""
    assert chosen([Told(1.0, HIT, 0.0, 10.0), Told(1.0, HIT, 0.0, speed)], committed=0) == taken


def test_what_diverged_is_never_the_mildest() -> None:
    """A prediction that is no number is worse than any collision."""
    assert chosen([Told(np.inf, np.inf), Told(1e5, 3 * NEARLY, 0.0, 5.0)]) == 1


def test_what_diverged_is_never_the_cheapest() -> None:
    """A cost that is infinite is larger than any other."""
    assert chosen([Told(np.inf, np.inf), Told(1e5, NEARLY / 2)]) == 1


def test_the_reason_tells_why() -> None:
    """Each rule has its sentence, and a change names the way that is left."""
    pair = [candidate(Told(1.0, way=LEFT)), candidate(Told(100.0, way=RIGHT))]
    assert "the only way" in choose(pair[:1], None, 0.5).reason
    assert "cheapest" in choose(pair, None, 0.5).reason
    assert "way so far" in choose(pair, pair[0], 0.5).reason or choose(pair, pair[0], 0.5).candidate is pair[0]
    assert "50%" in choose(pair, pair[1], 0.5).reason
    assert "right" in choose(pair, pair[1], 0.5).reason
    hit = [candidate(Told(1.0, HIT, 0.0, 7.0, LEFT)), candidate(Told(1.0, way=RIGHT))]
    assert "touches" in choose(hit, hit[0], 0.5).reason
    assert "only one that is clear" in choose(hit, None, 0.5).reason
    assert "7.0 m/s" in choose([hit[0], hit[0]], None, 0.5).reason
