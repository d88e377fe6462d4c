"""Random scenes: of those that can be avoided with something to spare, how many are."""

from swerve.study.random_scenes.drawing import quiet_scene, scene
from swerve.study.random_scenes.search import SPARE, Certificate, certificate
from swerve.study.random_scenes.survey import Survey, survey
from swerve.study.random_scenes.threats import is_quiet, is_threat
from swerve.study.random_scenes.trial import Trial, try_scene

__all__ = [
    "SPARE",
    "Certificate",
    "Survey",
    "Trial",
    "certificate",
    "is_quiet",
    "is_threat",
    "quiet_scene",
    "scene",
    "survey",
    "try_scene",
]
