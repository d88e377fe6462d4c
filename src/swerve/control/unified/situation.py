"""What the iterations of one way work on: its program, from a start, with what is beyond the horizon."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swerve.control.unified.acceptance import Step
from swerve.control.unified.condensing import Sensitivities, condense
from swerve.control.unified.deadline import ROLL_OUT, Deadline
from swerve.control.unified.limits import ObstacleLimit
from swerve.control.unified.prediction import PredictionModel
from swerve.control.unified.program import Program
from swerve.control.unified.tail import Outlook, Tail
from swerve.control.unified.way import Way

Array = NDArray[np.float64]

CLEAR = 5e-3  # [m] a margin missed by less counts as kept


@dataclass(frozen=True, eq=False)
class Situation:
    """The situation of one way in one step.

    Attributes:
        way: through the scene.
        program: cost and limits.
        model: of the vehicle.
        tail: what is beyond the horizon ...
        outlook: ... and what it does.
        times: (n_poses,) of the poses of a trajectory, on the controller's clock [s].
        start: (6,) measured state.
        loads: (4,) wheel loads [N].
        full_trust: (5,) trust region at its largest [rad, N, N, N, N].
        deadline: of the step.
    """

    way: Way
    program: Program
    model: PredictionModel
    tail: Tail
    outlook: Outlook
    times: Array
    start: Array
    loads: Array
    full_trust: Array
    deadline: Deadline

    def roll_out(self, inputs: Array) -> Step:
        """The step that inputs (Np, 5) make, clipped to what the actuators can do."""
        self.deadline.count(ROLL_OUT)
        trajectory = self.model.roll_out(self.start, self.program.clip(inputs), self.loads)
        trajectory = trajectory.extended(*self.tail.path(trajectory.states[-1], self.outlook))
        return Step(trajectory, self.program.score(trajectory))

    def sensitivities(self, step: Step) -> Sensitivities:
        """Derivatives of a step's states, poses and slip angles."""
        of_horizon = condense(self.model.linearise(step.trajectory, self.loads), self.program.box.blocking)
        beyond = self.tail.sensitivities(step.trajectory.states[-1], of_horizon.states[-1], self.outlook)
        return of_horizon.extended(beyond)

    def is_near(self, step: Step) -> bool:
        """Whether an obstacle is in reach of a step, so that the way matters."""
        return any(limit.is_near(step.trajectory) for limit in self._obstacles)

    def touched(self, step: Step) -> tuple[int, ...]:
        """Indices of the obstacles whose margin a step misses."""
        missed = [limit.penalty.missed(limit.violation(step.trajectory)) for limit in self._obstacles]
        return tuple(i for i, each in enumerate(missed) if each > CLEAR)

    def impact_speed(self, step: Step) -> float | None:
        """Largest speed relative to an obstacle at a step's first contact with it; None without one [m/s]."""
        impacts = [limit.impact(step.trajectory) for limit in self._obstacles]
        speeds = [self._relative_speed(step, *impact) for impact in impacts if impact is not None]
        return max(speeds, default=None)

    def _relative_speed(self, step: Step, pose: int, velocity: Array) -> float:
        """Speed of the vehicle at a pose, relative to a velocity (2,) [m/s]."""
        moved = step.trajectory.poses[pose, :2] - step.trajectory.poses[pose - 1, :2]
        return float(np.linalg.norm(moved / (self.times[pose] - self.times[pose - 1]) - velocity))

    @property
    def _obstacles(self) -> list[ObstacleLimit]:
        return [limit for limit in self.program.soft if isinstance(limit, ObstacleLimit)]
