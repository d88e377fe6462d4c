"""The survey of random scenes: what is counted, and a seeded part of it."""

from functools import cache

import pytest

from swerve.report.random_scenes import as_markdown, write_survey
from swerve.scenario.loader import load
from swerve.simulate import Outcome
from swerve.study.random_scenes import Survey, survey, try_scene

N_SCENES, N_QUIET = 5, 4


@cache
def _survey() -> tuple[Survey, list[float]]:
    """A small one, and the progress that it told."""
    told: list[float] = []
    return survey("planar", 0, told.append, n_scenes=N_SCENES, n_quiet=N_QUIET), told


def test_every_scene_drawn_is_accounted_for() -> None:
    """Run, harmless or uncertain; each that is run has a certificate, and a quiet one none."""
    done, _ = _survey()
    assert (len(done.trials), len(done.quiet)) == (N_SCENES, N_QUIET)
    assert done.drawn == len(done.trials) + done.harmless + done.uncertain
    assert all(trial.certificate for trial in done.trials)
    assert not any(trial.certificate for trial in done.quiet)


def test_the_progress_goes_to_one() -> None:
    """In steps that never go back."""
    told = _survey()[1]
    assert told == sorted(told)
    assert told[-1] == 1


def test_commands_are_within_their_limits() -> None:
    """In every scene."""
    done, _ = _survey()
    assert all(trial.is_within_limits for trial in (*done.trials, *done.quiet))


def test_nothing_is_done_in_quiet_scenes() -> None:
    """No decision, no steering angle to speak of, no force to speak of."""
    assert not _survey()[0].interventions


def test_a_disc_in_the_way_is_an_intervention_and_a_collision_has_its_cause() -> None:
    """The paper's scene is no quiet one; and one that nothing can avoid fails by the obstacle's kind."""
    trial = try_scene(load("paper"), "planar", None)
    assert trial.is_avoided
    assert trial.intervenes
    hit = try_scene(load("paper", ["obstacles.0.position=[6, 0]", "duration=1"]), "planar", None)
    assert (hit.outcome, hit.cause, hit.impact_obstacle) == (Outcome.COLLIDED, "collided: static", 0)


def test_the_files_tell_what_failed_and_replay_it(tmp_path) -> None:
    """The table counts it by its cause, and its scene is a file that loads to the same scene."""
    done, _ = _survey()
    hit = try_scene(load("paper", ["obstacles.0.position=[6, 0]", "duration=1"]), "planar", None)
    failed = Survey("planar", 0, 9, 3, 5, (hit,), done.quiet)
    paths = write_survey([failed], tmp_path)
    assert {path.name for path in paths} == {"random_scenes.md", "paper-planar.toml"}
    assert load(tmp_path / "paper-planar.toml") == hit.scene
    text = as_markdown([failed])
    assert "| `planar` | collided: static | 1 |" in text
    assert "| avoided | 0 (0.0%) |" in text


@pytest.mark.parametrize("index", [0, 1])
def test_a_survey_is_the_same_again(index: int) -> None:
    """Scenes and outcomes follow from the seed."""
    first = _survey()[0].trials[index]
    again = try_scene(first.scene, "planar", first.certificate)
    assert (again.outcome, again.min_clearance) == (first.outcome, first.min_clearance)
