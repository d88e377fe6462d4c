"""Road edges and what is between them."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.world import Point, Rectangle, Road
from tests.world.strategies import placed, rectangles


def test_edges_of_a_road_with_one_lane_to_the_left() -> None:
    """The ego vehicle starts in the middle of the right one of two lanes of 3.5 m."""
    road = Road(lane_width=3.5, lanes_left=1, lanes_right=0)
    assert road.left_edge == 5.25
    assert road.right_edge == -1.75


def test_a_road_without_a_lane_width_has_no_edges() -> None:
    """Without edges every place is inside."""
    road = Road()
    assert road.left_edge is None
    assert road.right_edge is None
    assert road.is_inside(Point(), [(0.0, 1e6, 0.0), (0.0, -1e6, 0.0)]).tolist() == [True, True]


def test_a_box_leaves_the_road_with_its_first_corner() -> None:
    """A car of 4.8 m by 1.8 m may be 4.35 m to the left, an edge included, and less when it is turned."""
    road, car = Road(lane_width=3.5), Rectangle(4.8, 1.8)
    heights = [(0.0, 4.35, 0.0), (0.0, 4.36, 0.0), (0.0, 4.35, 0.1), (0.0, -0.85, 0.0), (0.0, -0.86, 0.0)]
    assert road.is_inside(car, heights).tolist() == [True, False, False, True, False]


@given(rectangles, st.floats(-8.0, 8.0), st.floats(-math.pi, math.pi))
def test_inside_means_every_corner_inside(box: Rectangle, y: float, heading: float) -> None:
    """The answer is that of the box's corners, looked at one by one."""
    road = Road(lane_width=3.5, lanes_left=1, lanes_right=1)
    corners = placed(box.outline(), (0.0, y), heading)[:, 1]
    margin = min(5.25 - corners.max(), corners.min() + 5.25)
    if abs(margin) > 1e-9:
        assert road.is_inside(box, [(3.0, y, heading)])[0] == (margin > 0)


def test_oncoming_lanes_begin_where_the_own_ones_end() -> None:
    """Of three lanes to the left the outer two are oncoming: beyond one and a half lanes from the middle."""
    assert Road(3.5, lanes_left=3, lanes_oncoming=2).oncoming_edge == 5.25
    assert Road(3.5, lanes_left=1, lanes_oncoming=1).oncoming_edge == 1.75
    assert Road(3.5, lanes_left=3).oncoming_edge is None
    assert Road().oncoming_edge is None


@given(rectangles, st.floats(-8.0, 8.0), st.floats(-math.pi, math.pi))
def test_oncoming_means_any_corner_beyond_the_line(box: Rectangle, y: float, heading: float) -> None:
    """The answer is that of the box's corners, looked at one by one, and never true without oncoming lanes."""
    road = Road(3.5, lanes_oncoming=1)
    corners = placed(box.outline(), (0.0, y), heading)[:, 1]
    if abs(corners.max() - 1.75) > 1e-9:
        assert road.is_oncoming(box, [(3.0, y, heading)])[0] == (corners.max() > 1.75)
    assert not Road(3.5).is_oncoming(box, [(3.0, y, heading)])[0]


def test_a_pose_that_is_not_finite_is_not_inside() -> None:
    """A run that diverged is not on the road."""
    assert not Road(lane_width=3.5).is_inside(Point(), np.full((1, 3), np.nan))[0]


@pytest.mark.parametrize(
    "arguments", [{"lane_width": 0.0}, {"lane_width": math.nan}, {"lanes_left": -1}, {"lanes_oncoming": 2}]
)
def test_an_impossible_road_is_refused(arguments: dict[str, float]) -> None:
    """The error names the argument that is wrong."""
    with pytest.raises(ValueError, match=next(iter(arguments))):
        Road(**arguments)  # type: ignore[arg-type]
