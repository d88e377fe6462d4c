"""The studio's queue: few runs at once, few that wait, none that takes for ever, and any of them can be cancelled."""

import shutil
import threading
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from queue import SimpleQueue
from typing import Final

from swerve.errors import SwerveError
from swerve.studio.job import Job
from swerve.studio.runs import Runs
from swerve.studio.worker import Order, RunFailed, Worker

WORKERS: Final = 1  # runs at once
MOST_WAITING: Final = 8  # runs
TIME_LIMIT: Final = 60.0  # of a run [s]
MOST_KEPT: Final = 200  # jobs that are over and can still be asked about


class QueueFull(Exception):
    """There is no room for another run; the text says so."""


class Jobs:
    """All jobs of a studio. Its threads do nothing but wait for their processes.

    Args:
        runs: where finished runs go.
        time_limit: of a run [s].
        workers: runs at once.
        most_waiting: runs.
    """

    def __init__(
        self,
        runs: Runs,
        time_limit: float = TIME_LIMIT,
        workers: int = WORKERS,
        most_waiting: int = MOST_WAITING,
    ) -> None:
        self._runs, self._time_limit, self._most_waiting = runs, time_limit, most_waiting
        self._lock = threading.Lock()
        self._jobs: dict[int, Job] = {}
        self._waiting: SimpleQueue[int | None] = SimpleQueue()
        self._ended = threading.Event()
        self._cancelled: set[int] = set()
        self._count = 0
        self._threads = [threading.Thread(target=self._work, daemon=True) for _ in range(workers)]

    def start(self) -> None:
        """Start the processes; they warm up on their own."""
        for thread in self._threads:
            thread.start()

    def stop(self) -> None:
        """Cancel everything and end the processes."""
        self._ended.set()
        for _ in self._threads:
            self._waiting.put(None)
        for thread in self._threads:
            thread.join()

    def add(self, order: Order) -> Job:
        """A new job at the end of the queue; QueueFull where there is no room."""
        with self._lock:
            waiting = sum(job.state == "waiting" for job in self._jobs.values())
            if waiting >= self._most_waiting:
                raise QueueFull(f"{waiting} runs wait already; try again when one of them is done")
            self._count += 1
            job = self._jobs[self._count] = Job(self._count, order)
            self._forget()
        self._waiting.put(job.number)
        return job

    def get(self, number: int) -> Job | None:
        """A job; None where there is none, or it was over long ago."""
        return self._jobs.get(number)

    def cancel(self, number: int) -> Job | None:
        """Cancel a job that is not over; the job, None where there is none."""
        with self._lock:
            job = self._jobs.get(number)
            if job is None or job.is_over:
                return job
            self._cancelled.add(number)
            if job.state == "waiting":
                self._jobs[number] = replace(job, state="cancelled")
            return self._jobs[number]

    def _forget(self) -> None:
        over = [number for number, job in self._jobs.items() if job.is_over]
        for number in over[: max(0, len(over) - MOST_KEPT)]:
            del self._jobs[number]
            self._cancelled.discard(number)

    def _change(self, number: int, **changes: object) -> None:
        with self._lock:
            self._jobs[number] = replace(self._jobs[number], **changes)  # type: ignore[arg-type]

    def _work(self) -> None:
        """What a thread does: give one job after the other to its process."""
        worker = Worker()
        while (number := self._waiting.get()) is not None and not self._ended.is_set():
            with self._lock:
                job = self._jobs[number]
                if job.is_over:
                    continue
                self._jobs[number] = replace(job, state="running")
            self._make(worker, job)
        worker.stop()

    def _make(self, worker: Worker, job: Job) -> None:
        directory = None
        try:
            directory = self._reserve()
            worker.run(job.order, directory, lambda share: self._change(job.number, share=share), self._reason(job))
            self._change(job.number, state="done", share=1.0, run=directory.name)
        except (RunFailed, SwerveError, OSError) as error:
            if directory is not None:
                shutil.rmtree(directory, ignore_errors=True)
            state = "cancelled" if job.number in self._cancelled else "failed"
            self._change(job.number, state=state, message=str(error))

    def _reserve(self) -> Path:
        """A new folder that no other job gets."""
        with self._lock:
            directory = self._runs.new()
            directory.mkdir()
            return directory

    def _reason(self, job: Job) -> Callable[[], str]:
        """What tells why a job that begins now has to be ended; "" while it has not."""
        end = time.monotonic() + self._time_limit

        def reason() -> str:
            if self._ended.is_set():
                return "the studio ends"
            if job.number in self._cancelled:
                return "cancelled"
            return f"it took longer than {self._time_limit:g} s" if time.monotonic() > end else ""

        return reason
