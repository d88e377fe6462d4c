"""Settings of the unified controller, beside those that all controllers share."""

from dataclasses import dataclass


@dataclass(frozen=True)
class UnifiedSettings:
    """How the sequential convex program is set up; the scenario's schema holds the defaults.

    Attributes:
        slip_limit: largest |slip angle| of an axle, soft [rad].
        slip_penalty: per radian beyond it [1/rad].
        slip_penalty_quadratic: per square radian beyond it [1/rad^2].
        clearance_margin: between the footprint and an obstacle, soft [m].
        clearance_penalty: per metre of margin that is missed [1/m].
        clearance_penalty_quadratic: per square metre of it [1/m^2].
        passing_gap: besides the margin, to an obstacle that it passes, as far as it costs little [m].
        stopping_gap: besides the margin, to an obstacle that it stays behind [m].
        force_weight: on each wheel force, which settles the forces that the cost does not see [1/N^2].
        trust_steering: largest change of a planned steering angle in an iteration [rad].
        trust_force: largest change of a planned wheel force in an iteration [N].
        iterations: of the convex program in an ordinary step.
        first_iterations: when a way has no plan that keeps clear.
        commitment: another way is taken when it costs less than this share of the present one [1].
        deadline: of a step, as a share of the sample time [1].
    """

    slip_limit: float
    slip_penalty: float
    slip_penalty_quadratic: float
    clearance_margin: float
    clearance_penalty: float
    clearance_penalty_quadratic: float
    passing_gap: float
    stopping_gap: float
    force_weight: float
    trust_steering: float
    trust_force: float
    iterations: int
    first_iterations: int
    commitment: float
    deadline: float
