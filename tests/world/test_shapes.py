"""Shapes: support functions and outlines."""

import math

import numpy as np
import pytest
from hypothesis import given

from swerve.world import Ellipse, Point, Rectangle
from tests.world.strategies import angles, ellipses, rectangles


def unit(angle: float) -> np.ndarray:
    """The unit direction at an angle, shape (1, 2)."""
    return np.array([[math.cos(angle), math.sin(angle)]])


@given(ellipses, angles)
def test_support_of_an_ellipse_is_the_furthest_point_of_its_outline(shape: Ellipse, angle: float) -> None:
    """The closed form agrees with the largest projection over a dense outline, and is never below it."""
    furthest = (shape.outline(4000) @ unit(angle)[0]).max()
    reach = shape.support(unit(angle))[0]
    assert furthest - 1e-12 <= reach <= furthest + 1e-5


@given(rectangles, angles)
def test_support_of_a_rectangle_is_its_furthest_corner(shape: Rectangle, angle: float) -> None:
    """A box reaches as far as its furthest corner, wherever its centre is."""
    furthest = (shape.outline() @ unit(angle)[0]).max()
    assert shape.support(unit(angle))[0] == pytest.approx(furthest, abs=1e-12)


def test_support_takes_many_directions_at_once() -> None:
    """One call answers for n directions, each shape in its closed form along the axes."""
    directions = np.array([[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]])
    np.testing.assert_allclose(Ellipse((3.0, 1.0)).support(directions), [3, 1, 3, 1])
    np.testing.assert_allclose(Rectangle(4.0, 2.0, (0.5, -0.25)).support(directions), [2.5, 0.75, 1.5, 1.25])
    np.testing.assert_array_equal(Point().support(directions), np.zeros(4))


def test_outlines_have_the_vertices_that_the_shape_has() -> None:
    """A point has one vertex, a box its four corners, an ellipse as many as are asked for, all on it."""
    assert Point().outline().tolist() == [[0.0, 0.0]]
    assert sorted(Rectangle(4.0, 2.0).outline().tolist()) == [[-2, -1], [-2, 1], [2, -1], [2, 1]]
    points = Ellipse((3.0, 2.0)).outline(100)
    assert points.shape == (100, 2)
    np.testing.assert_allclose((points[:, 0] / 3) ** 2 + (points[:, 1] / 2) ** 2, 1.0)


@pytest.mark.parametrize("outline", [Rectangle(4.0, 2.0, (9.0, 9.0)).outline(), Ellipse((1.0, 5.0)).outline()])
def test_outlines_run_anticlockwise(outline: np.ndarray) -> None:
    """The signed area of an outline is positive."""
    x, y = outline.T
    assert np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) > 0


@pytest.mark.parametrize("bad", [0.0, -1.0, math.nan, math.inf])
def test_a_shape_without_a_size_is_refused(bad: float) -> None:
    """A length that is zero, negative or not finite names itself in the error."""
    with pytest.raises(ValueError, match="semi_axes"):
        Ellipse((2.0, bad))
    with pytest.raises(ValueError, match="length and width"):
        Rectangle(bad, 1.0)


def test_a_box_with_its_centre_nowhere_is_refused() -> None:
    """A centre that is not finite is an error."""
    with pytest.raises(ValueError, match="centre"):
        Rectangle(4.0, 2.0, (math.nan, 0.0))
