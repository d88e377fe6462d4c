"""What the decision of the hierarchical controller is bounded by."""

from dataclasses import dataclass


@dataclass(frozen=True)
class HierarchicalSettings:
    """Settings of the controller `hierarchical`.

    Attributes:
        comfort: share of mu g that keeping the lane, or returning to it, may take [1].
        evasive: share of mu g that a lane change may take, which leaves the tracker the rest [1].
        braking: share of mu g up to which braking goes before a lane change [1].
        margin: between the footprint and an obstacle on a planned path [m].
        slip_limit: largest |slip angle| of an axle in the tracker, soft [rad].
        slip_penalty: per radian beyond it [1/rad].
        slip_penalty_quadratic: per square radian beyond it [1/rad^2].
        lateral_offset: weight on the distance from the path [1/m^2].
        heading: weight on the angle to the path [1/rad^2].
        speed: weight on the deviation from the speed profile [s^2/m^2].
        iterations: of the tracker's quadratic program in a step.
    """

    comfort: float
    evasive: float
    braking: float
    margin: float
    slip_limit: float
    slip_penalty: float
    slip_penalty_quadratic: float
    lateral_offset: float
    heading: float
    speed: float
    iterations: int
