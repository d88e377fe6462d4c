"""From a measurement and a memory to a command: one folder a controller, one protocol for all."""

from swerve.control.plan import KEEP, Branch, Fallback, Passing, Plan, Side
from swerve.control.protocol import Controller
from swerve.control.settings import Goal, Horizon, Latency, Weights

__all__ = [
    "KEEP",
    "Branch",
    "Controller",
    "Fallback",
    "Goal",
    "Horizon",
    "Latency",
    "Passing",
    "Plan",
    "Side",
    "Weights",
]
