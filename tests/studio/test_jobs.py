"""The queue: few at once, few that wait, none for ever; and the process that makes the runs."""

import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from swerve.report.exports.folder import read_run_folder
from swerve.scenario import load, parse
from swerve.simulate import run
from swerve.studio import jobs as module
from swerve.studio.jobs import Job, Jobs, QueueFull
from swerve.studio.runs import Runs
from swerve.studio.worker import Order, RunFailed, Worker

PAPER = Order(load("paper", ["duration=0.5 s"]).to_toml(), "unified", "planar", 0)


class FakeWorker:
    """Makes a run when it is told to, or ends it when it is asked to."""

    finish = threading.Event()
    made: list[int] = []  # noqa: RUF012

    def run(self, order: Order, directory: Path, tell: Callable[[float], None], reason: Callable[[], str]) -> None:
        """Wait for either."""
        tell(0.5)
        while not self.finish.is_set():
            if sentence := reason():
                raise RunFailed(sentence)
            time.sleep(0.002)
        self.made.append(order.seed)

    def stop(self) -> None:
        """There is nothing to end."""


@pytest.fixture
def start(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., Jobs]]:
    """Starts a queue with one fake worker."""
    started: list[Jobs] = []
    monkeypatch.setattr(module, "Worker", FakeWorker)
    FakeWorker.finish.clear()
    FakeWorker.made.clear()

    def begin(**settings: float) -> Jobs:
        started.append(Jobs(Runs(tmp_path), **settings))  # type: ignore[arg-type]
        started[0].start()
        return started[0]

    yield begin
    for each in started:
        each.stop()


def _wait(jobs: Jobs, job: Job, *states: str) -> Job:
    """The job once it has one of the states."""
    end = time.monotonic() + 10
    while (found := jobs.get(job.number)) is None or found.state not in states:
        assert time.monotonic() < end, found
        time.sleep(0.002)
    return found


def test_runs_are_made_in_order(start: Callable[..., Jobs], tmp_path: Path) -> None:
    """The first to be ordered runs, the others wait, and all are made, each in a folder of its own."""
    jobs = start()
    ordered = [jobs.add(replace(PAPER, seed=seed)) for seed in range(3)]
    assert _wait(jobs, ordered[0], "running").run is None
    assert jobs.get(ordered[1].number) == ordered[1]
    FakeWorker.finish.set()
    assert [_wait(jobs, each, "done").run for each in ordered] == ["studio-0001", "studio-0002", "studio-0003"]
    assert FakeWorker.made == [0, 1, 2]
    assert sorted(each.name for each in tmp_path.iterdir()) == ["studio-0001", "studio-0002", "studio-0003"]


def test_the_queue_has_an_end(start: Callable[..., Jobs]) -> None:
    """Beyond those that may wait, an order is refused, and taken again when there is room."""
    jobs = start(most_waiting=2)
    first = jobs.add(PAPER)
    _wait(jobs, first, "running")
    waiting = [jobs.add(PAPER) for _ in range(2)]
    with pytest.raises(QueueFull, match="2 runs wait already"):
        jobs.add(PAPER)
    jobs.cancel(waiting[0].number)
    assert jobs.add(PAPER).state == "waiting"


def test_a_job_can_be_cancelled(start: Callable[..., Jobs], tmp_path: Path) -> None:
    """One that waits never begins, one that runs ends and leaves nothing; one that is over stays as it is."""
    jobs = start()
    running, waiting = jobs.add(replace(PAPER, seed=1)), jobs.add(replace(PAPER, seed=2))
    _wait(jobs, running, "running")
    assert jobs.cancel(waiting.number) == replace(waiting, state="cancelled")
    jobs.cancel(running.number)
    _wait(jobs, running, "cancelled")
    assert list(tmp_path.iterdir()) == []
    FakeWorker.finish.set()
    last = jobs.add(replace(PAPER, seed=3))
    done = _wait(jobs, last, "done")
    assert FakeWorker.made == [3]
    assert jobs.cancel(last.number) == done
    assert jobs.cancel(99) is None


def test_no_run_takes_for_ever(start: Callable[..., Jobs], tmp_path: Path) -> None:
    """After its time a run is ended, says why, and leaves nothing."""
    jobs = start(time_limit=0.05)
    failed = _wait(jobs, jobs.add(PAPER), "failed")
    assert failed.message == "it took longer than 0.05 s"
    assert list(tmp_path.iterdir()) == []


def test_old_jobs_are_forgotten(start: Callable[..., Jobs], monkeypatch: pytest.MonkeyPatch) -> None:
    """Only the last ones that are over can still be asked about."""
    monkeypatch.setattr(module, "MOST_KEPT", 2)
    jobs = start()
    FakeWorker.finish.set()
    done = [_wait(jobs, jobs.add(PAPER), "done") for _ in range(4)]
    assert jobs.get(done[0].number) is None
    assert jobs.get(done[3].number) == done[3]


def test_a_process_makes_the_same_run(tmp_path: Path) -> None:
    """A run of the process has the numbers of the same run made here; one that is ended leaves it fit for the next."""
    worker, shares = Worker(), []
    try:
        with pytest.raises(RunFailed, match="enough"):
            worker.run(PAPER, tmp_path / "ended", shares.append, lambda: "enough")
        worker.run(PAPER, tmp_path / "made", shares.append, lambda: "")
        with pytest.raises(RunFailed, match="unknown plant"):
            worker.run(replace(PAPER, plant="moon"), tmp_path / "none", shares.append, lambda: "")
    finally:
        worker.stop()
    expected = run(parse(PAPER.toml.encode(), "scene"), "unified", "planar", 0).log.motion
    found = read_run_folder(tmp_path / "made").log.motion
    for name, values in expected.columns.items():
        assert (found.columns[name] == values).all(), name
    assert shares[-1] == 1.0
    assert not (tmp_path / "ended").exists()
    assert not (tmp_path / "none").exists()
