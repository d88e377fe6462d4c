"""A run that was ordered, and how far it is."""

from dataclasses import dataclass
from typing import Literal

from swerve.studio.worker import Order

State = Literal["waiting", "running", "done", "failed", "cancelled"]


@dataclass(frozen=True)
class Job:
    """A run that was ordered.

    Attributes:
        number: by which it is asked about.
        order: what is wanted.
        state: how far it is.
        share: that is done [1].
        message: why it failed; "" where it has not.
        run: name of its folder once it is done, else None.
    """

    number: int
    order: Order
    state: State = "waiting"
    share: float = 0.0
    message: str = ""
    run: str | None = None

    @property
    def is_over(self) -> bool:
        """Whether nothing more comes of it."""
        return self.state in ("done", "failed", "cancelled")
