"""Processes that work beside one another, for the commands that make many runs."""

import argparse
import multiprocessing
import os
import signal
import sys
from collections.abc import Iterator
from concurrent.futures import BrokenExecutor, Executor, ProcessPoolExecutor
from contextlib import contextmanager
from threading import Thread
from typing import Any, Final

from swerve.errors import InputError, SwerveError

MOST_WORKERS: Final = 64
GRACE: Final = 1.0  # that a process is given to end, with the compiler that it may be waiting for [s]


def add_workers(parser: argparse.ArgumentParser, what: str) -> None:
    """Add --workers to a command's parser."""
    parser.add_argument("--workers", type=int, default=1, metavar="N", help=f"{what} run beside one another [1]")


def check_workers(n: int) -> None:
    """InputError for a number of processes that is out of range."""
    if not 1 <= n <= MOST_WORKERS:
        raise InputError(f"--workers: {n} is out of range; write a whole number from 1 to {MOST_WORKERS}")


@contextmanager
def pool(n: int) -> Iterator[Executor | None]:
    """`n` processes, of which none is left at the end, also at an interrupt; None where this one is enough.

    Raises:
        KeyboardInterrupt: once all of them have ended.
        SwerveError: one of them was ended by somebody else.
    """
    if n == 1:
        yield None
        return
    with ProcessPoolExecutor(n, initializer=_end_when_told) as executor:
        try:
            yield executor
        except (KeyboardInterrupt, SystemExit) as interrupt:  # Ctrl-C reaches them all: one of them may tell first
            executor.shutdown(wait=False, cancel_futures=True)
            _end_all()
            raise KeyboardInterrupt from interrupt
        except BrokenExecutor as error:
            fault = "one of the processes was ended before its work was done, as it is where the memory is full"
            raise SwerveError(f"{fault}; take fewer --workers") from error


def _end_when_told() -> None:
    """Leave by an exception, so that a compiler which is waited for is ended as well; and with whoever began it all."""
    for each in (signal.SIGINT, signal.SIGTERM):
        signal.signal(each, _leave)
    Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    """However the parent ends: nobody is left who would take what is done here."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _leave(number: int, frame: Any) -> None:
    sys.exit(128 + number)


def _end_all() -> None:
    children = multiprocessing.active_children()
    for each in children:
        each.terminate()
    for each in children:
        each.join(GRACE)
        each.kill()
