"""The controller at measurements that no run would come to."""

from swerve.study.fuzz.fuzz import Fault, Fuzz, fuzz
from swerve.study.fuzz.measurements import measurement

__all__ = ["Fault", "Fuzz", "fuzz", "measurement"]
