"""`swerve export`, and the exports of `swerve run`: what is written, and what is said where it cannot be."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image

from swerve.cli import main
from swerve.report.exports import FORMATS, formats_named, write_exports
from tests.report.exports.folders import write_folder
from tests.report.runs import made

Outputs = pytest.CaptureFixture[str]
SHORT = ["--plant", "planar", "--set", "duration=0.1 s"]
FULL_DISK = """
import resource, sys
from swerve.cli import main
resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))
sys.exit(main(sys.argv[1:]))
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A finished run's."""
    return write_folder(made("duration=0.2 s", controller="unified"), tmp_path / "run")


def _names(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()}


def test_a_folder_is_exported(folder: Path, tmp_path: Path, capsys: Outputs) -> None:
    """The files go to the run's own folder, or where --out says; each is told on a line."""
    before = _names(folder)
    assert main(["export", str(folder), "--to", "csv,mcap"]) == 0
    files = {"motion.csv", "steps.csv", "run.mcap", "foxglove_layout.json"}
    assert _names(folder) == before | files
    assert set(capsys.readouterr().out.splitlines()) == {f"wrote {folder / name}" for name in files}
    assert main(["export", str(folder), "--to", "webp", "--out", str(tmp_path / "new")]) == 0
    assert _names(tmp_path / "new") == {"top_view.webp"}


def test_a_run_and_its_folder_export_the_same(folder: Path, tmp_path: Path) -> None:
    """What is written of a run that has just been made is what is written of its folder, byte by byte."""
    done = made("duration=0.2 s", controller="unified")
    write_exports(done, formats_named("csv,mcap,gif,webp", "--to"), tmp_path / "made")
    main(["export", str(folder), "--to", "csv,mcap,gif,webp", "--out", str(tmp_path / "read")])
    assert _names(tmp_path / "made") == _names(tmp_path / "read")
    for path in (tmp_path / "made").iterdir():
        assert path.read_bytes() == (tmp_path / "read" / path.name).read_bytes()


def test_a_run_can_be_exported_at_once(tmp_path: Path, capsys: Outputs) -> None:
    """`run --export` writes the exports beside the run's own files, and --quiet says nothing; `export` reads them."""
    assert main(["run", *SHORT, "--out", str(tmp_path / "a"), "--export", "csv,gif", "--quiet"]) == 0
    captured = capsys.readouterr()
    assert (captured.out, captured.err) == ("", "")
    assert _names(tmp_path / "a") >= {"result.json", "motion.parquet", "motion.csv", "steps.csv", "top_view.gif"}
    with Image.open(tmp_path / "a" / "top_view.gif") as image:
        assert image.n_frames == 3
    first = (tmp_path / "a" / "motion.csv").read_bytes()
    assert main(["export", str(tmp_path / "a"), "--to", "csv"]) == 0
    assert (tmp_path / "a" / "motion.csv").read_bytes() == first


def test_a_quiet_run_has_its_json(tmp_path: Path, capsys: Outputs) -> None:
    """With --quiet and --json there is the result and nothing else; an outcome that was not required is told still."""
    assert main(["run", *SHORT, "--quiet", "--json", "--require", "collided"]) == 1
    captured = capsys.readouterr()
    assert json.loads(captured.out)["outcome"] == "avoided"
    assert captured.err == "swerve: the outcome is avoided, required was collided\n"


@pytest.mark.parametrize(
    ("names", "message"),
    [
        ("cvs", "unknown format 'cvs'; did you mean csv?"),
        ("csv,", "unknown format ''; write one of csv, mcap, mf4, gif, webp, mp4"),
        ("", "unknown format ''; write one of "),
        ("csv mcap", "unknown format 'csv mcap'; "),
    ],
)
def test_an_unknown_format_is_refused(folder: Path, capsys: Outputs, names: str, message: str) -> None:
    """It gives status 2 and one line with the right names, from `run` and from `export`, and nothing is written."""
    before = _names(folder)
    for arguments in (["export", str(folder), "--to"], ["run", *SHORT, "--out", str(folder / "new"), "--export"]):
        assert main([*arguments, names]) == 2
        captured = capsys.readouterr()
        assert captured.out == ""
        assert captured.err.startswith(f"swerve: error: {arguments[-1]}: {message}")
        assert captured.err.count("\n") == 1
    assert _names(folder) == before


@pytest.mark.parametrize(("name", "module"), [("mcap", "mcap"), ("mf4", "asammdf")])
def test_an_extra_that_is_not_installed_is_named(
    folder: Path, capsys: Outputs, monkeypatch: pytest.MonkeyPatch, name: str, module: str
) -> None:
    """Where a format's package is missing, the message says what to install; nothing is run or written."""
    before = _names(folder)
    monkeypatch.setitem(sys.modules, module, None)  # which is how Python marks what cannot be imported
    for arguments in (["export", str(folder), "--to"], ["run", *SHORT, "--out", str(folder / "new"), "--export"]):
        assert main([*arguments, f"csv,{name}"]) == 2
        needs = f"needs the package {module}, which is not installed; install it with: pip install 'swerve[{name}]'"
        assert capsys.readouterr().err == f"swerve: error: {arguments[-1]} {name}: {needs}\n"
    assert _names(folder) == before


def test_a_missing_ffmpeg_is_named(
    folder: Path, tmp_path: Path, capsys: Outputs, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where there is no ffmpeg on the PATH, the message says so, and which formats do without."""
    monkeypatch.setenv("PATH", str(tmp_path))
    assert main(["export", str(folder), "--to", "mp4"]) == 2
    needs = "needs the program ffmpeg, which is not on the PATH; install it, or export to webp or gif"
    assert capsys.readouterr().err == f"swerve: error: --to mp4: {needs}\n"


def test_an_export_needs_a_folder(tmp_path: Path, capsys: Outputs) -> None:
    """`run --export` without --out, a folder that is none, and one that cannot be made are refused in one line."""
    (tmp_path / "file").touch()
    folder = str(write_folder(made("duration=0.2 s"), tmp_path / "run"))
    for arguments, message in (
        (["run", *SHORT, "--export", "csv"], "--export csv: there is no folder to write to; add --out DIR"),
        (["export", str(tmp_path), "--to", "csv"], f"{tmp_path}: is no run's folder: has no result.json; "),
        (["export", folder, "--to", "csv", "--out", str(tmp_path / "file")], f"--out {tmp_path / 'file'}: cannot be w"),
        (["export", folder], "the following arguments are required: --to"),
    ):
        assert main(arguments) == 2
        captured = capsys.readouterr()
        assert (captured.out, captured.err.count("\n")) == ("", 1)
        assert captured.err.startswith(f"swerve: error: {message}")


@pytest.mark.parametrize("name", [name for name in FORMATS if name not in ("mp4", "gif")])  # gif is webp's writer
def test_a_full_disk_leaves_no_half_file(folder: Path, tmp_path: Path, name: str) -> None:
    """Where no file may grow beyond a thousand bytes, there is one line and status 2, and no file of the export."""
    pytest.importorskip("resource", reason="limits on files are those of POSIX")
    command = [sys.executable, "-c", FULL_DISK, "export", str(folder), "--to", name, "--out", str(tmp_path / "new")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("swerve: error: cannot write: ")
    assert done.stderr.count("\n") == 1
    assert not (tmp_path / "new").exists()
