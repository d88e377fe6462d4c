"""Sec. 4 of the paper to the letter, misprints included, with a switch for each."""

from swerve.control.as_printed.controller import AsPrintedController
from swerve.control.as_printed.settings import AsPrintedSettings

__all__ = ["AsPrintedController", "AsPrintedSettings"]
