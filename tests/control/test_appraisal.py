"""What is told of a predicted motion is what geometry finds: distances of outlines, corners beyond edges, speeds."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from swerve.control.appraisal import Appraisal
from swerve.control.plan import Passing
from swerve.world import Ellipse, Obstacle, Rectangle, Road, Steady, clearance
from tests.control.unified.situations import CAR, HORIZON, RUNNING, forecast, random_roll_out

MARGIN, START = 0.2, 3.0
TIMES = 0.05 * np.arange(21.0)
ROAD = Road(lane_width=3.5, lanes_left=1)
places = st.floats(-8, 8)


def straight(y: float, heading: float = 0.0) -> np.ndarray:
    """States (21, 6) at 20 m/s along a heading, from (0, y) on."""
    states = np.tile(RUNNING, (21, 1))
    states[:, 3] = heading
    states[:, 4], states[:, 5] = 20 * TIMES * np.cos(heading), y + 20 * TIMES * np.sin(heading)
    return states


@settings(max_examples=50, deadline=None)
@given(st.floats(5, 20), places, st.floats(-6, 6), st.floats(-6, 6), st.floats(-0.3, 0.3), st.booleans())
def test_what_it_misses_is_measured(x: float, y: float, vx: float, vy: float, heading: float, is_box: bool) -> None:
    """The margin less the smallest distance of the outlines, and contact exactly where they touch."""
    shape = Rectangle(4.0, 1.8) if is_box else Ellipse((2.0, 1.0))
    states = straight(0.0, heading)
    seen = forecast(shape, (x, y), (vx, vy))
    moved = Steady(tuple(np.subtract((x, y), START * np.array((vx, vy))).tolist()), (vx, vy))
    asked = Appraisal(CAR, Road(), MARGIN, HORIZON)
    branch = asked.branch("left", 1.0, states, 0.0, [seen])
    later = asked.branch("left", 1.0, states, START, [forecast(shape, moved.position, (vx, vy))])
    apart = clearance(CAR, states[:, [4, 5, 3]], Obstacle(shape, Steady((x, y), (vx, vy))), TIMES)
    assume(apart.min() > 1e-3 or apart.max(initial=0, where=apart < 1e-3) == 0)
    assert later.violation == pytest.approx(branch.violation, abs=1e-6)
    if apart.min() > 0 and is_box:
        assert branch.violation >= max(0.0, MARGIN - apart.min()) - 1e-6  # what is between two poses counts too
    if (apart == 0).any():
        assert branch.violation >= MARGIN - 1e-3
        assert branch.impact_speed is None or branch.impact_speed == pytest.approx(
            np.hypot(20 * np.cos(heading) - vx, 20 * np.sin(heading) - vy)
        )
    if branch.violation == 0:
        assert apart.min() >= MARGIN - 1e-3
        assert branch.impact_speed is None


def test_beside_a_car_the_gap_is_exact() -> None:
    """A car 3 m to the side leaves 1.2 m between boxes of 1.8 m: with a margin of 1.5 m, 0.3 m are missed."""
    appraisal = Appraisal(CAR, Road(), 1.5, HORIZON)
    for y, passing in ((3.0, Passing.RIGHT), (-3.0, Passing.LEFT)):
        branch = appraisal.branch("keep", 0.0, straight(0.0), 0.0, [forecast(Rectangle(4.5, 1.8), (10.0, y))])
        assert branch.violation == pytest.approx(0.3, abs=1e-9)
        assert branch.passing == (passing,)


def test_behind_a_car_it_stays_behind() -> None:
    """Beyond a plan of 20 m there is nothing to pass; driven into, the speed of the impact is the closing one."""
    appraisal = Appraisal(CAR, Road(), MARGIN, HORIZON)
    far = appraisal.branch("brake", 0.0, straight(0.0), 0.0, [forecast(Rectangle(4.5, 1.8), (30.0, 0.0))])
    assert (far.passing, far.violation, far.impact_speed) == ((Passing.BEHIND,), 0.0, None)
    hit = appraisal.branch("brake", 0.0, straight(0.0), 0.0, [forecast(Rectangle(4.5, 1.8), (12.0, 0.0), (5.0, 0.0))])
    assert hit.impact_speed == pytest.approx(15.0)


@given(places, st.floats(-0.4, 0.4))
def test_off_the_road_is_the_farthest_corner(y: float, heading: float) -> None:
    """Beyond either edge."""
    states = straight(y, heading)
    corners = states[:, 5, np.newaxis] + CAR.outline() @ [np.sin(heading), np.cos(heading)]
    branch = Appraisal(CAR, ROAD, MARGIN, HORIZON).branch("keep", 0.0, states, 0.0, [])
    assert branch.off_road == pytest.approx(max(0.0, corners.max() - 5.25, -1.75 - corners.min()), abs=1e-9)


@given(st.integers(0, 2**32 - 1))
def test_half_way_the_poses_are_the_model_s(seed: int) -> None:
    """Those that the prediction finds by integrating to the half of each sample, within 3 mm and 3 mrad."""
    trajectory, _, _ = random_roll_out(seed)
    poses = Appraisal(CAR, ROAD, MARGIN, HORIZON).branch("left", 0.0, trajectory.states, 0.0, []).poses
    np.testing.assert_array_equal(poses[::2], trajectory.poses[::2])
    np.testing.assert_allclose(poses[1::2], trajectory.poses[1::2], atol=3e-3)


def test_a_motion_that_diverged_is_as_bad_as_can_be() -> None:
    """Nothing of it is a number that could be taken for a good one."""
    branch = Appraisal(CAR, ROAD, MARGIN, HORIZON).branch(
        "left", np.inf, straight(0.0) * np.nan, 0.0, [forecast(Rectangle(4.5, 1.8), (10.0, 0.0))]
    )
    assert (branch.violation, branch.off_road, branch.impact_speed) == (np.inf, np.inf, None)
