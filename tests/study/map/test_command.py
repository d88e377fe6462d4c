"""The command: what it writes, what it refuses, and that neither kills nor workers change the table."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pyarrow.parquet
import pytest

from swerve.cli import main
from tests.study.map.commands import ENVIRONMENT, SMALL, TINY, begin, finished, keys_in, runs_in

BOTH = ("--controllers", "brake,unified")
FILES = {"runs.parquet", "boundaries.parquet", "map.json", "map.md", "map.html", "map.png", "map.pdf"}


def wait(until: Callable[[], object], longest: float = 120.0) -> None:
    """Until something is so; an AssertionError where it never comes to that [s]."""
    end = time.monotonic() + longest
    while not until():
        assert time.monotonic() < end, "it has taken too long"
        time.sleep(0.02)


def group_is_gone(group: int) -> bool:
    """Whether no process of a group runs any more; one that has ended and waits for its parent does not."""
    listed = subprocess.run(["ps", "-eo", "pgid=,stat="], check=True, capture_output=True, text=True).stdout
    lines = (line.split() for line in listed.splitlines())
    return not any(int(pgid) == group and not stat.startswith("Z") for pgid, stat in lines)


def workers_of(group: int) -> list[int]:
    """The processes of a group that a map has begun for its runs."""
    ps = ["ps", "-ww", "-eo", "pid=,pgid=,args="]
    listed = subprocess.run(ps, check=True, capture_output=True, text=True).stdout
    lines = (line.split(None, 2) for line in listed.splitlines())
    return [int(pid) for pid, pgid, args in lines if int(pgid) == group and "spawn_main" in args]


def killed(out: Path, at_least: int) -> list[str]:
    """The keys that a map has kept which is killed when there are so many of them."""
    going = begin(out, *BOTH, *SMALL, "--workers", "2")
    wait(lambda: len(keys_in(out)) >= at_least)
    going.kill()
    going.communicate()
    wait(lambda: group_is_gone(going.pid))
    return keys_in(out)


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A small map that two workers made in one go."""
    out = tmp_path_factory.mktemp("map") / "undisturbed"
    done = finished(out, *BOTH, *SMALL, "--workers", "2")
    assert done.returncode == 0, done.stderr
    return out


@pytest.mark.slow
def test_a_map_has_its_files(undisturbed: Path) -> None:
    """Runs, boundaries, JSON, page, table and figure; the JSON has a boundary for each controller and cell."""
    assert {path.name for path in undisturbed.iterdir()} - {".lock"} == FILES
    made = json.loads((undisturbed / "map.json").read_text())
    assert [(each["who"], each["speed"]) for each in made["boundaries"]] == [
        ("brake", 15.0),
        ("brake", 20.0),
        ("unified", 15.0),
        ("unified", 20.0),
    ]
    rows = pyarrow.parquet.read_table(undisturbed / "runs.parquet").to_pylist()
    for each in made["boundaries"]:
        mine = [row for row in rows if (row["who"], row["speed"]) == (each["who"], each["speed"])]
        assert each["n_runs"] == len(mine)
        assert all(row["outcome"] == "avoided" for row in mine if row["distance"] >= each["avoided"])
        assert each["avoided"] - each["failed"] == pytest.approx(1.0)


@pytest.mark.slow
def test_one_worker_makes_the_same_table_as_two(undisturbed: Path, tmp_path: Path) -> None:
    """Byte by byte."""
    assert finished(tmp_path, *BOTH, *SMALL, "--workers", "1").returncode == 0
    assert runs_in(tmp_path) == runs_in(undisturbed)


@pytest.mark.slow
def test_a_map_that_is_killed_three_times_ends_with_the_same_table(undisturbed: Path, tmp_path: Path) -> None:
    """With SIGKILL, each time after some more results; none is lost, none is stored twice, and no worker is left."""
    kept: list[str] = []
    for _ in range(3):
        before, kept = kept, killed(tmp_path, at_least=len(kept) + 3)
        assert set(before) < set(kept)
        assert len(kept) == len(set(kept))
    assert finished(tmp_path, *BOTH, *SMALL, "--workers", "2").returncode == 0
    assert runs_in(tmp_path) == runs_in(undisturbed)


