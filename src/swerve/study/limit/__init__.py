"""The limit of a scene: the smallest distance and friction at which any control could still avoid."""

from swerve.study.limit.best import Optimum
from swerve.study.limit.limit import Limit, Limits, limit_of, limits_of
from swerve.study.limit.means import Means

__all__ = ["Limit", "Limits", "Means", "Optimum", "limit_of", "limits_of"]
