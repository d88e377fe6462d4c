"""`swerve view`: how it begins, what it refuses, and how it ends."""

import socket
import subprocess
import sys
import time
from pathlib import Path

import pytest

from swerve.cli import main
from swerve.scenario import load
from tests.studio.servers import Server, served

LONG = load("far-away", ["duration=100 s"]).to_toml()


def _error(capsys: pytest.CaptureFixture[str]) -> str:
    captured = capsys.readouterr()
    assert captured.out == ""
    return captured.err


@pytest.mark.parametrize("port", ["-1", "65536", "x", "80.5", "٣"])
def test_a_port_that_is_none_is_told(port: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A port is a whole number of 16 bits."""
    assert main(["view", str(tmp_path), f"--port={port}"]) == 2
    assert f"{port!r} is no port; write a whole number from 0 to 65535" in _error(capsys)


def test_a_port_that_is_taken_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Another one's port is not shared."""
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        assert main(["view", str(tmp_path), "--port", str(port)]) == 2
    assert _error(capsys) == (
        f"swerve: error: --port {port}: Address already in use; write another one, or 0 for any that is free\n"
    )


def test_a_folder_that_is_none_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """There is nothing to see."""
    assert main(["view", str(tmp_path / "none")]) == 2
    assert "there is no such folder; write one with finished runs in it" in _error(capsys)


@pytest.mark.parametrize("name", ["fastapi", "uvicorn"])
def test_what_is_not_installed_is_told(name: str, tmp_path: Path) -> None:
    """Without its extra the command says what to install, and no other command needs it."""
    hidden = f"""
import importlib.abc, sys
class Hide(importlib.abc.MetaPathFinder):
    def find_spec(self, module, path, target=None):
        if module.split(".")[0] == {name!r}:
            raise ModuleNotFoundError(module)
sys.meta_path.insert(0, Hide())
import importlib.util
real = importlib.util.find_spec
importlib.util.find_spec = lambda module, *rest: None if module == {name!r} else real(module, *rest)
from swerve.cli import main
sys.exit(main(["view", {str(tmp_path)!r}]) + 10 * main(["scenarios"]))
"""
    done = subprocess.run([sys.executable, "-c", hidden], capture_output=True, text=True, timeout=60)
    assert done.returncode == 2
    assert done.stderr == (
        f"swerve: error: view needs {name}, which is not installed; install it with: pip install 'swerve[view]'\n"
    )


def _lives(process: str) -> bool:
    """Whether a process of this number still does anything, after a moment in which it may end."""
    state = Path("/proc") / process / "stat"
    for _ in range(50):
        try:
            if state.read_text().rpartition(")")[2].split()[0] == "Z":  # ended, and nobody has asked how
                return False
        except OSError:
            return False
        time.sleep(0.1)
    return True


def test_ctrl_c_ends_it_with_all_that_runs(tmp_path: Path) -> None:
    """In the middle of a run it ends at once, with status 0, without a word on stderr, and leaves nothing behind."""
    with served(tmp_path) as server:
        status, job = server.post("/api/jobs", {"toml": LONG})
        assert status == 202
        while server.get(f"/api/jobs/{job['number']}")["share"] == 0.0:
            time.sleep(0.05)
        children = subprocess.run(
            ["ps", "--ppid", str(server.process.pid), "-o", "pid="], capture_output=True, text=True, check=True
        ).stdout.split()
        assert children
    assert server.process.returncode == 0
    assert server.said == ["ended\n", ""]
    assert not any(map(_lives, children))
    assert list(tmp_path.iterdir()) == []


def test_it_listens_to_this_machine_alone(server: Server) -> None:
    """Of all addresses of this machine only the loopback interface's has the port, another one of that not even."""
    assert server.ask("/api/runs")[0] == 200
    own = {str(each[4][0]) for each in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)}
    for address in own | {"127.0.0.2"}:
        with socket.socket() as probe:
            assert (probe.connect_ex((address, server.port)) == 0) is (address == "127.0.0.1")
