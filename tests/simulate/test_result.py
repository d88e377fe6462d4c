"""The numbers of a run, on paths where they are known."""

import json
import re
from dataclasses import fields

import numpy as np
import pytest

import swerve
from swerve.control import Fallback, Side
from swerve.simulate import Result
from swerve.simulate.result import Divergence
from tests.simulate.recordings import COAST, plan, recorded, straight

CONTRACT = """
scenario controller plant seed version outcome min_distance_ratio min_clearance impact_speed
impact_obstacle oncoming_lane_time decision
lateral_offset speed final_yaw_rate final_lateral_speed max_sideslip max_yaw_rate max_steer
step_time steps fallback_steps solver_failures wall_time
divergence lateral_excursion max_friction_use mean_friction_use driver_deviation
"""


def test_the_keys_of_the_json_are_those_that_scripts_know() -> None:
    """Keys, and the keys of the objects in them, are exactly the documented ones."""
    result = recorded(straight()).to_json()
    assert list(result) == CONTRACT.split()
    assert list(result["lateral_offset"]) == list(result["speed"]) == ["min", "max", "final"]
    assert list(result["step_time"]) == ["median", "p99", "max"]
    assert [each.name for each in fields(Result)] == CONTRACT.split()


def test_the_json_is_json() -> None:
    """It passes through `json` without a number that JSON does not have, and comes back the same."""
    result = recorded(straight()).to_json()
    assert json.loads(json.dumps(result, allow_nan=False)) == result
    assert result["outcome"] == "collided"
    assert result["version"] == swerve.__version__
    assert re.fullmatch(r"\d+\.\d+.*", result["version"])
    assert (result["scenario"], result["controller"], result["plant"], result["seed"]) == (
        "paper",
        "unified",
        "planar",
        7,
    )


def test_every_documented_number_has_its_sentence() -> None:
    """The class says of each of its numbers what it is."""
    for each in fields(Result):
        assert re.search(rf"^ +{each.name}: ", Result.__doc__ or "", re.MULTILINE), each.name


@pytest.mark.parametrize("lateral", [3.0, -2.5, 0.5])
def test_the_distance_ratio_of_a_straight_path(lateral: float) -> None:
    """Past a disc of radius 2 m the smallest sqrt(rho) is the lateral distance over 2 m, the clearance what is
    beyond.
    """
    result = recorded(straight(lateral=lateral))
    assert result.min_distance_ratio == pytest.approx(abs(lateral) / 2, abs=1e-9)
    assert result.min_clearance == pytest.approx(max(0.0, abs(lateral) - 2), abs=1e-4)


def test_the_smallest_of_all_obstacles_counts() -> None:
    """With two ellipses the nearer one gives the ratio; a rectangle gives a clearance, and no ratio."""
    second = "obstacles.1={position=[40, 4], semi_axes=[2, 2]}"
    assert recorded(straight(lateral=3.0), (second,)).min_distance_ratio == pytest.approx(0.5, abs=1e-9)
    box = ("obstacles=[{position=[40, 5], size=[4, 2]}]",)
    result = recorded(straight(), box)
    assert result.min_distance_ratio is None
    assert result.min_clearance == pytest.approx(4.0, abs=1e-9)


def test_without_obstacles_there_is_no_distance() -> None:
    """Keys of what does not exist are null."""
    result = recorded(straight(), ("obstacles=[]",)).to_json()
    assert (result["min_distance_ratio"], result["min_clearance"], result["impact_speed"]) == (None, None, None)
    assert result["outcome"] == "avoided"


@pytest.mark.parametrize(
    ("velocity", "speed"), [("[0, 0]", 20.0), ("[12, 0]", 8.0), ("[-5, 0]", 25.0), ("[4, 12]", 20.0)]
)
def test_impact_speed_is_relative_to_the_obstacle(velocity: str, speed: float) -> None:
    """A vehicle that runs into one that moves hits it with the difference of the velocities."""
    wide = "obstacles.0.semi_axes=[2, 90]"
    assert recorded(straight(seconds=4.0), (wide, f"obstacles.0.velocity={velocity}")).impact_speed == pytest.approx(
        speed
    )


def test_impact_speed_is_that_of_the_first_contact() -> None:
    """What happens after the first contact, to another obstacle or at another speed, is not asked."""
    states = straight()
    first = int(np.argmax(states[:, 4] > 23.0))
    states[first + 1 :, 0] = 3.0
    second = "obstacles.1={position=[40, 0], semi_axes=[2, 2], velocity=[1, 0]}"
    assert recorded(states, (second,)).impact_speed == pytest.approx(20.0)


