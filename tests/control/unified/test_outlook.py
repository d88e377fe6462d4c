"""What a way does beyond the horizon: where it steers for, and when it stands."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from swerve.control.plan import Passing
from swerve.control.unified.outlook import BRAKING, OVERSHOOT, outlook
from swerve.control.unified.tail import Outlook
from swerve.control.unified.way import Way, ways
from swerve.conventions import GRAVITY
from swerve.world import Obstacle, Rectangle, Steady
from tests.control.unified.situations import BOX_CAR, LANES, PASSED, RUNNING, in_the_mirror, other_side, scene

LEFT, RIGHT, BEHIND = Passing.LEFT, Passing.RIGHT, Passing.BEHIND
OPEN = BOX_CAR
ROAD = (*BOX_CAR, *LANES)
LOWEST, HIGHEST = -1.75 + 0.9 + 0.02, 5.25 - 0.9 - 0.02  # of the centre of gravity on that road [m]


def car(x: float, y: float, speed: float = 0.0) -> Obstacle:
    """A car of 4.5 m x 1.8 m."""
    return Obstacle(Rectangle(4.5, 1.8), Steady((x, y), (speed, 0.0)))


def found(
    passing: tuple[Passing, ...], *obstacles: Obstacle, of: tuple[str, ...] = OPEN, ahead: float = 0.0
) -> Outlook:
    """The outlook of a way round all of these, as if each were in the path."""
    return outlook(scene(*obstacles, of=of), Way(passing, tuple(range(len(passing)))), 0.05, 20, 16, ahead)


@pytest.mark.parametrize("side", PASSED)
def test_it_steers_past_the_obstacle_and_then_for_its_goal(side: Passing) -> None:
    """While the obstacle is to be passed the target is OVERSHOOT beyond what is clear of it; then it is the goal."""
    targets = found((side,), car(40.0, 0.0)).targets
    clear = 0.9 + 0.9 + 0.02
    assert targets[0] == pytest.approx(side.value * (clear + OVERSHOOT))
    assert targets[-1] == 0.0
    assert set(np.round(targets, 6)) == {0.0, round(side.value * (clear + OVERSHOOT), 6)}
    assert (targets[:20] != 0).all()  # after a second it is still before the obstacle


@settings(max_examples=60)
@given(st.floats(15.0, 60.0), st.floats(-1.0, 3.5), st.sampled_from(PASSED))
def test_targets_are_on_the_road_where_there_is_room(x: float, y: float, side: Passing) -> None:
    """On a road with edges every target is clear of the obstacle and on the road, if both go together at all."""
    outlooks = found((side,), car(x, y), of=ROAD)
    clear = y + side.value * (0.9 + 0.9 + 0.02)
    assume(LOWEST <= clear <= HIGHEST)
    assert (outlooks.targets >= LOWEST - 1e-9).all()
    assert (outlooks.targets <= HIGHEST + 1e-9).all()
    assert (outlooks.targets[0] - clear) * side.value >= -1e-9


def test_what_is_met_at_the_same_time_leaves_its_room() -> None:
    """Between two cars that are side by side the target is clear of both."""
    targets = found((LEFT, RIGHT), car(30.0, -2.5), car(31.0, 3.5)).targets
    assert -2.5 + 1.82 <= targets[0] <= 3.5 - 1.82


def test_one_after_the_other() -> None:
    """A slalom: past the first on its left, then past the second on its right, then for the goal."""
    targets = found((LEFT, RIGHT), car(30.0, 0.0), car(55.0, 0.5)).targets
    signs = [int(np.sign(round(float(target), 6))) for target in targets]
    assert signs[0] == 1
    assert signs[-1] == 0
    changes = [sign for k, sign in enumerate(signs) if k == 0 or sign != signs[k - 1]]
    assert changes == [1, -1, 0]


@settings(max_examples=40)
@given(
    st.lists(
        st.tuples(st.floats(10.0, 70.0), st.floats(-3.0, 3.0), st.floats(-10.0, 25.0), st.sampled_from(list(Passing))),
        min_size=1,
        max_size=4,
    )
)
def test_the_mirror_steers_for_mirrored_targets(cars: list[tuple[float, float, float, Passing]]) -> None:
    """Left for right, all targets change their sign and nothing else changes."""
    others, passing = [car(*each[:3]) for each in cars], tuple(each[3] for each in cars)
    here = found(passing, *others)
    there = found(tuple(other_side(each) for each in passing), *(in_the_mirror(each) for each in others))
    np.testing.assert_allclose(there.targets, -here.targets, atol=1e-12)
    np.testing.assert_array_equal(there.durations, here.durations)
    assert (there.stiffness, there.lateral, there.braking) == (here.stiffness, here.lateral, here.braking)
    assert np.isfinite(here.targets).all()


def test_a_straight_stop_has_no_target() -> None:
    """Staying behind all of the path, it brakes and ends its lateral motion."""
    stop = found((BEHIND,), car(40.0, 0.0))
    assert (stop.stiffness, stop.braking) == (0.0, pytest.approx(BRAKING * 0.85 * GRAVITY))


@pytest.mark.parametrize("speed", [2.0, 10.0, 20.0, 40.0])
def test_it_looks_until_it_stands(speed: float) -> None:
    """The steps of a way that brakes reach to the stop, whatever the speed; the first of them are samples."""
    state = RUNNING * speed / 20
    seen = scene(car(10.0, 0.0), state=state, of=OPEN)
    stop = outlook(seen, Way((BEHIND,), (0,)), 0.05, 20, 16, 0.0)
    np.testing.assert_array_equal(stop.durations[:20], 0.05)
    assert stop.times[-1] >= speed / stop.braking - 1e-9
    assert (np.diff(stop.durations[20:]) == 0).all()


def test_what_stays_behind_does_not_steer_past_what_it_stays_behind() -> None:
    """Past the first and behind the second: the target is that of the first alone, and it brakes less than straight."""
    one, both = found((LEFT,), car(30.0, 0.0)), found((LEFT, BEHIND), car(30.0, 0.0), car(60.0, 3.0))
    assert both.targets[0] == one.targets[0]
    assert 0 < both.braking < found((BEHIND,), car(30.0, 0.0)).braking
    assert one.braking == 0.0


def test_keeping_on_steers_for_the_goal() -> None:
    """With nothing in the path the target is the goal's offset, and nothing brakes."""
    seen = scene(of=(*ROAD, "goal.lateral_offset=1 m"))
    (keep,) = ways(seen.natural, seen.threats, seen.companions)
    rest = outlook(seen, keep, 0.05, 20, 16, 1.0)
    np.testing.assert_array_equal(rest.targets, 1.0)
    assert rest.braking == 0.0
