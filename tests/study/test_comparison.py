"""Controllers side by side: each row is that of a run alone."""

from dataclasses import replace
from typing import Any

import pytest

from swerve.errors import InputError
from swerve.scenario import load
from swerve.simulate import Outcome, Result, run
from swerve.study.comparison import Comparison, Entry, Group, check, compare
from tests.report.results import RESULT
from tests.report.runs import made

SHORT = ("duration=0.5 s", "obstacles=[{position=[25, 0], size=[4, 2]}]")
TIMES = ("step_time", "wall_time")  # depend on the machine


def _compared(*overrides: str) -> Comparison:
    scenarios = [load(name, [*SHORT, *overrides]) for name in ("paper", "wet")]
    return compare(scenarios, ("as-printed", "hierarchical", "brake"), "planar", 3, lambda share: None)


def without_times(row: dict[str, Any]) -> dict[str, Any]:
    """What does not depend on the machine."""
    return {key: value for key, value in row.items() if key not in TIMES}


def test_a_row_is_that_of_the_run_alone() -> None:
    """Scenario by scenario and controller by controller, every number but times is that of a run on its own."""
    rows = iter(_compared().to_json()["runs"])
    for name in ("paper", "wet"):
        for controller in ("as-printed", "hierarchical", "brake"):
            alone = run(load(name, SHORT), controller, "planar", 3).result.to_json()
            row = without_times(next(rows))
            assert (row.pop("refusal"), row.pop("best")) == (None, True)
            assert row == without_times(alone)
    assert next(rows, None) is None


def test_a_controller_that_refuses_is_a_row() -> None:
    """One that cannot be told of the scenario's mode has its reason in its row and nulls; the others are run."""
    rows = _compared("actuation.mode=brakes-only").to_json()["runs"]
    assert [row["refusal"] is None for row in rows] == [False, False, True] * 2
    refused = rows[1]
    assert refused["refusal"].startswith("actuation.mode: hierarchical knows no brakes-only")
    told = {"scenario": "paper", "controller": "hierarchical", "plant": "planar", "seed": 3, "best": False}
    assert told.items() <= refused.items()
    assert {refused[key] for key in rows[2] if key not in {*told, "version", "refusal"}} == {None}


def test_progress_rises_to_the_whole() -> None:
    """It is told in every sample of every run, and ends at 1."""
    told: list[float] = []
    compare([load("paper", SHORT)], ("brake", "driver"), "planar", 0, told.append)
    assert told == sorted(told)
    assert (len(told), told[-1]) == (20, 1.0)


def _entry(outcome: Outcome, impact_speed: float | None = None) -> Entry:
    result: Result = replace(RESULT, outcome=outcome, impact_speed=impact_speed)
    done = made()
    return Entry(done.scenario, "unified", "planar", 7, replace(done, result=result), None)


@pytest.mark.parametrize("n", range(6))
def test_the_best_outcome_is_the_mildest(n: int) -> None:
    """Avoided is better than spun, than left the road, than a slow impact, than a fast one, than a diverged run."""
    order = [
        _entry(Outcome.AVOIDED),
        _entry(Outcome.SPUN),
        _entry(Outcome.LEFT_ROAD),
        _entry(Outcome.COLLIDED, 1.0),
        _entry(Outcome.COLLIDED, 9.0),
        _entry(Outcome.DIVERGED),
    ]
    refusal = Entry(made().scenario, "nonlinear", "planar", 7, None, "no compiler")
    group = Group(made().scenario, (refusal, *order[:n:-1], order[n]))
    assert [each for each in group.entries if group.is_best(each)] == [order[n]]


def test_those_that_end_alike_are_all_best() -> None:
    """Two that avoid are both the best, however near they came."""
    both = (_entry(Outcome.AVOIDED), _entry(Outcome.AVOIDED))
    assert all(Group(made().scenario, both).is_best(each) for each in both)


def test_scenarios_are_told_apart_by_name() -> None:
    """Two of one name are refused, as are those that the plant cannot drive; the message names the scenario."""
    with pytest.raises(InputError, match=r"^paper: 2 of the scenarios have this name"):
        check([load("paper"), load("wet"), load("paper", SHORT)], "planar")
    with pytest.raises(InputError, match=r"^ice-patch: road.patches: the planar plant has one friction"):
        check([load("paper"), load("ice-patch")], "planar")
    check([load("paper"), load("ice-patch")], "multibody")
