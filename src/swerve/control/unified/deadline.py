"""When a step has to come to an end: its time is counted by a clock, or by the work it has done.

A simulation that is to give the same bits on every machine can't look at a clock. It counts what the work takes on an
ordinary processor, as measured by `make bench`, and so caps the iterations; a vehicle looks at its clock.
"""

from collections.abc import Callable

PROGRAM = 0.6e-3  # [s] one convex program: linearised, condensed, set up
ROW = 2e-6  # [s] each of its rows
ITERATION = 4e-6  # [s] each of its solver's iterations
SECOND_SOLVER = 6e-3  # [s] by interior points, where the active-set method failed
ROLL_OUT = 0.2e-3  # [s] one roll-out with its score

Clock = Callable[[], float]


class Deadline:
    """The deadline of one step, from now on."""

    def __init__(self, allowed: float, clock: Clock | None) -> None:
        """A step may take `allowed` [s], by a clock, or without one by its work."""
        self._allowed, self._clock = allowed, clock
        self._begun = 0.0 if clock is None else clock()
        self._work = 0.0

    def count(self, work: float) -> None:
        """Some work was done, which takes this long [s]."""
        self._work += work

    @property
    def is_over(self) -> bool:
        """Whether the time has passed."""
        return self._left < 0

    def again(self, allowed: float) -> "Deadline":
        """A deadline from now on for what comes next: `allowed` [s], and what this one has left or lacks."""
        return Deadline(allowed + self._left, self._clock)

    @property
    def _left(self) -> float:
        return self._allowed - (self._work if self._clock is None else self._clock() - self._begun)
