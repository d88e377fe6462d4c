"""The verdict of a run: geometry and motion on the plant's grid, in a fixed order."""

import numpy as np
import pytest

from swerve.simulate import Outcome
from swerve.simulate.outcome import SPIN_SIDESLIP, decide, sideslip, touches
from swerve.world import Ellipse, Obstacle, Point, Rectangle, Road, Steady
from tests.simulate.recordings import recorded, straight

CAR = Rectangle(4.85, 1.8)
OPEN = Road()
TWO_LANES = Road(3.5)


def verdict(
    states: np.ndarray, contact: bool = False, road: Road = OPEN, footprint: Point | Rectangle = CAR
) -> Outcome:
    """The outcome of states, with contact in their middle or without."""
    touched = np.zeros(len(states), dtype=bool)
    touched[len(states) // 2] = contact
    return decide(states, touched, states[:, [4, 5, 3]], road, footprint)


def spinning() -> np.ndarray:
    """A vehicle that turns round while it slides on."""
    states = straight()
    angle = np.linspace(0.0, np.pi / 2, len(states))
    states[:, 0], states[:, 1] = 20 * np.cos(angle), -20 * np.sin(angle)
    states[:, 3] = angle
    return states


def test_a_vehicle_that_keeps_its_lane_avoided() -> None:
    """Nothing touched, no edge crossed, no spin: avoided."""
    assert verdict(straight(), road=TWO_LANES) is Outcome.AVOIDED


def test_one_row_of_contact_is_a_collision() -> None:
    """A single instant of contact on the plant's grid decides, however short it is."""
    assert verdict(straight(), contact=True) is Outcome.COLLIDED


@pytest.mark.parametrize(("lateral", "outcome"), [(-0.84, Outcome.AVOIDED), (-0.86, Outcome.LEFT_ROAD)])
def test_the_edge_is_for_the_body(lateral: float, outcome: Outcome) -> None:
    """With 0.9 m of body to each side and the right edge at -1.75 m, the centre may go to -0.85 m."""
    assert verdict(straight(lateral=lateral), road=TWO_LANES) is outcome
    assert verdict(straight(lateral=lateral)) is Outcome.AVOIDED


def test_a_point_has_no_body_to_leave_the_road_with() -> None:
    """A point may drive on the edge itself."""
    assert verdict(straight(lateral=5.25), road=TWO_LANES, footprint=Point()) is Outcome.AVOIDED
    assert verdict(straight(lateral=5.26), road=TWO_LANES, footprint=Point()) is Outcome.LEFT_ROAD


@pytest.mark.parametrize(("degrees", "outcome"), [(44.0, Outcome.AVOIDED), (46.0, Outcome.SPUN), (-46.0, Outcome.SPUN)])
def test_beyond_45_degrees_it_has_spun(degrees: float, outcome: Outcome) -> None:
    """A sideslip angle of more than 45 degrees to either side is a vehicle that is lost."""
    states = straight()
    states[100, :2] = 20 * np.cos(np.radians(degrees)), 20 * np.sin(np.radians(degrees))
    assert verdict(states) is outcome
    assert pytest.approx(np.radians(45)) == SPIN_SIDESLIP


def test_slow_vehicles_have_no_sideslip() -> None:
    """Nearly at rest the angle of the velocity means nothing; faster, it is that of vy to vx."""
    states = np.zeros((4, 6))
    states[:, :2] = [[0.0, 0.0], [0.1, 1.5], [3.0, 3.0], [10.0, -1.0]]
    np.testing.assert_allclose(sideslip(states), [0.0, 0.0, np.pi / 4, -np.arctan(0.1)])


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_the_first_that_holds_is_the_verdict(value: float) -> None:
    """Diverged before collided, before left road, before spun, before avoided."""
    states, off_road = spinning(), spinning()
    off_road[:, 5] = 30.0
    broken = off_road.copy()
    broken[-1, 2] = value
    found = [
        verdict(broken, contact=True, road=TWO_LANES),
        verdict(off_road, contact=True, road=TWO_LANES),
        verdict(off_road, road=TWO_LANES),
        verdict(states),
        verdict(straight()),
    ]
    assert found == list(Outcome)


def test_every_outcome_is_a_name_and_a_sentence() -> None:
    """The names are those that other people's scripts know; each has a sentence for a reader."""
    assert {each.value for each in Outcome} == {"avoided", "collided", "left_road", "spun", "diverged"}
    assert all(each.sentence.endswith(".") and " " in each.sentence for each in Outcome)


@pytest.mark.parametrize(("lateral", "hit"), [(2.001, False), (1.999, True)])
def test_an_ellipse_is_touched_where_rho_is_below_one(lateral: float, hit: bool) -> None:
    """A point that passes a disc of 2 m at 2.001 m does not touch it; at 1.999 m it does."""
    states = straight(lateral=lateral)
    disc = Obstacle(Ellipse((2.0, 2.0)), Steady((25.0, 0.0)))
    contact = touches(disc, Point(), states[:, [4, 5, 3]], np.arange(len(states)) * 1e-3)
    assert contact.any() == hit
    if hit:
        assert abs(straight()[contact, 4] - 25.0).max() < 0.1


@pytest.mark.parametrize(("lateral", "hit"), [(1.751, False), (1.75, True), (1.0, True)])
def test_a_box_is_touched_where_there_is_no_clearance(lateral: float, hit: bool) -> None:
    """A body of 1.8 m passes a box of 1.7 m at a distance of centres of 1.75 m or more."""
    states = straight(lateral=lateral)
    box = Obstacle(Rectangle(4.0, 1.7), Steady((25.0, 0.0)))
    assert touches(box, CAR, states[:, [4, 5, 3]], np.arange(len(states)) * 1e-3).any() == hit


def test_contact_counts_where_the_obstacle_is_at_the_time() -> None:
    """An obstacle that has driven away is not hit where it stood; one that is caught up with is."""
    away = ("obstacles.0.velocity=[21, 0]",)
    caught = ("obstacles.0.velocity=[10, 0]",)
    assert recorded(straight(), away).outcome is Outcome.AVOIDED
    assert recorded(straight(), caught).outcome is Outcome.COLLIDED
    assert recorded(straight()).outcome is Outcome.COLLIDED
