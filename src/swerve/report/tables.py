"""Tables of a run as Parquet: every column with its unit, and in the metadata all that is needed to run it again."""

from pathlib import Path
from typing import Final

import pyarrow
import pyarrow.parquet

from swerve.simulate import Run, Table

UNIT: Final = b"unit"  # key of a field's metadata; "" for words, "1" for a number without a dimension
SCENARIO: Final = b"swerve.scenario"  # keys of the file's metadata: the whole scenario as TOML ...
VERSION: Final = b"swerve.version"  # ... and the rest as text
CONTROLLER: Final = b"swerve.controller"
PLANT: Final = b"swerve.plant"
SEED: Final = b"swerve.seed"


def write_table(table: Table, run: Run, path: Path) -> None:
    """Write one table of `run`'s log to a Parquet file."""
    write_columns(table, _metadata(run), path)


def write_columns(table: Table, metadata: dict[bytes, bytes], path: Path) -> None:
    """Write a table to a Parquet file, with the file's metadata."""
    arrays = {name: pyarrow.array(values) for name, values in table.columns.items()}
    fields = [
        pyarrow.field(name, array.type, metadata={UNIT: table.units[name].encode()}) for name, array in arrays.items()
    ]
    schema = pyarrow.schema(fields, metadata=metadata)
    pyarrow.parquet.write_table(pyarrow.table(list(arrays.values()), schema=schema), path)


def read_scenario(path: Path) -> str:
    """The scenario of the run in a Parquet file, as TOML, from which the run can be made again."""
    text: bytes = pyarrow.parquet.read_schema(path).metadata[SCENARIO]
    return text.decode()


def _metadata(run: Run) -> dict[bytes, bytes]:
    result = run.result
    return {
        VERSION: result.version.encode(),
        CONTROLLER: result.controller.encode(),
        PLANT: result.plant.encode(),
        SEED: str(result.seed).encode(),
        SCENARIO: run.scenario.to_toml().encode(),
    }
