"""What a step plans in: the start, the obstacles as expected, the road; and which of the obstacles are in the path.

In the path is what the vehicle would touch if it kept its speed and went to its goal's lateral offset.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.forecast import Forecast
from swerve.control.plan import Passing, Side
from swerve.control.unified.lines import ANY, Lines
from swerve.control.unified.tail import Outlook, Tail
from swerve.conventions import GRAVITY, POSE, PSI, VX, VY, Y
from swerve.world import Footprint, Road

Array = NDArray[np.float64]

SHORTEST_LOOK = 3.4  # [s] as far as a plan sees with its tail
REACTION = 1.5  # [s] that is added to the time of a stop to look for what is in the path
LEAVING_SPEED = 0.7  # [m/s] sideways
OFF_MIDDLE = 0.7  # [m]
LANE_LEFT = 0.3  # [m] beyond a lane's line that leaves the lane
BESIDE = 6.0  # [m] a swerve may meet what is no further from the path
LEAVING = 1.5  # [m] what was in the path is so until it is passed with more than that
STOPPING_GRIP = 0.9  # [1] share of mu g of that stop
GENTLE = 0.3  # [1] share of mu g with which the vehicle goes to its goal's offset
STIFFNESS = 4.0  # [1/s^2] of that motion


@dataclass(frozen=True, eq=False)
class Place:
    """What stays the same from step to step.

    Attributes:
        footprint: of the ego vehicle.
        road: its edges.
        friction: mu [1].
        lateral_offset: of the goal [m].
        margin: to obstacles and edges [m].
        braking: share of full braking that the vehicle's inputs reach [1].
        turning: share of a steered swerve that they reach [1].
    """

    footprint: Footprint
    road: Road
    friction: float
    lateral_offset: float
    margin: float
    braking: float = 1.0
    turning: float = 1.0

    @property
    def grip(self) -> float:
        """mu g [m/s^2]."""
        return self.friction * GRAVITY

    def reach(self, side: Side) -> float:
        """How far the footprint reaches to a side when it points along the road [m]."""
        return float(self.footprint.support([[0.0, side.value]])[0])

    def room(self) -> tuple[float, float]:
        """Smallest and largest Y of the centre of gravity with the footprint on the road, infinite without edges."""
        right, left = self.road.right_edge, self.road.left_edge
        lowest = -np.inf if right is None else right + self.reach(Side.RIGHT) + self.margin
        highest = np.inf if left is None else left - self.reach(Side.LEFT) - self.margin
        return lowest, highest

    def lanes(self, y: float) -> tuple[float, float]:
        """Smallest and largest Y of the centre of gravity in the lanes of `y` and the goal; infinite without lanes."""
        width = self.road.lane_width
        if width is None:
            return -np.inf, np.inf
        middles = [width * round(each / width) for each in (y, self.lateral_offset)]
        room = width / 2 + LANE_LEFT
        return min(middles) - room + self.reach(Side.RIGHT), max(middles) + room - self.reach(Side.LEFT)


@dataclass(frozen=True, eq=False)
class Scene:
    """The scene of one step.

    Attributes:
        place: what stays the same.
        start: (6,) state in which this step's command begins to act.
        time: of that, on the controller's clock [s].
        forecasts: of each obstacle.
        natural: how each obstacle is passed by going on; for those in the path it says nothing.
        threats: indices of the obstacles in the path, the first to be met first.
        companions: indices of those beside it.
    """

    place: Place
    start: Array
    time: float
    forecasts: tuple[Forecast, ...]
    natural: tuple[Passing, ...]
    threats: tuple[int, ...]
    companions: tuple[int, ...]

    def leaves_lane(self, poses: Array) -> bool:
        """Whether a path (n, 3) does."""
        lowest, highest = self.place.lanes(float(self.start[Y]))
        return bool((poses[:, 1] < lowest).any() or (poses[:, 1] > highest).any())

    @property
    def is_leaving(self) -> bool:
        """Whether the vehicle moves sideways too fast, or is too far off the middle, to be said to stay in its lane."""
        sideways = np.sin(self.start[PSI]) * self.start[VX] + np.cos(self.start[PSI]) * self.start[VY]
        width = self.place.road.lane_width or np.inf
        off_middle = abs(self.start[Y] - width * round(self.start[Y] / width)) if np.isfinite(width) else 0.0
        return bool(abs(sideways) > LEAVING_SPEED or off_middle > OFF_MIDDLE)

    @property
    def speed(self) -> float:
        """Of the vehicle over ground [m/s]."""
        return float(np.hypot(self.start[VX], self.start[VY]))


def look(
    place: Place,
    start: Array,
    time: float,
    forecasts: tuple[Forecast, ...],
    before: tuple[int, ...],
    tail: Tail,
    lines: Lines,
) -> Scene:
    """The scene with what is in the path; `before` was in it so far, `lines` are for the pairs of poses of the tail."""
    speed = float(np.hypot(start[VX], start[VY]))
    duration = max(SHORTEST_LOOK, REACTION + speed / (STOPPING_GRIP * place.grip))
    steps = np.full(tail.n_steps, duration / tail.n_steps)
    targets = np.full(tail.n_steps, place.lateral_offset)
    outlook = Outlook(steps, targets, STIFFNESS, GENTLE * place.grip, 0.0)
    poses = np.concatenate([start[np.newaxis, POSE], tail.path(start, outlook)[0]])
    times = time + np.concatenate([[0.0], outlook.times])
    natural, met, companions = [], {}, []
    for i, forecast in enumerate(forecasts):
        from_centre = poses.copy()
        from_centre[:, :2] -= forecast.position_at(times)
        normals, gaps, _ = lines.between(forecast.shape, forecast.heading, from_centre, ANY)
        gap = gaps.min(axis=1)
        touching = np.flatnonzero(gap < (LEAVING if i in before else place.margin))
        if len(touching):
            met[i] = int(touching[0])
        elif gap.min() < BESIDE:
            companions.append(i)
        natural.append(passed(normals[gap.argmin()], from_centre[0]))
    threats = sorted(met, key=lambda i: (met[i], i))
    return Scene(place, start, time, forecasts, tuple(natural), tuple(threats), tuple(companions))


def passed(normal: Array, from_centre: Array) -> Passing:
    """How an obstacle is passed whose nearest separating line has this normal (2,), from this pose (3,) on."""
    if abs(normal[0]) < abs(normal[1]):
        return Passing.LEFT if normal[1] > 0 else Passing.RIGHT
    if normal[0] < 0:
        return Passing.BEHIND
    return Passing.LEFT if from_centre[1] >= 0 else Passing.RIGHT
