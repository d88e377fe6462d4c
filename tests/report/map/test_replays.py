"""The pages of a map's conditions, and the links that lead to them."""

import re
from pathlib import Path

import pytest

from swerve.report.map import Source, write_map, write_replays
from swerve.report.map.replays import replay_name
from swerve.study.map.boundary import Condition
from tests.report.map.maps import SOURCE, made
from tests.report.runs import made as made_run

CONDITION = Condition(20.0, 0.85, 0.0)
FOUND = made(speeds=(15.0, 20.0), frictions=(0.85,))


def test_links_lead_to_the_pages_that_are_there(tmp_path: Path) -> None:
    """Each condition with runs has its page, to which the map's page links; it links to no other file."""
    runs = {CONDITION: [made_run(), made_run(controller="unified")], Condition(15.0, 0.85, 0.0): []}
    paths = write_replays(runs, tmp_path)
    assert paths == [tmp_path / "replays" / replay_name(CONDITION)]
    assert [*(tmp_path / "replays").iterdir()] == paths
    write_map(FOUND, tmp_path / "map.html", SOURCE, [CONDITION])
    text = (tmp_path / "map.html").read_text(encoding="utf-8")
    assert set(re.findall(r'"(?:href=")?(replays/[^"]+)"', text)) == {f"replays/{replay_name(CONDITION)}"}


def test_conditions_have_names_of_their_own() -> None:
    """No two conditions of a map share a page."""
    found = made(offsets=(-0.5, 0.0, 0.5))
    assert len({replay_name(each) for each in found.conditions}) == len(found.conditions)


def test_runs_of_two_scenes_are_refused(tmp_path: Path) -> None:
    """Runs of one condition that are not of one scene leave nothing behind."""
    with pytest.raises(ValueError, match="same road, obstacles"):
        write_replays({CONDITION: [made_run(), made_run("obstacles=[]")]}, tmp_path / "new")
    assert not (tmp_path / "new").exists()


def test_a_scenario_of_one_s_own_is_a_source(tmp_path: Path) -> None:
    """A map of a file names the file in its commands, quoted, with the overrides that were given, and no studio."""
    path = tmp_path / "my scene.toml"
    path.write_text(SOURCE.base.to_toml())
    write_map(FOUND, tmp_path / "map.html", Source(str(path), ("road.lane_width=3.5",)))
    text = (tmp_path / "map.html").read_text(encoding="utf-8")
    assert f"swerve run '{path}' --set road.lane_width=3.5 --set ego.speed=20.0" in text
    assert "/studio?" not in text
