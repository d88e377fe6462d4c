"""The scenarios that come with swerve."""

from itertools import combinations

import numpy as np
import pytest

from swerve.scenario import Scenario, library_names, load
from swerve.world import Rectangle, clearance

QUIET = [name for name in library_names() if name in ("far-away", "beside-the-lane") or "quiet" in name]
STEERED_INTO = "driver-into-obstacle"  # its driver makes the threat: straight on there is none


def straight_on(scenario: Scenario) -> float:
    """Smallest distance to any obstacle if the ego vehicle just went straight on at its speed [m]."""
    times = np.linspace(0.0, scenario.duration, 2001)
    poses = np.column_stack((scenario.ego.speed * times, 0 * times, 0 * times))
    footprint = scenario.ego.to_footprint()
    return min(clearance(footprint, poses, each.to_world(), times).min() for each in scenario.obstacles)


@pytest.mark.parametrize("name", library_names())
def test_a_scenario_says_what_it_is_for(name: str) -> None:
    """A library scenario has its file's name, a description that fits a line, and a source."""
    scenario = load(name)
    assert scenario.name == name
    assert 0 < len(scenario.description) <= 100
    assert scenario.source


def test_the_paper_s_scenario_has_the_paper_s_numbers() -> None:
    """`paper` is sec. 5 with Tables 2 and 3."""
    paper = load("paper")
    assert (paper.duration, paper.road.friction, paper.road.lane_width) == (5.0, 0.85, None)
    assert (paper.ego.position, paper.ego.heading, paper.ego.speed, paper.ego.footprint) == ((0, 0), 0, 20, "point")
    assert (paper.ego.to_vehicle().mass, paper.ego.to_vehicle().yaw_inertia) == (1530, 2315.3)
    (obstacle,) = paper.obstacles
    assert (obstacle.position, obstacle.velocity, obstacle.semi_axes) == ((25, 0), (0, 0), (2, 2))
    assert (paper.goal.speed, paper.goal.lateral_offset) == (20, 0)
    assert (paper.controller.prediction_horizon, paper.controller.control_horizon) == (20, 15)
    assert paper.controller.sample_time == 0.05
    weights = paper.controller.weights
    assert (weights.speed, weights.lateral_speed, weights.lateral_offset) == (1, 1, 10)


@pytest.mark.parametrize(
    ("name", "x", "y"),
    [
        ("static-40", 40, 0),
        ("static-20", 20, 0),
        ("static-18", 18, 0),
        ("static-17", 17, 0),
        ("static-16", 16, 0),
        ("static-15.5", 15.5, 0),
        ("offset-left", 25, 0.3),
        ("offset-right", 25, -0.3),
    ],
)
def test_variants_of_the_paper_s_differ_in_the_obstacle_s_place_alone(name: str, x: float, y: float) -> None:
    """The static variants are the paper's scenario with the obstacle somewhere else."""
    paper, variant = load("paper"), load(name)
    moved = paper.obstacles[0].model_copy(update={"position": (x, y)})
    about = {"name": variant.name, "description": variant.description, "source": variant.source}
    assert variant == paper.model_copy(update={"obstacles": (moved,), **about})


@pytest.mark.parametrize("name", [name for name in library_names() if name != STEERED_INTO])
def test_a_threat_is_one_and_a_quiet_scene_is_none(name: str) -> None:
    """Straight on there is a contact in every scene but the quiet ones, which leave more than half a metre."""
    assert straight_on(load(name)) > 0.5 if name in QUIET else straight_on(load(name)) <= 0


@pytest.mark.parametrize("name", library_names())
def test_it_begins_on_the_road(name: str) -> None:
    """The ego vehicle starts between the road's edges."""
    scenario = load(name)
    assert scenario.road.to_world().is_inside(scenario.ego.to_footprint(), [(0.0, 0.0, 0.0)]).all()


@pytest.mark.parametrize("name", [name for name in library_names() if len(load(name).obstacles) > 1])
def test_obstacles_do_not_run_through_each_other(name: str) -> None:
    """Until the end of the run the bodies of any two obstacles stay apart."""
    scenario = load(name)
    times = np.linspace(0.0, scenario.duration, 1001)
    for one, other in combinations(sorted(scenario.obstacles, key=lambda each: each.size is None), 2):
        assert one.size is not None
        moving = one.to_world()
        poses = np.column_stack((moving.position_at(times), moving.heading_at(times)))
        assert clearance(Rectangle(*one.size), poses, other.to_world(), times).min() > 0.1
