"""Tyre data from a tyre property file (.tir): its Magic Formula, evaluated at pure side slip without camber.

Loads are eight, from a quarter of the nominal load FNOMIN to twice it, slip angles from -20 to 20 deg in steps of half
a degree, both within the ranges that the file gives. The inflation pressure is the file's own. In the W axes of ISO and
TYDEX a positive slip angle, of a wheel that moves to its left, gives a negative force: Ky is negative, and the slip
angle is turned. A file with a positive Ky counts it as here already.
"""

from dataclasses import MISSING, fields
from math import radians
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.errors import InputError, one_line
from swerve.vehicle.fitting.data import LoadBlock, TyreData
from swerve.vehicle.fitting.magic_formula import LateralCoefficients, cornering_stiffness, lateral_force
from swerve.vehicle.fitting.property_file import PropertyFile, read_property_file

Array = NDArray[np.float64]

N_LOADS: Final = 8  # as many as Table 1 has
LOAD_RANGE: Final = (0.25, 2.0)  # of the nominal load [1]
SLIP_LIMIT: Final = radians(20.0)  # [rad]
N_SLIP_ANGLES: Final = 81

# FITTYP and the version that it stands for; "52" is also that of MF-MCTyre 1.1, for motorcycles, which has PCY2.
VERSIONS: Final = {"6": "5.2", "21": "5.2", "52": "5.2", "60": "6.0", "61": "6.1", "62": "6.2"}
FORMATS: Final = ("MF-TYRE", "MF-TIRE", "MF-SWIFT", "SWIFT-TYRE", "PAC2002", "MF-05", "USER")
SUPPORTED: Final = "Magic Formula 5.2 (FITTYP 6, 21 or 52, or PAC2002) and 6.0 to 6.2 (FITTYP 60 to 62) are read"


def read_tir(path: Path) -> TyreData:
    """The tyre data that a property file stands for.

    Raises:
        InputError: it cannot be read, is of another model, or something in it is wrong: with line, key and value.
    """
    source = read_property_file(path)
    version = _version(source)
    _check_units(source)
    coefficients = _coefficients(source)
    dpi = _pressure_change(source)
    low, high = (share * coefficients.FNOMIN for share in LOAD_RANGE)
    loads = _range(source, "FZMIN", "FZMAX", low, high, N_LOADS)
    slips = _range(source, "ALPMIN", "ALPMAX", -SLIP_LIMIT, SLIP_LIMIT, N_SLIP_ANGLES)
    equations = "5.2" if version == "5.2" else "6.x"
    with np.errstate(all="ignore"):
        turn = -1.0 if cornering_stiffness(coefficients, coefficients.FNOMIN, dpi=dpi) < 0 else 1.0
        forces = [lateral_force(coefficients, load, slips, version=equations, dpi=dpi) for load in loads]
    if not np.isfinite(forces).all():
        fault = "the coefficients give a lateral force that is not finite"
        raise InputError(f"{source.file}: {fault}; mend PCY1, PDY1, PDY2, PKY1 or PKY2")
    note = f"Magic Formula {version}, {'slip angle turned' if turn < 0 else 'slip angle as in the file'}"
    if dpi:
        note += f", pressure {dpi:+.1%} of nominal"
    blocks = (
        LoadBlock(f"load {load:.6g} N", np.full_like(slips, load), turn * slips, force)
        for load, force in zip(loads, forces, strict=True)
    )
    return TyreData(source.file, note, tuple(blocks))


def _version(source: PropertyFile) -> str:
    """The version of the Magic Formula, such as "6.1"."""
    kind, fit = source.entry("PROPERTY_FILE_FORMAT"), source.entry("FITTYP")
    if kind is not None and kind.text.upper().replace("_", "-") not in FORMATS:
        fault = f"PROPERTY_FILE_FORMAT '{one_line(kind.text, 40)}' is another tyre model"
        raise InputError(f"{source.file}: line {kind.line}: {fault}; {SUPPORTED}")
    motorcycle = source.entry("PCY2")
    if motorcycle is not None:
        fault = "PCY2 belongs to the Magic Formula of motorcycle tyres"
        raise InputError(f"{source.file}: line {motorcycle.line}: {fault}; {SUPPORTED}")
    if fit is None:
        if kind is not None and kind.text.upper() == "PAC2002":
            return "5.2"
        raise InputError(f"{source.file}: no FITTYP, which tells the tyre model; {SUPPORTED}")
    if fit.text.removeprefix("MF") not in VERSIONS:
        fault = f"FITTYP {one_line(fit.text, 40) or 'is empty,'} stands for another tyre model"
        raise InputError(f"{source.file}: line {fit.line}: {fault}; {SUPPORTED}")
    return VERSIONS[fit.text.removeprefix("MF")]


def _check_units(source: PropertyFile) -> None:
    for key, right in (("FORCE", ("newton", "n")), ("ANGLE", ("radian", "radians", "rad"))):
        entry = source.entry(key)
        if entry is not None and entry.text.lower() not in right:
            fault = f"{key} = '{one_line(entry.text, 20)}' is a unit that is not read"
            cure = f"convert the file to {key} = '{right[0]}'"
            raise InputError(f"{source.file}: line {entry.line}: {fault}; {cure}")


def _coefficients(source: PropertyFile) -> LateralCoefficients:
    values = {
        f.name: source.number(f.name, None if f.default is MISSING else f.default) for f in fields(LateralCoefficients)
    }
    for key in ("FNOMIN", "LFZO"):
        if values[key] <= 0:
            raise InputError(f"{source.place(key)}: {key} = {values[key]:g} is not above 0; write a load that is")
    for key in ("PCY1", "PDY1", "PKY1", "PKY2"):
        if values[key] == 0:
            raise InputError(f"{source.place(key)}: {key} = 0 makes no force; write a number that does")
    return LateralCoefficients(**values)


def _pressure_change(source: PropertyFile) -> float:
    """The inflation pressure's change from nominal, as a share of it; 0 where the file does not give both [1]."""
    for own, nominal in (("INFLPRES", "NOMPRES"), ("IP", "IP_NOM")):
        if source.entry(own) and source.entry(nominal):
            if source.number(nominal) <= 0:
                fault = f"{nominal} = {source.number(nominal):g} is not above 0"
                raise InputError(f"{source.place(nominal)}: {fault}; write a pressure that is")
            return source.number(own) / source.number(nominal) - 1
    return 0.0


def _range(source: PropertyFile, low_key: str, high_key: str, low: float, high: float, n: int) -> Array:
    """`n` values from `low` to `high`, within the range that the file gives."""
    least, most = source.number(low_key, low), source.number(high_key, high)
    if least >= most:
        raise InputError(f"{source.file}: {low_key} = {least:g} is not below {high_key} = {most:g}; mend one of them")
    if least >= high or most <= low:
        fault = f"{low_key} = {least:g} to {high_key} = {most:g} has nothing of what is fitted, {low:g} to {high:g}"
        raise InputError(f"{source.file}: {fault}; mend one of them")
    return np.linspace(max(least, low), min(most, high), n)
