"""From truth to measurement."""

from swerve.sensing.ideal import measure

__all__ = ["measure"]
