"""The survey of random scenes as a file, to be included in a page; and every scene that failed, to be run again."""

from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from swerve import __version__
from swerve.report.markdown import table
from swerve.report.output import filled
from swerve.study.random_scenes import SPARE, Survey, Trial


def as_markdown(surveys: Sequence[Survey]) -> str:
    """What became of the scenes on each plant, and the failures by their cause."""
    causes = Counter((each.plant, trial.cause) for each in surveys for trial in each.failed)
    rows = [[f"`{plant}`", cause, str(number)] for (plant, cause), number in causes.most_common()]
    failures = table(["plant", "failed by", "scenes"], rows) if rows else "No scene failed."
    return f"""Measured by swerve {__version__}; a scene counts where a search finds a manoeuvre that is clear with the
friction divided by {SPARE:g}.

{table(["", *(f"`{each.plant}`" for each in surveys)], _rows(surveys))}

{failures}
"""


def write_survey(surveys: Sequence[Survey], directory: Path) -> list[Path]:
    """Write random_scenes.md, and a scenario file for each scene that failed or was interfered with.

    Raises:
        OSError: they cannot be written; then the directory is as it was.
    """
    texts = {"random_scenes.md": as_markdown(surveys)}
    for each in surveys:
        texts |= {_file_name(trial): trial.scene.to_toml() for trial in (*each.failed, *each.interventions)}
    with filled(directory) as place:
        for name, text in texts.items():
            (place / name).write_text(text, encoding="utf-8", newline="\n")
    return [directory / name for name in texts]


def _file_name(trial: Trial) -> str:
    return f"{trial.scene.name}-{trial.plant}.toml"


def _rows(surveys: Sequence[Survey]) -> list[list[str]]:
    """A column for each survey."""
    lines = {
        "scenes drawn": lambda each: str(each.drawn),
        "not a threat": lambda each: str(each.harmless),
        "no way through found": lambda each: str(each.uncertain),
        "run": lambda each: str(len(each.trials)),
        "avoided": lambda each: f"{len(each.trials) - len(each.failed)} ({each.share_avoided:.1%})",
        "with a command beyond a limit": lambda each: str(
            sum(not trial.is_within_limits for trial in (*each.trials, *each.quiet))
        ),
        "with a step that fell back": lambda each: str(sum(trial.fallbacks > 0 for trial in each.trials)),
        "quiet scenes run": lambda each: str(len(each.quiet)),
        "of them, with an intervention": lambda each: str(len(each.interventions)),
    }
    return [[name, *map(show, surveys)] for name, show in lines.items()]
