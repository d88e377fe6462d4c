"""A path of straight lanes along X, joined by smooth changes between them.

Over a change of length l and width w, with s from 0 to 1:   Y = Y0 + w (s - sin(2 pi s) / (2 pi)),

whose curvature is continuous; at speed v its largest lateral acceleration is 2 pi w v^2 / l^2.
"""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class LanePath:
    """Y over X.

    Attributes:
        lanes: (from X, to X, Y) of each straight part, in order [m]; before the first and after the last it goes on.
    """

    lanes: tuple[tuple[float, float, float], ...]

    def at(self, x: float) -> float:
        """Y at `x` [m]."""
        y = self.lanes[0][2]
        for (_, start, before), (end, _, after) in zip(self.lanes[:-1], self.lanes[1:], strict=True):
            s = float(np.clip((x - start) / (end - start), 0.0, 1.0))
            y += (after - before) * (s - np.sin(2 * np.pi * s) / (2 * np.pi))
        return float(y)
