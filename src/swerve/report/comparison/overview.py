"""The page of a comparison of several scenarios: who ended how, and a table for each, with the way to its own page."""

from collections.abc import Sequence
from html import escape
from pathlib import Path
from string import Template
from typing import Final

from swerve import __version__
from swerve.report.comparison.measures import LEGEND, MEASURES, shown
from swerve.report.comparison.names import folder_name
from swerve.report.page.head import badge
from swerve.report.page.single_file import Asset
from swerve.report.picture import picture
from swerve.study.comparison import Comparison, Entry, Group

POLICY: Final = "default-src 'none'; style-src 'unsafe-inline'"  # it has no script
STYLES: Final = (  # those of the pages that it leads to, and its own
    Asset("swerve.report.page", "css/palette.css"),
    Asset("swerve.report.page", "css/style.css"),
    Asset(__package__, "overview.css"),
)
REFUSED: Final = '<span class="badge">Refused</span>'


def write_overview(comparison: Comparison, names: Sequence[str], path: Path) -> None:
    """Write the page; OSError as the file system says.

    Args:
        comparison: that is shown.
        names: of each scenario's files.
        path: of the page.
    """
    pairs = list(zip(comparison.groups, names, strict=True))
    text = Template(Asset(__package__, "overview.html").text).substitute(
        policy=POLICY,
        styles="".join(f"<style>\n{each.text}</style>\n" for each in STYLES),
        about=escape(f"{_count(comparison)} on {comparison.plant}, seed {comparison.seed}"),
        outcomes=_outcomes(comparison, names),
        sections="".join(_section(group, name) for group, name in pairs),
        legend=escape(" ".join(LEGEND)),
        version=escape(__version__),
    )
    path.write_text(text, encoding="utf-8", newline="\n")


def _count(comparison: Comparison) -> str:
    scenarios, controllers = len(comparison.groups), len(comparison.controllers)
    return f"{controllers} controller{'s' * (controllers > 1)} in {scenarios} scenario{'s' * (scenarios > 1)}"


def _outcomes(comparison: Comparison, names: Sequence[str]) -> str:
    """A row for each scenario, with a link to its table, and a column for each controller."""
    head = "".join(f"<th>{escape(each)}</th>" for each in comparison.controllers)
    rows = []
    for group, name in zip(comparison.groups, names, strict=True):
        title = f'<th scope="row"><a href="#{escape(name)}">{escape(group.scenario.name)}</a></th>'
        rows.append(f"<tr>{title}{''.join(f'<td>{_badge(each)}</td>' for each in group.entries)}</tr>")
    return f"<thead><tr><th>Scenario</th>{head}</tr></thead><tbody>{''.join(rows)}</tbody>"


def _section(group: Group, name: str) -> str:
    """A scenario: its picture and the way to its page, where there is a run, and its table."""
    drawing, link = "", ""
    if runs := [each.run for each in group.entries if each.run is not None]:
        drawing = f'<figure class="above" role="img" aria-label="The paths from above">{picture(runs)}</figure>'
        link = f'<a href="{escape(name)}.html">Watch them together</a>'
    return (
        f'<section class="card" id="{escape(name)}"><div class="about"><div><h2>{escape(group.scenario.name)}</h2>'
        f'<p class="note">{escape(group.scenario.description)}</p>{link}</div>{drawing}</div>'
        f'<div class="wide"><table class="numbers">{_table(group, name)}</table></div></section>\n'
    )


def _table(group: Group, name: str) -> str:
    units = [f"{each.title} <small>{each.unit}</small>" if each.unit else each.title for each in MEASURES]
    head = "".join(f"<th>{each}</th>" for each in ("Controller", "Outcome", "Decision", *units))
    numbers = {entry.controller: i for i, entry in enumerate(group.runs, start=1)}  # of the paths in the picture
    rows = "".join(_row(group, entry, name, numbers.get(entry.controller, 0)) for entry in group.entries)
    return f"<thead><tr>{head}</tr></thead><tbody>{rows}</tbody>"


def _row(group: Group, entry: Entry, name: str, number: int) -> str:
    if entry.run is None:
        who = f'<th scope="row"><i class="key"></i>{escape(entry.controller)}</th>'
        reason = f'<td class="reason" colspan="{len(MEASURES) + 1}">{escape(entry.refusal or "")}</td>'
        return f"<tr>{who}<td>{REFUSED}</td>{reason}</tr>"
    report = f"{escape(folder_name(name, entry.controller))}/report.html"
    who = f'<th scope="row"><i class="key path-{number}"></i><a href="{report}">{escape(entry.controller)}</a></th>'
    cells = "".join(f"<td>{each}</td>" for each in (_badge(entry), entry.run.result.decision, *shown(entry)))
    kind = "best" if group.is_best(entry) else "other"
    return f'<tr class="{kind}">{who}{cells}</tr>'


def _badge(entry: Entry) -> str:
    return REFUSED if entry.run is None else badge(entry.run)
