"""How near an obstacle may be: the smallest distance that is avoided, against the physical limit."""

from swerve.study.envelope.envelope import REQUIRED, Cell, Condition, Envelope, approach, conditions, envelope
from swerve.study.envelope.limits import LIMITS, SPEEDS

__all__ = ["LIMITS", "REQUIRED", "SPEEDS", "Cell", "Condition", "Envelope", "approach", "conditions", "envelope"]
