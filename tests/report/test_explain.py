"""What `swerve run --explain` says: every change of mind, and nothing in between."""

from dataclasses import replace

import numpy as np
import pytest

from swerve.cli import main
from swerve.control import Branch, Fallback, Passing, Plan
from swerve.report.explain import explanation
from tests.report.runs import made

NOTHING = np.zeros((20, 5))


def plan(time: float, name: str, **changes: object) -> Plan:
    """A plan of this name."""
    return replace(Plan(time, NOTHING, np.zeros((21, 6)), name=name, reason="because"), **changes)  # type: ignore[arg-type]


def told(*plans: Plan) -> list[str]:
    """The lines for a run with these plans."""
    return explanation(replace(made(), plans=plans)).splitlines()


def test_each_change_is_told_once() -> None:
    """A step that decides as the one before is not told again; a way taken up again is."""
    lines = told(plan(0.0, "keep"), plan(0.05, "keep"), plan(0.1, "left"), plan(0.15, "left"), plan(0.2, "keep"))
    assert lines[0] == "decisions: 3 moments in 5 steps"
    assert [line.split("s  ")[1] for line in lines[1:]] == ["keep: because", "left: because", "keep: because"]


def test_a_fallback_is_told_with_its_reason() -> None:
    """Not with the reason of the plan that it follows."""
    lines = told(plan(0.0, "left"), plan(0.05, "left", fallback=Fallback.NO_SOLUTION))
    assert lines[-1].endswith(f"left: fallback: {Fallback.NO_SOLUTION.value}")


def test_a_branch_is_told_with_what_is_wrong_with_it() -> None:
    """Its cost, and by how much it misses, touches and leaves the road; clear where it does none of these."""
    good = Branch("left", (Passing.LEFT,), 1234.5, 0.0, 0.0, None, np.zeros((1, 3)))
    bad = Branch("brake", (Passing.BEHIND,), 9.0, 0.25, 1.5, 7.04, np.zeros((1, 3)))
    lines = told(plan(0.0, "left", branches=(good, bad), active=("slip",)))
    assert lines[2].strip() == "left: costs 1234, clear"
    assert lines[3].strip() == "brake: costs 9, misses a margin by 0.250 m, touches at 7.0 m/s, 1.50 m off the road"
    assert lines[4].strip() == "held by slip"


def test_the_command_tells_it(capsys: pytest.CaptureFixture[str]) -> None:
    """After the summary; with --json on the other stream, so that the object stays alone."""
    assert main(["run", "paper", "--plant", "planar", "--set", "duration=0.2 s", "--explain", "--json"]) == 0
    printed = capsys.readouterr()
    assert printed.out.count("\n") == 1
    assert "decisions:" in printed.err
    assert "the only one" in printed.err or "the cheapest" in printed.err
