"""Scenes of the tests: the paper's, with what a test changes."""

from swerve.scenario import load
from swerve.study.limit.scene import Scene


def scene(*overrides: str) -> Scene:
    """The paper's scene with overrides."""
    return Scene.of(load("paper", overrides))
