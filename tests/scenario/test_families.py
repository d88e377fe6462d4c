"""Families: the members of a protocol's test, against its numbers and the closed forms of where they start."""

from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import numpy as np
import pytest

from swerve.errors import InputError
from swerve.scenario import FAMILIES, Scenario, load, parse

MEMBERS = [name for family in FAMILIES for name in family.members]
ROOT = Path(__file__).parents[2]


def gap(scenario: Scenario, time: float, index: int = 0) -> float:
    """From the front of the ego vehicle, if it kept its speed, to the rear of an obstacle [m]."""
    obstacle, vehicle = scenario.obstacles[index], scenario.ego.to_vehicle()
    assert obstacle.size is not None
    rear = float(obstacle.to_world().position_at(time)[0]) - obstacle.size[0] / 2
    return rear - scenario.ego.position[0] - scenario.ego.speed * time - vehicle.cg_to_front_end


@pytest.mark.parametrize("name", MEMBERS)
def test_a_member_is_a_scenario_with_the_protocol_s_dimensions(name: str) -> None:
    """Every member loads, says what it is, has the protocol's vehicle and target, and survives its own TOML."""
    member = load(name)
    assert member.name == name
    assert 0 < len(member.description) <= 100
    assert "own:" in member.source
    vehicle = member.ego.to_vehicle()
    assert (vehicle.length, vehicle.width, member.ego.footprint) == (4.358, 1.815, "rectangle")
    assert all(obstacle.size == (4.023, 1.712) for obstacle in member.obstacles)
    assert parse(member.to_toml().encode(), "again.toml") == member


def test_the_grids_have_the_protocol_s_size() -> None:
    """Eight speeds, eleven and six, each with five impact locations; two cut-ins and two cut-outs."""
    assert {family.name: len(family.members) for family in FAMILIES} == {
        "ccrs": 40,
        "ccrm": 55,
        "ccrb": 30,
        "cut-in": 2,
        "cut-out": 2,
    }


@pytest.mark.parametrize(("impact", "offset"), [(0, -0.9075), (25, -0.45375), (50, 0.0), (100, 0.9075)])
def test_the_impact_location_is_a_share_of_the_front(impact: int, offset: float) -> None:
    """0 % is the right end of the front and 100 % the left one, of 1.815 m."""
    for name in ("ccrs-50", "ccrm-80", "ccrb-50"):
        position = load(f"{name}-il{impact}").obstacles[0].position
        assert position is not None and position[1] == pytest.approx(offset, abs=1e-12)


@pytest.mark.parametrize(("name", "closing"), [("ccrs-10-il50", 10), ("ccrs-80-il0", 80), ("ccrm-130-il75", 60)])
def test_without_a_reaction_the_target_is_met_after_four_seconds(name: str, closing: float) -> None:
    """The gap is closed at a time to collision of 4 s, with the difference of the protocol's speeds."""
    member = load(name)
    assert gap(member, 0.0) == pytest.approx(4.0 * closing / 3.6)
    assert gap(member, 4.0) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    ("speed", "target"), [(30, 20), (80, 20), (90, 30), (100, 40), (110, 50), (120, 60), (130, 70)]
)
def test_the_slower_target_has_the_protocol_s_speed(speed: int, target: int) -> None:
    """20 km/h up to 80 km/h, then 60 km/h less than the vehicle under test."""
    member = load(f"ccrm-{speed}-il50")
    assert member.ego.speed == member.goal.speed == pytest.approx(speed / 3.6)
    assert member.obstacles[0].velocity == pytest.approx((target / 3.6, 0.0))


def test_the_braking_target_is_a_second_ahead_and_brakes_to_two_kilometres_an_hour() -> None:
    """Equal speeds and a headway of 1 s; -4 m/s^2 from 1 s on."""
    member = load("ccrb-80-il50")
    car = member.obstacles[0].to_world()
    assert gap(member, 0.0) == gap(member, 1.0) == pytest.approx(80 / 3.6)
    assert car.velocity_at(2.0)[0] == pytest.approx(80 / 3.6 - 4.0)
    assert car.velocity_at(30.0)[0] == pytest.approx(2 / 3.6)


