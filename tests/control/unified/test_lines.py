"""Separating lines against polygons: sound for every way of passing, and complete for the shapes with corners."""

from functools import cache

import numpy as np
import pytest
import shapely
from hypothesis import assume, example, given
from hypothesis import strategies as st
from numpy.typing import NDArray

from swerve.control.plan import Passing
from swerve.control.unified.lines import ANY, OBLIQUE, Lines
from swerve.world import Ellipse, Footprint, Point, Rectangle, Shape
from tests.control.unified.situations import CAR

Array = NDArray[np.float64]

FAR = 1e3  # [m] how far a shadow is cast
SMALL = Rectangle(2.0, 0.8)
FOOTPRINTS = (Point(), CAR, SMALL)
lengths = st.floats(0.1, 5.0)
ellipses = st.builds(Ellipse, st.tuples(lengths, lengths))
rectangles = st.builds(Rectangle, lengths, lengths)
footprints = st.sampled_from(FOOTPRINTS)
headings = st.sampled_from([0.0, np.pi / 2, -np.pi, 0.3]) | st.floats(-np.pi, np.pi)
places = st.floats(-7.0, 7.0)
poses = st.tuples(places, places, headings).map(np.array)
passings = st.sampled_from([*(each.value for each in Passing), ANY])


@cache
def lines(footprint: Footprint) -> Lines:
    """For two pairs of poses."""
    return Lines(footprint, 2)


def between(
    footprint: Footprint, shape: Shape, heading: float, first: Array, second: Array, passing: int
) -> tuple[Array, Array, Array]:
    """Normal (2,), gaps (2,) and their derivatives by psi (2,) for one pair."""
    found = lines(footprint).between(shape, heading, np.array([first, second, second]), passing)
    return found[0][0], found[1][0], found[2][0]


def turned(points: Array, angle: float) -> Array:
    """Points (n, 2) turned anticlockwise."""
    cos, sin = np.cos(angle), np.sin(angle)
    return points @ np.array([[cos, sin], [-sin, cos]])


def hull(*points: Array) -> shapely.Geometry:
    """The convex hull of all points (n, 2)."""
    return shapely.MultiPoint(np.concatenate(points)).convex_hull


def corners(footprint: Footprint, pose: Array) -> Array:
    """The footprint's outline in world axes."""
    return turned(footprint.outline(), pose[2]) + pose[:2]


def inside(shape: Shape, heading: float) -> Array:
    """An outline in world axes of which no part is outside of the shape."""
    return turned(shape.outline(720), heading)


@given(footprints, ellipses | rectangles, headings, poses, poses, passings)
def test_behind_a_line_is_clear_all_the_way(
    footprint: Footprint, shape: Shape, heading: float, first: Array, second: Array, passing: int
) -> None:
    """Both poses, and all that is straight between them, are as far from the obstacle as the smaller gap says."""
    normal, gaps, _ = between(footprint, shape, heading, first, second, passing)
    obstacle = shapely.Polygon(inside(shape, heading))
    swept = hull(corners(footprint, first), corners(footprint, second))
    assert np.hypot(*normal) == pytest.approx(1.0, abs=1e-12)
    assert swept.distance(obstacle) >= gaps.min() - 1e-9
    for pose, gap in zip((first, second), gaps, strict=True):
        assert shapely.MultiPoint(corners(footprint, pose)).convex_hull.distance(obstacle) >= gap - 1e-9


@given(footprints, ellipses | rectangles, headings, poses, poses, passings)
def test_a_gap_is_what_its_formula_says(
    footprint: Footprint, shape: Shape, heading: float, first: Array, second: Array, passing: int
) -> None:
    """n . (p - c) - h(n) - h_ego(-n), with both reaches by brute force over the outlines."""
    normal, gaps, _ = between(footprint, shape, heading, first, second, passing)
    obstacle = inside(shape, heading) @ normal
    for pose, gap in zip((first, second), gaps, strict=True):
        nearest = float((corners(footprint, pose) @ normal).min())
        assert gap == pytest.approx(nearest - obstacle.max(), abs=1e-4)


@given(footprints, ellipses | rectangles, headings, poses, poses, st.sampled_from([Passing.LEFT, Passing.RIGHT]))
def test_left_never_pushes_to_the_right(
    footprint: Footprint, shape: Shape, heading: float, first: Array, second: Array, passing: Passing
) -> None:
    """A normal for passing on a side has no part to the other side, and the other way round."""
    normal, *_ = between(footprint, shape, heading, first, second, passing.value)
    assert normal[1] * passing.value >= -1e-12


@given(footprints, ellipses | rectangles, headings, poses, poses)
def test_staying_behind_is_not_swerving(
    footprint: Footprint, shape: Shape, heading: float, first: Array, second: Array
) -> None:
    """A line for staying behind faces backwards, or is straight along the road for who is beside the obstacle."""
    normal, *_ = between(footprint, shape, heading, first, second, Passing.BEHIND.value)
    assert normal[0] <= -OBLIQUE or abs(normal[0]) < 1e-12


