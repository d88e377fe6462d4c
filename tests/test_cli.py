"""The command line: what it prints, where, and with which exit status."""

import json
import os
import re
import signal
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

import swerve
from swerve.cli import main
from swerve.report import ablation_table
from swerve.scenario import FAMILIES, Scenario, library_names
from swerve.simulate import Run
from tests.report.results import ABLATION, RESULT
from tests.report.runs import made

Outputs = pytest.CaptureFixture[str]


class FakeSimulation:
    """Stands in for `swerve.simulate.run`: notes how it was called and answers at once."""

    def __init__(self) -> None:
        self.calls: list[tuple[Scenario, str, str, int]] = []
        self.interrupt: type[BaseException] | None = None

    def __call__(
        self, scenario: Scenario, controller: str, plant: str, seed: int, progress: Callable[[float], None]
    ) -> Run:
        """A run that was avoided."""
        if self.interrupt:
            raise self.interrupt
        progress(0.5)
        self.calls.append((scenario, controller, plant, seed))
        names = {"scenario": scenario.name, "controller": controller, "plant": plant, "seed": seed}
        return replace(made(), result=replace(RESULT, **names))


@pytest.fixture
def simulation(monkeypatch: pytest.MonkeyPatch) -> FakeSimulation:
    """The command line with a fake simulation below it, and a report that writes one file."""
    fake = FakeSimulation()

    def write_run(run: object, directory: Path, progress: Callable[[float], None]) -> list[Path]:
        directory.mkdir()
        (directory / "result.json").touch()
        progress(1.0)
        return [directory / "result.json"]

    monkeypatch.setattr("swerve.simulate.run", fake)
    monkeypatch.setattr("swerve.report.write_run", write_run)
    return fake


def test_a_run_is_the_paper_s_by_default(simulation: FakeSimulation, capsys: Outputs) -> None:
    """Without arguments `run` takes the paper's scenario, the unified controller, the default plant and seed 0."""
    assert main(["run"]) == 0
    ((scenario, *rest),) = simulation.calls
    assert (scenario.name, *rest) == ("paper", "unified", "multibody", 0)


def test_a_run_s_table_is_for_people(simulation: FakeSimulation, capsys: Outputs) -> None:
    """Without --json stdout is a table, and stderr is silent."""
    assert main(["run", "wet", "--seed", "7"]) == 0
    captured = capsys.readouterr()
    assert captured.out.startswith("scenario        wet, unified on multibody, seed 7\noutcome         avoided: ")
    assert captured.err == ""


def test_json_is_one_object_and_nothing_else(simulation: FakeSimulation, capsys: Outputs, tmp_path: Path) -> None:
    """With --json stdout is one JSON object; where the files went is told on stderr."""
    assert main(["run", "--json", "--out", str(tmp_path / "new"), "--controller", "as-printed"]) == 0
    captured = capsys.readouterr()
    assert json.loads(captured.out)["controller"] == "as-printed"
    assert captured.out.count("\n") == 1
    assert captured.err == f"wrote {tmp_path / 'new' / 'result.json'}\n"


def test_overrides_reach_the_scenario(simulation: FakeSimulation) -> None:
    """Every --set is applied, in order."""
    assert main(["run", "paper", "--set", "road.friction=0.4", "--set", "ego.speed=36 km/h"]) == 0
    scenario = simulation.calls[0][0]
    assert (scenario.road.friction, scenario.ego.speed) == (0.4, 10.0)


