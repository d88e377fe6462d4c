"""The dotted keys of a scenario or another file of settings, and the right one nearest to a wrong one."""

from collections.abc import Iterator, Sequence
from typing import get_args, get_origin

from swerve.errors import nearest
from swerve.scenario.settings import Settings

Location = tuple[str | int, ...]
MOST_OFFERED = 3  # right keys in one message


def dotted(location: Sequence[str | int]) -> str:
    """A location as `--set` writes it: obstacles.0.position."""
    return ".".join(map(str, location))


def tables_in(table: type[Settings]) -> dict[str, type[Settings] | None]:
    """The keys of a table; beside each the table that it holds (or holds a list of), None for a plain value."""
    return {name: _table(field.annotation) for name, field in table.model_fields.items()}


def table_at(location: Location, root: type[Settings]) -> type[Settings]:
    """The kind of table at a location in `root` below which there are keys."""
    table = root
    for key in location:
        if isinstance(key, str):
            table = tables_in(table)[key] or table
    return table


def all_keys(table: type[Settings], above: Location = ()) -> Iterator[Location]:
    """The location of every key of a kind of table, in a list that of its first entry."""
    for name, below in tables_in(table).items():
        yield (*above, name)
        if below is not None:
            is_list = get_origin(table.model_fields[name].annotation) is tuple
            yield from all_keys(below, (*above, name, 0) if is_list else (*above, name))


def right_keys(wrong: Location, root: type[Settings]) -> list[str]:
    """The dotted keys that may have been meant: the nearest in the same table, else the nearest name in any table."""
    *above, word = wrong
    sibling = nearest(str(word), tables_in(table_at(tuple(above), root)))
    if sibling:
        return [dotted([*above, sibling])]
    locations = list(all_keys(root))
    name = nearest(str(word), (str(location[-1]) for location in locations))
    return [dotted(location) for location in locations if location[-1] == name][:MOST_OFFERED]


def _table(annotation: object) -> type[Settings] | None:
    """The table in an annotation such as `RoadSettings`, `TyreSettings | None` or `tuple[ObstacleSettings, ...]`."""
    for kind in (annotation, *get_args(annotation)):
        if isinstance(kind, type) and issubclass(kind, Settings):
            return kind
    return None
