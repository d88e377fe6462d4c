"""Runs of a finished map made again, to be watched: in each cell all controllers, where the first one just avoids."""

from collections.abc import Callable, Sequence
from concurrent.futures import Executor

from swerve.scenario import Scenario
from swerve.simulate import Run, run
from swerve.study.map.boundary import Condition, Map
from swerve.study.map.cell import Cell

Progress = Callable[[float], None]  # takes the share that is done, from 0 to 1


def replayed(
    cells: Sequence[Cell], made: Map, executor: Executor | None, progress: Progress
) -> dict[Condition, list[Run]]:
    """The runs of each condition in which the first controller has a last avoided distance.

    Args:
        cells: of the map.
        made: the map.
        executor: makes runs beside one another; without one they are made here.
        progress: called with the share that is done [1].
    """
    first = made.controllers[0]
    ends = [(cell, made.boundary(first, cell.condition)) for cell in cells]
    scenes = {cell.condition: cell.at(end.avoided) for cell, end in ends if end is not None and end.avoided is not None}
    tasks = [(scene, who, made.plant, made.seed) for scene in scenes.values() for who in made.controllers]
    found = []
    for each in executor.map(_run, tasks) if executor else map(_run, tasks):
        found.append(each)
        progress(len(found) / len(tasks))
    n = len(made.controllers)
    return {condition: found[n * i : n * (i + 1)] for i, condition in enumerate(scenes)}


def _run(task: tuple[Scenario, str, str, int]) -> Run:
    return run(*task)
