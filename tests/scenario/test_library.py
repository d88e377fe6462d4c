"""The scenarios that come with swerve."""

import pytest

from swerve.scenario import library_names, load


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
