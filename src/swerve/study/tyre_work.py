"""The tyre work of sec. 3 of the paper, done again: Table 1, Fig. 3 and Fig. 4, each with its error."""

from dataclasses import dataclass

from swerve.vehicle.fitting.figures import Figure4, FrictionEllipse, figure_3, figure_4
from swerve.vehicle.fitting.table_1_refit import Table1Refit, refit_table_1


@dataclass(frozen=True, eq=False)
class TyreWork:
    """Section 3 of the paper.

    Attributes:
        table_1: its parameters made into curves and fitted again, and the lines.
        figure_3: friction ellipses, one for each slip angle.
        figure_4: the printed lines against Table 1, as values and as forces.
    """

    table_1: Table1Refit
    figure_3: tuple[FrictionEllipse, ...]
    figure_4: Figure4


def tyre_work() -> TyreWork:
    """Do it; it takes a fraction of a second."""
    return TyreWork(refit_table_1(), figure_3(), figure_4())
