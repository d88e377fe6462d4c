"""Tyre data in a CSV file: a header, and a point a line.

    # lines that begin with # and empty lines are skipped
    load [N], slip_angle [deg], lateral_force [N]
    1594, -12, -1571.8

The header names the three columns, in any order, each with its unit in brackets: load and lateral_force in N or kN,
slip_angle in rad, mrad or deg. Numbers have a decimal point, no unit and no separator of thousands. Points of one load
stand together, in any order, and the loads rise.
"""

import csv
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import degrees, pi
from pathlib import Path
from typing import Final

import numpy as np

from swerve.errors import InputError, nearest, one_line, shown_path
from swerve.units import DIMENSIONS
from swerve.vehicle.fitting.data import TyreData, blocks_of
from swerve.vehicle.fitting.source_file import finite_number, read_lines

COLUMNS: Final = {"load": "force", "slip_angle": "angle", "lateral_force": "force"}  # and their dimensions
HEADER: Final = "load [N], slip_angle [deg], lateral_force [N]"
LARGEST_SLIP_ANGLE: Final = pi / 2  # [rad]
LARGEST_FRICTION: Final = 5.0  # |lateral force| over load [1]; no tyre reaches it, a wrong unit does


@dataclass(frozen=True)
class _Column:
    """A column of the header: its name, its unit as written and that unit in SI."""

    name: str
    unit: str
    factor: float


def read_csv(path: Path) -> TyreData:
    """The tyre data in a CSV file.

    Raises:
        InputError: it cannot be read, or something in it is wrong: with the line, the column and the value.
    """
    file = shown_path(path)
    rows = _rows(file, read_lines(path))
    number, header = next(rows)
    columns = _columns(header, f"{file}: line {number}")
    points = [(number, _point(cells, columns, f"{file}: line {number}")) for number, cells in rows]
    if not points:
        raise InputError(f"{file}: line {number}: no points below the header; write one a line")
    loads, slip_angles, forces = np.array([point for _, point in points]).T
    note = "as in the file, positive slip angle with positive force"
    return TyreData(file, note, blocks_of(file, [number for number, _ in points], loads, slip_angles, forces))


def _rows(file: str, lines: Sequence[str]) -> Iterator[tuple[int, list[str]]]:
    """Line number and cells of each line that says something."""
    for number, line in enumerate(lines, start=1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        try:
            yield number, [cell.strip() for cell in next(csv.reader([line], skipinitialspace=True, strict=True))]
        except csv.Error as error:
            raise InputError(f"{file}: line {number}: not CSV: {error}") from error


def _columns(cells: Sequence[str], place: str) -> list[_Column]:
    if len(cells) == 1 and (other := re.search(r"[;\t]", cells[0])):
        fault = f"columns are separated by {'a tab' if other[0] != ';' else 'a semicolon'}"
        raise InputError(f"{place}: {fault}; write commas between them and decimals with a point")
    columns = [_column(cell, place) for cell in cells]
    names = [column.name for column in columns]
    for name in COLUMNS:
        if name not in names:
            raise InputError(f"{place}: no column {name}; write a header such as {HEADER}")
        if names.count(name) > 1:
            raise InputError(f"{place}: column {name} is there twice; write it once")
    return columns


def _column(cell: str, place: str) -> _Column:
    match = re.fullmatch(r"([^\[\]]*?)\s*(?:\[([^\[\]]*)\])?", cell)
    name = re.sub(r"\s+", "_", match[1].lower()) if match else ""
    if match is None or name not in COLUMNS:
        guess = nearest(name, COLUMNS) if name else None
        cure = f"did you mean {guess}?" if guess else f"write a header such as {HEADER}"
        raise InputError(f"{place}: unknown column '{one_line(cell, 40)}'; {cure}")
    units = DIMENSIONS[COLUMNS[name]].units
    known = " or ".join(f"{name} [{unit}]" for unit in units)
    if not match[2]:
        raise InputError(f"{place}: column {name} has no unit; write {known}")
    unit = match[2].strip().replace("°", "deg")
    if unit not in units:
        noun = DIMENSIONS[COLUMNS[name]].noun
        raise InputError(f"{place}: column {name}: [{one_line(unit, 20)}] is no unit of {noun}; write {known}")
    return _Column(name, unit, units[unit])


def _point(cells: Sequence[str], columns: Sequence[_Column], place: str) -> tuple[float, float, float]:
    """Load [N], slip angle [rad] and lateral force [N] of one line."""
    if len(cells) != len(columns):
        raise InputError(f"{place}: {len(cells)} values under {len(columns)} columns; write one in each")
    values = {column.name: _value(cell, column, place) for cell, column in zip(cells, columns, strict=True)}
    load, slip_angle, force = (values[name] for name in COLUMNS)
    if load <= 0:
        raise InputError(f"{place}: column load: {load:g} N is not above 0; leave such lines out")
    if abs(slip_angle) > LARGEST_SLIP_ANGLE:
        fault = f"{degrees(slip_angle):g} deg is beyond 90 deg"
        raise InputError(f"{place}: column slip_angle: {fault}; mend the value, or the unit in the header")
    if abs(force) > LARGEST_FRICTION * load:
        fault = f"{force:g} N is {abs(force) / load:.3g} times the load, more than any tyre gives"
        raise InputError(f"{place}: column lateral_force: {fault}; mend the value, or the units in the header")
    return load, slip_angle, force


def _value(cell: str, column: _Column, place: str) -> float:
    try:
        return finite_number(cell) * column.factor
    except ValueError as error:
        cure = f"write a plain number in {column.unit}, or leave the line out"
        raise InputError(f"{place}: column {column.name}: {error}; {cure}") from error
