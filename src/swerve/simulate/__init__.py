"""One run: the loop, its log, its outcome."""

from swerve.simulate.assemble import CONTROLLERS, DEFAULT_CONTROLLER, DEFAULT_PLANT, PLANTS
from swerve.simulate.log import Log, Table
from swerve.simulate.loop import Run, run
from swerve.simulate.outcome import Outcome, first_contact
from swerve.simulate.result import Result

__all__ = [
    "CONTROLLERS",
    "DEFAULT_CONTROLLER",
    "DEFAULT_PLANT",
    "PLANTS",
    "Log",
    "Outcome",
    "Result",
    "Run",
    "Table",
    "first_contact",
    "run",
]
