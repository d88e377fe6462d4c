"""The words and numbers at the top of the page, as HTML: they are there, and print, without any script.

Every text that comes from outside is escaped. A number carries its key and its exact value in SI beside what is shown.
"""

from collections.abc import Iterable, Sequence
from html import escape
from json import dumps
from math import degrees
from typing import Any, Final

from swerve.report.page.data import names
from swerve.report.page.words import TITLES, facts, settings
from swerve.simulate import Run

NUMBERS: Final = (  # key in the result, name, factor and unit of display, decimals
    ("min_clearance", "Smallest clearance", 1.0, "m", 3),
    ("min_distance_ratio", "Distance ratio, 1 is contact", 1.0, "", 3),
    ("impact_speed", "Impact speed", 3.6, "km/h", 1),
    ("lateral_excursion", "Lateral excursion", 1.0, "m", 2),
    ("max_friction_use", "Largest friction use", 100.0, "%", 0),
    ("speed.min", "Lowest speed", 3.6, "km/h", 1),
    ("max_sideslip", "Largest sideslip", degrees(1), "°", 1),
    ("max_steer", "Largest steering", degrees(1), "°", 1),
    ("step_time.median", "Step time, median", 1e3, "ms", 2),
    ("step_time.p99", "Step time, 99 %", 1e3, "ms", 2),
    ("fallback_steps", "Fallback steps", 1.0, "", 0),
)


def badge(run: Run) -> str:
    """The outcome in a word; its colour and its mark say the same."""
    outcome = run.result.outcome
    return f'<span class="badge {outcome.value}">{TITLES[outcome]}</span>'


def tiles(run: Run) -> str:
    """The numbers that most readers look for."""
    values = flat(run.result.to_json())
    shown = [each for each in NUMBERS if values.get(each[0]) is not None]
    return "".join(f"<div><dt>{each[1]}</dt><dd>{_number(values, each)}</dd></div>" for each in shown)


def fact_list(runs: Sequence[Run]) -> str:
    """The scene, and of a single run its main settings."""
    shown = facts(runs[0]) + (settings(runs[0]) if len(runs) == 1 else [])
    return "".join(f"<div><dt>{escape(name)}</dt><dd>{escape(text)}</dd></div>" for name, text in shown)


def result_table(runs: Sequence[Run]) -> str:
    """Every number of the results, exactly as in their JSON: a row each, a column for each run."""
    results = [flat(run.result.to_json()) for run in runs]
    keys = dict.fromkeys(key for result in results for key in result)
    head = _row("th", ["", *names(runs)])
    rows = [_row("td", [key, *(_exact(result.get(key)) for result in results)]) for key in keys]
    return f"<thead>{head}</thead><tbody>{''.join(rows)}</tbody>"


def comparison_table(runs: Sequence[Run]) -> str:
    """The main numbers of several runs: a row for each run, its verdict first."""
    results = [flat(run.result.to_json()) for run in runs]
    shown = [each for each in NUMBERS if any(result.get(each[0]) is not None for result in results)]
    units = [f"{name} [{unit}]" if unit else name for _, name, _, unit, _ in shown]
    head = _row("th", ["Run", "Outcome", *units])
    rows = []
    for i, (name, run, result) in enumerate(zip(names(runs), runs, results, strict=True)):
        cells = [f'<th scope="row"><i class="key" data-car="{i}"></i>{escape(name)}</th>', f"<td>{badge(run)}</td>"]
        cells += [f"<td>{_number(result, each, with_unit=False)}</td>" for each in shown]
        rows.append(f"<tr>{''.join(cells)}</tr>")
    return f"<thead>{head}</thead><tbody>{''.join(rows)}</tbody>"


def flat(values: dict[str, Any], above: str = "") -> dict[str, Any]:
    """Nested values by dotted key."""
    found: dict[str, Any] = {}
    for key, value in values.items():
        found |= flat(value, f"{above}{key}.") if isinstance(value, dict) else {f"{above}{key}": value}
    return found


def _number(values: dict[str, Any], kind: tuple[str, str, float, str, int], *, with_unit: bool = True) -> str:
    key, _, factor, unit, decimals = kind
    value = values.get(key)
    if value is None:
        return "\N{EN DASH}"
    text = f"{value * factor:.{decimals}f}"
    shown_unit = f" <small>{unit}</small>" if unit and with_unit else ""
    return f'<data data-key="{key}" value="{escape(dumps(value))}">{text}</data>{shown_unit}'


def _exact(value: Any) -> str:
    return value if isinstance(value, str) else dumps(value)


def _row(tag: str, cells: Iterable[str]) -> str:
    first, *rest = map(escape, cells)
    return f'<tr><th scope="row">{first}</th>{"".join(f"<{tag}>{each}</{tag}>" for each in rest)}</tr>'
