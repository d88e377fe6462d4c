"""The server of `swerve view`, for this machine alone."""

import socket
from collections.abc import Callable
from pathlib import Path
from typing import Final

import uvicorn

from swerve.errors import InputError, shown_path
from swerve.studio.app import studio_app

HOST: Final = "127.0.0.1"
HTTP_PORT: Final = 80
MOST_AT_ONCE: Final = 100  # connections
GRACE: Final = 2  # for requests that are not answered when the server ends [s]


def serve(directory: Path, port: int, ready: Callable[[str], None]) -> None:
    """Serve a folder of runs until an interrupt.

    Args:
        directory: with the runs.
        port: on the loopback interface; 0 for any that is free.
        ready: called with the address, once there is one.

    Raises:
        InputError: there is no such folder, or the port is taken.
        KeyboardInterrupt: as the server has ended, at an interrupt.
    """
    if not directory.is_dir():
        raise InputError(f"{shown_path(directory)}: there is no such folder; write one with finished runs in it")
    with _listening(port) as listener:
        actual = listener.getsockname()[1]
        app = studio_app(directory, _hosts(actual))
        config = uvicorn.Config(
            app,
            log_level="warning",
            access_log=False,
            server_header=False,
            ws="none",
            limit_concurrency=MOST_AT_ONCE,
            timeout_graceful_shutdown=GRACE,
        )
        ready(f"http://{HOST}:{actual}/")
        uvicorn.Server(config).run(sockets=[listener])


def _hosts(port: int) -> list[str]:
    """By which a browser calls this server; it leaves out the port that HTTP has anyway."""
    names = (HOST, "localhost")
    return [f"{name}:{port}" for name in names] + ([*names] if port == HTTP_PORT else [])


def _listening(port: int) -> socket.socket:
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    try:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind((HOST, port))
        listener.listen()  # who asks from here on waits until the server is up
    except OSError as error:
        listener.close()
        raise InputError(f"--port {port}: {error.strerror}; write another one, or 0 for any that is free") from error
    return listener
