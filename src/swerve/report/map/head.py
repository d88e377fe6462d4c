"""The numbers and the table of a map's page, as HTML: they are there, and print, without any script.

Every text that comes from outside is escaped. A number carries its exact value in SI beside what is shown.
"""

from collections.abc import Collection, Iterator
from html import escape
from json import dumps
from statistics import median
from typing import Final

from swerve.report.map.columns import Column, columns, rows
from swerve.report.map.replays import FOLDER, replay_name
from swerve.report.map.summary import INDIVIDUAL, most_bought, ratios, reach
from swerve.study.limit import Means
from swerve.study.map.boundary import LIMIT, Condition, Map

BOUND: Final = "below it not even a point mass with the same friction comes by"


def tiles(found: Map) -> str:
    """The median ratio of each controller to the limit, and the most that the four wheel torques buy."""
    return "".join(f"<div><dt>{escape(name)}</dt><dd>{value}</dd></div>" for name, value in _tiles(found))


def _tiles(found: Map) -> Iterator[tuple[str, str]]:
    for who in found.controllers:
        values, span = ratios(found, who), reach(found, who)
        if span is not None:
            yield f"{who} / limit, median; {span}", _number(median(values), f"{median(values):.3f}")
    most = most_bought(found)
    if most is not None:
        value, where = most
        name = f"Most that four wheel torques buy: at {where.speed:g} m/s, friction {where.friction:g}"
        yield name, f"{_number(value, f'{value:.2f}')} <small>m</small>"


def fact_list(found: Map) -> str:
    """What was mapped, and how."""
    aside = f"{found.half_width:.4g} m beside its middle to come by, {found.extent:.4g} m before it at contact"
    facts = {
        "Scenario": f"{found.scenario} on the plant {found.plant}, seed {found.seed}",
        "Distance": "from the vehicle's centre of gravity to the centre of the first obstacle ahead, along X",
        "Obstacle": aside,
        "Runs": f"{len(found.runs)}; boundaries to within {found.tolerance:g} m",
    }
    limits = {who: meaning(who) for who in found.limits}
    return "".join(
        f"<div><dt>{escape(key)}</dt><dd>{escape(text)}</dd></div>" for key, text in (facts | limits).items()
    )


def meaning(who: str) -> str:
    """What a limit is the limit of."""
    means = {f"{LIMIT}{each.value}": each.sentence for each in Means}
    return f"nearest that is avoided with {means[who]}" if who in means else BOUND


def note(found: Map) -> str:
    """What the table's words mean."""
    limit = "Limit is limit: individual, the nearest that was found with a torque of its own on every wheel. "
    return f"{limit if INDIVIDUAL in found.limits else ''}A dash: none."


def table(found: Map, replays: Collection[Condition]) -> str:
    """A row for each condition, with a link to the page of its runs where there are such pages."""
    every = columns(found)
    titles = [*(each.title for each in every), *(["runs"] if replays else [])]
    head = "".join(f'<th scope="col">{escape(each)}</th>' for each in titles)
    body = "".join(_row(every, each, replays) for each in rows(found))
    return f"<thead><tr>{head}</tr></thead><tbody>{body}</tbody>"


def _row(every: list[Column], condition: Condition, replays: Collection[Condition]) -> str:
    cells = [f"<td>{_number(each.of(condition), each.shown(condition))}</td>" for each in every]
    if replays:
        name = f"{FOLDER}/{replay_name(condition)}"
        cells.append(f'<td><a href="{escape(name)}">watch</a></td>' if condition in replays else "<td></td>")
    return f"<tr>{''.join(cells)}</tr>"


def _number(value: float | None, shown: str) -> str:
    return shown if value is None else f'<data value="{dumps(value)}">{shown}</data>'
