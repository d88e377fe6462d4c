"""What a scene takes, and how it is shifted."""

import numpy as np
import pytest

from swerve.errors import InputError
from swerve.study.limit.guesses import starts
from swerve.study.limit.means import Means
from tests.study.limit.scenes import scene


def test_a_shift_moves_every_obstacle_alike() -> None:
    """Twice shifted is once shifted by the sum; velocity and heading stay."""
    here = scene('obstacles.0.velocity=["5 m/s", "0 m/s"]')
    twice, once = here.at(40.0).at(18.0).obstacles[0], here.at(18.0).obstacles[0]
    times = np.linspace(0.0, 3.0, 7)
    assert np.allclose(twice.position_at(times), once.position_at(times))
    assert np.allclose(once.position_at(times)[:, 0], 18.0 + 5.0 * times)
    assert np.array_equal(once.velocity_at(times), here.obstacles[0].velocity_at(times))
    assert np.array_equal(once.heading_at(times), here.obstacles[0].heading_at(times))


@pytest.mark.parametrize(
    ("override", "told"),
    [
        ('obstacles.0.position=["-5 m", "0 m"]', "none is ahead"),
        ('obstacles.0.velocity=["0 m/s", "2 m/s"]', "moves across the road at 2 m/s"),
    ],
)
def test_what_has_no_limit_is_refused(override: str, told: str) -> None:
    """With one line that says why."""
    with pytest.raises(InputError, match=told):
        scene(override)


def test_nobody_stays_behind_what_comes_towards_them() -> None:
    """Braking has no start against an oncoming obstacle."""
    assert starts(scene('obstacles.0.velocity=["-5 m/s", "0 m/s"]'), Means.BRAKING) == []


def test_no_start_leaves_the_road() -> None:
    """With one lane and none beside it, there is no way past."""
    narrow = scene('road.lane_width="3.5 m"', "road.lanes_left=0", "road.lanes_right=0")
    assert starts(narrow, Means.BOTH) == []


@pytest.mark.parametrize(
    "override",
    [
        "obstacles.0.position=[25, 0.01]",
        "obstacles.0.heading=0.3",
        "ego.position=[0, 0.1]",
        "ego.heading=0.01",
        "road.lanes_right=1",
    ],
)
def test_of_two_mirror_images_one_is_tried(override: str) -> None:
    """The left one of a scene that is its own mirror image, both of any other."""
    road = "road.lane_width=5", "road.lanes_left=2", "road.lanes_right=2"
    for symmetric in (scene(), scene(*road)):
        assert {start.sides for start in starts(symmetric, Means.BOTH)} == {(1,)}
    assert {start.sides for start in starts(scene(*road, override), Means.BOTH)} == {(1,), (-1,)}
