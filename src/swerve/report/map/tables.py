"""A map as Markdown, to be included in a page of the documentation."""

from statistics import median

from swerve import __version__
from swerve.report.map.columns import columns, rows
from swerve.report.map.summary import INDIVIDUAL, ratios, reach
from swerve.report.markdown import table
from swerve.study.map.boundary import Map


def as_markdown(found: Map) -> str:
    """What each controller reaches in words, and a row for each condition."""
    every = columns(found)
    cells = [[each.shown(condition) for each in every] for condition in rows(found)]
    what = f"Scenario `{found.scenario}` on the plant `{found.plant}`, seed {found.seed}"
    how = f"{len(found.runs)} runs, boundaries to within {found.tolerance:g} m, measured by swerve {__version__}"
    lines = [_line(found, who) for who in found.controllers] if INDIVIDUAL in found.limits else []
    text = "".join(f"{line}\n" for line in [*lines, *([""] if lines else [])])
    return f"{what}: {how}.\n\n{text}{table([each.title for each in every], cells)}\n"


def _line(found: Map, who: str) -> str:
    span, values = reach(found, who), ratios(found, who)
    told = (
        "no distance to hold against the limit"
        if span is None
        else f"median {median(values):.3f} times the limit, {span}"
    )
    return f"- `{who}`: {told}"