@pytest.mark.parametrize(("required", "status"), [("avoided", 0), ("collided", 1)])
def test_a_required_outcome_decides_the_status(
    simulation: FakeSimulation, capsys: Outputs, required: str, status: int
) -> None:
    """--require gives status 1 at another outcome and says so on stderr; the result is printed all the same."""
    assert main(["run", "--json", "--require", required]) == status
    captured = capsys.readouterr()
    assert json.loads(captured.out)["outcome"] == "avoided"
    assert ("required was collided" in captured.err) == (status == 1)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["run", "papre"], "papre: no such scenario; did you mean paper?"),
        (["run", "--set", "road.frictoin=0.4"], "road.frictoin: unknown key; did you mean road.friction?"),
        (["run", "--set", "ego.speed=72 kg"], "ego.speed: '72 kg' is not a speed"),
        (["run", "--set", "ego.speed=nan"], "ego.speed: nan is not finite"),
        (["run", "--set", "road.friction=-1"], "road.friction: -1 is out of range"),
        (["run", "--set", "road.friction"], "--set road.friction: no '='"),
        (["run", "--controller", "unifed"], "--controller: unknown controller 'unifed'; did you mean unified?"),
        (["run", "--plant", "planer"], "--plant: unknown plant 'planer'; did you mean planar?"),
        (["run", "--plant", ""], "--plant: unknown plant ''; write one of planar, multibody"),
        (["run", "--require", "avoidd"], "--require: unknown outcome 'avoidd'; did you mean avoided?"),
        (["run", "--seed", "-1"], "argument --seed: '-1' is no seed; write a whole number"),
        (["run", "--seed", "x"], "argument --seed: 'x' is no seed; write a whole number"),
        (["run", "--out", "/dev/null/new"], "--out /dev/null/new: cannot be written: "),
        (["run", "--sed"], "unrecognized arguments: --sed"),
        (["run", "paper", "wet"], "unrecognized arguments: wet"),
        (["runn"], "invalid choice: 'runn'"),
        ([], "the following arguments are required: COMMAND"),
    ],
    ids=" ".join,
)
def test_wrong_input_is_one_message(
    simulation: FakeSimulation, capsys: Outputs, arguments: list[str], message: str
) -> None:
    """Wrong input gives status 2 and one line on stderr; nothing is printed on stdout and nothing is run."""
    assert main(arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("swerve: error: ")
    assert message in captured.err
    assert captured.err.count("\n") == 1
    assert simulation.calls == []


def test_an_interrupted_run_writes_nothing(simulation: FakeSimulation, capsys: Outputs, tmp_path: Path) -> None:
    """Ctrl-C gives status 130, one line, and no output directory."""
    simulation.interrupt = KeyboardInterrupt
    assert main(["run", "--out", str(tmp_path / "new")]) == 130
    captured = capsys.readouterr()
    assert (captured.out, captured.err) == ("", "swerve: interrupted\n")
    assert list(tmp_path.iterdir()) == []


def test_reproduce_prints_its_table_and_files(monkeypatch: pytest.MonkeyPatch, capsys: Outputs, tmp_path: Path) -> None:
    """`reproduce` writes where it is told to, by default to swerve-reproduction, and prints the ablation."""

    def reproduce(progress: Callable[[float], None]) -> SimpleNamespace:
        progress(1.0)
        return SimpleNamespace(ablation=ABLATION)

    monkeypatch.setattr("swerve.study.reproduce.reproduce", reproduce)
    monkeypatch.setattr("swerve.report.write_reproduction", lambda it, directory, progress: [directory / "table.md"])
    monkeypatch.chdir(tmp_path)
    assert main(["reproduce"]) == 0
    assert main(["reproduce", "--out", "there"]) == 0
    table = ablation_table(ABLATION)
    written = [f"{table}\nwrote {Path(name) / 'table.md'}\n" for name in ("swerve-reproduction", "there")]
    assert capsys.readouterr().out == "".join(written)


def test_output_that_cannot_be_written_is_told_before_anything_is_run(
    simulation: FakeSimulation, capsys: Outputs, tmp_path: Path
) -> None:
    """Where --out names a file, `run` and `reproduce` end with status 2 at once, and the file stays."""
    (tmp_path / "file").write_text("mine")
    for command in ("run", "reproduce"):
        assert main([command, "--out", str(tmp_path / "file")]) == 2
        captured = capsys.readouterr()
        assert captured.out == ""
        assert captured.err.startswith(f"swerve: error: --out {tmp_path / 'file'}: cannot be written: File exists; ")
    assert simulation.calls == []
    assert (tmp_path / "file").read_text() == "mine"


def test_scenarios_are_listed(capsys: Outputs) -> None:
    """`scenarios` prints a line for each scene and each family, with what it is for; --json all of them as a list."""
    assert main(["scenarios"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == [*library_names(), *(family.pattern for family in FAMILIES)]
    assert all(len(line) < 120 and len(line.split()) > 3 for line in lines)
    assert main(["scenarios", "--json"]) == 0
    listed = json.loads(capsys.readouterr().out)
    members = [name for family in FAMILIES for name in family.members]
    assert [each["name"] for each in listed] == [*library_names(), *members]
    assert all(set(each) == {"name", "description", "source"} for each in listed)


@pytest.mark.parametrize("arguments", [["--help"], ["run", "--help"], ["scenarios", "--help"], ["reproduce", "--help"]])
def test_help_is_an_answer(capsys: Outputs, arguments: list[str]) -> None:
    """--help prints the usage on stdout with status 0."""
    assert main(arguments) == 0
    captured = capsys.readouterr()
    assert captured.out.startswith("usage: swerve")
    assert captured.err == ""


def test_the_version_is_the_package_s(capsys: Outputs) -> None:
    """--version prints the version of the package."""
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"swerve {swerve.__version__}\n"


CONTRACT_KEYS = {
    "scenario",
    "controller",
    "plant",
    "seed",
    "version",
    "outcome",
    "min_distance_ratio",
    "min_clearance",
    "impact_speed",
    "decision",
    "lateral_offset",
    "speed",
    "final_yaw_rate",
    "final_lateral_speed",
    "max_sideslip",
    "max_yaw_rate",
    "max_steer",
    "step_time",
    "steps",
    "fallback_steps",
    "solver_failures",
    "wall_time",
}


@pytest.mark.parametrize("obstacles", ["", "[]", "[{position=[30, 0], size=[4, 2]}]"])
def test_a_real_run_answers_with_all_keys(capsys: Outputs, obstacles: str) -> None:
    """The JSON of a run has every key, with null for a distance that does not exist, and so does the table."""
    arguments = ["run", "paper", "--set", "duration=0.1 s"]
    if obstacles:
        arguments += ["--set", f"obstacles={obstacles}"]
    assert main([*arguments, "--json"]) == 0
    result = json.loads(capsys.readouterr().out)
    assert set(result) >= CONTRACT_KEYS
    assert (result["min_distance_ratio"] is None) == bool(obstacles)
    assert (result["min_clearance"] is None) == (obstacles == "[]")
    assert main(arguments) == 0
    assert "outcome         avoided" in capsys.readouterr().out


def _python(code: str, **keywords: Any) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, **keywords)


def test_the_command_starts_light() -> None:
    """Importing the command line imports none of the heavy libraries, so that --help answers at once."""
    done = _python("import sys, swerve.cli; print(*{m.partition('.')[0] for m in sys.modules})")
    heavy = {"casadi", "matplotlib", "numpy", "pydantic", "pyarrow", "scipy", "shapely"}
    assert done.returncode == 0
    assert heavy.isdisjoint(done.stdout.split())


def test_a_wrong_scenario_in_a_process_of_its_own(tmp_path: Path) -> None:
    """`python -m swerve` gives status 2 and one line, without a traceback, and leaves no file behind."""
    done = subprocess.run(
        [sys.executable, "-m", "swerve", "run", "absent.toml", "--out", "there"],
        capture_output=True,
        text=True,
        timeout=60,
        cwd=tmp_path,
    )
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("swerve: error: absent.toml: cannot be read: No such file")
    assert done.stderr.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_a_reader_that_leaves_early_is_no_error() -> None:
    """When the reader of stdout has gone, there is no traceback and no complaint at exit."""
    reader, writer = os.pipe()
    os.close(reader)
    with os.fdopen(writer, "wb") as stdout:
        done = subprocess.run(
            [sys.executable, "-m", "swerve", "scenarios"], stdout=stdout, stderr=subprocess.PIPE, timeout=60
        )
    assert (done.returncode, done.stderr) == (141, b"")


def test_a_full_disk_is_one_line() -> None:
    """When stdout cannot be written, there is one line on stderr and status 2."""
    full = Path("/dev/full")
    if not full.exists():
        pytest.skip("no /dev/full on this system")
    with full.open("wb") as stdout:
        done = subprocess.run(
            [sys.executable, "-m", "swerve", "scenarios"], stdout=stdout, stderr=subprocess.PIPE, text=True, timeout=60
        )
    assert done.returncode == 2
    assert re.fullmatch(r"swerve: error: cannot write: .*No space left on device\n", done.stderr)


def test_ctrl_c_ends_a_real_run() -> None:
    """An interrupt in the middle of a run gives status 130 and one line after the progress, and no result."""
    command = [sys.executable, "-m", "swerve", "run", "far-away", "--json", "--set", "duration=300 s"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as running:
        assert running.stderr
        progress = running.stderr.readline()
        running.send_signal(signal.SIGINT)
        output, errors = running.communicate(timeout=60)
    assert re.fullmatch(r"swerve: \d+% done\n", progress)
    assert (running.returncode, output) == (130, "")
    assert errors.splitlines()[-1] == "swerve: interrupted"
    assert "Traceback" not in errors
