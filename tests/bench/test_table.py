"""Numbers as people and programs read them."""

from bench.statistic import Statistic
from bench.table import Table, in_ms

TABLE = Table("key", "Title", ("name", "ms"), [["a", 1.23456], ["longer", None]])


def test_columns_are_aligned() -> None:
    """Names are on the left, numbers on the right with four digits, and what is missing is a dash."""
    assert TABLE.text() == "Title\n  name       ms\n  a       1.235\n  longer      -"


def test_a_record_has_all_digits() -> None:
    """Programs get each row by the names of the columns, unrounded."""
    assert TABLE.record() == [{"name": "a", "ms": 1.23456}, {"name": "longer", "ms": None}]


def test_one_disturbed_run_does_not_count() -> None:
    """What is typical of runs is the median of each number."""
    runs = [Statistic.of([1e-3, 2e-3, 9e-3]), Statistic.of([1e-3, 3e-3, 5e-3]), Statistic.of([1.0, 2.0, 3.0])]
    median, _, largest = in_ms(Statistic.typical(runs))
    assert (round(median, 9), round(largest, 9)) == (3, 9)
