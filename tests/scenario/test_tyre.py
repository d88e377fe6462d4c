"""The tyre of a scenario: by name, from a file, written out, and refused."""

from pathlib import Path

import pytest

from swerve.errors import InputError
from swerve.scenario import load, parse
from swerve.scenario.tyre import TyreSettings, load_tyre
from swerve.vehicle import TYRES, VEHICLES, Tyre, vehicle_named

SOFT = Tyre(b0=9.0, b1=-1e-4, c0=1.3, c1=1e-6, d0=0.9, d1=-5e-6)
SOFT_FILE = TyreSettings.of("soft", "made for a test", SOFT).to_toml()
PAPER = load("paper").to_toml()


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A working directory with a folder, and in it a scenario beside the file of a tyre."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "cases").mkdir()
    (tmp_path / "cases" / "soft.toml").write_text(SOFT_FILE)
    (tmp_path / "cases" / "case.toml").write_text(PAPER.replace("[ego]", '[ego]\ntyre = "soft.toml"'))
    return tmp_path / "cases"


def test_the_vehicle_has_its_own_tyre_by_default() -> None:
    """A scenario that says nothing of tyres leaves the vehicle's, and does not write one."""
    scenario = load("paper")
    assert scenario.ego.to_vehicle().tyre == vehicle_named("d-class-sedan").tyre
    assert "tyre" not in scenario.to_toml()


@pytest.mark.parametrize("name", TYRES)
def test_a_tyre_of_the_library_by_its_name(name: str) -> None:
    """`ego.tyre` names one, on any vehicle that it carries."""
    assert load("paper", [f"ego.tyre={name}"]).ego.to_vehicle().tyre == TYRES[name]


@pytest.mark.parametrize("name", VEHICLES)
def test_every_vehicle_of_the_library_has_a_tyre_that_carries_it(name: str) -> None:
    """So that every vehicle can be in a scenario."""
    assert load("paper", [f"ego.vehicle={name}"]).ego.to_vehicle().name == name


def test_a_file_beside_the_scenario(folder: Path) -> None:
    """A path is looked for in the scenario's folder, whatever the working directory."""
    assert load(folder / "case.toml").ego.to_vehicle().tyre == SOFT


def test_a_file_in_the_working_directory(folder: Path) -> None:
    """What is not in the scenario's folder is looked for in the working directory."""
    assert load("paper", ["ego.tyre=cases/soft.toml"]).ego.to_vehicle().tyre == SOFT
    (folder.parent / "other.toml").write_text(SOFT_FILE.replace("9.0", "10.0"))
    assert load(folder / "case.toml", ["ego.tyre=other.toml"]).ego.to_vehicle().tyre.b0 == 10.0
    (folder / "other.toml").write_text(SOFT_FILE.replace("9.0", "11.0"))
    assert load(folder / "case.toml", ["ego.tyre=other.toml"]).ego.to_vehicle().tyre.b0 == 11.0


def test_a_scenario_holds_the_numbers(folder: Path) -> None:
    """Written out, a scenario has its tyre in it, and runs again where the file is gone."""
    scenario = load(folder / "case.toml")
    (folder / "soft.toml").unlink()
    again = parse(scenario.to_toml().encode(), "written.toml")
    assert again == scenario
    assert again.ego.tyre is not None
    assert (again.ego.tyre.name, again.ego.to_vehicle().tyre) == ("soft", SOFT)


def test_a_tyre_survives_its_own_toml(folder: Path) -> None:
    """Written and read again, a tyre is equal to itself, to the last bit."""
    tyre = load_tyre(folder / "soft.toml")
    assert tyre.to_tyre() == SOFT
    (folder / "again.toml").write_text(tyre.to_toml())
    assert load_tyre(folder / "again.toml") == tyre


def test_a_number_of_a_tyre_is_replaced() -> None:
    """`--set` reaches into a tyre that the scenario has written out."""
    text = PAPER + "\n[ego.tyre]\n" + SOFT_FILE.replace("[", "[ego.tyre.")
    scenario = parse(text.encode(), "case.toml", ["ego.tyre.peak_factor.at_no_load=0.8"])
    assert scenario.ego.to_vehicle().tyre.d0 == 0.8


