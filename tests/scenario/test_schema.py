"""What a scenario holds once it is read."""

import math

import pytest
from pydantic import ValidationError

from swerve.scenario import load
from swerve.world import Accelerating, AlongWaypoints, Ellipse, Motion, Obstacle, Point, Rectangle, Steady, Waiting


def test_quantities_become_si() -> None:
    """Units of the file are gone: metres, seconds, radians."""
    scenario = load("paper", ["ego.heading=90 deg", "goal.speed=36 km/h", "duration=300 ms", "road.friction=40 %"])
    assert scenario.ego.heading == pytest.approx(math.pi / 2)
    assert (scenario.goal.speed, scenario.duration, scenario.road.friction) == (10.0, 0.3, 0.4)


def test_an_obstacle_is_an_ellipse_or_a_rectangle_of_the_world() -> None:
    """`semi_axes` gives an ellipse, `size` a rectangle, each with its place and motion."""
    ellipse = load("slower-lead").obstacles[0].to_world()
    assert ellipse == Obstacle(Ellipse((2.5, 2.0)), Steady((25.0, 0.0), (10.0, 0.0)))
    box = load("paper", ['obstacles.0={position=["25 m", 0], size=[4, 1.7], heading="90 deg"}']).obstacles[0].to_world()
    assert box == Obstacle(Rectangle(4.0, 1.7), Steady((25.0, 0.0), heading=math.pi / 2))


MOTIONS = [
    ('position=["40 m", 0], velocity=["36 km/h", 0]', Steady((40.0, 0.0), (10.0, 0.0))),
    (
        'position=["40 m", 0], velocity=["36 km/h", 0], acceleration=["-4 m/s2", 0], accelerates_at="1500 ms"',
        Accelerating((40.0, 0.0), (10.0, 0.0), 0.0, (-4.0, 0.0), 1.5),
    ),
    (
        'position=["40 m", 0], acceleration=["0.5 g", 0], final_speed="18 km/h"',
        Accelerating((40.0, 0.0), (0.0, 0.0), 0.0, (0.5 * 9.80665, 0.0), 0.0, 5.0),
    ),
    (
        'position=["40 m", -4], velocity=[0, "1.5 m/s"], heading="90 deg", moves_at="1 s"',
        Waiting((40.0, -4.0), (0.0, 1.5), math.pi / 2, 1.0),
    ),
    (
        'waypoints=[{time="-1 s", position=["60 m", "3.5 m"]}, {time="2 s", position=["90 m", 0]}]',
        AlongWaypoints((-1.0, 2.0), ((60.0, 3.5), (90.0, 0.0))),
    ),
    (
        'waypoints=[{time=0, position=[60, 3]}, {time=2, position=[90, 0]}], heading="5 deg"',
        AlongWaypoints((0.0, 2.0), ((60.0, 3.0), (90.0, 0.0)), math.radians(5)),
    ),
]


@pytest.mark.parametrize(("keys", "motion"), MOTIONS, ids=[type(motion).__name__ for _, motion in MOTIONS])
def test_the_keys_of_an_obstacle_tell_its_motion(keys: str, motion: Motion) -> None:
    """Each motion has keys of its own, in any unit, and what is not written has the documented default."""
    obstacle = load("paper", [f"obstacles=[{{size=[4, 2], {keys}}}]"]).obstacles[0].to_world()
    assert obstacle == Obstacle(Rectangle(4.0, 2.0), motion)


def test_oncoming_lanes_are_the_outermost_on_the_left() -> None:
    """Of two lanes on the left one may carry oncoming traffic, beyond a line a lane further out than the own."""
    road = ("road.lane_width=3.5 m", "road.lanes_left=2")
    assert load("paper", road).road.to_world().oncoming_edge is None
    assert load("paper", [*road, "road.lanes_oncoming=1"]).road.to_world().oncoming_edge == 5.25


def test_the_footprint_is_a_point_or_the_vehicle_s_box() -> None:
    """A rectangle has the vehicle's length and width and reaches from its front end back."""
    assert load("paper").ego.to_footprint() == Point()
    ego = load("paper", ["ego.footprint=rectangle"]).ego
    vehicle, box = ego.to_vehicle(), ego.to_footprint()
    assert isinstance(box, Rectangle)
    assert (box.length, box.width) == (vehicle.length, vehicle.width)
    assert box.outline()[:, 0].max() == pytest.approx(vehicle.cg_to_front_end)


def test_parameters_change_the_vehicle() -> None:
    """A parameter replaces that number of the named vehicle and no other."""
    changed = load("paper", ["ego.parameters.mass=1600 kg"]).ego.to_vehicle()
    assert changed == load("paper").ego.to_vehicle().with_changes({"mass": 1600.0})


def test_the_road_has_edges_with_a_lane_width_alone() -> None:
    """One lane to the left and none to the right by default, about the middle of the ego vehicle's own."""
    assert load("paper").road.to_world().left_edge is None
    road = load("paper", ["road.lane_width=3.5 m"]).road.to_world()
    assert (road.left_edge, road.right_edge) == (5.25, -1.75)


@pytest.mark.parametrize(("duration", "samples"), [("5 s", 100), ("4.96 s", 100), ("0.15 s", 3), ("1 ms", 1)])
def test_a_run_covers_the_duration(duration: str, samples: int) -> None:
    """The number of samples is the duration's, rounded up, and rounding errors do not add one."""
    assert load("paper", [f"duration={duration}"]).n_samples == samples


@pytest.mark.parametrize(
    ("sample", "step", "substeps"), [("50 ms", "1 ms", 50), ("0.3 s", "0.1 s", 3), ("1 ms", "1 ms", 1)]
)
def test_a_sample_is_a_whole_number_of_steps(sample: str, step: str, substeps: int) -> None:
    """0.3 / 0.1 is 3 here, whatever floating point makes of it."""
    scenario = load("paper", [f"controller.sample_time={sample}", f"plant.step={step}"])
    assert scenario.n_substeps == substeps


def test_a_scenario_needs_no_obstacle() -> None:
    """An empty road is a scenario."""
    assert load("paper", ["obstacles=[]"]).obstacles == ()


def test_a_scenario_is_frozen() -> None:
    """Nothing in a scenario can be changed after it was checked, and equal ones have equal hashes."""
    scenario = load("paper")
    with pytest.raises(ValidationError):
        scenario.ego.speed = 3.0  # type: ignore[misc]
    assert hash(scenario) == hash(load("paper"))