@pytest.mark.parametrize(("name", "collision", "length"), [("cut-in-50-10", 0.0, 14.5), ("cut-in-120-70", 1.5, 60.0)])
def test_a_cut_in_leaves_the_protocol_s_time_to_collision(name: str, collision: float, length: float) -> None:
    """When the car has come over from 3.5 m on the left, on the protocol's length, that time is left."""
    member = load(name)
    car = member.obstacles[0].to_world()
    over = 1.0 + length / car.velocity_at(0.5)[0]
    np.testing.assert_allclose(
        [car.position_at(t)[1] for t in (0.0, 1.0, over, over + 5.0)], [3.5, 3.5, 0, 0], atol=1e-9
    )
    assert gap(member, over) == pytest.approx(collision * (member.ego.speed - car.velocity_at(over)[0]), abs=1e-9)


@pytest.mark.parametrize(
    ("name", "most"), [("cut-in-50-10", 0.5), ("cut-in-120-70", 1.5), ("cut-out-70-50", 1.5), ("cut-out-90-70", 1.5)]
)
def test_a_lane_change_has_about_the_protocol_s_lateral_acceleration(name: str, most: float) -> None:
    """Its mean over either half, twice the half's offset over its time squared, is that within a tenth."""
    car = load(name).obstacles[0].to_world()
    times = np.linspace(0.0, 12.0, 12001)
    lateral = np.abs(np.array([car.position_at(t)[1] for t in times]) - car.position_at(0.0)[1])
    begun, half, over = (float(times[np.argmax(lateral > share)]) for share in (1e-6, 1.75, 3.5 - 1e-6))
    assert half - begun == pytest.approx(over - half, abs=0.01)
    assert 2 * 1.75 / (half - begun) ** 2 == pytest.approx(most, rel=0.1)


def test_a_cut_out_reveals_a_car_three_seconds_ahead_of_the_lead() -> None:
    """When its lane change begins the lead is 3 s from the stationary car; it passes beside it."""
    member = load("cut-out-70-50")
    lead, standing = (obstacle.to_world() for obstacle in member.obstacles)
    between = standing.position_at(1.0)[0] - lead.position_at(1.0)[0] - 4.023
    assert between == pytest.approx(3.0 * 50 / 3.6)
    beside = 1.0 + between / (50 / 3.6)
    assert lead.position_at(beside)[1] - standing.position_at(beside)[1] > 1.712


@pytest.mark.parametrize(
    ("name", "right"),
    [
        ("ccrs-55-il50", "SPEED 10 to 80 by 10 km/h, IMPACT 0 to 100 by 25 %"),
        ("ccrm", "such as ccrm-30-il0 "),
        ("cut-in-60-10", "cut-in-50-10 or cut-in-120-70"),
    ],
)
def test_an_unknown_member_gets_the_ranges(name: str, right: str) -> None:
    """A name that begins as a family's does is answered with what its members are called."""
    with pytest.raises(InputError, match=f"^{name}: no such member of the family ") as caught:
        load(name)
    assert right in str(caught.value)


def test_a_member_takes_overrides() -> None:
    """`--set` works on a member as on a file, and leaves the family as it was."""
    assert load("ccrs-50-il50", ["road.friction=0.4", "ego.parameters.width=2"]).road.friction == 0.4
    assert load("ccrs-50-il50").road.friction == 0.9
    assert load("ccrs-50-il50").ego.to_vehicle().width == 1.815


def test_the_documentation_s_page_is_that_of_the_library() -> None:
    """`docs/library.md` is what `make library` would write."""
    spec = spec_from_file_location("library_page", ROOT / "docs" / "hooks" / "library.py")
    assert spec is not None and spec.loader is not None
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    assert (ROOT / "docs" / "library.md").read_text("utf-8") == module.page()
