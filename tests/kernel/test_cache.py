"""The folder of compiled kernels: compiled once, whole or not at all, never what others could have written."""

import logging
import os
import subprocess
import sys
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from swerve.kernel import Kernel
from swerve.kernel.folder import VARIABLE
from swerve.kernel.library import FLAGS, compiled
from tests.kernel.compilers import answer, compiler, counting, example, script, start

LOCK = "compiling.lock"


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder of kernels for this process."""
    monkeypatch.setenv(VARIABLE, str(tmp_path / "kernels"))
    return tmp_path / "kernels"


def contents(folder: Path) -> set[str]:
    """Names of the files, but for the lock."""
    return {each.name for each in folder.iterdir()} - {LOCK}


def test_the_second_process_compiles_nothing(tmp_path: Path) -> None:
    """What one process has compiled the next one loads."""
    command, compilations = counting(tmp_path)
    first = answer(start(tmp_path / "kernels", CC=command))
    assert compilations() == 1
    assert answer(start(tmp_path / "kernels", CC=command)) == first
    assert compilations() == 1


def test_many_processes_may_start_at_once(tmp_path: Path) -> None:
    """On an empty cache all get the same compiled kernel, one of them compiles it, and nothing else is left behind."""
    command, compilations = counting(tmp_path)
    processes = [start(tmp_path / "kernels", CC=command) for _ in range(6)]
    answers = [answer(each) for each in processes]
    assert answers[0][0] == "True"
    assert answers == [answers[0]] * 6
    assert compilations() == 1
    assert [Path(each).suffix for each in contents(tmp_path / "kernels")] == [".so"]


def test_a_process_without_a_compiler_gets_the_same_number(tmp_path: Path) -> None:
    """CC=none, or a machine without a compiler, gives the same bits and leaves the folder empty."""
    known = answer(start(tmp_path / "compiled"))[1]
    nowhere = tmp_path / "no-programs"
    nowhere.mkdir()
    for environment in ({"CC": "none"}, {"PATH": str(nowhere), "CC": "cc"}):
        assert answer(start(tmp_path / "empty", **environment)) == ["False", known]
    assert contents(tmp_path / "empty") == set()


def test_a_function_is_written_as_c_once(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A second kernel of the same function costs no code generation, and is no other kernel."""
    written = []
    generator = ca.CodeGenerator
    monkeypatch.setattr(ca, "CodeGenerator", lambda *args: written.append(args) or generator(*args))
    function, arguments = example(), ([1.0, 2.0, 3.0], [[0.0] * 3] * 2)
    kernels = [Kernel(function), Kernel(function)]
    assert len(written) == 1
    first = kernels[0](*arguments)
    kernels[1]([0.0] * 3, arguments[1])
    for one, other in zip(first, kernels[0](*arguments), strict=True):
        np.testing.assert_array_equal(one, other)


def test_a_changed_function_is_another_library(cache: Path) -> None:
    """The same function is found again; one with another constant in it is not taken for it."""
    first = compiled(example(factor=1.0))
    assert first is not None
    assert compiled(example(factor=1.0)) == first
    assert compiled(example(factor=2.0)) != first
    assert Kernel(example(factor=2.0))([1.0, 2.0, 3.0], [[0.0] * 3] * 2)[2] == 2 * 14.0 * 1.0 + 6.0
    assert len(contents(cache)) == 2


