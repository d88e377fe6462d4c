"""`swerve fit-tyre`: a tyre for scenarios from measured data."""

import argparse
import sys
from pathlib import Path
from typing import Any

from swerve.commands.printing import print_paths


def add_command(commands: Any) -> None:
    """Add it to a parser's `commands`."""
    fit_tyre = commands.add_parser("fit-tyre", help="fit a tyre to data", allow_abbrev=False)
    fit_tyre.set_defaults(call=_fit_tyre)
    fit_tyre.add_argument("data", type=Path, metavar="DATA", help="tyre data in a .csv or .tir file")
    fit_tyre.add_argument("--json", action="store_true", help="print the fit as one JSON object")
    fit_tyre.add_argument("--out", type=Path, metavar="FILE", help="write the tyre there, for a scenario's ego.tyre")


def _fit_tyre(options: argparse.Namespace) -> int:
    from swerve.report.tyre import fitted_tyre, prepare_tyre_file, tyre_json, tyre_table, write_tyre
    from swerve.vehicle.fitting import fit_tyre, read_tyre_data

    data = read_tyre_data(options.data)
    if options.out is not None:
        prepare_tyre_file(options.out)
    fit = fit_tyre(data)
    tyre = fitted_tyre(fit, (options.out or options.data).stem)
    if options.out is not None:
        write_tyre(tyre, options.out)
    print(tyre_json(fit, tyre) if options.json else tyre_table(fit, tyre))
    print_paths([options.out] if options.out else [], sys.stderr if options.json else sys.stdout)
    return 0
