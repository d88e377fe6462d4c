"""Clearance in metres: closed forms, brute force, and the symmetries that a distance has."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swerve.world import AlongWaypoints, Ellipse, Obstacle, Point, Rectangle, Shape, Steady, clearance
from swerve.world.clearance import ELLIPSE_TOLERANCE
from tests.world.strategies import angles, at_start, boundary, coordinates, obstacles, placed, poses, rectangles, shapes

CAR = Rectangle(4.8, 1.8)


def clearance_at(footprint: Shape, pose: tuple[float, float, float], obstacle: Obstacle, time: float = 0.0) -> float:
    """Clearance of a single pose [m]."""
    return float(clearance(footprint, [pose], obstacle, [time])[0])


def test_two_boxes_side_by_side() -> None:
    """Boxes along the axes are apart by their gap, and diagonally by the distance of their corners."""
    other = Obstacle(Rectangle(4.0, 2.0), Steady(position=(10.0, 0.0)))
    assert clearance_at(CAR, (0.0, 0.0, 0.0), other) == pytest.approx(10 - 2 - 2.4)
    assert clearance_at(CAR, (0.0, 5.0, 0.0), other) == pytest.approx(math.hypot(5.6, 5 - 1 - 0.9))
    assert clearance_at(CAR, (0.0, 0.0, math.pi / 2), other) == pytest.approx(10 - 2 - 0.9)


def test_a_box_is_placed_by_its_own_centre() -> None:
    """A box whose centre is ahead of its origin is that much nearer to what is ahead."""
    ahead = Obstacle(Rectangle(4.0, 2.0), Steady(position=(10.0, 0.0)))
    assert clearance_at(Rectangle(4.8, 1.8, (0.3, 0.0)), (0.0, 0.0, 0.0), ahead) == pytest.approx(5.6 - 0.3)


@given(coordinates, coordinates)
def test_a_point_and_a_disc_are_apart_by_the_radius(x: float, y: float) -> None:
    """Distance to a disc is distance to its centre less its radius, at most 1e-4 m too small."""
    exact = max(0.0, math.hypot(x - 25, y) - 2)
    found = clearance_at(Point(), (x, y, 0.0), Obstacle(Ellipse((2.0, 2.0)), Steady(position=(25.0, 0.0))))
    assert exact - 1e-4 <= found <= exact + 1e-9


@given(poses, obstacles(st.builds(Ellipse, st.tuples(st.floats(0.5, 8.0), st.floats(0.5, 8.0)))))
def test_a_point_and_an_ellipse_agree_with_a_dense_search(pose: tuple[float, float, float], obstacle: Obstacle) -> None:
    """The polygon that stands for an ellipse costs less than 1e-4 m, and never flatters."""
    outline = placed(obstacle.shape.outline(20_000), at_start(obstacle)[:2], at_start(obstacle)[2])
    brute = float(np.hypot(*(outline - pose[:2]).T).min())
    found = clearance_at(Point(), pose, obstacle)
    if found > 0:
        assert brute - 1e-4 <= found <= brute + 1e-9


@given(rectangles, poses, obstacles(st.builds(Ellipse, st.tuples(st.floats(0.5, 5.0), st.floats(0.5, 5.0)))))
def test_a_box_and_an_ellipse_agree_with_a_dense_search(
    box: Rectangle, pose: tuple[float, float, float], obstacle: Obstacle
) -> None:
    """A turned box and a turned ellipse are apart by the least distance between their boundaries."""
    ellipse = placed(obstacle.shape.outline(720), at_start(obstacle)[:2], at_start(obstacle)[2])
    edge = placed(boundary(box.outline(), 200), pose[:2], pose[2])
    brute = float(np.hypot(*(ellipse[:, np.newaxis] - edge).transpose(2, 0, 1)).min())
    found = clearance_at(box, pose, obstacle)
    if found > 0.1:  # a dense search misses the foot of the perpendicular by less than a spacing
        assert brute - 0.02 <= found <= brute + 1e-9


@pytest.mark.parametrize("semi_axes", [(0.1, 0.1), (2.0, 2.0), (8.0, 0.5), (30.0, 20.0)])
def test_the_tolerance_holds_for_small_and_large_ellipses(semi_axes: tuple[float, float]) -> None:
    """The number of vertices follows the size: straight along any normal the error stays within the tolerance."""
    angle = np.linspace(0.0, 2 * np.pi, 5000)
    on_ellipse = np.column_stack((np.cos(angle), np.sin(angle))) * semi_axes
    normal = np.column_stack((np.cos(angle), np.sin(angle))) / semi_axes
    normal /= np.hypot(normal[:, 0], normal[:, 1])[:, np.newaxis]
    away = np.column_stack((on_ellipse + 3.0 * normal, angle))
    found = clearance(Point(), away, Obstacle(Ellipse(semi_axes), Steady((0.0, 0.0))), np.zeros(len(angle)))
    assert found.max() <= 3.0 + 1e-9
    assert found.min() >= 3.0 - ELLIPSE_TOLERANCE - 1e-9


@given(shapes, poses, obstacles(shapes))
def test_clearance_is_symmetric(footprint: Shape, pose: tuple[float, float, float], obstacle: Obstacle) -> None:
    """Exchanging footprint and obstacle changes nothing."""
    exchanged = Obstacle(footprint, Steady(position=pose[:2], heading=pose[2]))
    there = clearance_at(footprint, pose, obstacle)
    back = clearance_at(obstacle.shape, at_start(obstacle), exchanged)
    assert there == pytest.approx(back, abs=1e-9)


@given(st.one_of(st.just(Point()), rectangles), poses, obstacles(shapes), st.floats(0.0, 5.0))
def test_clearance_is_the_same_in_a_mirror(
    footprint: Point | Rectangle, pose: tuple[float, float, float], obstacle: Obstacle, time: float
) -> None:
    """Left and right exchanged, everything is as far away as before."""
    x, y, heading = at_start(obstacle)
    vx, vy = obstacle.velocity_at(0.0)
    mirrored = Obstacle(_mirror(obstacle.shape), Steady((x, -y), (vx, -vy), -heading))
    there = clearance_at(footprint, pose, obstacle, time)
    here = clearance_at(_mirror(footprint), (pose[0], -pose[1], -pose[2]), mirrored, time)
    assert there == pytest.approx(here, abs=1e-4)


def _mirror(shape: Shape) -> Shape:
    if isinstance(shape, Rectangle):
        return Rectangle(shape.length, shape.width, (shape.centre[0], -shape.centre[1]))
    return shape


@given(shapes, poses, shapes, angles)
def test_shapes_with_a_common_point_have_no_clearance(
    footprint: Shape, pose: tuple[float, float, float], shape: Shape, heading: float
) -> None:
    """Wherever the origins of a footprint and an obstacle that hold them coincide, the clearance is 0."""
    footprint, shape = _centred(footprint), _centred(shape)
    assert clearance_at(footprint, pose, Obstacle(shape, Steady(pose[:2], heading=heading))) == 0.0


def _centred(shape: Shape) -> Shape:
    return Rectangle(shape.length, shape.width) if isinstance(shape, Rectangle) else shape


def test_a_box_across_a_box_has_no_clearance() -> None:
    """Boxes that cross without a corner of one in the other overlap all the same."""
    across = Obstacle(Rectangle(10.0, 1.0), Steady((0.0, 3.0)))
    assert clearance_at(Rectangle(10.0, 1.0), (0.0, 0.0, math.pi / 2), across) == 0


def test_a_moving_obstacle_is_met_where_it_is_at_the_time() -> None:
    """Each pose is held against the obstacle's position at its own time."""
    lead = Obstacle(Rectangle(4.0, 2.0), Steady(position=(25.0, 0.0), velocity=(10.0, 0.0)))
    times = np.linspace(0.0, 1.0, 11)
    poses_at = np.column_stack((20 * times, np.zeros((11, 2))))
    np.testing.assert_allclose(clearance(CAR, poses_at, lead, times), 25 - 2 - 2.4 - 10 * times)


