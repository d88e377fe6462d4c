"""All measures together: what each of them always is."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swerve.conventions import GRAVITY
from swerve.study.criticality import UNITS, measure
from swerve.study.criticality.manoeuvre import SHIFTS, swerve
from swerve.study.criticality.roll_out import roll_out
from tests.study.criticality.scenes import FRONT, box, scene

speeds = st.floats(-20, 20)
TIMES = [name for name, unit in UNITS.items() if unit == "s" and name != "wttc"]


@given(st.floats(0, 40), st.floats(6, 80), st.floats(-10, 10), speeds, speeds, st.floats(0.1, 1.2))
@settings(max_examples=20, deadline=None)
def test_nothing_is_ever_nan_and_the_order_holds(
    speed: float, x: float, y: float, vx: float, vy: float, friction: float
) -> None:
    """WTTC <= TTC, every time to a manoeuvre <= TTC, TTR the largest of its three; at rest and beside, too."""
    values = {
        name: each[0]
        for name, each in measure(scene(box(x, y, vx, vy), speed=speed, friction=friction, lane_width=3.5)).items()
    }
    assert not any(np.isnan(each) for each in values.values())
    assert values["wttc"] <= values["ttc"]
    assert all(values[name] <= values["ttc"] for name in TIMES)
    assert values["ttr"] == max(values["ttb"], values["tts_left"], values["tts_right"])
    assert (values["impact_speed"] == 0) or values["ttb"] == -np.inf


@pytest.mark.parametrize("obstacles", [(), (box(-30),), (box(40, 6),), (box(40, vx=25),)])
def test_without_a_conflict_all_times_are_infinite(obstacles: tuple[dict[str, object], ...]) -> None:
    """Nothing around, behind, beside, or faster ahead: no threat and no impact."""
    values = measure(scene(*obstacles))
    assert all(values[name][0] == np.inf for name in TIMES)
    assert values["btn"][0] == values["stn"][0] == values["impact_speed"][0] == 0


def test_the_impact_speed_of_braking_too_late() -> None:
    """sqrt(v^2 - 2 a d) at a resting obstacle."""
    found = measure(scene(box(FRONT + 2 + 15)))["impact_speed"][0]
    assert found == pytest.approx(np.sqrt(20**2 - 2 * 0.95 * 0.85 * GRAVITY * 15), abs=0.1)


def test_a_vehicle_in_contact_is_too_late_for_everything() -> None:
    """TTC is 0, and nothing helps."""
    at = scene(box(20))
    states = at.states.copy()
    states[:, 4] = 17.0
    values = measure(replace(at, states=states))
    assert values["ttc"][0] == values["wttc"][0] == values["clearance"][0] == 0
    assert values["ttr"][0] == -np.inf
    assert values["btn"][0] == np.inf


@pytest.mark.parametrize("plant", ["planar", "multibody"])
@pytest.mark.parametrize("speed", [10.0, 20.0, 30.0, 40.0, 50.0])
@pytest.mark.parametrize("friction", [0.1, 0.3, 0.85, 1.1])
def test_the_sedan_stays_in_hand(plant: str, speed: float, friction: float) -> None:
    """Every swerve ends along its course, on no friction and at no speed in a spin."""
    at = scene(box(200), speed=speed, friction=friction, plant=plant)
    for shift in SHIFTS:
        states = roll_out(at, swerve(at, 1, shift)).states[0]
        assert np.abs(np.arctan2(states[:, 1], states[:, 0])).max() < 0.2
        assert abs(states[-1, 3]) < 0.02
