"""What the vehicle can command, and what of it has failed."""

from typing import Annotated, Final, Literal, Self

from pydantic import model_validator

from swerve.conventions import WHEELS
from swerve.scenario.quantities import SteeringAngle, choice
from swerve.scenario.settings import KeyedError, Settings

Mode = Literal["all", "steer-only", "brakes-only", "steer+friction-brakes", "no-drive"]
MODES: Final[tuple[Mode, ...]] = ("all", "steer-only", "brakes-only", "steer+friction-brakes", "no-drive")
Wheel = Annotated[Literal["fl", "fr", "rl", "rr"], choice("wheel", WHEELS)]


class ActuationSettings(Settings):
    """The inputs that there are. A failure lasts the whole run; the plant has it whether the controller knows or not.

    Attributes:
        mode: "all"; "steer-only"; "brakes-only", each wheel's, wheels straight; "steer+friction-brakes", one brake
            demand for all wheels; "no-drive", each wheel's brake and the steering.
        failed_wheels: wheels without torque.
        steering_stuck: angle at which the steering stays; None moves [rad].
        known: whether the controller is told of the failures; a mode it is always told.
    """

    mode: Annotated[Mode, choice("mode", MODES)] = "all"
    failed_wheels: tuple[Wheel, ...] = ()
    steering_stuck: SteeringAngle | None = None
    known: bool = True

    @model_validator(mode="after")
    def _something_is_left(self) -> Self:
        steers = self.mode != "brakes-only" and self.steering_stuck is None
        has_forces = self.mode != "steer-only" and len(set(self.failed_wheels)) < len(WHEELS)
        if not (steers or has_forces):
            raise KeyedError("mode", f"{self.mode} with these failures leaves nothing to command; leave out a failure")
        return self

    @model_validator(mode="after")
    def _failures_make_sense(self) -> Self:
        for wheel in self.failed_wheels:
            if self.failed_wheels.count(wheel) > 1:
                raise KeyedError("failed_wheels", f"names {wheel} twice; write it once")
        if not self.known and not self.has_failures:
            raise KeyedError("known", "means nothing without a failure; write failed_wheels or steering_stuck too")
        return self

    @property
    def has_failures(self) -> bool:
        """Whether anything has failed."""
        return bool(self.failed_wheels) or self.steering_stuck is not None

    @property
    def failed(self) -> tuple[int, ...]:
        """Indices of the wheels without torque."""
        return tuple(WHEELS.index(wheel) for wheel in self.failed_wheels)