@pytest.mark.slow
def test_a_finished_map_runs_nothing_again(undisturbed: Path) -> None:
    """It starts no worker either, whatever scheduler it is given, and prints the same."""
    before = runs_in(undisturbed)
    done = finished(undisturbed, *BOTH, *SMALL, "--scheduler", "127.0.0.1:1", "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == json.loads((undisturbed / "map.json").read_text())
    assert runs_in(undisturbed) == before


@pytest.mark.slow
def test_ctrl_c_keeps_what_is_there_and_says_how_to_go_on(tmp_path: Path) -> None:
    """Status 130, two lines beside the progress, no traceback of any worker, and no worker left."""
    going = begin(tmp_path, *BOTH, *SMALL, "--workers", "2")
    wait(lambda: len(keys_in(tmp_path)) >= 2)
    os.killpg(going.pid, signal.SIGINT)  # as a terminal does: to the workers as well
    out, err = going.communicate(timeout=60)
    told = [line for line in err.splitlines() if not re.fullmatch(r"swerve: \d+% done", line)]
    assert (going.returncode, out) == (130, "")
    assert told == [
        f"swerve: {len(keys_in(tmp_path))} results are kept in {tmp_path}; the same command goes on from there",
        "swerve: interrupted",
    ]
    wait(lambda: group_is_gone(going.pid))


@pytest.mark.slow
def test_a_worker_that_dies_does_not_hang_the_map(undisturbed: Path, tmp_path: Path) -> None:
    """It is started anew, and the table is the same."""
    going = begin(tmp_path, *BOTH, *SMALL, "--workers", "2")
    wait(lambda: len(keys_in(tmp_path)) >= 2)
    os.kill(workers_of(going.pid)[0], signal.SIGKILL)
    _, err = going.communicate(timeout=300)
    assert going.returncode == 0, err
    assert runs_in(tmp_path) == runs_in(undisturbed)


def dask(*arguments: str) -> "subprocess.Popen[bytes]":
    """A process of the `dask` command, without anything that it says."""
    silent = subprocess.DEVNULL
    return subprocess.Popen([sys.executable, "-m", "dask", *arguments], env=ENVIRONMENT, stdout=silent, stderr=silent)


def is_listening(port: int) -> bool:
    """Whether somebody takes connections there, on this machine."""
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0


@pytest.fixture
def scheduler() -> Iterator[str]:
    """A dask scheduler of its own process, and its address."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    process = dask("scheduler", "--host", "127.0.0.1", "--port", str(port), "--no-dashboard")
    wait(lambda: is_listening(port))
    yield f"tcp://127.0.0.1:{port}"
    process.terminate()
    process.wait()


@pytest.mark.slow
def test_a_scheduler_elsewhere_makes_the_same_table(undisturbed: Path, tmp_path: Path, scheduler: str) -> None:
    """With a worker that was started by hand."""
    worker = dask("worker", scheduler, "--nthreads", "1", "--no-dashboard", "--no-nanny")
    try:
        time.sleep(5.0)
        done = finished(tmp_path, *BOTH, *SMALL, "--scheduler", scheduler)
        assert done.returncode == 0, done.stderr
    finally:
        worker.terminate()
        worker.wait()
    assert runs_in(tmp_path) == runs_in(undisturbed)


@pytest.mark.slow
def test_a_scheduler_without_workers_is_refused(tmp_path: Path, scheduler: str) -> None:
    """Soon, and with what to start."""
    done = finished(tmp_path, *TINY, "--scheduler", scheduler)
    assert done.returncode == 2
    told = f"swerve: error: --scheduler {scheduler}: has no worker; start one with `dask worker ADDRESS`\n"
    assert done.stderr == told


@pytest.mark.parametrize("address", ["127.0.0.1:1", "nowhere://127.0.0.1:1", "127.0.0.1:port", ""])
def test_an_unreachable_scheduler_is_refused(tmp_path: Path, address: str) -> None:
    """Within ten seconds, in one line."""
    began = time.monotonic()
    done = finished(tmp_path / "map", *TINY, "--scheduler", address)
    assert (done.returncode, done.stdout) == (2, "")
    assert re.fullmatch(r"swerve: error: --scheduler .*: cannot be reached; start one with .*\n", done.stderr)
    assert time.monotonic() - began < 20.0


@pytest.mark.parametrize(
    "arguments, told",
    [
        (("--controllers", "unifeid"), "--controllers: unknown controller 'unifeid'; did you mean unified?"),
        (("--plant", "plane"), "--plant: unknown plant 'plane'; did you mean planar?"),
        (("--speeds", "72 km/h,fast"), "--speeds: 'fast' is not a speed; write a number in m/s"),
        (("--speeds", "0"), "--speeds: 0 is out of range; write 1 to 100, in SI"),
        (("--speeds", ""), "--speeds: '' is not a speed"),
        (("--frictions", "0.85,-1"), "--frictions: -1 is out of range"),
        (("--offsets", "nan"), "--offsets: "),
        (("--tolerance", "0"), "--tolerance: 0 is out of range"),
        (("--limit", "braking,none"), "--limit: unknown mean 'none'"),
        (("--seed", "-1"), "argument --seed: '-1' is no seed"),
        (("--workers", "0"), "--workers: 0 is out of range"),
        (("--workers", "2", "--scheduler", "127.0.0.1:1"), "--workers: the workers are those of --scheduler"),
        (("--set", "obstacles=[]"), "obstacles: none is ahead"),
        (("pedestrian-crossing",), "obstacles.0: moves across the road"),
        (("papre",), "papre: no such scenario; did you mean paper?"),
    ],
)
def test_wrong_input_is_told_and_nothing_is_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], told: str
) -> None:
    """In one line, before anything is run."""
    out = tmp_path / "map"
    assert main(["map", *arguments, "--out", str(out)]) == 2
    printed = capsys.readouterr()
    assert printed.err.startswith(f"swerve: error: {told}")
    assert (printed.out, printed.err.count("\n")) == ("", 1)
    assert not out.exists()


def test_a_folder_that_is_none_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A file stays as it was."""
    (tmp_path / "map").write_text("mine")
    assert main(["map", *TINY, "--out", str(tmp_path / "map")]) == 2
    assert re.search("--out .*: cannot be written", capsys.readouterr().err)
    assert (tmp_path / "map").read_text() == "mine"


def test_without_dask_it_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The extra's name."""
    monkeypatch.setitem(sys.modules, "distributed", None)
    assert main(["map", *TINY, "--out", str(tmp_path)]) == 2
    told = "map needs dask.distributed, which is not installed; install it with: pip install 'swerve[map]'"
    assert capsys.readouterr().err == f"swerve: error: {told}\n"
