"""From a CasADi function to a shared library in the user's cache.

The file's name is the hash of all that decides its content: the C code, the flags, the compiler and the processor. It
is written under a temporary name and renamed, so that a reader sees all of it or nothing; it ends in its own digest, so
that one which a full disk or a lost power supply has cut is compiled anew; a lock keeps many processes that start at
once from compiling the same code.
"""

import hashlib
import logging
import os
import shlex
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from functools import cache, lru_cache
from pathlib import Path

import casadi as ca
from filelock import FileLock

from swerve.kernel.folder import private_folder
from swerve.kernel.processor import processor_id

# No contraction of a*b + c: the result is that of CasADi's machine, on every processor.
FLAGS = ("-O3", "-march=native", "-ffp-contract=off", "-fPIC", "-shared")
OPT_OUT = "none"  # value of the environment variable CC that asks for CasADi's machine
SOURCES = 32  # kept in memory, some 100 kB each
DIGEST = hashlib.sha256
DIGEST_SIZE = DIGEST().digest_size  # [byte]
LOG = logging.getLogger(__name__)


def compiled(function: ca.Function) -> Path | None:
    """The shared library of `function`, or None where it can't be had (no compiler, no private folder)."""
    compiler = _compiler()
    folder = private_folder()
    if compiler is None or folder is None:
        return None
    source = _c_source(function)
    recipe = "\0".join((source, *FLAGS, *compiler, processor_id()))
    target = folder / f"{function.name()}-{DIGEST(recipe.encode()).hexdigest()[:24]}.so"
    try:
        if _is_whole(target):
            return target
        with FileLock(folder / "compiling.lock"):
            return target if _is_whole(target) or _compile(compiler[:-1], source, target) else None
    except OSError as error:
        LOG.warning("kernels run uncompiled: no library can be kept in %s: %s", folder, error)
        return None


@cache
def _compiler() -> tuple[str, ...] | None:
    """The C compiler: the words of its command ($CC, else cc) and, last, its version; None if there is none."""
    name, *options = shlex.split(os.environ.get("CC", "")) or ["cc"]
    path = None if name == OPT_OUT else shutil.which(name)
    if path is None:
        return None
    version = subprocess.run([path, *options, "--version"], capture_output=True, text=True, check=False)
    return (path, *options, version.stdout) if version.returncode == 0 else None


@lru_cache(maxsize=SOURCES)
def _c_source(function: ca.Function) -> str:
    """Kept, because it takes ten times as long as all else that a kernel does when its library is there."""
    generator = ca.CodeGenerator(function.name(), {"with_header": False})
    generator.add(function)
    return str(generator.dump())


def _compile(compiler: Sequence[str], source: str, target: Path) -> bool:
    """Write the library; False, with a warning, when the compiler refuses."""
    with tempfile.TemporaryDirectory(dir=target.parent) as work:
        code, library = Path(work, "kernel.c"), Path(work, "kernel.so")
        code.write_text(source)
        run = subprocess.run(
            [*compiler, *FLAGS, str(code), "-o", str(library), "-lm"], capture_output=True, text=True, check=False
        )
        if run.returncode != 0:
            words = " ".join(compiler)
            LOG.warning("%s could not compile %s; it runs slower, uncompiled: %s", words, target.stem, run.stderr[:300])
            return False
        content = library.read_bytes()
        library.write_bytes(content + DIGEST(content).digest())  # a loader reads no further than the headers say
        library.replace(target)
    return True


def _is_whole(library: Path) -> bool:
    """Whether the file is there and ends in its own digest."""
    content = library.read_bytes() if library.exists() else b""
    return DIGEST(content[:-DIGEST_SIZE]).digest() == content[-DIGEST_SIZE:]
