"""`swerve view` as its users have it: a process that is asked over the network."""

import json
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.client import HTTPConnection
from pathlib import Path
from typing import Any

JSON = {"Content-Type": "application/json"}


@dataclass(frozen=True)
class Server:
    """A server that runs.

    Attributes:
        directory: with its runs.
        port: on this machine.
        process: of it.
        said: on stdout and stderr after its address, once it has ended.
    """

    directory: Path
    port: int
    process: "subprocess.Popen[str]"
    said: list[str] = field(default_factory=list)

    @property
    def address(self) -> str:
        """Without a slash at its end."""
        return f"http://127.0.0.1:{self.port}"

    def ask(
        self, path: str, method: str = "GET", body: bytes | None = None, headers: dict[str, str] | None = None
    ) -> tuple[int, dict[str, str], bytes]:
        """Status, headers and body of the answer; the path goes out as it is written."""
        connection = HTTPConnection("127.0.0.1", self.port, timeout=30)
        connection.request(method, path, body, headers or {})
        answer = connection.getresponse()
        found = (answer.status, {name.lower(): value for name, value in answer.getheaders()}, answer.read())
        connection.close()
        return found

    def post(self, path: str, content: object) -> tuple[int, Any]:
        """Status and JSON of the answer to some JSON."""
        status, _, body = self.ask(path, "POST", json.dumps(content).encode(), JSON)
        return status, json.loads(body)

    def get(self, path: str) -> Any:
        """The JSON of an answer."""
        return json.loads(self.ask(path)[2])


@contextmanager
def served(directory: Path) -> Iterator[Server]:
    """A server over a folder, on a free port, ended by an interrupt."""
    command = [sys.executable, "-m", "swerve", "view", str(directory), "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout
        address = process.stdout.readline().split()[0]
        server = Server(directory, int(address.rsplit(":", 1)[1].strip("/")), process)
        try:
            yield server
        finally:
            process.send_signal(signal.SIGINT)
            server.said.extend(process.communicate(timeout=30))
