"""The course of ISO 3888-2, the driver, and the verdict."""

import numpy as np
import pytest

from swerve.driver.preview import preview_steering
from swerve.study.manoeuvres import DoubleLaneChange, SmoothLaneChange, run_manoeuvre
from swerve.study.manoeuvres.course import Course
from swerve.study.manoeuvres.path import LanePath
from swerve.vehicle import vehicle_named
from swerve.vehicle.steady_state import steering_per_acceleration
from swerve.world import Obstacle, Point, Rectangle, Steady, clearance

SEDAN = vehicle_named("d-class-sedan")
COURSE = Course.iso_3888_2(1.8)


def test_the_course_is_that_of_the_standard() -> None:
    """61 m in sections of 12, 13.5, 11, 12.5 and 12 m; widths 1.1 b + 0.25, b + 1 and 1.3 b + 0.25; 1 m aside."""
    first, aside, last = COURSE.lanes
    assert [(lane.start, lane.end) for lane in COURSE.lanes] == [(0.0, 12.0), (25.5, 36.5), (49.0, 61.0)]
    widths = [lane.left - lane.right for lane in COURSE.lanes]
    assert widths == pytest.approx([1.1 * 1.8 + 0.25, 1.8 + 1.0, 1.3 * 1.8 + 0.25])
    assert aside.right - first.left == pytest.approx(1.0)
    assert last.right == first.right
    assert first.middle == pytest.approx(0.0)


def test_the_exit_s_width_is_an_option() -> None:
    """A last lane of 3 m keeps its right edge."""
    wide = Course.iso_3888_2(1.8, 3.0).lanes[-1]
    assert wide.left - wide.right == pytest.approx(3.0)
    assert wide.right == COURSE.lanes[-1].right
    assert DoubleLaneChange(exit_width=3.0).course(1.8) == Course.iso_3888_2(1.8, 3.0)
    assert DoubleLaneChange().course(1.8) == COURSE


def test_cones_stand_on_both_edges_of_every_lane() -> None:
    """At both ends of each, no more than 3 m apart."""
    for lane in COURSE.lanes:
        for edge in (lane.left, lane.right):
            x = np.sort([cone[0] for cone in lane.cones() if cone[1] == edge])
            assert (x[0], x[-1]) == (lane.start, lane.end)
            assert np.diff(x).max() <= 3.0


def test_clearances_are_those_of_the_geometry() -> None:
    """Outside the body they are the distances that `world` measures; a cone within it is below zero by its depth."""
    poses = np.array([[-4.0, 0.0, 0.0], [8.0, 0.5, 0.3], [30.0, 2.5, -0.2]])
    body = Rectangle(SEDAN.length, SEDAN.width, (SEDAN.cg_to_front_end - SEDAN.length / 2, 0.0))
    measured = COURSE.clearances(SEDAN, poses)
    for cone, gap in zip(COURSE.cones(), measured, strict=True):
        exact = clearance(
            body, poses, Obstacle(Point(), Steady((cone[0], cone[1]), (0.0, 0.0), 0.0)), np.zeros(3)
        ).min()
        assert max(gap, 0.0) == pytest.approx(exact, abs=1e-9)
    middle_of_body = np.array(
        [[COURSE.cones()[0][0] + SEDAN.length / 2 - SEDAN.cg_to_front_end, COURSE.cones()[0][1], 0]]
    )
    assert COURSE.clearances(SEDAN, middle_of_body)[0] == pytest.approx(-SEDAN.width / 2)


@pytest.mark.parametrize("plant", ["planar", "multibody"])
def test_a_moderate_speed_is_passed_and_an_absurd_one_is_not(plant: str) -> None:
    """45 km/h without touching a cone; 120 km/h with many of them."""
    slow, fast = (run_manoeuvre(DoubleLaneChange(speed=v / 3.6), SEDAN, plant).measures for v in (45, 120))
    assert (slow["passed"].value, slow["cones_hit"].value) == (1.0, 0.0)
    assert slow["least_clearance"].value > 0
    assert slow["entry_speed"].value == pytest.approx(45 / 3.6, rel=0.01)
    assert fast["passed"].value == 0.0
    assert fast["cones_hit"].value > 3


def test_the_path_joins_its_lanes_smoothly() -> None:
    """It is straight in the lanes, and 2 pi w / l^2 is its largest second derivative between them."""
    path, h = LanePath(((0.0, 10.0, 1.0), (40.0, 50.0, 4.0))), 1e-3
    assert [path.at(x) for x in (-5.0, 10.0, 40.0, 99.0)] == pytest.approx([1.0, 1.0, 4.0, 4.0])
    assert path.at(25.0) == pytest.approx(2.5)
    second = [(path.at(x + h) - 2 * path.at(x) + path.at(x - h)) / h**2 for x in np.linspace(9.0, 41.0, 801)]
    assert np.abs(second).max() == pytest.approx(2 * np.pi * 3.0 / 30.0**2, rel=1e-3)


def test_the_driver_steers_where_he_looks() -> None:
    """On the path he does not steer; beside it by the turn that meets it in the preview time; never beyond the lock."""
    straight, beside = LanePath(((0.0, 1.0, 0.0),)), np.array([20.0, 0.0, 0.0, 0.0, 5.0, -0.5])
    assert preview_steering(SEDAN, 0.85, straight, 0.5, beside * [1, 1, 1, 1, 1, 0]) == 0.0
    expected = 2 * 0.5 / 0.5**2 * steering_per_acceleration(SEDAN, 0.85, 20.0)
    assert preview_steering(SEDAN, 0.85, straight, 0.5, beside) == pytest.approx(expected)
    assert preview_steering(SEDAN, 0.85, straight, 0.5, beside * [1, 1, 1, 1, 1, 100]) == SEDAN.steering_limit


def test_the_smooth_change_stays_within_the_friction_with_forces_of_both_signs() -> None:
    """At 120 km/h on friction 0.6 the car keeps to its path within 1.2 m and its wheels brake and drive."""
    run = run_manoeuvre(SmoothLaneChange(), SEDAN)
    assert run.measures["largest_path_error"].value < 1.2
    assert 3.5 < run.measures["largest_lateral_acceleration"].value < 0.6 * 9.81
    assert run.motion["Fx_fl"].min() < -800 and run.motion["Fx_fl"].max() > 800
    assert run.motion["vx"][0] == pytest.approx(120 / 3.6)
