"""The document that the page is made of: the run's numbers, its motion, its plans."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from swerve.report import result_json
from swerve.report.exports.folder import read_run_folder
from swerve.report.page.data import document, names
from swerve.report.page.motion import MOST_ROWS, Motion
from swerve.report.page.obstacles import obstacles_in_words
from swerve.report.page.plans import MOST_POINTS
from swerve.report.page.scene import scene_json
from swerve.report.page.single_file import embedded
from swerve.scenario import load
from swerve.scenario.obstacle import ObstacleSettings
from swerve.simulate import Log, Run, Table
from swerve.simulate.result import Divergence
from swerve.vehicle import vehicle_named
from tests.report.exports.folders import write_folder
from tests.report.page.ways import with_ways
from tests.report.runs import FAILING, MOST_SHOWN, made

CAR = vehicle_named("d-class-sedan")


def _diverged() -> Run:
    """A run whose last samples are no numbers."""
    done = made()
    motion = {name: values.copy() for name, values in done.log.motion.columns.items()}
    for name in ("vx", "vy", "r", "psi", "X", "Y"):
        motion[name][600:] = np.nan
    log = Log(Table(motion, done.log.motion.units), done.log.steps)
    states = log.motion.stack("vx", "vy", "r", "psi", "X", "Y")
    return replace(done, log=log, result=replace(done.result, divergence=Divergence.of(states, log.motion["time"])))


def test_the_numbers_are_the_result_s() -> None:
    """Every number of the result is in the document exactly as in result.json."""
    done = made(controller="unified")
    (car,) = json.loads(embedded(document([done])))["cars"]
    assert car["result"] == json.loads(result_json(done.result))


def test_charts_reach_the_results_extremes() -> None:
    """The rows that are shown hold the rows in which results were measured: their extremes agree."""
    done = with_ways(duration="2 s")
    motion, result = document([done])["cars"][0]["motion"], done.result
    assert min(motion["clearance"]) == pytest.approx(result.min_clearance, abs=1e-4)
    assert max(motion["Y"]) == pytest.approx(result.lateral_offset.max, abs=1e-3)
    assert min(motion["speed"]) == pytest.approx(result.speed.min, abs=1e-4)
    for name, largest in (("beta", result.max_sideslip), ("r", result.max_yaw_rate), ("delta", result.max_steer)):
        assert max(map(abs, motion[name])) == pytest.approx(largest, abs=1e-5)


@pytest.mark.parametrize("duration", ["0.05 s", "3 s", "12 s"])
def test_rows_are_few_and_in_order(duration: str) -> None:
    """Times rise from the first to the last of the log; a long run has no more rows than a screen can show."""
    done = made(f"duration={duration}", "obstacles=[]")
    time = document([done])["cars"][0]["motion"]["time"]
    assert np.all(np.diff(time) > 0)
    assert (time[0], time[-1]) == (0.0, pytest.approx(done.log.motion["time"][-1]))
    assert len(time) <= MOST_ROWS + 40
    assert np.diff(time).max() <= 0.0121


def test_torque_is_force_times_radius() -> None:
    """At every instant the four torques are the logged forces times the rolling radius."""
    done = made(controller="unified")
    expected = done.log.motion.stack("Fx_fl", "Fx_fr", "Fx_rl", "Fx_rr") * CAR.wheel_radius
    np.testing.assert_allclose(Motion.of(done).wheels["torque"], expected)


def test_obstacles_are_where_they_were() -> None:
    """An obstacle that moves has a track that is its motion; one at rest has a single row."""
    resting, moving = document([made(*MOST_SHOWN, controller="unified")])["scene"]["obstacles"]
    assert (resting["X"], resting["Y"], resting["psi"]) == ([20.0], [0.2], [pytest.approx(np.radians(6), abs=1e-4)])
    np.testing.assert_allclose(moving["X"], 45 - 5 * np.array(moving["time"]), atol=1e-3)
    assert moving["time"][-1] == 1.0


def test_every_step_has_its_ways() -> None:
    """Each step has its plan's path and every way that was tried, thinned, from the same start to the same end."""
    done = with_ways(duration="1 s")
    plans = document([done])["cars"][0]["plans"]
    assert len(plans) == len(done.plans)
    for shown, plan in zip(plans, done.plans, strict=True):
        assert shown["branches"][shown["taken"]]["name"] == plan.name
        assert [branch["name"] for branch in shown["branches"]] == [branch.name for branch in plan.branches]
        for branch, tried in zip(shown["branches"], plan.branches, strict=True):
            path = np.reshape(branch["path"], (-1, 3))
            assert 2 <= len(path) <= MOST_POINTS
            np.testing.assert_allclose(path[[0, -1]], tried.poses[[0, -1]], atol=6e-3)
            assert branch["cost"] == tried.cost


