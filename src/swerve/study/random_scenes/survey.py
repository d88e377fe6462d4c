"""The survey: random scenes that can be avoided with something to spare, and quiet ones, each run once.

Scenes are drawn in the order of their index until enough of them are threats with a certificate (`search.py`); those
that are left out are counted. Everything follows from the seed.
"""

from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from dataclasses import dataclass
from itertools import count, islice
from typing import Final, TypeVar

from swerve.study.random_scenes.drawing import quiet_scene, scene
from swerve.study.random_scenes.search import certificate
from swerve.study.random_scenes.threats import is_quiet, is_threat
from swerve.study.random_scenes.trial import Trial, try_scene

N_SCENES: Final = 1000
N_QUIET: Final = 200
AT_ONCE: Final = 20  # scenes that are drawn before the next progress is told

Progress = Callable[[float], None]  # takes the share that is done, from 0 to 1
Found = TypeVar("Found")


@dataclass(frozen=True)
class Survey:
    """What became of the scenes on one plant.

    Attributes:
        plant: by name.
        seed: of the scenes.
        drawn: scenes that were drawn.
        harmless: of those, in which nothing is hit by driving on.
        uncertain: of those, for which the search found no way through.
        trials: of the rest.
        quiet: of the scenes that ask for nothing.
    """

    plant: str
    seed: int
    drawn: int
    harmless: int
    uncertain: int
    trials: tuple[Trial, ...]
    quiet: tuple[Trial, ...]

    @property
    def failed(self) -> tuple[Trial, ...]:
        """Those not avoided."""
        return tuple(trial for trial in self.trials if not trial.is_avoided)

    @property
    def share_avoided(self) -> float:
        """Of the scenes that can be avoided [1]."""
        return 1 - len(self.failed) / len(self.trials)

    @property
    def interventions(self) -> tuple[Trial, ...]:
        """Quiet scenes in which something was done."""
        return tuple(trial for trial in self.quiet if trial.intervenes)


@dataclass(frozen=True)
class _Task:
    """A scene to draw and, if it qualifies, to run."""

    plant: str
    seed: int
    index: int


def survey(
    plant: str,
    seed: int,
    progress: Progress,
    executor: Executor | None = None,
    n_scenes: int = N_SCENES,
    n_quiet: int = N_QUIET,
) -> Survey:
    """Draw scenes until there are enough, and run them.

    Args:
        plant: by name.
        seed: of the scenes.
        progress: called with the share that is done [1].
        executor: runs scenes beside one another; without one they run here.
        n_scenes: that can be avoided.
        n_quiet: that ask for nothing.
    """
    trials: list[Trial] = []
    quiet: list[Trial] = []
    drawn = harmless = uncertain = 0
    for found in _results(_drawn_trial, plant, seed, executor):
        drawn += 1
        harmless += found == "harmless"
        uncertain += found == "uncertain"
        if isinstance(found, Trial):
            trials.append(found)
            progress(len(trials) / (n_scenes + n_quiet))
        if len(trials) == n_scenes:
            break
    for trial in islice((each for each in _results(_quiet_trial, plant, seed, executor) if each), n_quiet):
        quiet.append(trial)
        progress((n_scenes + len(quiet)) / (n_scenes + n_quiet))
    return Survey(plant, seed, drawn, harmless, uncertain, tuple(trials), tuple(quiet))


def _results(work: Callable[[_Task], Found], plant: str, seed: int, executor: Executor | None) -> Iterator[Found]:
    """Of one index after the other."""
    for first in count(0, AT_ONCE):
        tasks = [_Task(plant, seed, index) for index in range(first, first + AT_ONCE)]
        yield from executor.map(work, tasks) if executor else map(work, tasks)


def _drawn_trial(task: _Task) -> Trial | str:
    """The scene run, or why it is left out."""
    drawn = scene(task.seed, task.index)
    if not is_threat(drawn):
        return "harmless"
    way_through = certificate(drawn)
    return try_scene(drawn, task.plant, way_through) if way_through else "uncertain"


def _quiet_trial(task: _Task) -> Trial | None:
    drawn = quiet_scene(task.seed, task.index)
    return try_scene(drawn, task.plant, None) if is_quiet(drawn) else None
