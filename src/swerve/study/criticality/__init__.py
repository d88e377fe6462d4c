"""How close to the limit: measures of criticality of a scenario's start, and of every instant of a run."""

from swerve.study.criticality.log import Criticality, Worst, of_motion, of_scenario
from swerve.study.criticality.measures import UNITS, measure
from swerve.study.criticality.scene import Scene

__all__ = ["UNITS", "Criticality", "Scene", "Worst", "measure", "of_motion", "of_scenario"]
