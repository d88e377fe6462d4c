"""Obstacles in words: shape, place, and how each one moves."""

from collections.abc import Sequence
from math import hypot
from operator import mul
from typing import Final

from swerve.scenario.obstacle import ObstacleSettings

TIMES: Final = "\N{MULTIPLICATION SIGN}"
KM_H: Final = 3.6  # [(km/h) / (m/s)]


def obstacles_in_words(obstacles: Sequence[ObstacleSettings]) -> str:
    """All of them; "none" where there is none."""
    return "; ".join(map(_obstacle, obstacles)) or "none"


def _obstacle(obstacle: ObstacleSettings) -> str:
    if obstacle.semi_axes is not None:
        kind, size = "ellipse", tuple(2 * each for each in obstacle.semi_axes)
    else:
        kind, size = "box", obstacle.size or (0.0, 0.0)
    name = "" if obstacle.name is None else f"{obstacle.name}, "
    return f"{name}{kind} {size[0]:g} m {TIMES} {size[1]:g} m {_motion(obstacle)}"


def _motion(obstacle: ObstacleSettings) -> str:
    """Where it begins, and how it moves from there."""
    if obstacle.position is None:
        first, *between, last = [(each.time, _place(each.position)) for each in obstacle.waypoints]
        through = f" through {len(between)} more" if between else ""
        return f"from {first[1]} at {first[0]:g} s{through} to {last[1]} at {last[0]:g} s"
    start, speed = f"at {_place(obstacle.position)}", _speed(obstacle.velocity)
    if obstacle.moves_at is not None:
        return f"{start}, at rest until {obstacle.moves_at:g} s, then at {speed}"
    moving = f"{start}, {'at rest' if obstacle.velocity is None or not any(obstacle.velocity) else f'at {speed}'}"
    return f"{moving}{_change(obstacle)}"


def _change(obstacle: ObstacleSettings) -> str:
    """What becomes of its speed; nothing where it keeps it."""
    if obstacle.acceleration is None:
        return ""
    along = sum(map(mul, obstacle.acceleration, obstacle.velocity or obstacle.acceleration))
    deed = "brakes" if along < 0 else "accelerates"
    since = f" from {obstacle.accelerates_at:g} s on" if obstacle.accelerates_at else ""
    end = "" if obstacle.final_speed is None else f" to {obstacle.final_speed * KM_H:.4g} km/h"
    return f", {deed} with {hypot(*obstacle.acceleration):.3g} m/s\N{SUPERSCRIPT TWO}{since}{end}"


def _place(position: tuple[float, float]) -> str:
    return f"({position[0]:g}, {position[1]:g}) m"


def _speed(velocity: tuple[float, float] | None) -> str:
    return f"{hypot(*(velocity or (0.0,))) * KM_H:.4g} km/h"
