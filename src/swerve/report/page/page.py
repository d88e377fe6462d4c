"""The page: a template filled with words, the document and the assets beside this file."""

from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import Any, Final

from swerve.report.page.data import document
from swerve.report.page.head import badge, comparison_table, fact_list, result_table, tiles
from swerve.report.page.single_file import Asset, single_file
from swerve.simulate import Run

SCRIPTS: Final = (  # each uses only those before it
    "vendor/uPlot.iife.min.js",
    "js/elements.js",
    "js/colours.js",
    "js/theme.js",
    "js/printing.js",
    "js/player.js",
    "js/track.js",
    "js/camera.js",
    "js/surroundings.js",
    "js/car.js",
    "js/plans.js",
    "js/topview.js",
    "js/wheels.js",
    "js/decision.js",
    "js/band.js",
    "js/quantities.js",
    "js/charts.js",
    "js/controls.js",
    "js/paper.js",
    "js/main.js",
)
STYLES: Final = ("vendor/uPlot.min.css", "css/palette.css", "css/style.css", "css/print.css")
COMPARISON_SENTENCE: Final = "{n} of one scene; each is drawn in its own colour."


def write_page(run: Run, path: Path) -> None:
    """Write the report of a run; OSError as the file system says."""
    (car,) = (content := document([run]))["cars"]
    numbers = f'<p class="verdict">{badge(run)} {escape(car["verdict"])}</p><dl class="tiles">{tiles(run)}</dl>'
    _write(path, [run], content, numbers)


def write_comparison(runs: Sequence[Run], path: Path, remarks: Sequence[str] = ()) -> None:
    """Write the report of several runs in one scene, whose vehicles are drawn together.

    Args:
        runs: the first is drawn in full, the others as ghosts.
        path: of the file.
        remarks: sentences that stand below the table, as on who did not take part.

    Raises:
        ValueError: their scenes differ.
        OSError: as the file system says.
    """
    sentence = COMPARISON_SENTENCE.format(n=f"{len(runs)} runs" if len(runs) > 1 else "One run")
    below = "".join(f'<p class="note">{escape(each)}</p>' for each in remarks)
    table = f'<div class="wide"><table class="numbers">{comparison_table(runs)}</table></div>'
    _write(path, runs, document(runs), f'<p class="verdict">{sentence}</p>{table}{below}')


def _write(path: Path, runs: Sequence[Run], content: dict[str, Any], numbers: str) -> None:
    path.write_text(_page(runs, content, numbers), encoding="utf-8", newline="\n")


def _page(runs: Sequence[Run], content: dict[str, Any], numbers: str) -> str:
    first = runs[0]
    return single_file(
        _asset("template.html"),
        [_asset(name) for name in STYLES],
        [_asset(name) for name in SCRIPTS],
        content,
        title=escape(first.scenario.name),
        description=escape(first.scenario.description),
        source=escape(first.scenario.source),
        numbers=numbers,
        facts=fact_list(runs),
        results=result_table(runs),
        scenario=escape(first.scenario.to_toml()),
        version=escape(first.result.version),
    )


def _asset(name: str) -> Asset:
    return Asset(__package__, name)
