"""The decision: keep the lane (or return to it), brake, or change lanes, the first of them that is feasible.

    keep     with a gentle lane change to the goal's offset and the goal's speed, else at the present speed
    brake    with the smallest of BRAKING that stops at a distance
    swerve   left or right, with the gentlest of SHARES and then the smallest offset that is clear
    brake    as hard as it goes

A swerve that was begun is gone on with while it is clear and there is no way back yet; so is a path that is kept, and
braking that was begun, with all that the tyres give.
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from swerve.control.hierarchical.manoeuvre import Manoeuvre
from swerve.control.hierarchical.quintic import SHORTEST, Quintic, sharpest
from swerve.control.hierarchical.scene import SLACK, Scene
from swerve.control.hierarchical.settings import HierarchicalSettings
from swerve.control.settings import Goal
from swerve.conventions import X

Array = NDArray[np.float64]

OFFSETS = (1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 8.0, 10.0)  # [m] of a lane change, to either side
DURATIONS = np.arange(0.5, 6.01, 0.05)  # [s] of a lane change
SHARES = (0.5, 0.7, 0.85, 1.0)  # [1] of what a lane change may take
BRAKING = (0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)  # [1] of full braking
STANDOFF = 0.8  # [m] to an obstacle in front when both stand
BRISK = 0.7  # [1] of what a lane change may take, for one that the goal asks for
FULL = 1.1  # [1] of full braking: all there is, and a little more to pull at
SPEEDING_UP = 2.0  # [m/s^2]
PASSING = 3.0  # [s] looked ahead for a lane change at the least, but as far as a stop would take in any case
LONGER = 2.0  # [s] looked ahead before speeding up
LITTLE = 0.2  # [m/s] that is no speeding up
HERE = 0.05  # [m] from a lateral offset that counts as there
KEPT = "the lane, or the way back to it, is clear"
BRAKED = "the lane is not clear, and there is room to stop"
BEGUN = "braking was begun, and all that the tyres give still does it"
SWERVED = "there is no room to stop, and of the lane changes that are clear this is the gentlest"
HOPELESS = "neither stopping nor a lane change is in time: all that the tyres give"


class Decision:
    """The decision for one goal."""

    def __init__(self, goal: Goal, settings: HierarchicalSettings) -> None:
        """Within the bounds of `settings`."""
        self._goal, self._settings = goal, settings

    def __call__(self, scene: Scene, last: Manoeuvre | None) -> Manoeuvre:
        """What to do now, after `last`."""
        horizon = scene.speed / (2 * self._settings.braking * scene.deceleration) + SLACK
        margin = self._settings.margin
        for keep in self._keeping(scene, last):
            longer = LONGER if keep.speed > scene.speed + LITTLE else 0.0
            if scene.is_clear(keep, horizon + longer, margin):
                return keep
        if last is not None and last.side is not None and scene.is_clear(last, horizon, 0.0):
            return last
        is_braking = last is not None and last.name == "brake"
        for brake, gap in self._braking(scene, last, is_braking):
            if scene.is_clear(brake, scene.speed / brake.rate + SLACK, gap):
                return brake
        swerve = self._swerve(scene, last, max(PASSING, horizon))
        if swerve is not None:
            return swerve
        return Manoeuvre("brake", self._towards_goal(scene, last), 0.0, FULL * scene.deceleration, HOPELESS)

    def _keeping(self, scene: Scene, last: Manoeuvre | None) -> Iterator[Manoeuvre]:
        """Ways to keep the lane: the goal's speed first, then the present one."""
        path, present = self._towards_goal(scene, last), min(scene.speed, self._goal.speed)
        yield Manoeuvre("keep", path, self._goal.speed, SPEEDING_UP, KEPT)
        yield Manoeuvre("keep", path, present, SPEEDING_UP, KEPT)
        begun, target = scene.on_path(last), self._goal.lateral_offset
        if abs(begun[0] - target) > HERE:
            sharper = _change(scene, begun, target, BRISK * self._settings.evasive)
            yield from () if sharper is None else (Manoeuvre("keep", sharper, present, SPEEDING_UP, KEPT),)

    def _braking(self, scene: Scene, last: Manoeuvre | None, is_braking: bool) -> Iterator[tuple[Manoeuvre, float]]:
        """Ways to brake, the gentlest first, each with the clearance that it is to keep [m]."""
        path = self._towards_goal(scene, last)
        for share in BRAKING:
            if is_braking or share <= self._settings.braking:
                yield Manoeuvre("brake", path, 0.0, share * scene.deceleration, BRAKED), STANDOFF
        most = self._settings.braking * scene.deceleration
        yield Manoeuvre("brake", path, 0.0, most, BRAKED), self._settings.margin
        if is_braking:
            yield Manoeuvre("brake", path, 0.0, FULL * scene.deceleration, BEGUN), 0.0

    def _swerving(self, scene: Scene, last: Manoeuvre | None) -> Iterator[Manoeuvre]:
        """Ways to change lanes, the gentlest first, then the nearest, left before right."""
        begun = scene.on_path(last)
        for share in SHARES:
            for offset in OFFSETS:
                for name, side in (("left", 1), ("right", -1)):
                    path = _change(scene, begun, float(begun[0]) + side * offset, share * self._settings.evasive)
                    if path is not None:
                        yield Manoeuvre(name, path, scene.speed, SPEEDING_UP, SWERVED)

    def _towards_goal(self, scene: Scene, last: Manoeuvre | None) -> Quintic:
        """The path to the goal's offset: the last one if it leads there, else the shortest gentle one."""
        target = self._goal.lateral_offset
        if last is not None and abs(last.lateral.target - target) < HERE:
            return last.lateral
        begun = scene.on_path(last)
        gentle = _change(scene, begun, target, self._settings.comfort)
        longest = float(DURATIONS[-1]) * scene.speed
        return gentle or Quintic.between(float(scene.state[X]), begun, longest, target)

    def _swerve(self, scene: Scene, last: Manoeuvre | None, ahead: float) -> Manoeuvre | None:
        """The first lane change that keeps the margin for so long [s], else the one nearest to that without contact."""
        swerves = list(self._swerving(scene, last))
        if not swerves:
            return None
        gaps = scene.gaps(swerves, ahead, self._settings.margin)
        kept = gaps > self._settings.margin
        best = int(np.argmax(kept if kept.any() else gaps))
        return swerves[best] if gaps[best] > 0 else None


def _change(scene: Scene, begun: Array, target: float, share: float) -> Quintic | None:
    """The shortest path from y, its slope and bend (3,) to `target` [m] that takes no more than this share of mu g."""
    lengths = np.maximum(DURATIONS * scene.speed, SHORTEST)
    lateral = scene.speed**2 * sharpest(begun, lengths, target)
    feasible = lateral <= share * scene.grip
    if not feasible.any():
        return None
    return Quintic.between(float(scene.state[X]), begun, float(lengths[np.argmax(feasible)]), target)
