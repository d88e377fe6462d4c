"""The dense search: its family of manoeuvres, and what its certificates are worth."""

import numpy as np
import pytest

from swerve.conventions import GRAVITY, VX, VY, Y
from swerve.scenario import load
from swerve.study.map.boundary import Condition
from swerve.study.map.cell import Cell
from swerve.study.random_scenes import certificate, scene
from swerve.study.random_scenes.family import BATCH, Manoeuvre, RollOut, family
from swerve.vehicle import vehicle_named
from tests.study.limits import LIMITS

SEDAN = vehicle_named("d-class-sedan")
NEVER = 1e3


def motion(manoeuvre: Manoeuvre, speed: float = 20.0, friction: float = 0.85) -> np.ndarray:
    """States (n, 6) of one manoeuvre, over 6 s."""
    return RollOut(6.0)(np.array([manoeuvre]), np.array([speed, 0, 0, 0, 0, 0]), SEDAN, friction)[0]


def test_the_family_is_large_and_has_no_member_twice() -> None:
    """Thousands of members, all different, all within the vehicle's share of the friction."""
    members = family()
    assert len(np.unique(members, axis=0)) == len(members) > 2000
    assert np.isfinite(members).all()
    assert members[:, 5:].max() <= SEDAN.force_limit


@pytest.mark.parametrize("share", [0.3, 0.6, 0.95])
def test_braking_stops_where_physics_says(share: float) -> None:
    """Straight braking with a share b of the friction stops after v^2 / (2 b mu g), to within the last metre per
    second, and stays.
    """
    states = motion(Manoeuvre(0.0, 0.0, NEVER, 0.0, 0.6, share, share), speed=12.0)
    assert states[-1, 4] == pytest.approx(12.0**2 / (2 * share * 0.85 * GRAVITY), rel=0.01)
    assert abs(states[-1, VX]) < 0.01
    assert np.abs(states[:, Y]).max() == 0


@pytest.mark.parametrize("speed, friction", [(10.0, 1.0), (20.0, 0.3), (35.0, 0.5), (35.0, 1.0)])
@pytest.mark.parametrize("offset", [-3.5, 1.0, 5.0])
def test_a_change_of_offset_arrives_in_hand(speed: float, friction: float, offset: float) -> None:
    """With half of the friction every offset is reached and held, and the acceleration stays near that half."""
    states = motion(Manoeuvre(0.0, offset, NEVER, offset, 0.5, 0.0, 0.0), speed, friction)
    assert states[-1, Y] == pytest.approx(offset, abs=0.15)
    assert np.abs(np.arctan2(states[:, VY], states[:, VX])).max() < 0.2
    lateral = np.diff(states[:, VX] * np.sin(states[:, 3]) + states[:, VY] * np.cos(states[:, 3])) / 0.01
    assert np.abs(lateral).max() < 0.8 * friction * GRAVITY


def test_members_do_not_know_of_one_another() -> None:
    """A member's motion is the same in a full batch, in another place of it, and alone."""
    members, start = family()[:BATCH], np.array([25.0, 0, 0, 0.02, 0, 0.3])
    roll_out = RollOut(6.0)
    together = roll_out(members, start, SEDAN, 0.6)
    assert np.array_equal(roll_out(members[7:8], start, SEDAN, 0.6)[0], together[7])
    assert np.array_equal(roll_out(members[::-1], start, SEDAN, 0.6)[::-1], together)


@pytest.mark.parametrize("speed, friction, limit", LIMITS)
def test_the_search_comes_near_the_physical_limit_and_never_below_it(
    speed: float, friction: float, limit: float
) -> None:
    """With all of the friction a disc of 2 m is avoided from 1.15 times the limit of optimal control on, and never
    from 0.95 times it.
    """
    cell = Cell.of(load("paper"), Condition(speed, friction, 0.0))
    assert certificate(cell.at(1.15 * limit), spare=1.0)
    assert not certificate(cell.at(0.95 * limit), spare=1.0)


def test_a_wall_across_the_road_needs_the_distance_to_brake() -> None:
    """From 20 m/s on mu = 0.85 / 1.15 a share of 0.95 stops in 29.05 m: a wall 28.5 m ahead has no certificate, one
    30 m ahead has braking.
    """
    near, far = (load("paper", [f"obstacles=[{{position=[{x}, 0], size=[1, 60]}}]", "duration=6"]) for x in (29, 30.5))
    assert certificate(near) is None
    found = certificate(far)
    assert found is not None
    assert found.manoeuvre.b1 == 0.95


def test_the_road_counts() -> None:
    """What is avoided beside the road is not avoided."""
    ahead = ["obstacles.0.position=[25, 0]", "duration=6"]
    assert certificate(load("paper", ahead))
    assert certificate(load("paper", [*ahead, "road.lane_width=3", "road.lanes_left=0"])) is None


def test_more_friction_to_spare_is_harder() -> None:
    """What has a certificate with much to spare has one with little."""
    for index in range(8):
        drawn = scene(5, index)
        assert certificate(drawn, 1.0) or not certificate(drawn, 1.3)
