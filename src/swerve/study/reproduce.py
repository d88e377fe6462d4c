"""What the paper shows, made again: its tyre, its scenario for Fig. 7 to 10, and the ablation of its controller."""

from dataclasses import dataclass

from swerve.scenario import load
from swerve.simulate import Run, run
from swerve.study.ablation import SCENES, Ablation, Progress, ablate
from swerve.study.tyre_comparison import TyreComparison, compare_tyres
from swerve.study.tyre_work import TyreWork, tyre_work
from swerve.study.variants import VARIANTS


@dataclass(frozen=True, eq=False)
class Reproduction:
    """The paper's sections 3 and 5, measured.

    Attributes:
        tyre: Table 1, Fig. 3 and Fig. 4.
        forces: Fig. 5, eq. (4) against the tyres of the multibody plant.
        paper: the run of its scenario with the unified controller on the multibody plant, as sec. 5 has it.
        ablation: from the printed controller to the unified one.
    """

    tyre: TyreWork
    forces: TyreComparison
    paper: Run
    ablation: Ablation


def reproduce(progress: Progress) -> Reproduction:
    """Run it all; `progress` is called with the share that is done [1]."""
    n_runs = 1 + len(VARIANTS) * len(SCENES)
    paper = run(load("paper"), progress=lambda share: progress(share / n_runs))
    ablation = ablate(lambda share: progress((1 + share * (n_runs - 1)) / n_runs))
    return Reproduction(tyre_work(), compare_tyres(), paper, ablation)
