"""The top view in motion as MP4, by the `ffmpeg` that is on the PATH: pictures go to it one by one, through a pipe."""

import subprocess
from pathlib import Path
from tempfile import TemporaryFile
from typing import Final

from swerve.errors import SwerveError, one_line
from swerve.report.exports.frames import SIZE, Frames
from swerve.simulate import Run

PROGRAM: Final = "ffmpeg"


def write_mp4(run: Run, path: Path) -> None:
    """Write a run's top view to an .mp4 file.

    Raises:
        SwerveError: ffmpeg fails; the text is the last that it said.
    """
    frames = Frames.of(run)
    with TemporaryFile() as said:  # a pipe that nobody reads would stop it when full
        with subprocess.Popen(_command(frames.interval, path), stdin=subprocess.PIPE, stderr=said) as ffmpeg:
            assert ffmpeg.stdin is not None
            try:
                for picture in frames.draw():
                    ffmpeg.stdin.write(picture.tobytes())
                ffmpeg.stdin.close()
            except BrokenPipeError:  # it has given up, and says why
                pass
        if ffmpeg.returncode != 0:
            said.seek(0)
            lines = said.read().decode("utf-8", "replace").strip().splitlines() or ["it says nothing"]
            raise SwerveError(f"mp4: {PROGRAM} failed: {one_line(lines[-1], 200)}")


def _command(interval: float, path: Path) -> list[str]:
    size, rate = f"{SIZE[0]}x{SIZE[1]}", f"1000/{round(1000 * interval)}"  # [1/s]
    pictures = ["-f", "rawvideo", "-pix_fmt", "rgb24", "-s", size, "-r", rate, "-i", "-"]
    video = ["-pix_fmt", "yuv420p", "-movflags", "+faststart", str(path.absolute())]
    return [PROGRAM, "-hide_banner", "-loglevel", "error", "-y", *pictures, *video]