REFUSED = [
    ("ego.tyre=passenger-215-55-r18", "unknown tyre 'passenger-215-55-r18'; did you mean passenger-215-55-r17?"),
    ("ego.tyre=zzz", "unknown tyre 'zzz'; write one of passenger-215-55-r17 (a file of your own ends in .toml)"),
    ("ego.tyre=7", "7 is no tyre; write one of passenger-215-55-r17, a .toml file or a table [ego.tyre]"),
    ("ego.tyre=absent.toml", "absent.toml: cannot be read: No such file or directory; write a TOML file's path"),
    ("ego.tyre=a/b", "a/b: cannot be read: No such file or directory"),
    ("ego.tire=x", "ego.tire: unknown key; did you mean ego.tyre?"),
]


def test_half_a_tyre_is_refused() -> None:
    """A table that has some of a tyre's keys misses the others."""
    with pytest.raises(InputError, match=r"ego\.tyre\.shape_factor: missing; write one such as shape_factor = \{"):
        load("paper", ["ego.tyre.name=x", "ego.tyre.stiffness_factor={at_no_load=12, per_newton=0}"])


@pytest.mark.parametrize(("override", "message"), REFUSED)
def test_a_wrong_tyre_is_refused(override: str, message: str, folder: Path) -> None:
    """The message names the override, the key, the value and the cure."""
    with pytest.raises(InputError) as caught:
        load("paper", [override])
    assert message in str(caught.value)
    assert str(caught.value).startswith(f"--set {override}: ego.t")


REFUSED_FILES = [
    (SOFT_FILE.replace("9.0", "-9.0"), "stiffness_factor.at_no_load: -9.0 is out of range; write more than 0"),
    (SOFT_FILE.replace("1.3", "2.3"), "shape_factor.at_no_load: 2.3 is out of range; write more than 0 and at most 2"),
    (SOFT_FILE.replace("0.9", "nan"), "peak_factor.at_no_load: nan is not finite"),
    (SOFT_FILE.replace("per_newton", "per_newtom", 1), "stiffness_factor.per_newtom: unknown key; did you mean stiffn"),
    (SOFT_FILE.replace("[peak_factor]", "[peek_factor]"), "peek_factor: unknown key; did you mean peak_factor?"),
    (SOFT_FILE.replace('name = "soft"', ""), 'name: missing; write one such as name = "my-tyre"'),
    (SOFT_FILE.replace("= 9.0", "="), "not valid TOML: "),
    ("", "empty; a tyre has name, [stiffness_factor], [shape_factor] and [peak_factor]"),
    (PAPER, "description: unknown key"),
]


@pytest.mark.parametrize(("text", "message"), REFUSED_FILES, ids=[message[:40] for _, message in REFUSED_FILES])
def test_a_wrong_file_is_refused(text: str, message: str, folder: Path) -> None:
    """The message names the scenario, its key, the tyre's file, the key in that and the cure, on one line."""
    (folder / "soft.toml").write_text(text)
    with pytest.raises(InputError) as caught:
        load(folder / "case.toml")
    said = str(caught.value)
    assert said.startswith(f"{folder / 'case.toml'}: ego.tyre: {folder / 'soft.toml'}: ")
    assert message in said
    assert "\n" not in said


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (("-0.0001", "-0.0013"), "B is -0.756 at 7504.65 N, half the vehicle's weight, and has to be above 0; write"),
        (("1e-06", "0.001"), "C is 8.805 at 7504.65 N, half the vehicle's weight, and has to be above 0 and at most 2"),
        (("-5e-06", "-0.0002"), "D is -0.6009 at 7504.65 N"),
    ],
)
def test_a_tyre_that_cannot_carry_the_vehicle_is_refused(change: tuple[str, str], message: str, folder: Path) -> None:
    """Its lines must make sense up to half the vehicle's weight."""
    assert change[0] in SOFT_FILE
    (folder / "soft.toml").write_text(SOFT_FILE.replace(*change))
    with pytest.raises(InputError) as caught:
        load(folder / "case.toml")
    assert f"ego.tyre: {message}" in str(caught.value)
