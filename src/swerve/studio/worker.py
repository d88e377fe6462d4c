"""A process that makes the studio's runs, one after the other, and that can be ended with one that takes too long."""

import multiprocessing
import signal
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final

from swerve.errors import SwerveError

EVERY: Final = 0.02  # between two looks at a run that is going on [s]
ENDING: Final = 5.0  # that a process is given to end [s]
WARM_UP: Final = ["duration=0.1 s"]  # of the run that loads all there is to load


@dataclass(frozen=True)
class Order:
    """A run that is wanted.

    Attributes:
        toml: of its scenario.
        controller: by name.
        plant: by name.
        seed: of all that is random.
    """

    toml: str
    controller: str
    plant: str
    seed: int


class RunFailed(Exception):
    """A run that was not made; the text is the reason."""


class Worker:
    """The process, as the studio sees it."""

    def __init__(self) -> None:
        self._start()

    def _start(self) -> None:
        context = multiprocessing.get_context("spawn")  # a fork of a process with threads may wait for ever
        self._pipe, theirs = context.Pipe()
        self._process = context.Process(target=_serve, args=(theirs,), daemon=True)
        self._process.start()
        theirs.close()  # so that the end of one process is seen by the other

    def run(self, order: Order, directory: Path, tell: Callable[[float], None], reason: Callable[[], str]) -> None:
        """Make a run and write its folder.

        Args:
            order: what is wanted.
            directory: of the run, empty.
            tell: called with the share that is done [1].
            reason: called now and then; a sentence ends the run.

        Raises:
            RunFailed: it was ended, or could not be made.
        """
        try:
            self._pipe.send((order, directory))
            while not self._heard(tell):
                if sentence := reason():
                    self._restart()
                    raise RunFailed(sentence)
        except (EOFError, OSError) as error:
            self._restart()
            raise RunFailed("the process that made it has ended") from error

    def _heard(self, tell: Callable[[float], None]) -> bool:
        """Read what the process says, if it says anything, and whether the run is made."""
        while self._pipe.poll(EVERY):
            kind, value = self._pipe.recv()
            if kind == "failed":
                raise RunFailed(value)
            if kind == "made":
                return True
            tell(value)
        return False

    def _restart(self) -> None:
        self.stop()
        self._start()

    def stop(self) -> None:
        """End the process, whatever it does."""
        self._pipe.close()
        self._process.kill()
        self._process.join(ENDING)


def _serve(pipe: Connection) -> None:
    """What the process does: warm up, then make what is ordered until nobody orders any more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the one that ends this process
    from swerve.report.write import write_record
    from swerve.scenario import load
    from swerve.simulate import run
    from swerve.studio.scene import read_scene

    with TemporaryDirectory() as place:
        write_record(run(load("paper", WARM_UP)), Path(place))

    def tell(share: float) -> None:
        pipe.send(("share", share))

    with suppress(EOFError, OSError):  # the other end is gone
        while True:
            order, directory = pipe.recv()
            try:
                write_record(run(read_scene(order.toml), order.controller, order.plant, order.seed, tell), directory)
                pipe.send(("made", None))
            except SwerveError as error:
                pipe.send(("failed", str(error)))
