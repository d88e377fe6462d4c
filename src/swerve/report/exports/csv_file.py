"""A table of the log as CSV: one line with the columns' names and units, as in `vx [m/s]`, then a line for each row.

Numbers have as many digits as it takes to read the same number back. A field is empty where there is no number.
"""

from pathlib import Path

import pyarrow
import pyarrow.csv

from swerve.simulate import Table


def write_csv(table: Table, path: Path) -> None:
    """Write a table to a CSV file; OSError as the file system says."""
    columns = {
        header(name, table.units[name]): pyarrow.array(values, from_pandas=True)  # which makes nan a missing value
        for name, values in table.columns.items()
    }
    pyarrow.csv.write_csv(pyarrow.table(columns), path)


def header(name: str, unit: str) -> str:
    """What stands above a column: its name and unit, the name alone above words."""
    return f"{name} [{unit}]" if unit else name
