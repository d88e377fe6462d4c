"""How much of its friction each wheel used, and how far to the side a run went."""

import numpy as np
import pytest

from swerve.control import Plan
from swerve.conventions import GRAVITY
from swerve.simulate.excursion import lateral_excursion
from swerve.simulate.friction_use import friction_under, friction_use, largest, mean_while_shaped
from swerve.vehicle import vehicle_named
from swerve.world import Friction
from tests.report.runs import made

CAR = vehicle_named("d-class-sedan")


def test_friction_use_is_the_share_of_the_circle() -> None:
    """A wheel at rest on a level road that brakes with 3 parts and turns with 4 of mu Fz / 10 uses half of it."""
    load = CAR.mass * GRAVITY / 4
    wheels = {"Fx": np.full((1, 4), -0.3 * load), "Fy": np.full((1, 4), 0.4 * load), "Fz": np.full((1, 4), load)}
    np.testing.assert_allclose(friction_use(wheels, np.ones((1, 4))), 0.5)
    np.testing.assert_allclose(friction_use(wheels, np.full((1, 4), 0.5)), 1.0)
    assert np.isnan(friction_use({**wheels, "Fz": np.zeros((1, 4))}, np.ones((1, 4)))).all()


@pytest.mark.parametrize(("heading", "expected"), [(0.0, [0.3, 0.8, 0.3, 0.8]), (np.pi / 2, [0.3, 0.3, 0.8, 0.8])])
def test_each_wheel_has_the_friction_under_it(heading: float, expected: list[float]) -> None:
    """On a split road the wheels left of the line have the left side's friction, whichever way the car points."""
    split = Friction.split(right=0.8, left=0.3)
    np.testing.assert_array_equal(friction_under(split, CAR, np.array([[5.0, 0.0, heading]])), [expected])


def test_the_largest_share_is_of_any_wheel_on_the_road() -> None:
    """A wheel in the air does not count; where all are in the air there is no share."""
    assert largest(np.array([[0.1, np.nan, 0.3, 0.2], [0.4, np.nan, 0.9, 0.0]])) == 0.9
    assert largest(np.full((3, 4), np.nan)) is None


def test_the_mean_is_over_the_samples_that_an_obstacle_shaped() -> None:
    """Of three samples of two plant steps and the end, only the second counts; without such a sample there is none."""
    use = np.repeat([[0.0], [0.0], [0.2], [0.4], [1.0], [1.0], [1.0]], 4, axis=1)
    free, shaped = (Plan(0.0, np.zeros((1, 5)), np.zeros((2, 6)), is_shaped=each) for each in (False, True))
    assert mean_while_shaped(use, [free, shaped, free], 2) == pytest.approx(0.3)
    assert mean_while_shaped(use, [free, free, free], 2) is None


def test_a_run_s_shares_are_within_the_circle_of_its_plant() -> None:
    """The planar plant holds its tyres within friction, and a braking car uses much of it."""
    result = made(controller="brake").result
    assert result.max_friction_use is not None and result.mean_friction_use is not None
    assert 0.5 < result.mean_friction_use <= result.max_friction_use <= 1.0 + 1e-6


@pytest.mark.parametrize(
    ("lateral", "goal", "expected"),
    [
        ([0.0, 1.5, -0.5, 0.0], 0.0, 1.5),
        ([0.0, 0.5, -2.0, 0.0], 0.0, 2.0),
        ([0.0, 2.0, 3.5, 3.5], 3.5, 0.0),  # a lane change that does not overshoot goes nowhere beside its way
        ([0.0, -0.25, 4.0, 3.5], 3.5, 0.5),
    ],
)
def test_an_excursion_is_beside_the_way_to_the_goal(lateral: list[float], goal: float, expected: float) -> None:
    """It is measured from the strip between the line that the car began on and the one that it was to hold."""
    assert lateral_excursion(np.array(lateral), goal) == expected
