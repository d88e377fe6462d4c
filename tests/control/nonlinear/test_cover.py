"""Discs and ellipses hold the shapes that they stand for: points of the shapes are the truth."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from swerve.control.nonlinear.cover import N_DISCS, n_parts, pairs
from swerve.world import Ellipse, Obstacle, Point, Rectangle, Steady

sizes = st.floats(0.3, 8.0)
angles = st.floats(-np.pi, np.pi)
CAR = Rectangle(4.85, 1.8, centre=(-0.4, 0.0))


def inside(point: np.ndarray, centre: tuple[float, float], semi_axes: tuple[float, float], heading: float) -> bool:
    """Whether a point is in an ellipse."""
    x, y = point - centre
    cos, sin = np.cos(heading), np.sin(heading)
    return bool(np.hypot((cos * x + sin * y) / semi_axes[0], (cos * y - sin * x) / semi_axes[1]) <= 1 + 1e-5)


@given(sizes, sizes, angles, st.floats(-0.5, 0.5), st.floats(-0.5, 0.5))
def test_discs_hold_a_rectangle(length: float, width: float, heading: float, x: float, y: float) -> None:
    """Every point of a rectangular obstacle is in one of its discs, whatever its sides and heading."""
    obstacle = Obstacle(Rectangle(length, width), Steady((3.0, -2.0), heading=heading))
    local = np.array([x * length, y * width])
    cos, sin = np.cos(heading), np.sin(heading)
    point = np.array([3.0 + cos * local[0] - sin * local[1], -2.0 + sin * local[0] + cos * local[1]])
    found = pairs(Point(), obstacle)
    assert len(found) == N_DISCS == n_parts(obstacle.shape)
    assert any(inside(point, each.centre, each.semi_axes, each.heading) for each in found)


@given(sizes, sizes, angles, angles, st.floats(0, 2 * np.pi))
def test_a_rectangular_ego_that_touches_an_ellipse_has_a_point_in_its_pair(
    a: float, b: float, heading: float, psi: float, at: float
) -> None:
    """Where a corner of the ego vehicle is on the ellipse's edge, one of the pairs sees a point in its ellipse."""
    obstacle = Obstacle(Ellipse((a, b)), Steady((0.0, 0.0), heading=heading))
    cos, sin = np.cos(heading), np.sin(heading)
    edge = np.array([[cos, -sin], [sin, cos]]) @ (a * np.cos(at), b * np.sin(at))
    turn = np.array([[np.cos(psi), -np.sin(psi)], [np.sin(psi), np.cos(psi)]])
    for corner in CAR.outline():
        position = edge - turn @ corner
        seen = [
            inside(position + turn @ each.offset, each.centre, each.semi_axes, heading) for each in pairs(CAR, obstacle)
        ]
        assert any(seen)


def test_a_point_and_an_ellipse_are_taken_as_they_are() -> None:
    """The paper's own case is exact: one pair, no blowing up."""
    (only,) = pairs(Point(), Obstacle(Ellipse((3.0, 2.0)), Steady((25.0, 1.0), (4.0, 0.5), 0.3)))
    assert only.as_tuple() == (0.0, 0.0, 25.0, 1.0, 4.0, 0.5, 3.0, 2.0, 0.3)
