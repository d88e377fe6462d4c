"""What a scenario holds once it is read."""

import math

import pytest
from pydantic import ValidationError

from swerve.scenario import load
from swerve.world import Ellipse, Point, Rectangle


def test_quantities_become_si() -> None:
    """Units of the file are gone: metres, seconds, radians."""
    scenario = load("paper", ["ego.heading=90 deg", "goal.speed=36 km/h", "duration=300 ms", "road.friction=40 %"])
    assert scenario.ego.heading == pytest.approx(math.pi / 2)
    assert (scenario.goal.speed, scenario.duration, scenario.road.friction) == (10.0, 0.3, 0.4)


def test_an_obstacle_is_an_ellipse_or_a_rectangle_of_the_world() -> None:
    """`semi_axes` gives an ellipse, `size` a rectangle, each with its place and motion."""
    ellipse = load("slower-lead").obstacles[0].to_world()
    assert (ellipse.shape, ellipse.position, ellipse.velocity) == (Ellipse((2.5, 2.0)), (25.0, 0.0), (10.0, 0.0))
    box = load("paper", ['obstacles.0={position=["25 m", 0], size=[4, 1.7], heading="90 deg"}']).obstacles[0].to_world()
    assert (box.shape, box.heading) == (Rectangle(4.0, 1.7), math.pi / 2)


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
