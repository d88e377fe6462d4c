"""What is shown of a fitted tyre: a table, JSON, and the TOML file that a scenario can name."""

import json
from math import degrees
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from swerve import __version__
from swerve.errors import InputError, one_line, shown_path
from swerve.report.output import filled, prepare_output
from swerve.scenario.tyre import TyreSettings
from swerve.vehicle.fitting import LoadFit, TyreFit

SUFFIX = ".toml"  # by which a scenario tells a file from a name
LONGEST_NAME = 60  # characters of a file's name that become the tyre's


def prepare_tyre_file(path: Path) -> None:
    """See to it that a tyre can be written to `path`.

    Raises:
        InputError: it cannot, or does not end in .toml.
    """
    if path.suffix != SUFFIX:
        raise InputError(f"--out {shown_path(path)}: does not end in {SUFFIX}; write a name that does")
    if path.is_dir():
        raise InputError(f"--out {shown_path(path)}: is a directory; write the path of a file")
    prepare_output(path.parent)


def fitted_tyre(fit: TyreFit, name: str) -> TyreSettings:
    """The fitted tyre as a scenario holds it.

    Args:
        fit: of the data.
        name: of the tyre.

    Raises:
        InputError: no scenario takes it, because a line has a value at no load that no tyre has.
    """
    first, last = fit.loads[0].reduced.load, fit.loads[-1].reduced.load
    span = f"{len(fit.loads)} loads, {first:.6g} N to {last:.6g} N"
    source = f"swerve {__version__} fit-tyre {fit.file}: {fit.note}; {span}"
    try:
        return TyreSettings.of(one_line(name, LONGEST_NAME), one_line(source, 400), fit.tyre)
    except ValidationError as error:
        key = ".".join(map(str, error.errors()[0]["loc"]))
        fault = f"the line through the loads ends in a tyre that cannot be: {key}: {error.errors()[0]['ctx']['error']}"
        raise InputError(f"{fit.file}: {fault} (fit loads over a wider range)") from error


def write_tyre(tyre: TyreSettings, path: Path) -> None:
    """Write a tyre as TOML, over what was there; OSError as the file system says."""
    with filled(path.parent) as partial:
        (partial / path.name).write_text(tyre.to_toml(), encoding="utf-8", newline="\n")


def tyre_json(fit: TyreFit, tyre: TyreSettings) -> str:
    """The fit as one JSON object on one line, in SI."""
    values: dict[str, Any] = {
        "version": __version__,
        "data": fit.file,
        "note": fit.note,
        "tyre": tyre.model_dump(),
        "lines": {letter: vars(line) for letter, line in fit.lines.items()},
        "loads": [
            {"load": each.reduced.load, "n_points": each.reduced.n_points, "line_rms_error": each.line_error}
            | {"full": _curve(each, "full"), "reduced": _curve(each, "reduced")}
            for each in fit.loads
        ],
    }
    return json.dumps(values, allow_nan=False)


def tyre_table(fit: TyreFit, tyre: TyreSettings) -> str:
    """The fit for people: a row for each load, then the lines."""
    head = [
        f"tyre  {tyre.name}, from {fit.file}",
        f"data  {fit.note}; mu = 1 is their surface",
        "",
        "              eq. (3), E free                            eq. (3), E = 0                     lines",
        "   load   n   B        C       D       E        RMS      B        C       D       RMS       RMS",
        "    [N]       [1/rad]  [1]     [1]     [1]      [N]      [1/rad]  [1]     [1]     [N]       [N]",
    ]
    units = {"B": "1/rad", "C": "1", "D": "1"}
    lines = [
        f"{letter} = {line.at_no_load:.6g} {line.per_newton:+.5g} Fz  [{units[letter]}]   R^2 = {line.r_squared:.4f}"
        for letter, line in fit.lines.items()
    ]
    return "\n".join([*head, *map(_row, fit.loads), "", *lines, "", _shifts(fit)])


def _row(load: LoadFit) -> str:
    full, reduced = load.full, load.reduced
    return (
        f"{reduced.load:7.5g} {reduced.n_points:3d}   {full.B:<8.4f} {full.C:<7.4f} {full.D:<7.4f} {full.E:<8.3g} "
        f"{full.rms_error:<8.3g} {reduced.B:<8.4f} {reduced.C:<7.4f} {reduced.D:<7.4f} {reduced.rms_error:<9.3g} "
        f"{load.line_error:.3g}"
    )


def _shifts(fit: TyreFit) -> str:
    """What was done about a tyre that is not the same to both sides."""
    fitted = [
        (degrees(curve.horizontal_shift), curve.vertical_shift)
        for curve in (load.reduced for load in fit.loads)
        if curve.horizontal_shift is not None and curve.vertical_shift is not None
    ]
    if not fitted:
        return "shifts: none fitted, the points lie on one side of zero slip"
    horizontal, vertical = (max(map(abs, shifts)) for shifts in zip(*fitted, strict=True))
    most = f"at most {horizontal:.3g} deg and {vertical:.3g} of the load"
    return f"shifts: fitted at {len(fitted)} of {len(fit.loads)} loads, {most}, and left out of the tyre"


def _curve(load: LoadFit, which: str) -> dict[str, float | None]:
    values = vars(getattr(load, which))
    return {key: value for key, value in values.items() if key not in ("load", "n_points")}
