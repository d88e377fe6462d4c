"""`swerve map` as a process, on a small map that ends soon."""

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pyarrow.parquet

ENVIRONMENT = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
SMALL = ["--plant", "planar", "--speeds", "15,20", "--frictions", "0.85", "--tolerance", "1", "--limit", "none"]
TINY = [*SMALL, "--controllers", "brake", "--speeds", "10", "--tolerance", "4"]


def command(out: Path, *arguments: str) -> list[str]:
    """The command line of a map that is written to `out`."""
    return [sys.executable, "-m", "swerve", "map", *arguments, "--out", str(out)]


def begin(out: Path, *arguments: str) -> "subprocess.Popen[str]":
    """The process, at its start, in a group of its own."""
    pipes: dict[str, Any] = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    return subprocess.Popen(command(out, *arguments), env=ENVIRONMENT, start_new_session=True, **pipes)


def finished(out: Path, *arguments: str) -> "subprocess.CompletedProcess[str]":
    """The process, at its end."""
    return subprocess.run(
        command(out, *arguments), env=ENVIRONMENT, check=False, capture_output=True, text=True, timeout=300
    )


def runs_in(out: Path) -> bytes:
    """The bytes of a finished map's runs."""
    return (out / "runs.parquet").read_bytes()


def keys_in(out: Path) -> list[str]:
    """Of all records that a stopped map has kept."""
    parts = sorted((out / "runs").glob("*.parquet"))
    return [key for part in parts for key in pyarrow.parquet.read_table(part)["key"].to_pylist()]