@given(footprints, rectangles, headings, poses)
@example(CAR, Rectangle(4.0, 2.0), 0.7, np.array([4.0, 2.5, -0.5]))
@example(Point(), Rectangle(1.0, 1.0), np.pi / 4, np.array([0.5, 0.5, 0.0]))
def test_where_there_is_a_line_it_is_found(footprint: Footprint, shape: Shape, heading: float, pose: Array) -> None:
    """Boxes that are apart have a gap and boxes that overlap have none: the separating axis theorem."""
    _, gaps, _ = between(footprint, shape, heading, pose, pose, ANY)
    body = hull(corners(footprint, pose))
    obstacle = shapely.Polygon(inside(shape, heading))
    apart = body.distance(obstacle)
    assume(apart > 1e-9 or body.intersection(obstacle).length > 1e-6 or obstacle.buffer(-1e-6).contains(body))
    assert (gaps[1] > 0) == (apart > 0)


@given(footprints, rectangles, headings, poses, st.sampled_from([Passing.LEFT, Passing.RIGHT]))
def test_on_its_side_a_line_is_found_where_there_is_one(
    footprint: Footprint, shape: Shape, heading: float, pose: Array, passing: Passing
) -> None:
    """Who is out of the box and of its shadow to the other side is clear on this side, and no one else."""
    _, gaps, _ = between(footprint, shape, heading, pose, pose, passing.value)
    box = inside(shape, heading)
    shadowed = hull(box, box - np.array([0.0, passing.value * FAR]))
    body = hull(corners(footprint, pose))
    apart = body.distance(shadowed)
    assume(apart > 1e-6 or body.distance(shadowed.boundary) > 1e-6 or body.intersection(shadowed).area > 1e-6)
    assert (gaps[1] > 0) == (apart > 0)


@given(footprints, ellipses | rectangles, headings, poses, poses, passings)
def test_the_derivative_is_the_slope(
    footprint: Footprint, shape: Shape, heading: float, first: Array, second: Array, passing: int
) -> None:
    """With its line held still a gap changes with psi as the derivative says; at a kink it is one of the slopes."""
    normal, _, turning = between(footprint, shape, heading, first, second, passing)
    for pose, found in zip((first, second), turning, strict=True):
        reach = [float((corners(footprint, pose + np.array([0.0, 0.0, d])) @ normal).min()) for d in (-1e-6, 0.0, 1e-6)]
        slopes = np.diff(reach) / 1e-6
        assert slopes.min() - 1e-5 <= found <= slopes.max() + 1e-5


@given(footprints, ellipses | rectangles, headings, poses, poses, st.sampled_from(list(Passing)))
def test_the_mirror_image_has_the_mirrored_line(
    footprint: Footprint, shape: Shape, heading: float, first: Array, second: Array, passing: Passing
) -> None:
    """Left for right the gaps are the same."""
    _, here, _ = between(footprint, shape, heading, first, second, passing.value)
    flip = np.array([1.0, -1.0, -1.0])
    _, there, _ = between(footprint, shape, -heading, first * flip, second * flip, -passing.value)
    assert there.min() == pytest.approx(here.min(), abs=1e-9)


@given(ellipses, headings, places, places)
def test_a_point_outside_of_an_ellipse_has_a_line(shape: Ellipse, heading: float, x: float, y: float) -> None:
    """The tangent of the ellipse through the point, made larger about its centre, separates it: the gap is at least
    (sqrt(rho) - 1) times the smaller semi-axis, and there is none inside.
    """
    pose = np.array([x, y, 0.0])
    rho = float(np.hypot(*(turned(pose[np.newaxis, :2], -heading)[0] / shape.semi_axes)))
    assume(abs(rho - 1) > 1e-6)
    _, gaps, _ = between(Point(), shape, heading, pose, pose, ANY)
    assert (gaps[1] > 0) == (rho > 1)
    if rho > 1:
        assert gaps[1] >= (rho - 1) * min(shape.semi_axes) - 1e-6


@given(lengths, places, places)
def test_from_a_disc_nothing_is_given_away(radius: float, x: float, y: float) -> None:
    """The gap of a point beside a disc is its distance."""
    assume(np.hypot(x, y) > 0.1)
    pose = np.array([x, y, 0.0])
    _, gaps, _ = between(Point(), Ellipse((radius, radius)), 0.0, pose, pose, ANY)
    assert gaps[1] == pytest.approx(np.hypot(x, y) - radius, abs=1e-6)


def test_nothing_is_lost_in_the_middle_of_an_obstacle() -> None:
    """In the very centre the line is a finite one backwards, and so is every number."""
    for shape in (Ellipse((2.0, 1.0)), Rectangle(4.0, 2.0)):
        for footprint in FOOTPRINTS:
            for passing in (*(each.value for each in Passing), ANY):
                found = between(footprint, shape, 0.0, np.zeros(3), np.zeros(3), passing)
                assert all(np.isfinite(each).all() for each in found)
                assert (found[1] < 0).all()
