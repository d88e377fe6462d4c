"""`swerve fit-tyre`: what it prints, what it writes, and with which exit status."""

import json
import math
import tomllib
from pathlib import Path

import pytest

from swerve.cli import main
from swerve.scenario import load
from swerve.vehicle.fitting.table_1 import TABLE_1
from tests.vehicle.fitting.points import GOOD, HERE, force, table

Outputs = pytest.CaptureFixture[str]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A working directory with good data in it."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "good.csv").write_text(GOOD)
    return tmp_path


def files(folder: Path) -> list[str]:
    """What is in the working directory."""
    return sorted(path.name for path in folder.iterdir())


def test_a_table_is_printed_and_nothing_written(folder: Path, capsys: Outputs) -> None:
    """A row for each load, the three lines with their R^2, what mu is and what was done about shifts."""
    assert main(["fit-tyre", "good.csv"]) == 0
    out = capsys.readouterr().out
    rows = [line for line in out.splitlines() if line.split() and line.split()[0] in ("1500", "3000", "6000")]
    assert len(rows) == 3
    assert all("12.0000" in row and "1.4500" in row and "0.9500" in row for row in rows)
    assert "B = 12 " in out
    assert "R^2 = 1.0000" in out
    assert "mu = 1 is their surface" in out
    assert "shifts: fitted at 3 of 3 loads" in out
    assert max(map(len, out.splitlines())) <= 120
    assert files(folder) == ["good.csv"]


def test_table_1_of_the_paper_from_a_file(folder: Path, capsys: Outputs) -> None:
    """A CSV file of Table 1's curves, in newtons with a decimal, gives Table 1 back to its printed digits."""
    lines = [
        f"{c.Fz}, {degrees}, {force(c.Fz, math.radians(degrees), c.B, c.C, c.D):.3f}"
        for c in TABLE_1
        for degrees in range(-20, 21)
    ]
    (folder / "table-1.csv").write_text(table(lines))
    assert main(["fit-tyre", "table-1.csv", "--json"]) == 0
    result = json.loads(capsys.readouterr().out)
    for row, column in zip(result["loads"], TABLE_1, strict=True):
        assert (row["reduced"]["B"], row["reduced"]["C"], row["reduced"]["D"]) == pytest.approx(
            (column.B, column.C, column.D), abs=5e-5
        )
        assert row["full"]["E"] == pytest.approx(0.0, abs=1e-3)
    assert result["lines"]["B"]["per_newton"] == pytest.approx(-1.4758e-4, abs=5e-9)
    assert result["lines"]["B"]["r_squared"] == pytest.approx(0.9976, abs=1e-4)


def test_json_is_one_object_with_everything(capsys: Outputs) -> None:
    """On stdout alone, in SI, with the tyre as its file would have it."""
    assert main(["fit-tyre", "good.csv", "--json", "--out", "tyre.toml"]) == 0
    captured = capsys.readouterr()
    result = json.loads(captured.out)
    assert captured.err == "wrote tyre.toml\n"
    assert set(result) == {"version", "data", "note", "tyre", "lines", "loads"}
    assert set(result["loads"][0]) == {"load", "n_points", "line_rms_error", "full", "reduced"}
    assert set(result["loads"][0]["full"]) == {
        "B", "C", "D", "E", "horizontal_shift", "vertical_shift", "rms_error"
    }  # fmt: skip
    assert result["tyre"] == tomllib.loads(Path("tyre.toml").read_text())


@pytest.mark.parametrize("data", ["good.csv", HERE / "sample_52.tir", HERE / "sample_61.tir"])
def test_a_scenario_names_what_was_written(folder: Path, data: str | Path, capsys: Outputs) -> None:
    """The file that --out writes is a scenario's tyre, with the lines that were printed, wherever it is."""
    assert main(["fit-tyre", str(data), "--json", "--out", "tyres/mine.toml"]) == 0
    lines = json.loads(capsys.readouterr().out)["lines"]
    ego = load("paper", ["ego.tyre=tyres/mine.toml"]).ego
    tyre = ego.to_vehicle().tyre
    assert (tyre.b0, tyre.b1) == (lines["B"]["at_no_load"], lines["B"]["per_newton"])
    assert (tyre.d0, tyre.d1) == (lines["D"]["at_no_load"], lines["D"]["per_newton"])
    assert ego.tyre is not None
    assert ego.tyre.name == "mine"
    assert Path(data).name in ego.tyre.source
    assert files(folder / "tyres") == ["mine.toml"]


def test_an_earlier_file_is_replaced(folder: Path) -> None:
    """As all that --out writes is."""
    (folder / "tyre.toml").write_text("old")
    assert main(["fit-tyre", "good.csv", "--out", "tyre.toml"]) == 0
    assert load("paper", ["ego.tyre=tyre.toml"]).ego.to_vehicle().tyre.b0 == pytest.approx(12.0)


REFUSED = [
    (["fit-tyre"], "the following arguments are required: DATA"),
    (["fit-tyre", "absent.csv", "--out", "t.toml"], "absent.csv: cannot be read: No such file or directory; write"),
    (["fit-tyre", "good.csv", "--out", "tyre.csv"], "--out tyre.csv: does not end in .toml; write a name that does"),
    (["fit-tyre", "good.csv", "--out", "."], "--out .: does not end in .toml"),
    (["fit-tyre", "good.csv", "--out", "good.csv/t.toml"], "--out good.csv: cannot be written: "),
    (
        ["fit-tyre", "bad.csv", "--out", "new/t.toml"],
        "bad.csv: line 3: column load: 'nan' is not finite; write",
    ),
    (["fit-tyre", "short.csv", "--out", "new/t.toml"], "slip angles reach 1 deg, "),
    (
        ["fit-tyre", "steep.csv", "--out", "new/t.toml"],
        "ends in a tyre that cannot be: peak_factor.at_no_load: ",
    ),
]


@pytest.mark.parametrize(("arguments", "message"), REFUSED, ids=[" ".join(arguments) for arguments, _ in REFUSED])
def test_wrong_input_is_status_2_and_writes_nothing(
    folder: Path, arguments: list[str], message: str, capsys: Outputs
) -> None:
    """One message on stderr, nothing on stdout, no file and no directory."""
    lines = GOOD.splitlines()
    (folder / "bad.csv").write_text("\n".join([*lines[:2], "nan, 1, 1", *lines[2:]]))
    angles = [i / 10 for i in range(-10, 11)]
    short = [f"{load}, {a}, {force(load, math.radians(a), 12.0, 1.4, 1.0)}" for load in (1e3, 2e3, 4e3) for a in angles]
    (folder / "short.csv").write_text(table(short))
    steep = [
        f"{load}, {a}, {force(load, math.radians(a), 12.0, 1.4, 12.5 - load * 3e-3)}"
        for load in (3e3, 3.3e3, 3.9e3)
        for a in range(-15, 16)
    ]
    (folder / "steep.csv").write_text(table(steep))
    before = files(folder)
    assert main(arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("swerve: error: ")
    assert captured.err.count("\n") == 1
    assert message in captured.err
    assert files(folder) == before
