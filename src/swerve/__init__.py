"""swerve: brake, steer or both, with every wheel, in one optimisation; and how close to the limit it came."""

__version__ = "0.1.0"
