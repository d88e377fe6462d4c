"""What the nonlinear controller is told beside horizons, weights and goal."""

from dataclasses import dataclass


@dataclass(frozen=True)
class NonlinearSettings:
    """Penalties and limits, meant to be those of `unified`, and the solver.

    Attributes:
        slip_limit: largest |slip angle| of an axle, soft [rad].
        slip_penalty: per radian beyond it [1/rad].
        slip_penalty_quadratic: per square radian beyond it [1/rad^2].
        clearance_margin: between the footprint and an obstacle, soft [m].
        clearance_penalty: per metre of margin that is missed [1/m].
        clearance_penalty_quadratic: per square metre of it [1/m^2].
        force_weight: on each wheel force [1/N^2].
        commitment: the other side is taken when it costs less than this share of the present one [1].
        tail: samples after the horizon in which no state is tracked but all limits hold [1].
        solver: a name in `solver.SOLVERS`.
    """

    slip_limit: float
    slip_penalty: float
    slip_penalty_quadratic: float
    clearance_margin: float
    clearance_penalty: float
    clearance_penalty_quadratic: float
    force_weight: float
    commitment: float
    tail: int
    solver: str
