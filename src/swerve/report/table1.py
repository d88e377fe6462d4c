"""Table 1 of the paper as a file, printed and fitted again, with the lines and the errors of Fig. 3 and Fig. 4.

Markdown for the documentation, where an error that is a computer's rounding is shown as such, so that the file is the
same on every machine; CSV and JSON for programs, with all digits.
"""

import csv
import json
from dataclasses import asdict
from io import StringIO
from typing import Final

from swerve import __version__
from swerve.report.markdown import table
from swerve.study.tyre_work import TyreWork
from swerve.vehicle.fitting import TABLE_1
from swerve.vehicle.fitting.figures import FIG_3_FRICTION, FIG_3_LOAD, ForceComparison
from swerve.vehicle.fitting.table_1_refit import LineComparison

UNITS: Final = {"B": "1/rad", "C": "1", "D": "1", "E": "1"}
ROUNDING: Final = 1e-12  # in the letter's unit: below it, a number is not told from 0
ENDS: Final = ("at_no_load", "per_newton")  # the two numbers of a line


def as_markdown(work: TyreWork) -> str:
    """Two tables and what they do not hold, to be included in a page."""
    away = work.figure_4.largest_error
    off = max(ellipse.error for ellipse in work.figure_3)
    most = max(work.table_1.largest_error.values())
    return f"""Curves of eq. (3) with the parameters of Table 1, fitted again. The simulator's tyre data are not public:
this tests the fit and the lines, not how well eq. (3) meets those data. An error is fitted less printed.

{table(["$F_z$ [N]", *(f"{column.Fz:.0f}" for column in TABLE_1)], _load_rows(work))}

The largest error of a letter is {_shown(most)}. The rows "lines" are eq. (4) on the printed lines, at $F_x = 0$ and
$\\mu = 1$, against those curves.

{table(["", "printed", "fitted", "error", "rounding", "$R^2$"], _line_rows(work.table_1.lines))}

The lines go through the printed $B$, $C$ and $D$. "Rounding" is how far the four decimals of Table 1 leave them open.

Fig. 3: along eq. (4) the left side of eq. (2) is 1 to within {off:.0e}, the floor under the root. Fig. 4: the printed
lines are at most {away["B"]:.4f} 1/rad from $B$, {away["C"]:.5f} from $C$ and {away["D"]:.5f} from $D$ of Table 1.
"""


def as_csv(work: TyreWork) -> str:
    """A line for each number that is printed: its load where it has one, the number fitted, and the error."""
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["quantity", "load", "printed", "fitted", "error"])
    for column, fit in zip(TABLE_1, work.table_1.fit.loads, strict=True):
        for letter in UNITS:
            printed, fitted = getattr(column, letter), getattr(fit.full, letter)
            writer.writerow([letter, column.Fz, printed, fitted, fitted - printed])
    for letter, line in work.table_1.lines.items():
        for i, name in enumerate(ENDS):
            writer.writerow([f"{letter}_{name}", "", line.printed[i], getattr(line.fitted, name), line.difference[i]])
    return text.getvalue()


def as_json(work: TyreWork) -> str:
    """All of it, in SI units."""
    refit, figure = work.table_1, work.figure_4
    loads = [
        {"printed": asdict(column), "fitted": asdict(fit.full), "lines": _force_errors(force)}
        for column, fit, force in zip(TABLE_1, refit.fit.loads, figure.forces, strict=True)
    ]
    lines = {
        letter: {
            "printed": dict(zip(ENDS, line.printed, strict=True)),
            "fitted": asdict(line.fitted),
            "error": dict(zip(ENDS, line.difference, strict=True)),
            "rounding": dict(zip(ENDS, line.rounding, strict=True)),
        }
        for letter, line in refit.lines.items()
    }
    ellipses = [{"slip_angle": each.slip_angle, "error": each.error} for each in work.figure_3]
    whole = {
        "version": __version__,
        "table_1": {"loads": loads, "largest_error": refit.largest_error},
        "lines": lines,
        "figure_3": {"load": FIG_3_LOAD, "friction": FIG_3_FRICTION, "ellipses": ellipses},
        "figure_4": {"largest_error": figure.largest_error},
    }
    return json.dumps(whole, indent=2, allow_nan=False) + "\n"


def _force_errors(force: ForceComparison) -> dict[str, float]:
    return {name: getattr(force, name) for name in ("rms_error", "largest_error", "relative_error")}


def _load_rows(work: TyreWork) -> list[list[str]]:
    """A column for each load."""
    fits, forces, rows = [load.full for load in work.table_1.fit.loads], work.figure_4.forces, []
    for letter, unit in UNITS.items():
        printed, fitted = ([getattr(each, letter) for each in source] for source in (TABLE_1, fits))
        rows += [
            [f"${letter}$ [{unit}], printed", *(f"{value:.{'1e' if letter == 'E' else '4f'}}" for value in printed)],
            [f"${letter}$, fitted", *map(_shown, fitted)],
            [f"${letter}$, error", *(_shown(a - b) for a, b in zip(fitted, printed, strict=True))],
        ]
    return [
        *rows,
        ["LSE [N], printed", *(_shown(column.LSE) for column in TABLE_1)],
        ["lines, rms [N]", *(f"{force.rms_error:.2f}" for force in forces)],
        ["lines, largest [N]", *(f"{force.largest_error:.2f}" for force in forces)],
        ["lines, largest over peak", *(f"{force.relative_error:.2%}" for force in forces)],
    ]


def _line_rows(lines: dict[str, LineComparison]) -> list[list[str]]:
    rows = []
    for letter, line in lines.items():
        numbers = zip(ENDS, line.printed, line.difference, line.rounding, strict=True)
        for end, printed, error, rounding in numbers:
            digits = ".4f" if end == "at_no_load" else ".4e"
            name = f"${letter}$ at no load [{UNITS[letter]}]" if end == "at_no_load" else f"${letter}$ per newton"
            r_squared = f"{line.fitted.r_squared:.4f}" if end == "at_no_load" else ""
            fitted = getattr(line.fitted, end)
            rows.append(
                [name, f"{printed:{digits}}", f"{fitted:{digits}}", f"{error:.1e}", f"{rounding:.1e}", r_squared]
            )
    return rows


def _shown(value: float) -> str:
    """To four decimals, as in Table 1."""
    return f"< {ROUNDING:.0e}" if abs(value) < ROUNDING else f"{value:.4f}"
