"""How a run ended, decided by geometry and motion on the plant's time grid, never by what a controller believed."""

from collections.abc import Callable
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import POSE, VX, VY
from swerve.plant import Trace
from swerve.scenario import Scenario
from swerve.world import Ellipse, Footprint, Obstacle, Road, clearance, distance_ratio

Array = NDArray[np.float64]

SPIN_SIDESLIP = np.pi / 4  # [rad] the vehicle points this far away from where it goes: lost
ABSURD = 1e6  # [SI] a speed, rate, angle or position beyond it is a simulation that diverged
SPIN_SPEED = 2.0  # [m/s] below, a sideslip angle means little


class Outcome(Enum):
    """The verdict of a run; the value is its name in JSON. The first that holds, in this order, is the verdict."""

    DIVERGED = "diverged"
    COLLIDED = "collided"
    LEFT_ROAD = "left_road"
    SPUN = "spun"
    AVOIDED = "avoided"

    @property
    def sentence(self) -> str:
        """The verdict in words."""
        return _SENTENCES[self]


_SENTENCES = {
    Outcome.DIVERGED: "The simulated motion grew beyond all bounds.",
    Outcome.COLLIDED: "The vehicle touched an obstacle.",
    Outcome.LEFT_ROAD: "The vehicle crossed the edge of the road.",
    Outcome.SPUN: "The vehicle turned more than 45 degrees away from where it was going.",
    Outcome.AVOIDED: "The vehicle touched nothing and stayed in hand.",
}


def ratio_to(obstacle: Obstacle, footprint: Footprint, poses: Array, times: Array) -> Array | None:
    """sqrt(rho) of eq. (5), (n,), 1 is contact; None for an obstacle that is no ellipse."""
    return distance_ratio(footprint, poses, obstacle, times) if isinstance(obstacle.shape, Ellipse) else None


def touches(obstacle: Obstacle, footprint: Footprint, poses: Array, times: Array) -> NDArray[np.bool_]:
    """Whether the footprint is in contact with the obstacle, at each of the times (n,) [s]."""
    ratio = ratio_to(obstacle, footprint, poses, times)
    return clearance(footprint, poses, obstacle, times) <= 0 if ratio is None else ratio < 1


def first_contact(scenario: Scenario) -> Callable[[float, Trace], bool]:
    """Ends a run of the scenario with the sample in which the vehicle first touches an obstacle: `run`'s `until`."""
    footprint, obstacles = scenario.ego.to_footprint(), [each.to_world() for each in scenario.obstacles]

    def is_over(start: float, trace: Trace) -> bool:
        times = start + scenario.plant.step * np.arange(float(len(trace.states)))
        poses = trace.states[:, POSE]
        return any(bool(touches(each, footprint, poses, times).any()) for each in obstacles)

    return is_over


def sideslip(states: Array) -> Array:
    """Angle from the vehicle's axis to its velocity (n,) [rad]; 0 where it is nearly at rest."""
    speed = np.hypot(states[:, VX], states[:, VY])
    angle: Array = np.where(speed > SPIN_SPEED, np.arctan2(states[:, VY], states[:, VX]), 0.0)
    return angle


def n_sane(states: Array) -> int:
    """How many rows of (n, 6) come before the first that is no vehicle's any more: nan, or beyond ABSURD."""
    sane = (np.abs(states) < ABSURD).all(axis=1)
    return len(states) if sane.all() else int(np.argmin(sane))


def decide(states: Array, contact: NDArray[np.bool_], poses: Array, road: Road, footprint: Footprint) -> Outcome:
    """The verdict.

    Args:
        states: (n, 6) vehicle states.
        contact: (n,) whether the footprint touches any obstacle.
        poses: (n, 3) X, Y, psi.
        road: with edges or without.
        footprint: of the ego vehicle.
    """
    if n_sane(states) < len(states):
        return Outcome.DIVERGED
    if contact.any():
        return Outcome.COLLIDED
    if not road.is_inside(footprint, poses).all():
        return Outcome.LEFT_ROAD
    return Outcome.SPUN if (np.abs(sideslip(states)) > SPIN_SIDESLIP).any() else Outcome.AVOIDED