def test_no_poses_have_no_clearances() -> None:
    """An empty log gives an empty answer."""
    assert clearance(CAR, np.empty((0, 3)), Obstacle(CAR, Steady((0.0, 0.0))), np.empty(0)).shape == (0,)


@pytest.mark.parametrize("footprint", [Point(), CAR])
def test_a_pose_that_is_not_finite_has_no_clearance(footprint: Point | Rectangle) -> None:
    """A pose of nan has a clearance of nan, and the other poses theirs."""
    ahead = Obstacle(Rectangle(4.0, 2.0), Steady(position=(10.0, 0.0)))
    found = clearance(footprint, [(0.0, 0.0, 0.0), (math.nan, 0.0, 0.0), (0.0, 0.0, math.nan)], ahead, np.zeros(3))
    assert np.isfinite(found).tolist() == [True, False, False]


@given(st.sampled_from([Point(), CAR, Ellipse((2.0, 1.0))]), st.floats(-1.0, 1.0), st.floats(2.0, 6.0))
def test_a_turning_obstacle_is_met_as_it_is_turned_at_the_time(shape: Shape, across: float, until: float) -> None:
    """Along a curve each pose has the clearance of an obstacle that stands there, turned so."""
    turning = Obstacle(shape, AlongWaypoints((0.0, 1.0, until), ((0.0, 0.0), (8.0, across), (20.0, 6.0))))
    times = np.linspace(-0.5, until + 0.5, 23)
    poses_at = np.column_stack((12 * times, 2 - times, 0.3 * times))
    expected = [
        clearance_at(CAR, tuple(pose), Obstacle(shape, Steady(tuple(position), heading=float(heading))))
        for pose, position, heading in zip(poses_at, turning.position_at(times), turning.heading_at(times), strict=True)
    ]
    np.testing.assert_allclose(clearance(CAR, poses_at, turning, times), expected, atol=1e-9)


def test_a_turning_box_agrees_with_a_dense_search() -> None:
    """A point is as far from a box on a curve as from the nearest point of its boundary, walked round."""
    turning = Obstacle(CAR, AlongWaypoints((0.0, 1.0, 2.0), ((0.0, 0.0), (8.0, 1.0), (12.0, 8.0))))
    times, walk = np.linspace(0.0, 2.0, 9), boundary(CAR.outline(), 2000)
    points = np.column_stack((np.full(9, 6.0), np.full(9, 9.5), np.zeros(9)))
    brute = [
        np.hypot(*(placed(walk, position, heading) - (6.0, 9.5)).T).min()
        for position, heading in zip(turning.position_at(times), turning.heading_at(times), strict=True)
    ]
    assert np.ptp(turning.heading_at(times)) > 0.5
    np.testing.assert_allclose(clearance(Point(), points, turning, times), brute, atol=2e-3)
