"""What is in the path and what is not, as anyone on the road would say."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swerve.control.plan import Passing, Side
from swerve.control.unified.memory import Memory
from swerve.control.unified.scene import BESIDE, LEAVING, Place
from swerve.world import Ellipse, Footprint, Obstacle, Point, Rectangle, Road, Steady
from tests.control.unified.situations import (
    AHEAD,
    BOX_CAR,
    CAR,
    LANES,
    RUNNING,
    Array,
    controller,
    in_the_mirror,
    other_side,
    random_start,
    scene,
    seeds,
)
from tests.vehicle.motions import MIRROR

VEHICLE = Rectangle(4.5, 1.8)
LANE = 3.5  # [m]
WIDE = (*BOX_CAR, *LANES, "road.lanes_left=2", "road.lanes_right=1")


def car(x: float, y: float, speed: float = 0.0, heading: float = 0.0, sideways: float = 0.0) -> Obstacle:
    """Another car."""
    return Obstacle(VEHICLE, Steady((x, y), (speed, sideways), heading))


def threats(*obstacles: Obstacle, state: Array = RUNNING, of: tuple[str, ...] = WIDE) -> tuple[int, ...]:
    """Which of these are in the path, at first sight."""
    return scene(*obstacles, state=state, of=of).threats


@pytest.mark.parametrize(
    "obstacle",
    [
        car(30.0, 0.0),
        car(30.0, 1.0),
        car(40.0, 0.0, 5.0),
        car(60.0, 0.0, -10.0, np.pi),
        car(30.0, 6.0, 0.0, -np.pi / 2, -3.5),
        car(14.0, -4.0, 15.0, 0.4, 2.5),
        Obstacle(Ellipse((0.3, 0.3)), Steady((30.0, -3.0), (0.0, 1.9))),
        car(5.0, 0.0),
    ],
    ids=["resting", "half in the lane", "slower", "oncoming", "crossing", "cutting in", "pedestrian", "touching"],
)
def test_what_would_be_hit_is_in_the_path(obstacle: Obstacle) -> None:
    """Whatever the vehicle would touch by going on."""
    assert threats(obstacle) == (0,)


@pytest.mark.parametrize(
    "obstacle",
    [
        car(20.0, LANE),
        car(20.0, -LANE),
        car(20.0, LANE, 20.0),
        car(60.0, LANE, -20.0, np.pi),
        car(20.0, -2.2),
        car(25.0, 0.0, 20.0),
        car(25.0, 0.0, 30.0),
        car(-20.0, 0.0),
        car(-20.0, 0.0, 20.0),
        Obstacle(Ellipse((0.3, 0.3)), Steady((30.0, -12.0), (0.0, 1.0))),
        Obstacle(Ellipse((0.3, 0.3)), Steady((30.0, 2.0), (0.0, 3.0))),
        car(500.0, 0.0),
    ],
    ids=[
        "left lane",
        "right lane",
        "alongside",
        "oncoming in its lane",
        "on the shoulder",
        "followed",
        "faster",
        "behind",
        "following",
        "pedestrian who comes too late",
        "pedestrian who is gone by then",
        "beyond the horizon",
    ],
)
def test_what_would_be_passed_is_not_in_the_path(obstacle: Obstacle) -> None:
    """Nothing is to be decided about what the vehicle does not touch by going on."""
    assert threats(obstacle) == ()


def test_the_goal_is_where_the_path_goes() -> None:
    """Asked to go to the next lane, what is there is in the path, and what is in this one far ahead is not."""
    of = (*WIDE, "goal.lateral_offset=3.5 m")
    assert threats(car(60.0, LANE), car(60.0, 0.0), of=of) == (0,)
    assert threats(car(60.0, LANE), car(60.0, 0.0)) == (1,)


@pytest.mark.parametrize(("speed", "distance"), [(20.0, 80.0), (30.0, 150.0), (40.0, 230.0)])
def test_it_looks_as_far_as_a_stop_takes(speed: float, distance: float) -> None:
    """The faster it is, the further ahead something is in the path, with time to react."""
    state = RUNNING * speed / 20
    assert threats(car(distance, 0.0), state=state) == (0,)
    assert threats(car(distance + 2 * speed, 0.0), state=state) == ()


def test_the_first_to_be_met_comes_first() -> None:
    """Threats are in the order in which they are met, not in that of the measurement."""
    assert threats(car(60.0, 0.0), car(20.0, 0.5), car(40.0, -0.3)) == (1, 2, 0)
    assert threats(car(30.0, 0.0, 12.0), car(45.0, 0.0)) == (1, 0)


def test_companions_are_near_and_not_in_the_path() -> None:
    """What a swerve may meet is known; what is further away than a swerve goes is not."""
    found = scene(car(30.0, 0.0), car(30.0, LANE), car(30.0, -LANE), car(30.0, 2 * BESIDE), of=WIDE)
    assert (found.threats, found.companions) == ((0,), (1, 2))


@pytest.mark.parametrize(
    ("obstacle", "passing"),
    [
        (car(30.0, LANE), Passing.RIGHT),
        (car(30.0, -LANE), Passing.LEFT),
        (car(25.0, 0.0, 20.0), Passing.BEHIND),
        (car(0.0, LANE, 20.0), Passing.RIGHT),
        (car(60.0, LANE, -20.0, np.pi), Passing.RIGHT),
    ],
)
def test_going_on_passes_it_like_this(obstacle: Obstacle, passing: Passing) -> None:
    """What is in the left lane is passed on its right, and what is followed is not passed."""
    assert scene(obstacle, of=WIDE).natural == (passing,)


@settings(max_examples=40)
@given(
    seeds,
    st.lists(
        st.tuples(st.floats(-20.0, 80.0), st.floats(-6.0, 6.0), st.floats(-25.0, 25.0), st.floats(-1.0, 1.0)),
        min_size=1,
        max_size=4,
    ),
)
def test_the_mirror_has_the_mirrored_scene(seed: int, cars: list[tuple[float, float, float, float]]) -> None:
    """Left for right the same obstacles are in the path, and those that are passed are passed on the other side."""
    state = random_start(np.random.default_rng(seed))
    others = [car(*each) for each in cars]
    of = (*BOX_CAR, "road.lane_width=3.5 m", "road.lanes_left=1", "road.lanes_right=1")
    here = scene(*others, state=state, of=of)
    there = scene(*(in_the_mirror(each) for each in others), state=state * MIRROR, of=of)
    assert (there.threats, there.companions) == (here.threats, here.companions)
    assert there.natural == tuple(other_side(each) for each in here.natural)


@settings(max_examples=30)
@given(st.floats(5.0, 40.0), st.floats(0.0, 25.0), st.floats(-3.4, 3.4))
def test_whoever_goes_straight_on_touches_what_is_in_the_path(gap: float, slower: float, offset: float) -> None:
    """Straight ahead at constant speeds the closed form: side by side overlap, and caught up with in time."""
    obstacle = car(gap + 5.0, offset, 20.0 - slower)
    reach, margin = (VEHICLE.width + CAR.width) / 2, 0.02
    front = CAR.centre[0] + CAR.length / 2
    nearest = gap + 5.0 - VEHICLE.length / 2 - front - margin
    is_met = abs(offset) < reach + margin and nearest < slower * 3.6
    if abs(abs(offset) - reach - margin) > 0.1 and abs(nearest - slower * 3.6) > 3.0:
        assert (threats(obstacle) == (0,)) == is_met


def test_what_was_in_the_path_leaves_it_late() -> None:
    """Once in the path an obstacle is so until it is passed with room to spare, and then it is gone."""
    known = Memory(controller(*WIDE).start().commands, threats=(0,))
    widths = (VEHICLE.width + CAR.width) / 2
    for room, before, after in ((0.3, (), (0,)), (LEAVING - 0.1, (), (0,)), (LEAVING + 0.1, (), ())):
        beside = car(30.0, widths + room)
        assert scene(beside, of=WIDE).threats == before
        assert scene(beside, memory=known, of=WIDE).threats == after


def test_nothing_around_is_nothing_in_the_path() -> None:
    """An empty road has an empty scene."""
    found = scene()
    assert (found.threats, found.companions, found.natural, found.forecasts) == ((), (), (), ())
    assert found.speed == 20.0


@pytest.mark.parametrize("state", [np.zeros(6), np.array([-3.0, 0, 0, 0, 0, 0])])
def test_standing_nothing_at_rest_is_in_the_path(state: Array) -> None:
    """Who stands or rolls back meets nothing that stands in front of it."""
    assert threats(car(8.0, 0.0), state=state) == ()
    assert scene(AHEAD, state=state).threats == ()


@pytest.mark.parametrize("footprint", [Point(), CAR])
def test_room_is_where_the_whole_footprint_is_on_the_road(footprint: Footprint) -> None:
    """Between the lines of room the footprint is on the road with its margin; without edges all is room."""
    place = Place(footprint, Road(3.5, 1, 0), 0.85, 0.0, 0.1)
    lowest, highest = place.room()
    half = 0.0 if isinstance(footprint, Point) else 0.9
    assert (lowest, highest) == (pytest.approx(-1.75 + half + 0.1), pytest.approx(5.25 - half - 0.1))
    assert place.reach(Side.LEFT) == place.reach(Side.RIGHT) == half
    assert Place(footprint, Road(), 0.85, 0.0, 0.1).room() == (-np.inf, np.inf)
