"""`swerve view`: finished runs in a browser, and new ones of scenes that are moved by hand."""

import argparse
import importlib.util
from pathlib import Path
from typing import Any, Final

from swerve.errors import InputError

NEEDED: Final = ("fastapi", "uvicorn")
LARGEST_PORT: Final = 65535


def add_command(commands: Any) -> None:
    """Add it to a parser's `commands`."""
    view = commands.add_parser("view", help="see finished runs and try scenes in a browser", allow_abbrev=False)
    view.set_defaults(call=_view)
    view.add_argument("directory", type=Path, metavar="DIR", help="with runs, comparisons and maps, or one of them")
    view.add_argument("--port", type=_port, default=8000, help="of this machine; 0 for any that is free [8000]")


def _port(text: str) -> int:
    if text.isascii() and text.isdigit() and len(text) <= 5 and int(text) <= LARGEST_PORT:
        return int(text)
    raise argparse.ArgumentTypeError(f"{text[:40]!r} is no port; write a whole number from 0 to {LARGEST_PORT}")


def _view(options: argparse.Namespace) -> int:
    for name in NEEDED:
        if importlib.util.find_spec(name) is None:
            raise InputError(f"view needs {name}, which is not installed; install it with: pip install 'swerve[view]'")
    from swerve.studio.server import serve

    try:
        serve(options.directory, options.port, lambda address: print(f"{address} (Ctrl-C ends it)", flush=True))
    except KeyboardInterrupt:  # the way to end it
        print("ended", flush=True)
    return 0
