"""The top view in motion as an animated picture, GIF or WebP: in real time, again and again."""

from pathlib import Path
from typing import Any, Final

from PIL import Image

from swerve.report.exports.frames import Frames
from swerve.simulate import Run

HOLD: Final = 1.0  # of the last picture [s]
OPTIONS: Final[dict[str, dict[str, Any]]] = {
    ".gif": {"optimize": False, "disposal": 1},
    ".webp": {"lossless": True, "quality": 50, "method": 2},  # of lossless pictures, the quality is the effort
}
COLOURS: Final = 64  # of a GIF picture


def write_animation(run: Run, path: Path) -> None:
    """Write a run's top view to a .gif or .webp file; OSError as the file system says."""
    frames = Frames.of(run)
    pictures = (_image(picture, path.suffix) for picture in frames.draw())
    durations = [round(1e3 * frames.interval)] * (len(frames.rows) - 1) + [round(1e3 * HOLD)]  # [ms]
    next(pictures).save(path, save_all=True, append_images=pictures, duration=durations, loop=0, **OPTIONS[path.suffix])


def _image(picture: Any, suffix: str) -> Image.Image:
    image = Image.fromarray(picture)
    if suffix != ".gif":
        return image
    return image.quantize(COLOURS, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
