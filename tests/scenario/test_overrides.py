"""`--set KEY=VALUE`."""

import copy
from typing import Any

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from swerve.errors import InputError
from swerve.scenario import Scenario, load
from swerve.scenario.overrides import DEEPEST, Override, apply, parse_override

KEYS = st.text("abcdefgh_", min_size=1, max_size=3)
PATHS = st.lists(KEYS, min_size=1, max_size=4).map(tuple)
TABLES = st.recursive(st.dictionaries(KEYS, st.integers()), lambda below: st.dictionaries(KEYS, below), max_leaves=8)


@pytest.mark.parametrize(
    ("text", "path", "value"),
    [
        ("road.friction=0.4", ("road", "friction"), 0.4),
        ("ego.speed=72 km/h", ("ego", "speed"), "72 km/h"),
        ('ego.speed="72 km/h"', ("ego", "speed"), "72 km/h"),
        ("obstacles.0.position=[1, 2]", ("obstacles", "0", "position"), [1, 2]),
        ("obstacles[0].position=[1, 2]", ("obstacles", "0", "position"), [1, 2]),
        (' name = a=b "c ', ("name",), 'a=b "c'),
        ("name=", ("name",), ""),
        ("name=1\nroad.friction=2", ("name",), "1\nroad.friction=2"),
    ],
)
def test_an_override_is_a_path_and_a_value(text: str, path: tuple[str, ...], value: object) -> None:
    """The value is TOML's where it can be read as one value, else the text itself."""
    assert parse_override(text) == Override(text, path, value)


@pytest.mark.parametrize("text", ["road.friction", "", "=3", "road.=3", ".road=3", "a..b=3", ".".join("a" * 99) + "=1"])
def test_what_is_no_override_is_refused(text: str) -> None:
    """Without "=", without a key, with an empty part or with more parts than any key has, it is an error."""
    with pytest.raises(InputError, match=r"^--set "):
        parse_override(text)


@given(TABLES, PATHS, st.integers())
def test_an_override_sets_one_value_and_nothing_else(tables: dict[str, Any], path: tuple[str, ...], value: int) -> None:
    """The value is found at its path; undoing it at that path leaves what was there; the input stays as it was."""
    before = copy.deepcopy(tables)
    try:
        after = apply(Override("", path, value), tables)
    except InputError:  # the path leads through a value
        after = None
    assert tables == before
    if after is None:
        return
    *above, last = path
    node, was = after, before
    for part in above:
        assert {k: v for k, v in node.items() if k != part} == {k: v for k, v in was.items() if k != part}
        node, was = node[part], was.get(part, {})
    assert node == {**was, last: value}


def test_later_overrides_win() -> None:
    """Overrides are applied in order."""
    assert load("paper", ["road.friction=0.4", "road.friction=0.5"]).road.friction == 0.5


def test_an_override_makes_an_absent_table() -> None:
    """A table or a list entry that the file does not have is made."""
    scenario = load(
        "static-20",
        [
            'controller.as_printed.corrections=["drift"]',
            "obstacles.1.position=[60, 0]",
            "obstacles.1.size=[4, 2]",
        ],
    )
    assert scenario.controller.as_printed.corrections == ("drift",)
    assert [obstacle.position for obstacle in scenario.obstacles] == [(20, 0), (60, 0)]
    assert scenario.controller.weights == load("static-20").controller.weights


def test_an_override_starts_an_absent_list() -> None:
    """Index 0 of a list that was emptied is its first entry."""
    overrides = ["obstacles=[]", "obstacles.0.position=[60, 0]", "obstacles.0.semi_axes=[1, 1]"]
    assert load("paper", overrides).obstacles[0].position == (60, 0)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("ego.speed.x=1", "ego.speed is a value, not a table; write ego.speed=VALUE"),
        ("obstacles.3.position=[1, 1]", "obstacles is a list of length 1; write an index from 0 to 1, which appends"),
        ("obstacles.first.position=[1, 1]", "obstacles is a list of length 1; write an index"),
        (f"obstacles.{'9' * 5000}.position=[1, 1]", "obstacles is a list of length 1; write an index"),
    ],
)
def test_a_path_that_leads_nowhere_is_refused(text: str, message: str) -> None:
    """A path through a value, or to an entry beyond a list's end, is an error that says where it went wrong."""
    with pytest.raises(InputError, match=r"^--set ") as caught:
        load("paper", [text])
    assert message in str(caught.value)


KNOWN = st.sampled_from(
    ["ego.speed", "road.friction", "obstacles", "obstacles.0.position", "name", "ego", "controller"]
)


@given(st.text() | st.builds("{}={}".format, KNOWN, st.text()))
@example("ego.speed=" + "[" * 5000)
@example("ego.speed=" + "9" * 5000)
@example("x" * 100_000 + "=1")
@example(".".join("a" * DEEPEST) + "=1")
@example("ego.\x1b[2J=1")
@example("ego.\udcff=1")
def test_any_text_is_a_scenario_or_one_line(text: str) -> None:
    """No text, however long, deep or odd, gives anything but a scenario or one printable line."""
    try:
        assert isinstance(load("paper", [text]), Scenario)
    except InputError as error:
        assert str(error).isprintable()
        assert len(str(error)) < 2000
