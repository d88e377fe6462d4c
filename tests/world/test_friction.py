"""The friction of a road: base, patches, split and jump."""

from math import inf, nan

import numpy as np
import pytest

from swerve.world import MOST_PATCHES, Friction, Patch

ICE = Patch((10.0, 30.0), (-1.0, 1.0), 0.1)


def test_a_road_without_patches_is_alike_everywhere() -> None:
    """The base holds at every point."""
    np.testing.assert_array_equal(Friction(0.85).at([[0, 0], [1e6, -1e6]]), 0.85)


def test_a_patch_holds_inside_and_on_its_edges() -> None:
    """Outside it the base holds."""
    points = [[20, 0], [10, 1], [30, -1], [9.999, 0], [30.001, 0], [20, 1.001]]
    np.testing.assert_array_equal(Friction(0.85, (ICE,)).at(points), [0.1, 0.1, 0.1, 0.85, 0.85, 0.85])


def test_the_last_patch_counts() -> None:
    """Where two overlap the later one holds."""
    dry = Patch((15.0, 20.0), (-inf, inf), 0.9)
    np.testing.assert_array_equal(Friction(0.5, (ICE, dry)).at([[12, 0], [17, 0], [17, 9]]), [0.1, 0.9, 0.9])


def test_split_and_jump() -> None:
    """Split parts left from right, jump parts before from after."""
    np.testing.assert_array_equal(Friction.split(right=0.8, left=0.3, y=0.5).at([[5, 1], [5, 0]]), [0.3, 0.8])
    np.testing.assert_array_equal(Friction.jump(before=0.8, after=0.3, x=20.0).at([[19, 0], [21, 5]]), [0.8, 0.3])


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Friction(0.0), "friction must be positive and finite, got 0"),
        (lambda: Friction(nan), "friction must be positive and finite, got nan"),
        (lambda: Patch((1.0, 1.0), (0.0, 1.0), 0.5), "x must go from a smaller to a larger number, got 1 to 1"),
        (lambda: Patch((0.0, 1.0), (nan, 1.0), 0.5), "y must go from a smaller to a larger number, got nan to 1"),
        (lambda: Friction(0.5, (MOST_PATCHES + 1) * (ICE,)), "a road has at most 8 patches, got 9"),
    ],
)
def test_nonsense_is_refused(make: object, message: str) -> None:
    """The message has the number at fault."""
    with pytest.raises(ValueError, match=message):
        make()  # type: ignore[operator]
