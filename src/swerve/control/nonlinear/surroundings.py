"""The obstacles as the program's data: numbers of pairs of a point and an ellipse, and the margins to keep to them."""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.control.nonlinear.cover import pairs
from swerve.control.nonlinear.stage import N_PAIR
from swerve.control.nonlinear.values import Question
from swerve.conventions import PSI, VX, VY, X, Y
from swerve.world import Footprint

Array = NDArray[np.float64]

NOWHERE: Final = (0.0, 0.0, 0.0, 1e3, 0.0, 0.0, 100.0, 100.0, 0.0)  # a pair beside the ego vehicle, never near
CENTRE: Final = slice(2, 4)  # of a pair's numbers
SPEED: Final = slice(4, 6)
SEMI_AXES: Final = slice(6, 8)


class Surroundings:
    """What a footprint is to keep clear of in each question."""

    def __init__(self, footprint: Footprint, size: tuple[int, int], margin: float, sample_time: float) -> None:
        """Of so many obstacles and pairs for each, to be kept off by a margin [m], seen every sample time [s]."""
        self._footprint, self._size, self._margin, self._sample_time = footprint, size, margin, sample_time

    def numbers(self, question: Question) -> tuple[Array, Array]:
        """Those of all pairs (n_obstacles n_pairs, N_PAIR), of the nearest obstacles if there are too many.

        Returns:
            The numbers as `Pair.as_tuple` has them, and the margin of each pair [m].
        """
        found = np.tile(NOWHERE, (*self._size, 1))
        found[..., CENTRE] += question.state[[X, Y]]
        for place, i in zip(found, question.nearest, strict=False):
            numbers = [pair.as_tuple() for pair in pairs(self._footprint, question.obstacles[i])][: self._size[1]]
            place[: len(numbers)] = numbers
        seen = found.reshape(-1, N_PAIR)
        return seen, self._margin + self._sagitta(question.state, seen)

    def _sagitta(self, state: Array, seen: Array) -> Array:
        """How far a chord of half a sample's length cuts into each pair's ellipse where it is roundest (n,) [m].

        What keeps clear by as much at both ends keeps clear between them, too.
        """
        cos, sin = np.cos(state[PSI]), np.sin(state[PSI])
        velocity = (cos * state[VX] - sin * state[VY], sin * state[VX] + cos * state[VY])
        chord = np.linalg.norm(velocity - seen[:, SPEED], axis=1) * self._sample_time / 2
        semi_axes = seen[:, SEMI_AXES]
        return np.asarray(chord**2 / (8 * semi_axes.min(axis=1) ** 2 / semi_axes.max(axis=1)))
