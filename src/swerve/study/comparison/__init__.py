"""Scenarios by controllers, side by side."""

from swerve.study.comparison.comparison import Comparison, Group, check, compare
from swerve.study.comparison.entry import Entry

__all__ = ["Comparison", "Entry", "Group", "check", "compare"]
