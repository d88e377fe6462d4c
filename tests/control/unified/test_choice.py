"""Left or right: the rules, one by one."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.control import Side
from swerve.control.unified.choice import CLEAR, choose
from tests.control.unified.situations import SIDES, side_plan

LEFT, RIGHT = SIDES
HIT = 1.0  # [m] of missed margin
merits = st.floats(0.0, 1e6)
misses = st.sampled_from([0.0, CLEAR, 2 * CLEAR, HIT])


def chosen(
    left: tuple[float, float], right: tuple[float, float], committed: Side | None = None, commitment: float = 0.5
) -> Side:
    """The side taken for merit and missed margin of both sides."""
    sides = {LEFT: side_plan(LEFT, *left), RIGHT: side_plan(RIGHT, *right)}
    return choose(sides, committed, commitment).side


def test_the_cheaper_side_is_taken() -> None:
    """Both clear, or neither: the lower merit wins."""
    assert chosen((100.0, 0.0), (90.0, 0.0)) is RIGHT
    assert chosen((90.0, 0.0), (100.0, 0.0)) is LEFT
    assert chosen((100.0, HIT), (90.0, HIT)) is RIGHT


@pytest.mark.parametrize("merit", [0.0, 1e-9, 1.0, 1e5])
def test_left_when_equal(merit: float) -> None:
    """At equal cost, to rounding, it goes left."""
    assert chosen((merit, 0.0), (merit, 0.0)) is LEFT
    assert chosen((merit * (1 + 1e-9), 0.0), (merit, 0.0)) is LEFT
    assert chosen((float("inf"), HIT), (float("inf"), HIT)) is LEFT


@given(merits, merits)
def test_a_side_that_is_clear_comes_first(left: float, right: float) -> None:
    """Before anything is committed a side that keeps its margin is taken before one that misses it, at any cost."""
    assert chosen((left, HIT), (right, 0.0)) is RIGHT
    assert chosen((left, 0.0), (right, HIT)) is LEFT


@given(merits, merits, st.sampled_from(SIDES), st.floats(0.0, 1.0))
def test_no_dithering(mine: float, other: float, committed: Side, commitment: float) -> None:
    """Both clear, a side once taken is left only for one that costs less than the settings' share of it."""
    plans = {committed: (mine, 0.0), Side(-committed.value): (other, 0.0)}
    stays = chosen(plans[LEFT], plans[RIGHT], committed, commitment) is committed
    assert stays == (not other < commitment * mine)


@given(merits, merits, st.sampled_from(SIDES))
def test_a_clear_side_is_not_left_for_one_that_is_not(mine: float, other: float, committed: Side) -> None:
    """However cheap the other side looks, a plan that keeps clear is kept."""
    plans = {committed: (mine, 0.0), Side(-committed.value): (other, HIT)}
    assert chosen(plans[LEFT], plans[RIGHT], committed) is committed


@given(merits, merits, st.sampled_from(SIDES))
def test_rescue(mine: float, other: float, committed: Side) -> None:
    """When the side that was taken no longer keeps clear and the other one does, it changes, at any cost."""
    plans = {committed: (mine, HIT), Side(-committed.value): (other, 0.0)}
    assert chosen(plans[LEFT], plans[RIGHT], committed) is not committed


@given(merits, misses, merits, misses, st.none() | st.sampled_from(SIDES))
def test_the_mirror_image_is_chosen_in_the_mirror(
    left: float, left_missed: float, right: float, right_missed: float, committed: Side | None
) -> None:
    """Left and right exchanged, the other side is taken, unless they are equal."""
    here = chosen((left, left_missed), (right, right_missed), committed)
    mirrored = None if committed is None else Side(-committed.value)
    there = chosen((right, right_missed), (left, left_missed), mirrored)
    is_tie = committed is None and abs(left - right) <= 2e-6 * (1 + abs(left))
    assert is_tie or there is not here
