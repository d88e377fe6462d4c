"""The ablation: from the printed controller to the working one, step by step, each step run in the same scenes.

Sec. 4 of the paper as printed; with one correction after another, each kept; then the unified controller, first with
little more than its way of stating the problem.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Final

from swerve.scenario import load
from swerve.simulate import Result, run
from swerve.study.variants import VARIANTS, Variant

Progress = Callable[[float], None]  # takes the share that is done, from 0 to 1


@dataclass(frozen=True)
class Scene:
    """One column: a scenario of the library, and what it shows."""

    name: str
    description: str


@dataclass(frozen=True)
class Row:
    """What became of one variant: a result for each scene, in their order."""

    variant: Variant
    results: tuple[Result, ...]


@dataclass(frozen=True)
class Ablation:
    """The table: each row has a result for each scene."""

    scenes: tuple[Scene, ...]
    rows: tuple[Row, ...]


PLANT: Final = "planar"  # the controllers' own model, so that a row tells of the controller alone

SCENES: Final = (
    Scene("paper", "the paper's own: 72 km/h, the obstacle 25 m ahead in the vehicle's line, too near to brake for"),
    Scene("offset-right", "the same with the obstacle 0.3 m to the right, so that its gradient tells left from right"),
    Scene("static-40", "the obstacle 40 m ahead in the vehicle's line, far enough to brake for"),
)


def ablate(progress: Progress, variants: Sequence[Variant] = VARIANTS, scenes: Sequence[Scene] = SCENES) -> Ablation:
    """Run every variant in every scene, on the planar plant.

    Args:
        progress: called with the share that is done [1].
        variants: the rows.
        scenes: the columns.
    """
    n_runs = len(variants) * len(scenes)
    results: list[Result] = []
    for variant in variants:
        for scene in scenes:
            scenario = load(scene.name, variant.overrides)
            tell = partial(_tell, progress, len(results), n_runs)
            results.append(run(scenario, variant.controller, PLANT, progress=tell).result)
    by_variant = [tuple(results[i : i + len(scenes)]) for i in range(0, n_runs, len(scenes))]
    return Ablation(tuple(scenes), tuple(map(Row, variants, by_variant)))


def _tell(progress: Progress, n_done: int, n_runs: int, share: float) -> None:
    """Tell the share of one run as one of all."""
    progress((n_done + share) / n_runs)
