"""Time to brake: until the last instant at which full braking still avoids every obstacle.

Hillenbrand, Spieker, Kroschel, A multilevel collision mitigation approach, IEEE Trans. Intelligent Transportation
Systems 7 (2006); Tamke, Dang, Breuel, A flexible method for criticality assessment in driver assistance systems, IEEE
IV (2011). Here the braking is that of the two-track model (driver.py).
"""

import numpy as np
from numpy.typing import NDArray

from swerve.study.criticality.last_start import last_start
from swerve.study.criticality.roll_out import Path
from swerve.study.criticality.scene import Scene

Array = NDArray[np.float64]


def time_to_brake(scene: Scene, braking: Path, ttc: Array) -> Array:
    """Of instants that lead to a collision, (n,) [s]; -inf where it is too late for braking alone.

    Args:
        scene: n instants.
        braking: where full braking leads (`roll_out` of `full_braking`).
        ttc: (n,) time to collision, finite [s].
    """
    return last_start(scene, braking, ttc, on_road=False)
