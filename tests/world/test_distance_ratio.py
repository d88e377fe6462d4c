"""The distance ratio sqrt(rho) of eq. (5), for points and for boxes."""

import math
import time

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.world import Ellipse, Obstacle, Point, Rectangle, Steady, clearance, distance_ratio
from tests.world.strategies import boundary, ellipses, obstacles, placed, poses, rectangles


def rho(points: np.ndarray, obstacle: Obstacle, at: float) -> np.ndarray:
    """Eq. (5) as the paper writes it, with the offsets turned into the ellipse's axes."""
    (x_o, y_o), (a, b) = obstacle.position_at(at), semi_axes(obstacle)
    cos, sin = math.cos(obstacle.heading_at(at)), math.sin(obstacle.heading_at(at))
    dx, dy = points[:, 0] - x_o, points[:, 1] - y_o
    squares: np.ndarray = ((cos * dx + sin * dy) / a) ** 2 + ((-sin * dx + cos * dy) / b) ** 2
    return squares


def semi_axes(obstacle: Obstacle) -> tuple[float, float]:
    """Semi-axes (a, b) of an elliptical obstacle [m]."""
    assert isinstance(obstacle.shape, Ellipse)
    return obstacle.shape.semi_axes


@given(poses, obstacles(ellipses), st.floats(0.0, 5.0))
def test_the_ratio_of_a_point_is_equation_5(pose: tuple[float, float, float], obstacle: Obstacle, at: float) -> None:
    """A point's ratio is the square root of eq. (5), whatever the obstacle's heading and speed."""
    expected = math.sqrt(rho(np.array([pose[:2]]), obstacle, at)[0])
    assert distance_ratio(Point(), [pose], obstacle, [at])[0] == pytest.approx(expected, rel=1e-9, abs=1e-9)


@given(rectangles, poses, obstacles(ellipses), st.floats(0.0, 5.0))
def test_the_ratio_of_a_box_is_the_smallest_over_its_boundary(
    box: Rectangle, pose: tuple[float, float, float], obstacle: Obstacle, at: float
) -> None:
    """Unless the ellipse's centre is inside the box, a dense walk round the box finds the same least ratio."""
    walk = boundary(box.outline(), 2000)
    brute = math.sqrt(rho(placed(walk, pose[:2], pose[2]), obstacle, at).min())
    step = max(box.length, box.width) / 2000 / min(semi_axes(obstacle))  # furthest from a sample, in ratio
    found = distance_ratio(box, [pose], obstacle, [at])[0]
    if found > 0:
        assert brute - step <= found <= brute + 1e-9
    else:
        centre = placed(obstacle.position_at([at]) - pose[:2], (0.0, 0.0), -pose[2])[0] - box.centre
        assert abs(centre[0]) <= box.length / 2 + 1e-9
        assert abs(centre[1]) <= box.width / 2 + 1e-9


def test_the_ratio_of_a_box_in_closed_form() -> None:
    """Ahead of a disc of 2 m the ratio is the bumper's distance over 2; a box over the centre has ratio 0."""
    disc, car = Obstacle(Ellipse((2.0, 2.0)), Steady(position=(25.0, 0.0))), Rectangle(4.8, 1.8)
    found = distance_ratio(car, [(0.0, 0.0, 0.0), (20.6, 0.0, 0.0), (25.0, 0.5, 1.0)], disc, np.zeros(3))
    np.testing.assert_allclose(found, [(25 - 2.4) / 2, 1.0, 0.0])


@given(rectangles, poses, obstacles(ellipses))
def test_a_ratio_above_one_and_a_clearance_go_together(
    box: Rectangle, pose: tuple[float, float, float], obstacle: Obstacle
) -> None:
    """Ratio at most 1 means overlap; a clearance means a ratio above 1."""
    ratio = distance_ratio(box, [pose], obstacle, [0.0])[0]
    gap = clearance(box, [pose], obstacle, [0.0])[0]
    if ratio <= 1:
        assert gap == 0.0
    if gap > 0:
        assert ratio > 1


def test_a_moving_obstacle_is_met_where_it_is_at_the_time() -> None:
    """Each pose is held against the ellipse at its own time."""
    lead = Obstacle(Ellipse((2.5, 2.0)), Steady(position=(25.0, 0.0), velocity=(10.0, 0.0)))
    times = np.linspace(0.0, 2.0, 5)
    poses_at = np.column_stack((25 * times, np.zeros((5, 2))))
    np.testing.assert_allclose(distance_ratio(Point(), poses_at, lead, times), np.abs(25 - 15 * times) / 2.5)


def test_a_rectangle_has_no_distance_ratio() -> None:
    """Eq. (5) speaks of ellipses; anything else is an error that says so."""
    with pytest.raises(TypeError, match="Rectangle"):
        distance_ratio(Point(), [(0.0, 0.0, 0.0)], Obstacle(Rectangle(4.0, 2.0), Steady((9.0, 0.0))), [0.0])


@pytest.mark.parametrize("footprint", [Point(), Rectangle(4.8, 1.8)])
def test_a_pose_that_is_not_finite_has_no_ratio(footprint: Point | Rectangle) -> None:
    """A pose of nan has a ratio of nan, not 0 and not a safe one."""
    disc = Obstacle(Ellipse((2.0, 2.0)), Steady(position=(25.0, 0.0)))
    found = distance_ratio(footprint, [(0.0, 0.0, 0.0), (math.nan, 0.0, 0.0)], disc, np.zeros(2))
    assert np.isfinite(found).tolist() == [True, False]


def test_five_seconds_at_a_millisecond_take_milliseconds() -> None:
    """5000 poses of a box are judged in less than 50 ms, best of three."""
    disc, car = Obstacle(Ellipse((2.0, 2.0)), Steady(position=(25.0, 0.0))), Rectangle(4.8, 1.8)
    times = np.linspace(0.0, 5.0, 5000)
    poses_at = np.column_stack((20 * times, np.zeros_like(times), 0.1 * np.sin(times)))
    took = []
    for _ in range(3):
        started = time.perf_counter()
        distance_ratio(car, poses_at, disc, times)
        took.append(time.perf_counter() - started)
    assert min(took) < 0.05
