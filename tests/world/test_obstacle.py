"""Obstacles: motion with constant velocity."""

import math

import numpy as np
import pytest

from swerve.world import Ellipse, Obstacle

DISC = Ellipse((2.0, 2.0))


def test_position_is_linear_in_time() -> None:
    """An obstacle is where its start and its velocity put it, for one time or any array of times."""
    obstacle = Obstacle(DISC, position=(25.0, 1.0), velocity=(10.0, -2.0))
    np.testing.assert_allclose(obstacle.position_at(0.5), [30.0, 0.0])
    np.testing.assert_allclose(obstacle.position_at([0.0, 1.0]), [[25.0, 1.0], [35.0, -1.0]])
    assert obstacle.position_at(np.zeros((3, 4))).shape == (3, 4, 2)


@pytest.mark.parametrize("field", ["position", "velocity", "heading"])
def test_an_obstacle_that_is_nowhere_is_refused(field: str) -> None:
    """A position, velocity or heading that is not finite names itself in the error."""
    values: dict[str, object] = {"position": (0.0, 0.0), field: math.inf if field == "heading" else (0.0, math.nan)}
    with pytest.raises(ValueError, match=field):
        Obstacle(DISC, **values)  # type: ignore[arg-type]