def test_a_run_from_its_files_has_all_but_paths(tmp_path: Path) -> None:
    """What is read back tells each step's decision as the run itself did; where the ways led is not in the log."""
    done = with_ways(duration="1 s")
    (made_now,) = document([done])["cars"]
    (read_back,) = document([read_run_folder(write_folder(done, tmp_path))])["cars"]
    for each in made_now["plans"]:
        each |= {"path": [], "taken": None, "branches": [{**branch, "path": []} for branch in each["branches"]]}
    assert read_back == made_now


MOVING = (
    ({"position": [30, 1], "velocity": [0, 0]}, "at (30, 1) m, at rest"),
    ({"position": [30, 0], "velocity": [10, 0], "name": "van"}, "at (30, 0) m, at 36 km/h"),
    (
        {"position": [30, 0], "velocity": [20, 0], "acceleration": [-6, 0], "accelerates_at": 1, "final_speed": 5},
        "at (30, 0) m, at 72 km/h, brakes with 6 m/s² from 1 s on to 18 km/h",
    ),
    ({"position": [30, 0], "acceleration": [3, 0]}, "at (30, 0) m, at rest, accelerates with 3 m/s²"),
    (
        {"position": [30, -4], "velocity": [0, 1.5], "moves_at": 0.8},
        "at (30, -4) m, at rest until 0.8 s, then at 5.4 km/h",
    ),
    (
        {"waypoints": [{"time": t, "position": [20 + 10 * t, 3.5 - t]} for t in (0, 1, 3)]},
        "from (20, 3.5) m at 0 s through 1 more to (50, 0.5) m at 3 s",
    ),
)


@pytest.mark.parametrize(("keys", "words"), MOVING)
def test_an_obstacle_s_motion_is_told(keys: dict[str, Any], words: str) -> None:
    """Each kind of motion has its words, behind name, shape and size."""
    obstacle = ObstacleSettings.model_validate({**keys, "size": [4, 1.8]})
    name = f"{keys['name']}, " if "name" in keys else ""
    assert obstacles_in_words([obstacle]) == f"{name}box 4 m \N{MULTIPLICATION SIGN} 1.8 m {words}"


def test_oncoming_lanes_have_a_line_of_their_own() -> None:
    """The line between the directions is told apart from those between lanes."""
    scenario = load(
        "paper", ["road.lane_width=3.5", "road.lanes_left=2", "road.lanes_right=1", "road.lanes_oncoming=1"]
    )
    road = scene_json([scenario], 1.0)["road"]
    assert road == {"edges": [-5.25, 8.75], "lines": [-1.75, 1.75], "oncoming": 5.25}
    assert scene_json([load("paper")], 1.0)["road"]["oncoming"] is None


def test_a_run_that_diverged_is_shown_up_to_there() -> None:
    """Nothing that is no motion is in the document, which stays plain JSON; the verdict says when."""
    (car,) = json.loads(embedded(document([_diverged()])))["cars"]
    assert car["motion"]["time"][-1] == pytest.approx(0.599)
    assert all(np.isfinite(car["motion"][name]).all() for name in ("X", "Y", "psi", "speed"))


def test_the_verdict_is_a_sentence() -> None:
    """It says what the vehicle did, how near it came, and how much of the friction it took."""
    avoided = document([with_ways(duration="3 s")])["cars"][0]["verdict"]
    assert avoided.startswith("The vehicle ")
    assert " clear, using up to " in avoided
    assert avoided.endswith("\N{NO-BREAK SPACE}% of a tyre's friction.")
    hit = document([made("duration=2 s")])["cars"][0]["verdict"]
    assert " and hit an obstacle at " in hit
    assert " km/h after 1." in hit


def test_steps_of_the_fallback_say_why() -> None:
    """A step that the fallback answered has its sentence, and is a moment of the run."""
    (car,) = document([made(FAILING)])["cars"]
    assert "no program of this step was solved" in car["steps"]["fallback"]
    assert "first fallback" in [each["words"] for each in car["moments"]]


def test_nothing_in_a_document_ends_its_element() -> None:
    """Whatever words a document has, no tag can begin in it, and it reads back as it was."""
    words = {"name": "</script><script>alert(1)</script> <!-- & \u2028 ü 雪"}
    text = embedded(words)
    assert not set(text) & set("<>&\u2028")
    assert json.loads(text) == words


def test_cars_are_named_by_what_differs() -> None:
    """Controllers name the cars; where plants or seeds differ between them, these too."""
    one, other = made(), made(controller="unified")
    assert names([one, other]) == ["as-printed", "unified"]
    assert names([one, made(seed=1)]) == ["as-printed, seed 0", "as-printed, seed 1"]


def test_cars_of_one_page_share_a_scene() -> None:
    """Runs among other obstacles are refused."""
    with pytest.raises(ValueError, match="same road, obstacles"):
        document([made(), made("obstacles=[]")])
