"""`swerve compare`: what it prints and writes, with which exit status, and what is left of it."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from swerve.cli import main

Outputs = pytest.CaptureFixture[str]
FEW = ["--controllers", "hierarchical,brake", "--plant", "planar", "--set", "duration=0.5 s"]
COMMAND = [sys.executable, "-m", "swerve", "compare"]
LONG = [*COMMAND, "far-away", "paper", "--controllers", "unified", "--set", "duration=300 s", "--workers", "2"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["papre"], "papre: no such scenario; did you mean paper?"),
        (["paper", "absent.toml"], "absent.toml: cannot be read"),
        (["paper", "paper"], "paper: 2 of the scenarios have this name"),
        (["paper", "--controllers", "brake,unifed"], "--controllers: unknown controller 'unifed'; did you mean unif"),
        (["paper", "--controllers", ""], "--controllers: unknown controller ''; write one of unified"),
        (["paper", "--plant", "planer"], "--plant: unknown plant 'planer'; did you mean planar?"),
        (["paper", "ice-patch", "--plant", "planar"], "ice-patch: road.patches: the planar plant has one friction"),
        (["paper", "--set", "road.frictoin=0.4"], "road.frictoin: unknown key; did you mean road.friction?"),
        (["paper", "--workers", "0"], "--workers: 0 is out of range; write a whole number from 1 to 64"),
        (["paper", "--seed", "x"], "argument --seed: 'x' is no seed"),
        ([], "the following arguments are required: SCENARIO"),
    ],
)
def test_wrong_input_is_one_message(
    capsys: Outputs, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: list[str], message: str
) -> None:
    """Before anything is run there is status 2 and one line on stderr, and nothing is written."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("swerve.study.comparison.compare", None)
    assert main(["compare", *arguments, "--out", "new"]) == 2
    captured = capsys.readouterr()
    assert (captured.out, captured.err.count("\n")) == ("", 1)
    assert captured.err.startswith("swerve: error: ")
    assert message in captured.err
    assert list(tmp_path.iterdir()) == []


def test_json_is_one_object_and_nothing_else(capsys: Outputs, tmp_path: Path) -> None:
    """With --json stdout is the object that the folder has as well; where the files went is told on stderr."""
    assert main(["compare", "paper", *FEW, "--json", "--out", str(tmp_path / "new")]) == 0
    captured = capsys.readouterr()
    assert captured.out == (tmp_path / "new" / "comparison.json").read_text(encoding="utf-8")
    assert [row["controller"] for row in json.loads(captured.out)["runs"]] == ["hierarchical", "brake"]
    written = {line.removeprefix("wrote ") for line in captured.err.splitlines() if line.startswith("wrote ")}
    assert written == {str(path) for path in (tmp_path / "new").iterdir()}


def test_a_table_is_for_people(capsys: Outputs) -> None:
    """Without --json stdout is the table of all scenarios, a controller that is named twice has one line."""
    assert main(["compare", "paper", "ccrs-50-il75", *FEW, "--controllers", "brake, driver,brake", "--seed", "7"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("on planar, seed 7")
    assert [line.split()[1] for line in lines if line.startswith("* ")] == ["brake", "driver"] * 2


def test_quiet_is_silent(capsys: Outputs) -> None:
    """With --quiet nothing is printed, and with --json the object alone."""
    assert main(["compare", "paper", *FEW, "--quiet"]) == 0
    assert tuple(capsys.readouterr()) == ("", "")


def test_a_controller_that_refuses_does_not_end_it(capsys: Outputs) -> None:
    """Its line has the reason, and the status is that of a comparison that was done."""
    assert main(["compare", "paper", *FEW, "--set", "actuation.mode=brakes-only"]) == 0
    assert "  hierarchical  refused: actuation.mode: hierarchical knows no brakes-only" in capsys.readouterr().out


def test_workers_change_nothing(tmp_path: Path) -> None:
    """One process or two: the same scenarios and controllers in the same order, with the same numbers."""
    told = []
    for workers in ("1", "2"):
        command = [*COMMAND, "paper", "wet", *FEW, "--json", "--workers", workers]
        done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=True)
        told.append(json.loads(done.stdout, object_pairs_hook=_without_times))
    assert told[0] == told[1]
    assert len(told[0]["runs"]) == 4


def _without_times(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    return {key: value for key, value in pairs if key not in ("step_time", "wall_time")}


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="no /proc to see processes in")
@pytest.mark.parametrize("everybody", [True, False], ids=["as by Ctrl-C", "the first process alone"])
def test_an_interrupt_leaves_no_process_and_no_file(tmp_path: Path, everybody: bool) -> None:
    """In the middle of its runs it ends with status 130 and one line; its processes end with it."""
    with subprocess.Popen(
        [*LONG, "--out", "new"], stderr=subprocess.PIPE, text=True, cwd=tmp_path, start_new_session=True
    ) as running:
        until = time.monotonic() + 60
        while len(children := _children(running.pid)) < 2 and time.monotonic() < until:
            time.sleep(0.05)
        time.sleep(1.0)
        os.killpg(running.pid, signal.SIGINT) if everybody else running.send_signal(signal.SIGINT)
        _, errors = running.communicate(timeout=60)
    assert len(children) == 2
    assert (running.returncode, errors) == (130, "swerve: interrupted\n")
    assert not any(Path(f"/proc/{child}").exists() for child in children)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="no /proc to see processes in")
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGKILL])
def test_processes_end_with_the_one_that_began_them(tmp_path: Path, number: int) -> None:
    """However it ends, none of its processes stays behind."""
    with subprocess.Popen([*LONG], stderr=subprocess.DEVNULL, cwd=tmp_path, start_new_session=True) as running:
        until = time.monotonic() + 60
        while len(children := _children(running.pid)) < 2 and time.monotonic() < until:
            time.sleep(0.05)
        time.sleep(1.0)
        running.send_signal(number)
    until = time.monotonic() + 20
    while (left := [child for child in children if _is_running(child)]) and time.monotonic() < until:
        time.sleep(0.05)
    assert len(children) == 2
    assert left == []


def _is_running(pid: str) -> bool:
    status = Path(f"/proc/{pid}/stat")
    return status.exists() and status.read_text().rpartition(")")[2].split()[0] != "Z"


def _children(pid: int) -> list[str]:
    path = Path(f"/proc/{pid}/task/{pid}/children")
    return path.read_text().split() if path.exists() else []
