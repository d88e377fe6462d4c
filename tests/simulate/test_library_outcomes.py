"""What must come out of the library's scenes whose right answer is known."""

from typing import Final, NamedTuple

import pytest

from swerve.scenario import FAMILIES, library_names, load
from swerve.simulate import run

LEFT: Final = frozenset({"steer-left", "brake+steer-left"})
RIGHT: Final = frozenset({"steer-right", "brake+steer-right"})
BRAKE: Final = frozenset({"brake"})
QUIET: Final = frozenset({"none"})
ANY: Final = LEFT | RIGHT | BRAKE


class Answer(NamedTuple):
    """The decisions that are right, and the largest impact speed where physics leaves no better [m/s]."""

    decisions: frozenset[str]
    impact_speed: float | None = None


ANSWERS: Final = {
    "beside-the-lane": Answer(QUIET),
    "far-away": Answer(QUIET),
    "offset-left": Answer(RIGHT),
    "offset-right": Answer(LEFT),
    "paper": Answer(LEFT | RIGHT),
    "slower-lead": Answer(ANY),
    "static-15.5": Answer(LEFT | RIGHT),
    "static-16": Answer(LEFT | RIGHT),
    "static-17": Answer(LEFT | RIGHT),
    "static-18": Answer(LEFT | RIGHT),
    "static-20": Answer(LEFT | RIGHT),
    "static-40": Answer(ANY),
    "stay-in-new-lane": Answer(LEFT | QUIET),  # the way to the goal already passes it
    "wet": Answer(LEFT | RIGHT),
    "stopped-car-town": Answer(LEFT | BRAKE),
    "stopped-car-motorway": Answer(LEFT),
    "queue-end": Answer(LEFT),
    "braking-lead-country": Answer(LEFT | BRAKE),
    "braking-lead-motorway": Answer(LEFT | BRAKE),
    "slower-truck": Answer(LEFT | BRAKE),
    "merging-car": Answer(ANY),
    "revealed-car": Answer(ANY),
    "oncoming-overtaker": Answer(RIGHT),
    "oncoming-drift": Answer(RIGHT | BRAKE),
    "pedestrian-crossing": Answer(ANY),
    "pedestrian-obstructed": Answer(ANY),
    "pedestrian-running": Answer(ANY),
    "bicycle-crossing": Answer(ANY),
    "bicycle-ahead": Answer(LEFT | BRAKE),
    "car-at-junction": Answer(ANY),
    "turns-across": Answer(ANY),
    "slalom": Answer(LEFT),
    "slalom-fast": Answer(LEFT),
    "both-lanes-blocked": Answer(BRAKE),
    "both-lanes-blocked-late": Answer(ANY, impact_speed=19.0),  # full braking: 16.3, and 18.2 with lags
    "left-blocked": Answer(RIGHT),
    "right-blocked": Answer(LEFT),
    "wet-motorway": Answer(LEFT),
    "ice": Answer(LEFT),
    "split-friction": Answer(ANY),
    "ice-patch": Answer(ANY),
    "quiet-next-lane": Answer(QUIET),
    "quiet-parked-car": Answer(QUIET),
    "quiet-oncoming": Answer(QUIET),
    "quiet-overtaken": Answer(QUIET),
    "quiet-following": Answer(QUIET),
    "driver-too-late": Answer(ANY),
    "driver-into-obstacle": Answer(ANY),
    "driver-is-right": Answer(QUIET),
    "driver-lane-keeping-quiet": Answer(QUIET),
}
STOPS: Final = "under ice that it was not told of it neither stops nor passes; full braking would be the better choice"
TURNS: Final = "it takes the wrong side of a car that drifts: what it expects of it changes too late"
LATE: Final = "within 1.2 m of the last point to steer, found for the planar plant, without the actuators' lags"
FAULTS: Final = {  # of the controller, not of the scenes, but for those too LATE: (scene, plant)
    ("static-15.5", "multibody"): LATE,
    ("static-16", "multibody"): LATE,
    ("split-friction", "multibody"): STOPS,
    ("oncoming-drift", "planar"): TURNS,
    ("oncoming-drift", "multibody"): TURNS,
}
PATCHED: Final = ("split-friction", "ice-patch")  # the planar plant has one friction for all wheels
QUICK: Final = ("left-blocked", "stopped-car-motorway", "oncoming-overtaker", "slalom")  # beside the paper's own
PAPER_LIKE: Final = [name for name in ANSWERS if load(name).ego.footprint == "point"]

KNOWN = [name for name, answer in ANSWERS.items() if answer.decisions is not QUIET]  # the quiet ones: test_contract
MEMBERS: Final = (
    "ccrs-50-il50",
    "ccrs-40-il0",
    "ccrm-80-il50",
    "ccrm-130-il100",
    "ccrb-50-il100",
    "ccrb-80-il50",
    "cut-in-50-10",
    "cut-in-120-70",
    "cut-out-70-50",
    "cut-out-90-70",
)


def _case(name: str, plant: str) -> object:
    marks: list[pytest.MarkDecorator] = []
    if (name, plant) in FAULTS:
        marks.append(pytest.mark.xfail(reason=FAULTS[name, plant]))
    if plant == "multibody" or name not in (*QUICK, *PAPER_LIKE):
        marks.append(pytest.mark.slow)
    return pytest.param(name, plant, id=f"{name}-{plant}", marks=marks)


CASES: Final = [
    _case(name, plant)
    for name in KNOWN
    for plant in ("planar", "multibody")
    if not (plant == "planar" and name in PATCHED)
]


@pytest.mark.parametrize(("name", "plant"), CASES)
def test_the_answer_is_right(name: str, plant: str) -> None:
    """The decision is a right one; contact only where physics leaves no way out, and then as slow as it does."""
    result, answer = run(load(name), plant=plant).result, ANSWERS[name]
    assert result.fallback_steps == 0
    assert result.decision in answer.decisions
    if answer.impact_speed is None:
        assert result.outcome.value == "avoided"
    else:
        assert result.impact_speed is not None and result.impact_speed <= answer.impact_speed


def test_every_scene_has_an_answer() -> None:
    """No scene of the library is without one."""
    assert sorted(ANSWERS) == library_names()


@pytest.mark.parametrize(("name", "plant"), [_case(name, "multibody") for name in MEMBERS])
def test_a_protocol_s_test_is_passed(name: str, plant: str) -> None:
    """The target is not touched, in tests that leave the time to."""
    assert run(load(name), plant=plant).result.outcome.value == "avoided"


def test_the_members_that_are_driven_come_from_every_family() -> None:
    """Each family is driven."""
    assert all(any(name in family.members for name in MEMBERS) for family in FAMILIES)
