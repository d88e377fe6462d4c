"""Tyre data from a file, whose name tells what it is."""

from collections.abc import Callable
from pathlib import Path
from typing import Final

from swerve.errors import InputError, shown_path
from swerve.vehicle.fitting.csv_file import read_csv
from swerve.vehicle.fitting.data import TyreData
from swerve.vehicle.fitting.tir_file import read_tir

READERS: Final[dict[str, Callable[[Path], TyreData]]] = {".csv": read_csv, ".tir": read_tir}


def read_tyre_data(path: Path) -> TyreData:
    """The tyre data in a .csv or .tir file.

    Raises:
        InputError: it is neither, cannot be read, or something in it is wrong.
    """
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        raise InputError(f"{shown_path(path)}: no tyre data by its name; write a file that ends in .csv or .tir")
    return reader(path)
