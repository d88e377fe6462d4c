"""Helpers for the kernel tests: functions to compile, and compilers that count or refuse."""

import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeVar

import casadi as ca
import pytest

from swerve.kernel.folder import VARIABLE
from swerve.kernel.library import OPT_OUT, _compiler

Made = TypeVar("Made")

# A program that makes a kernel and prints whether it was compiled, and its value to the last bit.
PROGRAM = """
import casadi as ca
from swerve.kernel import Kernel
x = ca.SX.sym("x", 3)
kernel = Kernel(ca.Function("program", [x], [ca.sin(x[0]) * ca.atan(x[1]) / ca.sqrt(x[2])]))
print(kernel.is_compiled, kernel((0.3, -2.0, 7.0))[0][0].hex())
"""


def example(name: str = "example", factor: float = 1.0) -> ca.Function:
    """(x (3,), y (2, 3)) -> a column, a matrix and a scalar, through all kinds of operations."""
    x, y = ca.SX.sym("x", 3), ca.SX.sym("y", 2, 3)
    column = ca.vertcat(ca.sin(x[0]) * x[1] + x[2] ** 3, ca.fmin(x[0], x[1]) - ca.fmax(x[1], x[2]))
    matrix = ca.if_else(y > 0, ca.sqrt(ca.fabs(y)), ca.atan(y)) / (1 + y**2)
    return ca.Function(name, [x, y], [column, matrix, factor * ca.dot(x, x) * x[0] + x[1] * x[2]])


@contextmanager
def compiler(patch: pytest.MonkeyPatch, command: str) -> Iterator[None]:
    """Kernels that are made inside have this C compiler, or none with "none"."""
    with patch.context() as inside:
        inside.setenv("CC", command)
        _compiler.cache_clear()
        yield
    _compiler.cache_clear()


def uncompiled(patch: pytest.MonkeyPatch, make: Callable[[], Made]) -> Made:
    """What `make` makes, with kernels that run in CasADi's machine."""
    with compiler(patch, OPT_OUT):
        return make()


def script(path: Path, body: str) -> str:
    """An executable shell script; its path."""
    path.write_text(f"#!/bin/sh\n{body}\n")
    path.chmod(0o755)
    return str(path)


def counting(folder: Path) -> tuple[str, Callable[[], int]]:
    """A compiler that is `cc`, and how often it has compiled."""
    log = folder / "compiled.log"
    log.touch()
    body = f'[ "$1" = --version ] || echo once >> "{log}"\nexec cc "$@"'
    return script(folder / "counting-cc", body), lambda: len(log.read_text().splitlines())


def start(cache: Path, **environment: str) -> "subprocess.Popen[str]":
    """PROGRAM in a process of its own, with this folder of kernels."""
    return subprocess.Popen(
        [sys.executable, "-c", PROGRAM],
        env={**os.environ, VARIABLE: str(cache), **environment},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def answer(process: "subprocess.Popen[str]") -> Any:
    """What PROGRAM printed: [compiled or not, value]; it must end well."""
    out, err = process.communicate(timeout=60)
    assert process.returncode == 0, err
    return out.split()
