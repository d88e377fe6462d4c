"""`swerve criticality`: how close to the limit a scenario begins, and how close every instant of a run was."""

import argparse
from pathlib import Path
from typing import Any


def add_command(commands: Any) -> None:
    """Add it to a parser's `commands`."""
    one = commands.add_parser("criticality", help="how close to the limit: TTC, TTB, TTS, BTN ...", allow_abbrev=False)
    one.set_defaults(call=_measure)
    one.add_argument(
        "what", metavar="SCENARIO|RUN-FOLDER", help="library name or TOML file; or a folder that `run --out` filled"
    )
    one.add_argument("--json", action="store_true", help="print all instants as one JSON object")


def _measure(options: argparse.Namespace) -> int:
    from swerve.report.criticality import criticality_json, criticality_table
    from swerve.report.exports.folder import read_run_folder
    from swerve.scenario import library_names, load
    from swerve.simulate import DEFAULT_PLANT
    from swerve.study.criticality import of_motion, of_scenario

    folder = Path(options.what)
    if options.what not in library_names() and folder.is_dir():
        run = read_run_folder(folder)
        found = of_motion(run.scenario, run.result.plant, run.log.motion)
    else:
        found = of_scenario(load(options.what), DEFAULT_PLANT)
    print(criticality_json(found) if options.json else criticality_table(found))
    return 0
