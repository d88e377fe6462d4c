"""Scenes: a scenario that has a name, moved by hand, as the TOML that makes the same run anywhere."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swerve.errors import InputError
from swerve.scenario import FAMILIES, Scenario, library_names, load, parse
from swerve.studio import scene
from swerve.studio.scene import (
    MOST_OBSTACLES,
    MOST_ROWS,
    Moved,
    first_place,
    moved_toml,
    read_scene,
    scenarios,
    start_of,
)
from tests.report.runs import MOST_SHOWN, ONCOMING

PAPER = load("paper").to_toml()
MEMBERS = [name for family in FAMILIES for name in family.members]


@pytest.mark.parametrize("name", [*library_names(), *MEMBERS])
def test_what_is_not_moved_is_the_scenario(name: str) -> None:
    """The TOML of a scenario of the library or of a family, of which nothing is moved, loads as that scenario."""
    assert parse(moved_toml(Moved(scenario=name)).encode(), "scene") == load(name)


def test_what_is_moved_arrives() -> None:
    """Each value is where it belongs, in SI; the goal holds the new speed; the rest is as it was."""
    found = read_scene(
        moved_toml(Moved(scenario="paper", speed="90 km/h", distance=31.5, friction="40 %", offset="-50 cm"))
    )
    expected = load(
        "paper", ["ego.speed=25", "goal.speed=25", "road.friction=0.4", "obstacles.0.position=[31.5, -0.5]"]
    )
    assert found.model_dump(exclude={"name", "description"}) == expected.model_dump(exclude={"name", "description"})
    assert found.name == "paper-moved"
    assert found.description == "paper with speed 90 km/h, obstacle at X = 31.5, friction 40 %, at Y = -50 cm"


def test_a_member_of_a_family_can_be_moved() -> None:
    """What is moved arrives; what the family has set, as when and how its target brakes, stays."""
    found = read_scene(moved_toml(Moved(scenario="ccrb-50-il25", speed="60 km/h", distance="20 m", friction=0.4)))
    base = load("ccrb-50-il25")
    speed, y = 60 / 3.6, base.obstacles[0].to_world().position_at(np.zeros(1))[0, 1]
    changes = [f"ego.speed={speed!r}", f"goal.speed={speed!r}", "road.friction=0.4"]
    expected = load("ccrb-50-il25", [*changes, f"obstacles.0.position=[20, {float(y)!r}]"])
    assert found.model_dump(exclude={"name", "description"}) == expected.model_dump(exclude={"name", "description"})
    assert found.name == "ccrb-50-il25-moved"
    assert found.obstacles[0].accelerates_at == base.obstacles[0].accelerates_at


def test_a_form_starts_where_the_scenario_is() -> None:
    """Moving everything to where it is leaves the scenario, whose obstacle may be absent."""
    start = start_of(load("offset-left"))
    assert start == {"speed": 20.0, "distance": 25.0, "friction": 0.85, "offset": 0.3}
    assert read_scene(moved_toml(Moved(scenario="offset-left", **start))).obstacles == load("offset-left").obstacles
    assert start_of(load("paper", ["obstacles=[]"]))["distance"] is None


@settings(max_examples=25)
@given(x=st.floats(10, 500), y=st.floats(-50, 50))
@pytest.mark.parametrize("overrides", [MOST_SHOWN, ONCOMING], ids=["positions", "way-points"])
def test_obstacles_move_together(overrides: tuple[str, ...], x: float, y: float) -> None:
    """The first one is where it is wanted; at any time all are as far from each other as before."""
    base = load("paper", [*overrides])
    moved = _moved(base, x, y)
    assert first_place(moved) == pytest.approx((x, y))
    times = np.linspace(0, 4, 9)
    before, after = (np.array([each.to_world().position_at(times) for each in one.obstacles]) for one in (base, moved))
    np.testing.assert_allclose(after - after[0], before - before[0], atol=1e-9)


def _moved(base: Scenario, x: float, y: float) -> Scenario:
    """The scenario as if it were one of the library."""
    known = {**scenarios(), "mine": base}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(scene, "scenarios", lambda: known)
        return read_scene(moved_toml(Moved(scenario="mine", distance=x, offset=y)))


@pytest.mark.parametrize(
    ("moved", "message"),
    [
        ({"scenario": "papr"}, "papr: no such scenario; did you mean paper?"),
        ({"scenario": "../paper.toml"}, "no such scenario"),
        ({"scenario": "ccrs-55-il75"}, "ccrs-55-il75: no such scenario; did you mean ccrs-[0-9]+-il75?"),
        ({"scenario": "zzz"}, "zzz: no such scenario; write a name that `swerve scenarios` lists"),
        ({"scenario": "paper", "speed": "90 m"}, "scene: ego.speed: .*90 m"),
        ({"scenario": "paper", "friction": 7}, "scene: road.friction: 7.0 is out of range"),
        ({"scenario": "paper", "distance": "far"}, "scene: distance: 'far'"),
        ({"scenario": "paper", "distance": 1}, "covers the ego vehicle at its start"),
        ({"scenario": "paper", "distance": "90 km"}, "scene: obstacles.0.position.0: 90000.0 is out of range"),
    ],
)
def test_a_move_that_cannot_be_is_told(moved: dict[str, object], message: str) -> None:
    """What is wrong is said by the key and the value, in the words of the scenario's schema."""
    with pytest.raises(InputError, match=message):
        moved_toml(Moved.model_validate(moved))


@pytest.mark.parametrize("tyre", ["/etc/passwd", "secret.toml", "../secret.toml", "./passenger-215-55-r17"])
def test_no_file_is_read(tyre: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A scene that names a tyre's file is refused before anything is opened, whether there is such a file or not."""
    (tmp_path / "secret.toml").write_text("password = 1")
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError, match=r"ego\.tyre: no file is read here"):
        read_scene(PAPER.replace("[ego]\n", f'[ego]\ntyre = "{tyre}"\n'))


def test_a_tyre_of_the_library_is_none() -> None:
    """Its name is no file's."""
    assert read_scene(PAPER.replace("[ego]\n", '[ego]\ntyre = "passenger-215-55-r17"\n')).ego.tyre is not None


def test_more_than_memory_takes_is_refused() -> None:
    """Neither a log of millions of rows nor a crowd of obstacles is begun."""
    with pytest.raises(InputError, match=f"3000000 steps of the plant are more than {MOST_ROWS}"):
        read_scene(PAPER.replace("duration = 5.0", "duration = 300").replace("step = 0.001", "step = 1e-4"))
    head, _, tail = PAPER.partition("[[obstacles]]")
    obstacle, _, tail = tail.partition("[goal]")
    crowd = f"[[obstacles]]{obstacle}" * (MOST_OBSTACLES + 1)
    with pytest.raises(InputError, match=f"obstacles: are {MOST_OBSTACLES + 1}"):
        read_scene(f"{head}{crowd}[goal]{tail}")
