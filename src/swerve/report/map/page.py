"""The page of a map: one HTML file with the boundaries, every run behind them, and how to see each again."""

from collections.abc import Collection
from html import escape
from pathlib import Path
from typing import Final

from swerve import __version__
from swerve.report.map.commands import Source
from swerve.report.map.data import document
from swerve.report.map.head import fact_list, note, table, tiles
from swerve.report.page.single_file import Asset, single_file
from swerve.study.map.boundary import Condition, Map

REPORT: Final = "swerve.report.page"
STYLES: Final = (
    Asset(REPORT, "vendor/uPlot.min.css"),
    Asset(REPORT, "css/palette.css"),
    Asset(REPORT, "css/style.css"),
    Asset(REPORT, "css/print.css"),
    Asset(__package__, "css/map.css"),
)
SCRIPTS: Final = (  # each uses only those before it
    Asset(REPORT, "vendor/uPlot.iife.min.js"),
    Asset(REPORT, "js/elements.js"),
    Asset(REPORT, "js/colours.js"),
    Asset(REPORT, "js/theme.js"),
    Asset(REPORT, "js/printing.js"),
    Asset(__package__, "js/looks.js"),
    Asset(__package__, "js/layers.js"),
    Asset(__package__, "js/words.js"),
    Asset(__package__, "js/card.js"),
    Asset(__package__, "js/marks.js"),
    Asset(__package__, "js/chart.js"),
    Asset(__package__, "js/panels.js"),
    Asset(__package__, "js/main.js"),
)


def write_map(found: Map, path: Path, source: Source, replays: Collection[Condition] = ()) -> None:
    """Write the page of a map; OSError as the file system says.

    Args:
        found: the map.
        path: of the file.
        source: the scenario as it was given on the command line, so that every point has its command.
        replays: the conditions for which `write_replays` writes a page beside this one.
    """
    text = single_file(
        Asset(__package__, "template.html"),
        STYLES,
        SCRIPTS,
        document(found, source, replays),
        title=escape(found.scenario),
        tiles=tiles(found),
        facts=fact_list(found),
        note=note(found),
        table=table(found, replays),
        version=escape(__version__),
    )
    path.write_text(text, encoding="utf-8", newline="\n")
