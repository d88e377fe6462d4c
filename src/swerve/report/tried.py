"""The ways that were tried in a step, as the log has them: a list in JSON for each step."""

from dataclasses import dataclass
from typing import Final

from pydantic import TypeAdapter


@dataclass(frozen=True)
class Tried:
    """One way.

    Attributes:
        name: what it does about the obstacles in the path.
        cost: of the tracking terms [1].
        violation: largest distance by which it misses a margin to an obstacle [m].
        off_road: largest distance beyond a road edge [m].
        impact_speed: relative to the obstacle that it touches, None where it touches none [m/s].
    """

    name: str
    cost: float
    violation: float
    off_road: float
    impact_speed: float | None


TRIED: Final = TypeAdapter(list[Tried])
