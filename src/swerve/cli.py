"""The command line: parse and call (`commands`). What it prints and its exit statuses are what scripts hold on to.

    0  done, whatever the run's outcome        2    wrong input: one message on stderr, nothing written
    1  --require was not met                   130  interrupted

Everything heavy is imported by the command that needs it, so that --help answers at once.
"""

import argparse
import os
import sys
from collections.abc import Sequence
from typing import Final, NoReturn

from swerve import __version__
from swerve.commands import (
    compare,
    criticality,
    export,
    fit_tyre,
    limit,
    manoeuvres,
    map,
    reproduce,
    run,
    scenarios,
    studies,
    view,
)
from swerve.errors import InputError, SwerveError

INTERRUPTED: Final = 130  # 128 + SIGINT, as shells have it
BROKEN_PIPE: Final = 141  # 128 + SIGPIPE
COMMANDS: Final = (
    run,
    compare,
    scenarios,
    fit_tyre,
    reproduce,
    export,
    view,
    manoeuvres,
    limit,
    map,
    criticality,
    studies,
)


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line `argv`, that of the process by default, and return the exit status."""
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the matrices are small: a second thread only makes them wait
    try:
        status = _command(argv)
        sys.stdout.flush()
        return status
    except SwerveError as error:
        print(f"swerve: error: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("swerve: interrupted", file=sys.stderr)
        return INTERRUPTED
    except OSError as error:  # of the output: a reader that has seen enough, a full disk
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # or Python's flush at exit would fail again
        if isinstance(error, BrokenPipeError):
            return BROKEN_PIPE
        print(f"swerve: error: cannot write: {error}", file=sys.stderr)
        return 2


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise InputError(f"{message} (see {self.prog} --help)")


def _command(argv: Sequence[str] | None) -> int:
    try:
        options = _parser().parse_args(argv)
    except SystemExit:  # --help and --version have printed what they are for
        return 0
    status: int = options.call(options)
    return status


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(
        prog="swerve", description="Emergency manoeuvres: decided, driven and measured.", allow_abbrev=False
    )
    parser.add_argument("--version", action="version", version=f"swerve {__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    for command in COMMANDS:
        command.add_command(commands)
    return parser
