"""A table of measurements, for people and for programs."""

from collections.abc import Sequence
from dataclasses import dataclass

from bench.statistic import Statistic

Cell = str | float | None

MILLI = 1e-3


@dataclass(frozen=True)
class Table:
    """Rows under columns.

    Attributes:
        key: its name in a record.
        title: what was measured, and in which unit.
        columns: names.
        rows: as many cells each as there are columns; None for what does not exist.
    """

    key: str
    title: str
    columns: Sequence[str]
    rows: Sequence[Sequence[Cell]]

    def text(self) -> str:
        """The table in columns of equal width."""
        lines = [list(self.columns), *([_text(cell) for cell in row] for row in self.rows)]
        widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
        first, *others = widths
        aligned = [[name.ljust(first), *map(str.rjust, cells, others)] for name, *cells in lines]
        return "\n".join([self.title, *("  ".join(["", *line]) for line in aligned)])

    def record(self) -> list[dict[str, Cell]]:
        """A dictionary for each row."""
        return [dict(zip(self.columns, row, strict=True)) for row in self.rows]


def in_ms(statistic: Statistic) -> tuple[float, float, float]:
    """Median, p99 and maximum [ms]."""
    return statistic.median / MILLI, statistic.p99 / MILLI, statistic.max / MILLI


def _text(cell: Cell) -> str:
    if cell is None:
        return "-"
    return cell if isinstance(cell, str) else f"{cell:.4g}"
