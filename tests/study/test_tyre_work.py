"""The tyre work of sec. 3: what it must come to."""

from swerve.study.tyre_work import tyre_work
from swerve.vehicle.fitting import TABLE_1


def test_each_part_is_there_and_near_the_paper() -> None:
    """Table 1 comes back, the ellipses are ellipses, and the lines miss the force by less than half a percent."""
    work = tyre_work()
    assert [load.full.load for load in work.table_1.fit.loads] == [column.Fz for column in TABLE_1]
    assert max(work.table_1.largest_error.values()) < 1e-9
    assert len(work.figure_3) >= 3
    assert max(ellipse.error for ellipse in work.figure_3) < 2e-6
    assert [force.load for force in work.figure_4.forces] == [column.Fz for column in TABLE_1]
    assert max(force.relative_error for force in work.figure_4.forces) < 0.005
