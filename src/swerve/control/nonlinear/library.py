"""The functions of a program as a shared library, in the folder of the kernels and with their flags but for one.

A sample's second derivatives are thirty thousand lines without a branch: -O3 takes half as long again as -O1 to compile
them, and they run no faster.
"""

import hashlib
import os
import shlex
import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path

import casadi as ca

from swerve.errors import SwerveError
from swerve.kernel.folder import private_folder
from swerve.kernel.library import FLAGS as KERNEL_FLAGS
from swerve.kernel.processor import processor_id

FLAGS = (*KERNEL_FLAGS, "-O1")  # the last level given counts


def library(name: str, functions: Iterable[ca.Function]) -> Path:
    """Compile functions into one library, or take it from an earlier time.

    Raises:
        SwerveError: there is no folder for it, or no compiler that can make it.
    """
    folder = private_folder()
    name_of_compiler, *options = shlex.split(os.environ.get("CC", "")) or ["cc"]
    compiler = shutil.which(name_of_compiler)
    if folder is None or compiler is None:
        raise SwerveError("the nonlinear program runs compiled only: it needs a C compiler and a folder for libraries")
    generator = ca.CodeGenerator(name, {"with_header": False})
    for function in functions:
        generator.add(function)
    source = str(generator.dump())
    command = [compiler, *options, *FLAGS]
    recipe = "\0".join((source, *command, processor_id()))
    target = folder / f"{name}-{hashlib.sha256(recipe.encode()).hexdigest()[:24]}.so"
    if not target.exists():
        _compile(command, source, target)
    return target


def _compile(command: Sequence[str], source: str, target: Path) -> None:
    with tempfile.TemporaryDirectory(dir=target.parent) as work:
        code, made = Path(work, "program.c"), Path(work, "program.so")
        code.write_text(source)
        files = (str(code), "-o", str(made), "-lm")
        run = subprocess.run([*command, *files], capture_output=True, text=True, check=False)
        if run.returncode != 0:
            raise SwerveError(f"{command[0]} could not compile {target.stem}: {run.stderr[:300]}")
        made.replace(target)
