"""The friction of a road: one coefficient, and rectangles along the axes on which it is another.

Where patches overlap the last one counts. A patch may be unbounded, so two well-known test roads are one patch each:
`Friction.split` (another coefficient to the left of a line) and `Friction.jump` (another one from a line on).
"""

from dataclasses import dataclass
from math import inf, isfinite, isnan

import numpy as np
from numpy.typing import ArrayLike, NDArray

MOST_PATCHES = 8  # that a road may have; a plant's kernel has a place for each


@dataclass(frozen=True)
class Patch:
    """A rectangle of the road, its edges included.

    Attributes:
        x: from and to, along X [m]; may be infinite.
        y: from and to, along Y [m]; may be infinite.
        friction: mu on it [1].

    Raises:
        ValueError: an interval that is empty, or a friction that is not positive and finite.
    """

    x: tuple[float, float]
    y: tuple[float, float]
    friction: float

    def __post_init__(self) -> None:
        for name, (low, high) in (("x", self.x), ("y", self.y)):
            if isnan(low) or isnan(high) or low >= high:
                raise ValueError(f"{name} must go from a smaller to a larger number, got {low:g} to {high:g}")
        _check(self.friction)


@dataclass(frozen=True)
class Friction:
    """The friction of a whole road.

    Attributes:
        base: mu beside all patches, which is what a controller is told [1].
        patches: in order; at most MOST_PATCHES.

    Raises:
        ValueError: a base that is not positive and finite, or too many patches.
    """

    base: float
    patches: tuple[Patch, ...] = ()

    def __post_init__(self) -> None:
        _check(self.base)
        if len(self.patches) > MOST_PATCHES:
            raise ValueError(f"a road has at most {MOST_PATCHES} patches, got {len(self.patches)}")

    @classmethod
    def split(cls, right: float, left: float, y: float = 0.0) -> "Friction":
        """`left` where Y is at least `y` [m], `right` beyond."""
        return cls(right, (Patch((-inf, inf), (y, inf), left),))

    @classmethod
    def jump(cls, before: float, after: float, x: float) -> "Friction":
        """`after` from X = `x` [m] on, `before` up to there."""
        return cls(before, (Patch((x, inf), (-inf, inf), after),))

    def at(self, positions: ArrayLike) -> NDArray[np.float64]:
        """Mu (n,) at positions (n, 2) [m]."""
        x, y = np.asarray(positions, dtype=float).reshape(-1, 2).T
        friction = np.full(len(x), self.base)
        for patch in self.patches:
            inside = (patch.x[0] <= x) & (x <= patch.x[1]) & (patch.y[0] <= y) & (y <= patch.y[1])
            friction[inside] = patch.friction
        return friction


def _check(friction: float) -> None:
    if not (isfinite(friction) and friction > 0):
        raise ValueError(f"friction must be positive and finite, got {friction:g}")
