"""Every controller in every scenario, on one plant, from one seed: each run is independent of all others."""

from collections.abc import Sequence
from concurrent.futures import Executor, as_completed
from dataclasses import dataclass
from functools import partial
from typing import Any

from swerve import __version__
from swerve.errors import InputError, one_line
from swerve.scenario import Scenario
from swerve.simulate.assemble import plant_named
from swerve.study.comparison.entry import Entry, Progress

Cell = tuple[Scenario, str, str, int]  # what an entry is of


@dataclass(frozen=True, eq=False)
class Group:
    """One scenario: an entry for each controller, in their order."""

    scenario: Scenario
    entries: tuple[Entry, ...]

    @property
    def runs(self) -> list[Entry]:
        """The entries without the refusals."""
        return [each for each in self.entries if each.run is not None]

    def is_best(self, entry: Entry) -> bool:
        """Whether no other entry ended better: avoided, spun, left the road, hit at a lower speed, hit, diverged."""
        return entry.rank is not None and entry.rank == min(each.rank for each in self.runs if each.rank is not None)


@dataclass(frozen=True, eq=False)
class Comparison:
    """Scenarios by controllers.

    Attributes:
        controllers: by name.
        plant: by name.
        seed: of all runs.
        groups: one for each scenario.
    """

    controllers: tuple[str, ...]
    plant: str
    seed: int
    groups: tuple[Group, ...]

    def to_json(self) -> dict[str, Any]:
        """What was compared, and a row for each scenario and controller, in SI; plain values."""
        rows = [{**each.to_json(), "best": group.is_best(each)} for group in self.groups for each in group.entries]
        return {
            "version": __version__,
            "plant": self.plant,
            "seed": self.seed,
            "controllers": list(self.controllers),
            "scenarios": [group.scenario.name for group in self.groups],
            "runs": rows,
        }


def check(scenarios: Sequence[Scenario], plant: str) -> None:
    """See to it that scenarios can be compared.

    Raises:
        InputError: two have the same name, by which rows and files are told apart, or the plant cannot drive one.
    """
    names = [each.name for each in scenarios]
    for name in names:
        if names.count(name) > 1:
            fault = f"{names.count(name)} of the scenarios have this name"
            raise InputError(f"{one_line(name)}: {fault}; write each once, and give files names of their own")
    for each in scenarios:
        try:
            plant_named(plant, each)
        except InputError as error:
            raise InputError(f"{one_line(each.name)}: {error}") from error


def compare(
    scenarios: Sequence[Scenario],
    controllers: Sequence[str],
    plant: str,
    seed: int,
    progress: Progress,
    executor: Executor | None = None,
) -> Comparison:
    """Run them all.

    Args:
        scenarios: that `check` has passed.
        controllers: by name.
        plant: by name.
        seed: of each run.
        progress: called with the share that is done [1].
        executor: makes runs beside one another; without one they are made here.
    """
    cells = [(scenario, controller, plant, seed) for scenario in scenarios for controller in controllers]
    entries = iter(_here(cells, progress) if executor is None else _beside(cells, progress, executor))
    groups = [Group(scenario, tuple(next(entries) for _ in controllers)) for scenario in scenarios]
    return Comparison(tuple(controllers), plant, seed, tuple(groups))


def _here(cells: Sequence[Cell], progress: Progress) -> list[Entry]:
    return [Entry.of(*cell, partial(_tell, progress, i, len(cells))) for i, cell in enumerate(cells)]


def _tell(progress: Progress, n_done: int, n_cells: int, share: float) -> None:
    """Tell the share of one run as one of all."""
    progress((n_done + share) / n_cells)


def _beside(cells: Sequence[Cell], progress: Progress, executor: Executor) -> list[Entry]:
    futures = [executor.submit(Entry.of, *cell) for cell in cells]
    for n_done, _ in enumerate(as_completed(futures), start=1):
        progress(n_done / len(cells))
    return [future.result() for future in futures]
