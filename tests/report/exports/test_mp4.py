"""MP4: what goes to ffmpeg, and what is said where it fails."""

import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from swerve.errors import SwerveError
from swerve.report.exports.frames import SIZE, Frames
from swerve.report.exports.mp4_file import write_mp4
from tests.report.runs import made

needs_shell = pytest.mark.skipif(sys.platform == "win32", reason="a shell script stands in for ffmpeg")


def _stand_in(folder: Path, monkeypatch: pytest.MonkeyPatch, script: str) -> None:
    """Let `ffmpeg` be a shell script."""
    program = folder / "bin" / "ffmpeg"
    program.parent.mkdir()
    program.write_text(f"#!/bin/sh\n{script}\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", str(program.parent), prepend=":")


@needs_shell
def test_ffmpeg_gets_every_picture(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """All pictures come through the pipe, byte by byte, and their size, form and rate in the arguments."""
    _stand_in(tmp_path, monkeypatch, f'echo "$@" > {tmp_path}/arguments; for last; do :; done; cat > "$last"')
    done = made("duration=0.2 s", controller="unified")
    write_mp4(done, tmp_path / "view.mp4")
    drawn = np.stack(list(Frames.of(done).draw()))
    assert len(drawn) == 5
    assert (tmp_path / "view.mp4").read_bytes() == drawn.tobytes()
    arguments = (tmp_path / "arguments").read_text()
    assert f"-f rawvideo -pix_fmt rgb24 -s {SIZE[0]}x{SIZE[1]} -r 1000/50 -i -" in arguments


@needs_shell
@pytest.mark.parametrize("script", ["exit 1", "cat > /dev/null; exit 3"], ids=["at once", "at the end"])
def test_what_ffmpeg_complains_of_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, script: str) -> None:
    """Where ffmpeg fails, before or after it has read the pictures, its last line is the message."""
    _stand_in(tmp_path, monkeypatch, f"echo first >&2; echo 'Unknown encoder' >&2; {script}")
    with pytest.raises(SwerveError, match=r"^mp4: ffmpeg failed: Unknown encoder$"):
        write_mp4(made("duration=0.2 s"), tmp_path / "view.mp4")


@needs_shell
def test_a_mute_failure_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where ffmpeg fails and says nothing, the message says that."""
    _stand_in(tmp_path, monkeypatch, "exit 1")
    with pytest.raises(SwerveError, match=r"^mp4: ffmpeg failed: it says nothing$"):
        write_mp4(made("duration=0.2 s"), tmp_path / "view.mp4")


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="there is no ffmpeg here")
def test_a_real_ffmpeg_makes_a_video_of_it(tmp_path: Path) -> None:
    """The video has the pictures, in number and, but for its compression, in colour."""
    done = made(controller="unified")
    write_mp4(done, tmp_path / "view.mp4")
    read = [
        "ffmpeg",
        "-loglevel",
        "error",
        "-i",
        str(tmp_path / "view.mp4"),
        "-f",
        "rawvideo",
        "-pix_fmt",
        "rgb24",
        "-",
    ]
    pixels = np.frombuffer(subprocess.run(read, capture_output=True, check=True).stdout, np.uint8)
    drawn = np.stack(list(Frames.of(done).draw()))
    assert pixels.size == drawn.size
    assert np.abs(pixels.reshape(drawn.shape).astype(int) - drawn).mean() < 5  # of 255
