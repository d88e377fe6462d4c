"""What `swerve compare` prints: a table for people, grouped by scenario, or one JSON object."""

import json
from collections.abc import Sequence
from typing import Final

from swerve.errors import one_line
from swerve.report.comparison.measures import LEGEND, MEASURES, shown
from swerve.report.console import PLAIN, Console
from swerve.simulate import Outcome
from swerve.study.comparison import Comparison, Entry, Group

WIDTH: Final = 120  # of a line [character]
DECISION: Final = 17  # width of the longest one that there is, brake+steer-right [character]


def comparison_json(comparison: Comparison) -> str:
    """The comparison as one JSON object on one line."""
    return json.dumps(comparison.to_json(), allow_nan=False)


def comparison_table(comparison: Comparison, console: Console = PLAIN) -> str:
    """A line for each run below the name of its scenario; the best outcomes have a star."""
    first = max(map(len, comparison.controllers))
    texts = {each: shown(each) for group in comparison.groups for each in group.runs}
    widths = [
        max(len(measure.title), len(_unit(measure.unit)), *(len(text[i]) for text in texts.values()), 0)
        for i, measure in enumerate(MEASURES)
    ]
    lines = [f"on {comparison.plant}, seed {comparison.seed}; *: no other outcome in the scenario is better", ""]
    lines += _header(first, widths)
    for group in comparison.groups:
        lines += ["", _heading(group)]
        lines += [_line(group, each, first, texts.get(each, []), widths, console) for each in group.entries]
    return "\n".join([*lines, "", *LEGEND])


def _heading(group: Group) -> str:
    scenario = group.scenario
    return one_line(f"{scenario.name}: {scenario.description}" if scenario.description else scenario.name, WIDTH)


def _header(first: int, widths: Sequence[int]) -> list[str]:
    titles = [f"{each.title:>{width}}" for each, width in zip(MEASURES, widths, strict=True)]
    units = [f"{_unit(each.unit):>{width}}" for each, width in zip(MEASURES, widths, strict=True)]
    start = f"  {'controller':{max(first, 10)}}  {'outcome':9}  {'decision':{DECISION}}  "
    return [start + "  ".join(titles), " " * len(start) + "  ".join(units).rstrip()]


def _unit(unit: str) -> str:
    return f"[{unit}]" if unit else ""


def _line(group: Group, entry: Entry, first: int, texts: Sequence[str], widths: Sequence[int], console: Console) -> str:
    name = f"{'*' if group.is_best(entry) else ' '} {entry.controller:{max(first, 10)}}"
    if entry.result is None:
        refusal = one_line(entry.refusal or "", WIDTH - len(name) - len("  refused: "))
        return f"{name}  {console.paint('bad', 'refused')}: {refusal}"
    outcome = entry.result.outcome
    verdict = console.paint("good" if outcome is Outcome.AVOIDED else "bad", f"{outcome.value:9}")
    cells = [f"{text:>{width}}" for text, width in zip(texts, widths, strict=True)]
    return "  ".join([name, verdict, f"{entry.result.decision:{DECISION}}", *cells])
