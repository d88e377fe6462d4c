"""Ways through a scene against brute force: which there are, what they are called, none twice."""

from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.control.plan import Passing, Side
from swerve.control.unified.way import MOST_DECIDED, Way, ways

LEFT, RIGHT, BEHIND = Passing.LEFT, Passing.RIGHT, Passing.BEHIND


@st.composite
def crowds(draw: st.DrawFn, most: int = 6) -> tuple[list[Passing], list[int], list[int]]:
    """How obstacles are passed by themselves, which are in the path, and which are beside it."""
    natural = draw(st.lists(st.sampled_from(list(Passing)), max_size=most))
    role = [draw(st.sampled_from(["threat", "companion", "far"])) for _ in natural]
    threats = draw(st.permutations([i for i, each in enumerate(role) if each == "threat"]))
    return natural, threats, [i for i, each in enumerate(role) if each == "companion"]


@given(crowds())
def test_there_is_always_a_way_and_none_twice(crowd: tuple[list[Passing], list[int], list[int]]) -> None:
    """At least one; each passes all obstacles; without repetition."""
    natural, threats, _ = crowd
    found = ways(*crowd)
    assert found
    assert len({each.passing for each in found}) == len(found)
    assert all(len(each.passing) == len(natural) and each.threats == tuple(threats) for each in found)


@given(crowds())
def test_what_is_not_in_the_path_is_passed_as_it_is(crowd: tuple[list[Passing], list[int], list[int]]) -> None:
    """Far ones are never decided about, and companions only together with all of the path on one side."""
    natural, threats, companions = crowd
    for way in ways(*crowd):
        changed = {i for i in range(len(natural)) if i not in threats and way.passing[i] is not natural[i]}
        assert changed <= set(companions)
        if changed:
            assert all(natural[i] is not BEHIND for i in changed)
            assert {way.passing[i] for i in [*changed, *threats]} in ({LEFT}, {RIGHT})


@given(crowds())
def test_braking_is_always_a_way(crowd: tuple[list[Passing], list[int], list[int]]) -> None:
    """Where anything is in the path, the first way stays behind all of it; where nothing is, there is one way."""
    natural, threats, _ = crowd
    found = ways(*crowd)
    if threats:
        assert set(found[0].decided) == {BEHIND}
        assert found[0].is_straight
        assert found[0].name == "brake"
        assert sum(way.is_straight for way in found) == 1
    else:
        assert [way.passing for way in found] == [tuple(natural)]
        assert found[0].name == "keep"
        assert (found[0].side, found[0].brakes, found[0].is_straight) == (None, False, False)


@given(crowds())
def test_all_sides_of_the_first_ones_are_combined(crowd: tuple[list[Passing], list[int], list[int]]) -> None:
    """Every combination of sides of the first obstacles in the path is a way, and so is a side and then the brake."""
    _, threats, _ = crowd
    decided = {way.decided for way in ways(*crowd)}
    if not threats:
        assert decided == {()}
        return
    n = len(threats)
    wanted = {sides + (sides[-1],) * (n - len(sides)) for sides in product((LEFT, RIGHT), repeat=min(n, MOST_DECIDED))}
    wanted |= {(BEHIND,) * n, (LEFT, *(BEHIND,) * (n - 1)), (RIGHT, *(BEHIND,) * (n - 1))}
    assert decided == wanted


def test_left_comes_before_right() -> None:
    """Of equal ways the first is taken: left before right."""
    names = [way.name for way in ways([LEFT], [0], [])]
    assert names == ["brake", "left", "right"]


@given(crowds())
def test_the_mirror_has_the_mirrored_ways(crowd: tuple[list[Passing], list[int], list[int]]) -> None:
    """Left for right, the set of ways is the mirror image."""
    natural, threats, companions = crowd
    flip = {LEFT: RIGHT, RIGHT: LEFT, BEHIND: BEHIND}
    here = {tuple(flip[each] for each in way.passing) for way in ways(*crowd)}
    assert here == {way.passing for way in ways([flip[each] for each in natural], threats, companions)}


@pytest.mark.parametrize(
    ("passing", "threats", "name", "side", "is_straight", "brakes"),
    [
        ((BEHIND, LEFT), (), "keep", None, False, False),
        ((BEHIND, LEFT), (0,), "brake", None, True, True),
        ((LEFT, RIGHT), (1, 0), "right, then left", Side.RIGHT, False, False),
        ((LEFT, LEFT), (0, 1), "left", Side.LEFT, False, False),
        ((LEFT, RIGHT, LEFT), (0, 1, 2), "left, then right, then left", Side.LEFT, False, False),
        ((BEHIND, RIGHT), (1, 0), "right, then brake", Side.RIGHT, False, True),
        ((BEHIND, RIGHT), (0, 1), "brake, then right", Side.RIGHT, False, True),
    ],
)
def test_what_a_way_is_called(
    passing: tuple[Passing, ...],
    threats: tuple[int, ...],
    name: str,
    side: Side | None,
    is_straight: bool,
    brakes: bool,
) -> None:
    """Its name tells what is done about the path, the first first; its side is that of the first it passes."""
    way = Way(passing, threats)
    assert (way.name, way.side, way.is_straight, way.brakes) == (name, side, is_straight, brakes)
