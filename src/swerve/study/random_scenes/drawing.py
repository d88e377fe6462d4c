"""Random scenes: a scenario for each seed and index, with nothing in it that was chosen by hand.

Speed, friction, footprint, start, road and obstacles are drawn independently. An obstacle is put where the vehicle
would be near it after a time that is drawn too, so that most scenes are threats; which of them are is decided by
geometry (`threats.py`), not here.
"""

from collections.abc import Callable
from math import pi
from typing import Any, Final

import numpy as np
from pydantic import ValidationError

from swerve.conventions import GRAVITY
from swerve.scenario import Scenario

DURATION: Final = 6.0  # [s]
SPEEDS: Final = (10.0, 35.0)  # [m/s]
FRICTIONS: Final = (0.3, 1.0)  # [1]
LANE_WIDTH: Final = 3.5  # [m]
MOST_OBSTACLES: Final = 3

Random = np.random.Generator
Keys = dict[str, Any]  # of a scenario's table
Place = Callable[[Random, float, float], Keys]  # (random, ego speed [m/s], friction) -> where it is and how it moves


def scene(seed: int, index: int) -> Scenario:
    """The scene of this number, in which obstacles stand and move near the vehicle's path."""
    return _drawn(seed, index, _obstacle, "random")


def quiet_scene(seed: int, index: int) -> Scenario:
    """The scene of this number, in which the vehicle is where it wants to be and obstacles are beside its path."""
    return _drawn(seed, index, _bystander, "quiet")


def _drawn(seed: int, index: int, draw: Place, name: str) -> Scenario:
    """The first draw that is a scenario: one whose obstacles do not cover the vehicle at its start."""
    random = np.random.default_rng([seed, index])
    while True:
        speed, friction = random.uniform(*SPEEDS), random.uniform(*FRICTIONS)
        n_obstacles = random.integers(1, MOST_OBSTACLES, endpoint=True)
        ego: Keys = {"speed": speed, "footprint": str(random.choice(["point", "rectangle"]))}
        tables = {
            "name": f"{name}-{seed}-{index}",
            "duration": DURATION,
            "road": {"friction": friction} | _lanes(random),
            "ego": ego | (_start(random) if draw is _obstacle else {"position": (0.0, 0.0)}),
            "obstacles": [draw(random, speed, friction) for _ in range(n_obstacles)],
            "goal": {"speed": speed, "lateral_offset": 0.0},
        }
        try:
            return Scenario.model_validate(tables)
        except ValidationError:
            continue


def _start(random: Random) -> Keys:
    """Not quite in the middle of the lane, nor quite along it."""
    return {"position": (0.0, random.uniform(-0.5, 0.5)), "heading": random.uniform(-0.02, 0.02)}


def _lanes(random: Random) -> Keys:
    """No edges in half of the scenes, else two to four lanes."""
    if random.random() < 0.5:
        return {}
    lanes = {"lanes_left": int(random.integers(1, 2, endpoint=True)), "lanes_right": int(random.integers(0, 2))}
    return {"lane_width": LANE_WIDTH} | lanes


def _obstacle(random: Random, speed: float, friction: float) -> Keys:
    """A shape, and one of five ways to be in the way."""
    return _shape(random) | PLACES[random.choice(list(PLACES))](random, speed, friction)


def _shape(random: Random) -> Keys:
    """An ellipse, a car, a lorry or a person."""
    match random.choice(["ellipse", "car", "lorry", "person"], p=[0.4, 0.4, 0.1, 0.1]):
        case "ellipse":
            return {"semi_axes": tuple(random.uniform(0.5, 2.5, 2))}
        case "car":
            return {"size": (random.uniform(3.5, 5.0), random.uniform(1.6, 2.0))}
        case "lorry":
            return {"size": (random.uniform(7.0, 12.0), 2.5)}
    return {"semi_axes": (0.4, 0.4)}


def _static(random: Random, speed: float, friction: float) -> Keys:
    """At rest, turned in any way."""
    position = (speed * _time_to_reach(random), random.normal(0.0, 1.2))
    return {"position": position, "heading": random.uniform(-pi, pi)}


def _slower(random: Random, speed: float, friction: float) -> Keys:
    """In the same direction, at a share of the speed."""
    slow = speed * random.uniform(0.2, 0.8)
    distance = 5.0 + (speed - slow) * _time_to_reach(random)
    return {"position": (distance, random.normal(0.0, 1.2)), "velocity": (slow, 0.0)}


def _braking(random: Random, speed: float, friction: float) -> Keys:
    """Ahead at about the same speed, and then it brakes."""
    position = (5.0 + speed * random.uniform(0.7, 2.0), random.normal(0.0, 1.0))
    deceleration = random.uniform(0.3, 0.9) * friction * GRAVITY
    return {
        "position": position,
        "velocity": (speed * random.uniform(0.7, 1.0), 0.0),
        "acceleration": (-deceleration, 0.0),
        "accelerates_at": random.uniform(0.0, 1.5),
    }


def _oncoming(random: Random, speed: float, friction: float) -> Keys:
    """Towards the vehicle, in its lane or beside it."""
    towards = random.uniform(5.0, 25.0)
    position = ((speed + towards) * _time_to_reach(random), random.uniform(-4.0, 4.0))
    return {"position": position, "velocity": (-towards, 0.0), "heading": pi}


def _crossing(random: Random, speed: float, friction: float) -> Keys:
    """From either side, in the path at about the time at which the vehicle is there."""
    across, time = random.uniform(1.0, 10.0) * random.choice([-1, 1]), _time_to_reach(random)
    position = (speed * time, random.normal(0.0, 1.0) - across * time)
    return {"position": position, "velocity": (0.0, across), "heading": np.sign(across) * pi / 2}


def _time_to_reach(random: Random) -> float:
    """After which the vehicle is there [s]."""
    return random.uniform(0.8, 3.5)


PLACES: Final[dict[str, Place]] = {
    "static": _static,
    "slower": _slower,
    "braking": _braking,
    "oncoming": _oncoming,
    "crossing": _crossing,
}


def _bystander(random: Random, speed: float, friction: float) -> Keys:
    """Beside the path, at rest or along it in either direction."""
    side = random.choice([-1, 1])
    along = random.choice([0.0, speed * random.uniform(0.3, 1.3), -random.uniform(5.0, 25.0)])
    position = (random.uniform(-20.0, 100.0), side * random.uniform(2.0, 8.0))
    return _shape(random) | {"position": position, "velocity": (along, 0.0), "heading": 0.0 if along >= 0 else pi}
