"""Random scenes and what geometry says of them."""

from collections import Counter

import numpy as np
import pytest

from swerve.scenario import Scenario, load
from swerve.study.random_scenes import is_quiet, is_threat, quiet_scene, scene
from swerve.study.random_scenes.drawing import FRICTIONS, PLACES, SPEEDS
from swerve.study.random_scenes.trial import kind_of

N = 150


def one_ahead(*overrides: str) -> Scenario:
    """The paper's scenario, the disc of 2 m somewhere, with other overrides."""
    return load("paper", overrides)


def test_a_scene_follows_from_its_seed_and_index() -> None:
    """The same two numbers give the same scene, and either of them changed another one."""
    assert scene(3, 4) == scene(3, 4)
    assert scene(3, 4) != scene(3, 5)
    assert scene(3, 4) != scene(4, 4)


def test_the_scenes_cover_what_they_are_to_cover() -> None:
    """All kinds of motion and shape, both footprints, roads with edges and without, one to three obstacles; and the
    speeds and frictions reach from one end of their ranges to the other, and no further.
    """
    scenes = [scene(0, index) for index in range(N)]
    kinds = Counter(kind_of(each, i) for each in scenes for i in range(len(each.obstacles)))
    assert set(kinds) == set(PLACES)
    assert min(kinds.values()) > N / 10
    assert {each.ego.footprint for each in scenes} == {"point", "rectangle"}
    assert {each.road.lane_width for each in scenes} == {None, 3.5}
    assert {len(each.obstacles) for each in scenes} == {1, 2, 3}
    assert {o.size is None for each in scenes for o in each.obstacles} == {True, False}
    for values, (low, high) in (
        ([each.ego.speed for each in scenes], SPEEDS),
        ([each.road.friction for each in scenes], FRICTIONS),
    ):
        assert low <= min(values) < low + 0.05 * (high - low)
        assert high - 0.05 * (high - low) < max(values) <= high


def test_most_scenes_are_threats() -> None:
    """Otherwise most of the drawing would be for nothing."""
    assert np.mean([is_threat(scene(0, index)) for index in range(N)]) > 0.5


def test_a_scene_rounds_through_its_file() -> None:
    """What is written of a scene that failed is that scene."""
    from swerve.scenario.loader import parse

    for index in range(20):
        drawn = scene(1, index)
        assert parse(drawn.to_toml().encode(), "scene.toml") == drawn


@pytest.mark.parametrize("offset, hits", [(0.0, True), (1.99, True), (2.01, False), (-1.99, True), (-2.01, False)])
def test_a_threat_is_what_driving_on_would_touch(offset: float, hits: bool) -> None:
    """A point that goes straight on at Y = 0 touches a disc of 2 m exactly where its centre is less than that away."""
    assert is_threat(one_ahead(f"obstacles.0.position=[40, {offset}]")) is hits


def test_a_lead_as_fast_is_no_threat_and_a_slower_one_is_in_time() -> None:
    """At 20 m/s, 40 m behind a disc of 2 m at 10 m/s, contact is 3.8 s away: in a run of 4 s, not in one of 3.6 s."""
    slower = ("obstacles.0.position=[40, 0]", "obstacles.0.velocity=[10, 0]")
    assert not is_threat(one_ahead("obstacles.0.velocity=[20, 0]"))
    assert is_threat(one_ahead(*slower, "duration=4"))
    assert not is_threat(one_ahead(*slower, "duration=3.6"))


@pytest.mark.parametrize("offset, is_so", [(2.45, False), (2.55, True), (-2.45, False), (-2.55, True)])
def test_quiet_is_half_a_metre_beside_the_path(offset: float, is_so: bool) -> None:
    """A point's path needs 0.5 m on each side; a disc of 2 m is out of that from 2.5 m on."""
    assert is_quiet(one_ahead(f"obstacles.0.position=[40, {offset}]")) is is_so


def test_what_will_cross_the_path_later_is_not_quiet() -> None:
    """Even if it does so after the end of the run, or where the vehicle has long passed."""
    crossing = ("obstacles.0.position=[40, 10]", "obstacles.0.velocity=[0, -1]")
    assert not is_quiet(one_ahead(*crossing, "duration=5"))
    assert is_quiet(one_ahead("obstacles.0.position=[40, 10]", "obstacles.0.velocity=[0, 1]"))


def test_quiet_scenes_are_drawn_quiet_often() -> None:
    """The vehicle is where it is to be, at its goal's speed; many of the draws keep off its path."""
    scenes = [quiet_scene(0, index) for index in range(60)]
    assert all(each.ego.position == (0.0, 0.0) and each.ego.speed == each.goal.speed for each in scenes)
    assert np.mean([is_quiet(each) for each in scenes]) > 0.3
