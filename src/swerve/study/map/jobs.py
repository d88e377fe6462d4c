"""What is left to do in a cell, given what is stored: the search of each controller, and the limits.

A job is asked for its next task; while it has one under way it is not asked again. What it asks for depends on the
records alone, so that it comes to the same end whoever runs its tasks, and however often it is begun anew.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import Final, Protocol

from swerve.study.map.boundary import RunRecord
from swerve.study.map.cell import Cell
from swerve.study.map.search import Lattice, search
from swerve.study.map.settings import MapSettings
from swerve.study.map.task import Limits, Task, Trial

REFINING: Final = 8  # runs that a search takes after its way in, about

Records = Mapping[str, RunRecord]  # by the tasks' keys


class Job(Protocol):
    """A part of the map that goes on by itself."""

    def task(self, stored: Records) -> Task | None:
        """The next task of which a record is missing; None when there is none left."""

    @property
    def share(self) -> float:
        """That is done of it, about [1]."""


class SearchJob:
    """The search of one controller in one cell."""

    def __init__(self, cell: Cell, controller: str, settings: MapSettings) -> None:
        lattice = Lattice.of(cell, settings.tolerance)
        self._cell, self._controller, self._settings = cell, controller, settings
        self._search = search(lattice)
        self._distance: float | None = next(self._search)
        self._n_done, self._n_expected = 0, len(lattice.inwards) + REFINING

    def task(self, stored: Records) -> Task | None:
        """The run of the next distance."""
        while self._distance is not None:
            trial = Trial(self._cell, self._distance, self._controller, self._settings.plant, self._settings.seed)
            if trial.key not in stored:
                return trial
            self._take(stored[trial.key])
        return None

    @property
    def share(self) -> float:
        """As `Job`."""
        return 1.0 if self._distance is None else min(self._n_done / self._n_expected, 0.95)

    def _take(self, record: RunRecord) -> None:
        self._n_done += 1
        try:
            self._distance = self._search.send(record)
        except StopIteration:
            self._distance = None


class LimitsJob:
    """All limits of one cell, at once."""

    def __init__(self, cell: Cell, settings: MapSettings) -> None:
        self._limits = Limits(cell, settings.limits)
        self._is_done = False

    def task(self, stored: Records) -> Task | None:
        """All of them, unless all are there."""
        self._is_done = all(key in stored for key in self._limits.keys.values())
        return None if self._is_done else self._limits

    @property
    def share(self) -> float:
        """As `Job`."""
        return float(self._is_done)


def jobs(cells: Sequence[Cell], settings: MapSettings) -> Iterator[Job]:
    """Those of all cells; the limits first, because each takes longest."""
    if settings.limits:
        yield from (LimitsJob(cell, settings) for cell in cells)
    for controller in settings.controllers:
        yield from (SearchJob(cell, controller, settings) for cell in cells)
