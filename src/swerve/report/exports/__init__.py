"""Exports of a run to other tools' formats, one module each; what they need is imported when they are written."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Final

from swerve.errors import InputError, unknown
from swerve.report.exports.format import Format, Write
from swerve.report.output import filled
from swerve.simulate import Run

__all__ = ["FORMATS", "Format", "formats_named", "write_exports"]


def _csv(name: str) -> Write:
    def write(run: Run, path: Path) -> None:
        from swerve.report.exports.csv_file import write_csv

        write_csv(getattr(run.log, name), path)

    return write


def _mcap(run: Run, path: Path) -> None:
    from swerve.report.exports.mcap_file import write_mcap

    write_mcap(run, path)


def _layout(run: Run, path: Path) -> None:
    from swerve.report.exports.layout import write_layout

    write_layout(run, path)


def _mf4(run: Run, path: Path) -> None:
    from swerve.report.exports.mf4_file import write_mf4

    write_mf4(run, path)


def _animation(run: Run, path: Path) -> None:
    from swerve.report.exports.animation import write_animation

    write_animation(run, path)


def _mp4(run: Run, path: Path) -> None:
    from swerve.report.exports.mp4_file import write_mp4

    write_mp4(run, path)


FORMATS: Final = {
    each.name: each
    for each in (
        Format("csv", {"motion.csv": _csv("motion"), "steps.csv": _csv("steps")}),
        Format("mcap", {"run.mcap": _mcap, "foxglove_layout.json": _layout}, module="mcap"),
        Format("mf4", {"run.mf4": _mf4}, module="asammdf"),
        Format("gif", {"top_view.gif": _animation}),
        Format("webp", {"top_view.webp": _animation}),
        Format("mp4", {"top_view.mp4": _mp4}, program="ffmpeg"),
    )
}


def formats_named(names: str, option: str) -> list[Format]:
    """The formats of a list such as "csv,mcap", each once, all of which can be written here.

    Args:
        names: with commas between them.
        option: of the command line that has them, for messages.

    Raises:
        InputError: there is no such format, or what it needs is not installed.
    """
    formats = []
    for name in dict.fromkeys(names.split(",")):
        if name not in FORMATS:
            raise InputError(f"{option}: {unknown('format', name, FORMATS)}")
        FORMATS[name].require(option)
        formats.append(FORMATS[name])
    return formats


def write_exports(
    run: Run, formats: Sequence[Format], directory: Path, progress: Callable[[float], None] = lambda share: None
) -> list[Path]:
    """Write a run in some formats.

    Args:
        run: that is over, or was read back.
        formats: to write.
        directory: is made where it does not exist; files of an earlier export in it are replaced.
        progress: called with the share that is done [1].

    Returns:
        The files.

    Raises:
        OSError: they cannot be written; then the directory is as it was.
        InputError: a program that makes one of them fails; likewise.
    """
    files = {name: write for each in formats for name, write in each.files.items()}
    with filled(directory) as place:
        for i, (name, write) in enumerate(files.items(), start=1):
            write(run, place / name)
            progress(i / len(files))
    return [directory / name for name in files]
