"""Make a map: ask every job for its next task, have it run, keep the records, ask again."""

from collections.abc import Callable, Sequence
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING, Any, Final

from swerve.study.map.boundary import Boundary, Map, RunRecord
from swerve.study.map.cell import Cell
from swerve.study.map.engine import EngineLostError, is_deserted, result_of
from swerve.study.map.jobs import Job, jobs
from swerve.study.map.search import boundary_of
from swerve.study.map.settings import MapSettings
from swerve.study.map.store import Store, kept
from swerve.study.map.task import perform

if TYPE_CHECKING:
    from distributed import Client, Future

LOOKED_AFTER: Final = 1.0  # [s] between two looks at the workers
MOURNED: Final = 20  # looks in a row without one, before the map ends

Progress = Callable[[float], None]  # takes the share that is done, from 0 to 1


def cells_of(settings: MapSettings) -> list[Cell]:
    """All cells; InputError where the scenario has no distance, as `study.limit` says."""
    return [Cell.of(settings.scenario, condition) for condition in settings.conditions]


def is_complete(cells: Sequence[Cell], settings: MapSettings, store: Store) -> bool:
    """Whether nothing is left to run."""
    return all(job.task(store.records) is None for job in jobs(cells, settings))


def run_missing(
    cells: Sequence[Cell], settings: MapSettings, store: Store, client: "Client", progress: Progress
) -> None:
    """Run all that is not in the store yet, and keep it there.

    Raises:
        EngineLostError: no worker is left.
        InputError: a run is refused, say by its controller; or a record cannot be written.
    """
    todo = list(jobs(cells, settings))
    flights = _Flights(client)
    for job in todo:
        flights.start(job, store)
    while flights.under_way:
        landed = flights.land()
        store.add({key: record for records, _ in landed for key, record in records.items()})
        for _, job in landed:
            flights.start(job, store)
        progress(sum(job.share for job in todo) / len(todo))


def map_of(cells: Sequence[Cell], settings: MapSettings, records: Sequence[RunRecord]) -> Map:
    """The map in all of its records."""
    runs = [(who, cell, kept(records, who, cell.condition)) for who in settings.controllers for cell in cells]
    limits = [kept(records, who, cell.condition)[0] for who in settings.limits for cell in cells]
    return Map(
        scenario=settings.scenario.name,
        plant=settings.plant,
        seed=settings.seed,
        tolerance=settings.tolerance,
        half_width=cells[0].scene.room,
        extent=cells[0].extent,
        controllers=settings.controllers,
        limits=settings.limits,
        conditions=tuple(cell.condition for cell in cells),
        boundaries=(*(boundary_of(who, cell.condition, each) for who, cell, each in runs), *map(_limit, limits)),
        runs=tuple(run for _, _, each in runs for run in each),
    )


def _limit(record: RunRecord) -> Boundary:
    """A limit has no run below it."""
    avoided = record.distance if record.is_avoided else None
    return Boundary(record.who, record.condition, avoided, None, None, None, 1, None)


class _Flights:
    """The tasks that are under way, and whose they are."""

    def __init__(self, client: "Client") -> None:
        self._client = client
        self._ended: SimpleQueue[Future[Any]] = SimpleQueue()
        self.under_way: dict[Any, tuple[Future[Any], Job]] = {}  # by the future's key

    def start(self, job: Job, store: Store) -> None:
        """A job's next task, if it has one."""
        task = job.task(store.records)
        if task is None:
            return
        future = self._client.submit(perform, task, key=f"swerve-{task.key}", pure=False)
        self.under_way[future.key] = future, job
        future.add_done_callback(self._ended.put)

    def land(self) -> list[tuple[dict[str, RunRecord], Job]]:
        """The records of all that have ended, at least of one, and whose they are."""
        ended = [self._wait()]
        while not self._ended.empty():
            ended.append(self._ended.get())
        return [(result_of(future), self.under_way.pop(future.key)[1]) for future in ended]

    def _wait(self) -> "Future[Any]":
        """The next one that ends."""
        n_deserted = 0
        while n_deserted < MOURNED:
            try:
                return self._ended.get(timeout=LOOKED_AFTER)
            except Empty:
                n_deserted = n_deserted + 1 if is_deserted(self._client) else 0
        raise EngineLostError(f"no worker was left for {MOURNED * LOOKED_AFTER:g} s")
