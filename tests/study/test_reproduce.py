"""The reproduction of the paper: what its runs must come to, whatever their exact numbers."""

from functools import cache
from math import radians

import pytest

from swerve.scenario import CORRECTIONS, load
from swerve.simulate import Outcome, Result
from swerve.study.ablation import SCENES, ablate
from swerve.study.reproduce import Reproduction, reproduce
from swerve.study.variants import VARIANTS

ROWS = ("as printed", *(f"+ {name}" for name in CORRECTIONS), "unified, bare", "+ slip limit, trust region", "unified")


@cache
def _reproduction() -> tuple[Reproduction, list[float]]:
    """All of it, and the progress that it told."""
    told: list[float] = []
    return reproduce(told.append), told


def _result(row: str, scene: str) -> Result:
    rows = {each.variant.name: each.results for each in _reproduction()[0].ablation.rows}
    return rows[row][[each.name for each in SCENES].index(scene)]


def test_the_table_goes_from_the_print_to_the_working_controller() -> None:
    """A row for the print, one for each correction in turn, and the unified controller; a result for each scene."""
    ablation = _reproduction()[0].ablation
    assert tuple(row.variant.name for row in ablation.rows) == ROWS
    for row in ablation.rows:
        assert [result.scenario for result in row.results] == ["paper", "offset-right", "static-40"]
        assert {result.controller for result in row.results} == {row.variant.controller}


def test_every_row_says_what_it_changed() -> None:
    """Each has a sentence of its own, and no two rows are the same controller with the same settings."""
    assert len({variant.change for variant in VARIANTS}) == len(VARIANTS)
    assert len({(variant.controller, variant.overrides) for variant in VARIANTS}) == len(VARIANTS)
    for n, variant in enumerate(VARIANTS[: len(CORRECTIONS) + 1]):
        assert load("paper", variant.overrides).controller.as_printed.corrections == CORRECTIONS[:n]


def test_the_print_drives_through_the_obstacle() -> None:
    """As printed the car does not even steer; its path goes through the middle."""
    printed = _result("as printed", "paper")
    assert printed.outcome is Outcome.COLLIDED
    assert printed.min_distance_ratio is not None and printed.min_distance_ratio < 0.05
    assert printed.impact_speed == pytest.approx(20.0)


def test_with_the_drift_programs_have_no_solution() -> None:
    """With the drift the first-order wall stands half way, and many programs that had a solution have none."""
    assert _result("+ mass", "paper").solver_failures < 5
    for name in CORRECTIONS[1:]:
        result = _result(f"+ {name}", "paper")
        assert 20 <= result.solver_failures == result.fallback_steps <= 40


@pytest.mark.parametrize("scene", ["paper", "offset-right"])
def test_no_set_of_corrections_avoids_what_cannot_be_braked_for(scene: str) -> None:
    """All corrections together collide at full speed, on the obstacle's line as beside it, as the print does."""
    for row in ROWS[: len(CORRECTIONS) + 1]:
        assert _result(row, scene).outcome is Outcome.COLLIDED
        assert _result(row, scene).impact_speed == pytest.approx(20.0)


def test_with_the_drift_it_brakes_where_there_is_room() -> None:
    """At 40 m the print collides and the drift makes it brake; full Jacobians keep it from steering to the lock."""
    assert _result("+ mass", "static-40").outcome is Outcome.COLLIDED
    for name in CORRECTIONS[1:]:
        assert _result(f"+ {name}", "static-40").outcome is Outcome.AVOIDED
    assert _result("+ hold-input", "static-40").max_steer > radians(20)
    assert _result("+ jacobian", "static-40").max_steer < radians(1)
    assert _result("+ discretisation", "static-40").solver_failures == 0


@pytest.mark.parametrize("scene", [scene.name for scene in SCENES])
def test_the_unified_controller_avoids_every_obstacle(scene: str) -> None:
    """Without contact at any millisecond, and without a step that failed."""
    unified = _result("unified", scene)
    assert unified.outcome is Outcome.AVOIDED
    assert unified.min_distance_ratio is not None and unified.min_distance_ratio >= 1.0
    assert unified.fallback_steps == 0


def test_the_limits_on_slip_and_step_save_steering() -> None:
    """Without slip limit and trust region the bare program steers further for the same obstacle."""
    assert _result("unified, bare", "paper").max_steer > _result("+ slip limit, trust region", "paper").max_steer


def test_the_paper_s_run_is_on_the_full_vehicle() -> None:
    """The run behind figures 7 to 10 is the unified controller's, on the multibody plant, and avoids."""
    result = _reproduction()[0].paper.result
    assert (result.controller, result.plant, result.outcome.value) == ("unified", "multibody", "avoided")


def test_progress_goes_from_nothing_to_all() -> None:
    """The shares that are told grow from below 1 % to 1."""
    told = _reproduction()[1]
    assert told == sorted(told)
    assert told[0] < 0.01
    assert told[-1] == pytest.approx(1.0)


def test_a_smaller_table_can_be_asked_for() -> None:
    """Rows and columns are the caller's to choose."""
    small = ablate(lambda share: None, VARIANTS[:1], SCENES[1:2])
    assert [result.scenario for result in small.rows[0].results] == ["offset-right"]