def test_impact_speed_knows_where_the_vehicle_points() -> None:
    """Speeds are compared in world axes: a vehicle across the road moves where its axes say."""
    states = straight()
    states[:, 0], states[:, 1], states[:, 3] = 20 * np.cos(1.0), -20 * np.sin(1.0), 1.0
    assert recorded(states, ("obstacles.0.velocity=[12, 0]",)).impact_speed == pytest.approx(8.0)


def test_impact_speed_is_that_of_the_instant() -> None:
    """A lead car that brakes at 5 m/s^2 from 20 m/s, 10 m ahead, is hit after 2 s, when it has lost 10 m/s."""
    braking = 'obstacles=[{position=[14, 0], size=[8, 2], velocity=[20, 0], acceleration=["-5 m/s2", 0]}]'
    assert recorded(straight(), (braking,)).impact_speed == pytest.approx(10.0, abs=0.02)


def test_the_impact_s_obstacle_is_the_first_that_is_touched() -> None:
    """The index is that of the obstacle in the scenario, whatever is touched later."""
    far, near = "{position=[40, 0], semi_axes=[2, 2]}", "{position=[20, 0], semi_axes=[2, 2]}"
    assert recorded(straight(), (f"obstacles=[{far}, {near}]",)).impact_obstacle == 1
    assert recorded(straight(), (f"obstacles=[{near}, {far}]",)).impact_obstacle == 0


def test_time_in_the_oncoming_lane_counts_any_part_of_the_footprint() -> None:
    """A body 1.8 m wide that is at Y = 1 m for half a second reaches beyond the line at 1.75 m for so long."""
    road = ("road.lane_width=3.5", "obstacles=[]", "ego.footprint=rectangle")
    oncoming = (*road, "road.lanes_oncoming=1")
    states = straight()
    states[1000:1500, 5] = 1.0
    assert recorded(states, road).oncoming_lane_time is None
    assert recorded(states, oncoming).oncoming_lane_time == pytest.approx(0.5)
    assert recorded(straight(), oncoming).oncoming_lane_time == 0.0
    assert recorded(states, (*oncoming, "ego.footprint=point")).oncoming_lane_time == 0.0


def test_no_contact_no_impact() -> None:
    """A run that touches nothing has no impact speed, and no obstacle of it."""
    result = recorded(straight(lateral=3.0))
    assert (result.impact_speed, result.impact_obstacle) == (None, None)


def test_extremes_and_ends_of_the_motion() -> None:
    """Ranges are those of all rows; speed is over ground; final values and largest ones are magnitudes."""
    states = straight()
    states[10, 5], states[20, 5], states[-1, 5] = -1.5, 2.5, 0.25
    states[30, :2] = 16.0, -12.0
    states[40, 2], states[-1, 2], states[-1, 1] = -0.7, -0.1, -0.3
    result = recorded(states, ("obstacles=[]",))
    assert (result.lateral_offset.min, result.lateral_offset.max, result.lateral_offset.final) == (-1.5, 2.5, 0.25)
    assert result.speed.min == pytest.approx(20.0)
    assert result.speed.max == result.speed.final == pytest.approx(np.hypot(20.0, 0.3))
    assert (result.final_yaw_rate, result.final_lateral_speed, result.max_yaw_rate) == (0.1, 0.3, 0.7)
    assert result.max_sideslip == pytest.approx(np.arctan2(12, 16))


def test_steps_are_counted() -> None:
    """Steps, fallbacks and failures of the solver are those of the plans; times are those of the steps."""
    plans = [plan(), plan(fallback=Fallback.LATE), plan(Side.LEFT, solver_failures=2), plan(solver_failures=1)]
    result = recorded(straight(), commands=[COAST] * 4, plans=plans)
    assert (result.steps, result.fallback_steps, result.solver_failures) == (4, 1, 3)
    assert (result.step_time.median, result.step_time.max, result.wall_time) == (1e-3, 1e-3, 1.5)


def test_what_is_not_finite_is_null() -> None:
    """A run that diverged says so, with null where there is no number."""
    states = straight()
    states[-5:] = np.nan
    result = recorded(states).to_json()
    assert result["outcome"] == "diverged"
    assert result["final_yaw_rate"] is None
    assert result["speed"]["final"] is None
    json.dumps(result, allow_nan=False)


def test_a_divergence_is_told_with_its_time_and_the_state_before_it() -> None:
    """The first row that is no motion gives the time, the row before it the state; a motion that is one has neither."""
    states = np.tile([20.0, 0.1, 0.2, 0.3, 4.0, 5.0], (4, 1))
    times = np.array([0.0, 0.1, 0.2, 0.3])
    assert Divergence.of(states, times) is None
    states[2, 1] = np.nan
    told = Divergence.of(states, times)
    assert told == Divergence(0.2, {"vx": 20.0, "vy": 0.1, "r": 0.2, "psi": 0.3, "X": 4.0, "Y": 5.0})
