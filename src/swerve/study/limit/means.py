"""What a vehicle may do against a collision: the columns through which its inputs can be reached.

Inputs are shares: of the steering lock, and for each wheel of the force that `Vehicle.force_limit` gives it,

    u = [delta_max w_0;  force_limit mu Fz_i w_i],   w = E v,   lower <= v <= upper.
"""

from enum import Enum
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swerve.conventions import N_INPUTS

Array = NDArray[np.float64]

_STEER: Final = (1, 0, 0, 0, 0)
_FRONT: Final = (0, 1, 1, 0, 0)
_REAR: Final = (0, 0, 0, 1, 1)
_ALL_WHEELS: Final = (0, 1, 1, 1, 1)


class Means(Enum):
    """The value is its name on the command line; each has a sentence.

    Brakes act alike left and right; with individual torques each wheel brakes and drives as it likes.
    """

    BRAKING = "braking"
    STEERING = "steering"
    BOTH = "both"
    INDIVIDUAL = "individual"

    @property
    def sentence(self) -> str:
        """What is used."""
        return _SENTENCES[self]

    @property
    def directions(self) -> Array:
        """E (5, n): a column of w for each free input."""
        return np.array(_DIRECTIONS[self], dtype=float).T

    @property
    def lower(self) -> Array:
        """Smallest v (n,) [1]: full steering to the right, full brake."""
        return -np.ones(len(_DIRECTIONS[self]))

    @property
    def upper(self) -> Array:
        """Largest v (n,) [1]: full steering to the left, and no drive but with individual torques."""
        steers = self.directions[0] > 0
        return np.ones(steers.size) if self is Means.INDIVIDUAL else steers.astype(float)

    @property
    def contained(self) -> tuple["Means", ...]:
        """The means with which nothing can be done that cannot be done with these."""
        return _CONTAINED[self]

    def free(self, shares: Array) -> Array:
        """The v (n, k) nearest to shares w (k, 5)."""
        v = np.linalg.lstsq(self.directions, shares.T, rcond=None)[0]
        free: Array = np.clip(v, self.lower[:, np.newaxis], self.upper[:, np.newaxis])
        return free


_SENTENCES: Final = {
    Means.BRAKING: "brakes alone, the wheels straight",
    Means.STEERING: "steering alone, the wheels rolling",
    Means.BOTH: "steering, and brakes on the front and the rear axle",
    Means.INDIVIDUAL: "steering, and a torque of its own on every wheel",
}
_DIRECTIONS: Final = {
    Means.BRAKING: (_ALL_WHEELS,),
    Means.STEERING: (_STEER,),
    Means.BOTH: (_STEER, _FRONT, _REAR),
    Means.INDIVIDUAL: tuple(tuple(row) for row in np.eye(N_INPUTS, dtype=int).tolist()),
}
_CONTAINED: Final[dict[Means, tuple[Means, ...]]] = {
    Means.BRAKING: (),
    Means.STEERING: (),
    Means.BOTH: (Means.BRAKING, Means.STEERING),
    Means.INDIVIDUAL: (Means.BOTH,),
}
