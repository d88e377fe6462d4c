"""The paper's scene, and the same with the obstacle nearer: what the product promises."""

from functools import cache

import numpy as np
import pytest

from swerve.scenario import load
from swerve.simulate import Outcome, Run, run

DISTANCES = [25.0, 20.0, 18.0, 17.0, 16.0, 15.5]  # [m]


@cache
def around(distance: float, lateral: float = 0.0) -> Run:
    """The paper's scene with the obstacle's centre there [m]."""
    return run(load("paper", [f"obstacles.0.position=[{distance}, {lateral}]"]), plant="planar")


@pytest.mark.parametrize("distance", DISTANCES)
def test_it_goes_round_and_comes_back(distance: float) -> None:
    """Never inside the ellipse on any millisecond, no needless swing, little speed lost, back in its lane and calm."""
    done = around(distance)
    result, end = done.result, done.log.motion.stack("Y", "vy", "r")[-1]
    assert result.outcome is Outcome.AVOIDED
    assert done.log.motion["time"][-1] == pytest.approx(5.0)
    assert 1.0 <= result.min_distance_ratio <= 1.25
    assert max(result.lateral_offset.max, -result.lateral_offset.min) <= 3.2
    assert result.speed.min >= 17.5
    assert result.speed.max <= 20.5
    assert np.abs(end).max() <= 0.02
    assert np.degrees(result.max_sideslip) <= (6.0 if distance == 25 else 8.0)
    assert (result.fallback_steps, result.solver_failures) == (0, 0)


@pytest.mark.parametrize("distance", DISTANCES)
def test_straight_ahead_it_goes_left(distance: float) -> None:
    """Where both sides cost the same, the side is left, as in the paper."""
    done = around(distance)
    assert "steer-left" in done.result.decision
    assert done.result.lateral_offset.max > 2.0
    assert done.result.lateral_offset.min > -1.0


@pytest.mark.parametrize(("lateral", "side"), [(0.3, "steer-right"), (-0.3, "steer-left")])
def test_off_centre_it_goes_the_short_way(lateral: float, side: str) -> None:
    """An obstacle that stands 0.3 m to one side is passed on the other."""
    result = around(25.0, lateral).result
    assert side in result.decision
    assert result.outcome is Outcome.AVOIDED
    assert result.min_distance_ratio >= 1.0


def test_the_whole_loop_is_the_same_in_a_mirror() -> None:
    """With the obstacle to the other side by as much, the motion is the mirror image."""
    left, right = (around(25.0, lateral).log.motion for lateral in (0.3, -0.3))
    signs = [1, -1, -1, -1, 1, -1, -1]
    names = ("vx", "vy", "r", "psi", "X", "Y", "delta")
    np.testing.assert_allclose(left.stack(*names), right.stack(*names) * signs, atol=1e-6)
    np.testing.assert_allclose(left["Fy_fl"], -right["Fy_fr"], atol=1e-2)
