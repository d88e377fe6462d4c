"""When the emergency brake acts, and when it lets go."""

from dataclasses import dataclass


@dataclass(frozen=True)
class BrakeSettings:
    """Settings of the controller `brake`.

    Attributes:
        trigger_share: it acts when braking with this share of the largest deceleration comes too late [1].
        trigger_time: it acts when there is contact within this time at the present speed [s].
        margin: between the footprint and an obstacle that counts as contact [m].
    """

    trigger_share: float
    trigger_time: float
    margin: float