def test_other_flags_or_another_compiler_are_another_library(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A library that was made in another way is not loaded."""
    found = [compiled(example())]
    with compiler(monkeypatch, counting(tmp_path)[0]):
        found.append(compiled(example()))
    with compiler(monkeypatch, "cc -fno-math-errno"):
        found.append(compiled(example()))
    monkeypatch.setattr("swerve.kernel.library.FLAGS", ("-O1", *FLAGS[1:]))
    found.append(compiled(example()))
    monkeypatch.setattr("swerve.kernel.library.processor_id", lambda: "another processor")
    found.append(compiled(example()))
    assert None not in found
    assert len(set(found)) == 5
    assert len(contents(cache)) == 5


@pytest.mark.parametrize("damage", ["empty", "cut", "zeros", "one bit"])
def test_a_damaged_library_is_compiled_anew(cache: Path, damage: str) -> None:
    """What a full disk or a lost power supply leaves of a library is not loaded but made again."""
    library = compiled(example())
    assert library is not None
    whole = library.read_bytes()
    flipped = bytearray(whole)
    flipped[len(whole) // 2] ^= 1
    damaged = {"empty": b"", "cut": whole[: len(whole) // 2], "zeros": bytes(len(whole)), "one bit": bytes(flipped)}
    library.write_bytes(damaged[damage])
    kernel = Kernel(example())
    assert kernel.is_compiled
    assert kernel([1.0, 2.0, 3.0], [[0.0] * 3] * 2)[2] == 20.0
    assert library.read_bytes() == whole


def test_a_compiler_that_fails_costs_speed_only(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    """The compiler's words are a warning, the kernel runs uncompiled, and no half of a library is left."""
    failing = script(tmp_path / "failing-cc", '[ "$1" = --version ] && exit 0\necho "out of registers" >&2\nexit 1')
    with compiler(monkeypatch, failing):
        kernel = Kernel(example())
    assert not kernel.is_compiled
    assert kernel([1.0, 2.0, 3.0], [[0.0] * 3] * 2)[2] == 20.0
    assert [record.levelno for record in caplog.records] == [logging.WARNING]
    assert "out of registers" in caplog.text
    assert contents(cache) == set()


@pytest.mark.skipif(os.name != "posix", reason="permission bits")
@pytest.mark.parametrize("mode", [0o770, 0o707, 0o777])
def test_a_folder_that_others_can_write_to_is_refused(cache: Path, caplog: pytest.LogCaptureFixture, mode: int) -> None:
    """Code that anyone could have put there is not loaded: a warning that says the cure, and an uncompiled kernel."""
    cache.mkdir()
    cache.chmod(mode)
    assert not Kernel(example()).is_compiled
    assert "chmod 700" in caplog.text
    assert str(cache) in caplog.text
    assert contents(cache) == set()


@pytest.mark.skipif(os.name != "posix", reason="owners")
def test_another_users_folder_is_refused(
    cache: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    """A folder that somebody else owns is not trusted, whatever its mode is."""
    owner = os.getuid()
    monkeypatch.setattr(os, "getuid", lambda: owner + 1)
    assert not Kernel(example()).is_compiled
    assert [record.levelno for record in caplog.records] == [logging.WARNING]


@pytest.mark.skipif(os.name != "posix", reason="permission bits")
def test_a_new_folder_is_the_users_alone(cache: Path) -> None:
    """The folder is made with its parents, and nobody else may write into it, whatever the umask says."""
    before = os.umask(0o000)
    try:
        assert Kernel(example()).is_compiled
    finally:
        os.umask(before)
    assert cache.stat().st_mode & 0o777 == 0o700


def test_a_folder_that_cannot_be_made_costs_speed_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    """With a file where the folder should be, kernels run uncompiled, after a warning."""
    (tmp_path / "file").write_text("not a folder")
    monkeypatch.setenv(VARIABLE, str(tmp_path / "file" / "kernels"))
    assert not Kernel(example()).is_compiled
    assert [record.levelno for record in caplog.records] == [logging.WARNING]


def test_a_full_disk_costs_speed_only(
    cache: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    """A folder that takes no more files gives a warning and an uncompiled kernel."""

    def refuse(*arguments: object, **named: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("swerve.kernel.library.tempfile.TemporaryDirectory", refuse)
    assert not Kernel(example()).is_compiled
    assert "No space left on device" in caplog.text


def test_a_compiler_is_a_command(cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """CC may hold options, as it does for make: a launcher in front of the compiler is used."""
    launcher = script(tmp_path / "launcher", 'exec "$@"')
    with compiler(monkeypatch, f"{launcher} cc"):
        assert Kernel(example()).is_compiled


def test_the_temporary_folder_goes_with_a_killed_compiler(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A compiler that dies of a signal is one that fails: nothing stays, and the next one may try again."""
    dying = script(tmp_path / "dying-cc", '[ "$1" = --version ] && exit 0\nkill -9 $$')
    with compiler(monkeypatch, dying):
        assert compiled(example()) is None
    assert contents(cache) == set()
    assert compiled(example()) is not None


def test_importing_a_kernel_needs_no_compiler_run() -> None:
    """The compiler is asked for its version when the first kernel is made, not before."""
    program = "import subprocess; subprocess.run = None; import swerve.kernel, swerve.simulate"
    subprocess.run([sys.executable, "-c", program], check=True, timeout=60)
