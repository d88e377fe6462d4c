"""Scenarios: what happens around the ego vehicle and what is asked of it, from a TOML file."""

from swerve.scenario.actuation import MODES, ActuationSettings
from swerve.scenario.controller import CORRECTIONS, ControllerSettings, UnifiedSettings, Weights
from swerve.scenario.families import FAMILIES
from swerve.scenario.loader import library_names, load, parse
from swerve.scenario.scenario import Scenario

__all__ = [
    "CORRECTIONS",
    "FAMILIES",
    "MODES",
    "ActuationSettings",
    "ControllerSettings",
    "Scenario",
    "UnifiedSettings",
    "Weights",
    "library_names",
    "load",
    "parse",
]
