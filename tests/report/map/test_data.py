"""The document of a map: its numbers are the map's, and its commands and links lead to the same scene."""

import json
import shlex
from itertools import pairwise
from pathlib import Path
from urllib.parse import parse_qsl, urlsplit

import pytest

from swerve.cli import main
from swerve.report.map.commands import Source, limit_command, run_command, studio_link
from swerve.report.map.data import document
from swerve.report.map.summary import bought, most_bought, ratio
from swerve.report.page.single_file import embedded
from swerve.scenario import load
from swerve.studio.scene import Moved, moved_toml, read_scene
from swerve.study.limit.scene import Scene
from swerve.study.map.boundary import Condition
from swerve.study.map.cell import Cell
from tests.report.map.maps import EXTENT, HALF_WIDTH, LIMITS, SHARES, SOURCE, made, nearest, reached

GRAVITY = 9.81  # [m/s^2]
SEVERAL = (
    "obstacles=[{position=[30, 0], semi_axes=[2, 2]},"
    " {size=[4, 1.8], waypoints=[{time=0, position=[50, 3]}, {time=2, position=[55, 3]}]}]"
)


def _overrides(command: str) -> list[str]:
    words = shlex.split(command)
    return [after for word, after in pairwise(words) if word == "--set"]


def test_every_number_is_the_map_s() -> None:
    """Each line has the boundaries of its series by speed; each run is there once, exactly as the map has it."""
    found = made(offsets=(0.0, 0.5))
    content = json.loads(embedded(document(found, SOURCE, ())))
    names = [each["name"] for each in content["series"]]
    assert names == [*SHARES, *LIMITS]
    assert len(content["panels"]) == 8
    for panel in content["panels"]:
        for who, line in zip(names, panel["lines"], strict=True):
            cells = [Condition(speed, panel["friction"], panel["offset"]) for speed in panel["speeds"]]
            assert line == [boundary.avoided for each in cells if (boundary := found.boundary(who, each))]
    runs = [
        point | {"panel": panel} for panel in content["panels"] for point in panel["points"] if point["kind"] == "run"
    ]
    told = {
        (names[each["series"]], each["speed"], each["panel"]["friction"], each["panel"]["offset"], each["distance"])
        for each in runs
    }
    assert told == {
        (run.who, run.condition.speed, run.condition.friction, run.condition.offset, run.distance) for run in found.runs
    }
    assert len(runs) == len(found.runs)
    assert sum(each["is_last"] for each in runs) == sum(
        each.avoided is not None and each.who in SHARES for each in found.boundaries
    )


def test_closed_forms_are_the_formulas() -> None:
    """On the page stand v^2 / (2 mu g) before contact, and v sqrt(2 w / (mu g)) with what the offset leaves of w."""
    for panel in document(made(offsets=(0.0, -0.5)), SOURCE, ())["panels"]:
        grip, width = panel["friction"] * GRAVITY, HALF_WIDTH - abs(panel["offset"])
        for speed, braking, swerving in zip(*panel["closed"].values(), strict=True):
            assert braking - EXTENT == pytest.approx(speed**2 / (2 * grip), rel=2e-3)
            assert swerving == pytest.approx(speed * (2 * width / grip) ** 0.5, rel=1e-3)


def test_a_command_makes_the_same_scene() -> None:
    """What a point's command loads is the scene that the map has run: obstacle by obstacle, with its duration."""
    source, condition = Source("paper", (SEVERAL, "road.lane_width=3.5")), Condition(23.7, 0.45, 0.3)
    words = run_command(made(), source, "unified", condition, 31.4159)
    again = load("paper", _overrides(words))
    assert again == Cell.of(load("paper", source.overrides), condition).at(31.4159)
    assert Scene.of(again).distance == pytest.approx(31.4159, abs=1e-6)
    assert shlex.split(words)[:3] == ["swerve", "run", "paper"]
    assert shlex.split(words)[-8:] == ["--controller", "unified", "--plant", "planar", "--seed", "0", "--out", "replay"]


def test_a_command_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Typed as it stands, a point's command writes a run with its controller on the map's plant."""
    monkeypatch.chdir(tmp_path)
    words = run_command(made(), SOURCE, "brake", Condition(10.0, 0.85, 0.0), 20.0)
    assert main([*shlex.split(words)[1:], "--quiet"]) == 0
    result = json.loads((tmp_path / "replay" / "result.json").read_text())
    assert (result["controller"], result["plant"], result["outcome"]) == ("brake", "planar", "avoided")


def test_limits_are_found_again_by_their_means() -> None:
    """The command of a limit names its means and moves the scene, but not the obstacle along X."""
    words = limit_command(SOURCE, ["limit: both", "limit: individual"], Condition(20.0, 0.5, 0.0))
    moved = ("ego.speed=20.0", "goal.speed=20.0", "road.friction=0.5")
    assert _overrides(words) == [*moved]
    assert words.startswith("swerve limit paper --set ")
    assert words.endswith(" --means both,individual")
    assert limit_command(SOURCE, ["limit: point-mass"], Condition(20.0, 0.5, 0.0)).endswith("--means braking")


@pytest.mark.parametrize("source", [SOURCE, Source("ccrm-60-il25")])
def test_the_studio_has_the_same_scene(source: Source) -> None:
    """What a point's link says makes in the studio the scene of the map, but for its name and description."""
    condition = Condition(23.7, 0.45, 0.3)
    link = studio_link(made(), source, "unified", condition, 31.4159)
    assert link is not None
    wanted = dict(parse_qsl(urlsplit(link).query))
    assert {key: wanted.pop(key) for key in ("controller", "plant", "seed")} == {
        "controller": "unified",
        "plant": "planar",
        "seed": "0",
    }
    name = wanted.pop("scenario")
    scene = read_scene(moved_toml(Moved(scenario=name, **{key: float(value) for key, value in wanted.items()})))
    there = Cell.of(source.base, condition).at(31.4159)
    assert scene.model_copy(update={"name": there.name, "description": there.description}) == there


def test_the_studio_is_not_asked_for_what_it_has_not() -> None:
    """A scenario of one's own, or one with values replaced, has no link to the studio."""
    assert (
        studio_link(made(), Source("paper", ("road.friction=0.4",)), "unified", Condition(20.0, 0.5, 0.0), 20.0) is None
    )


def test_ratios_and_what_torques_buy() -> None:
    """A ratio is to the limit with a torque on every wheel; what these buy is the other limit less that one."""
    found = made()
    for condition in found.conditions:
        assert ratio(found, "unified", condition) == pytest.approx(1.04)
        assert bought(found, condition) == pytest.approx(0.03 * nearest(condition))
    assert ratio(found, "hierarchical", Condition(35.0, 0.3, 0.0)) is None
    assert most_bought(found) == (pytest.approx(0.03 * nearest(Condition(35.0, 0.3, 0.0))), Condition(35.0, 0.3, 0.0))
    assert reached("unified", Condition(35.0, 0.3, 0.0)) > 40


def test_a_map_without_limits_has_a_document() -> None:
    """Without limits there is neither a ratio nor anything that the torques buy."""
    content = document(made(controllers=("unified",), limits=(), frictions=(0.85,)), SOURCE, ())
    assert content["bought"] == []
    assert {point["of_limit"] for point in content["panels"][0]["points"]} == {None}
