"""The interval of contact along a line: against the contact of a run's outcome, point by point."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from swerve.simulate.outcome import touches
from swerve.study.criticality.span import contact_span
from swerve.world import Ellipse, Footprint, Obstacle, Point, Rectangle, Steady

lengths = st.floats(0.3, 5.0)
shapes = st.builds(lambda a, b: Ellipse((a, b)), lengths, lengths) | st.builds(Rectangle, lengths, lengths)
footprints = st.just(Point()) | st.builds(Rectangle, lengths, lengths, st.tuples(st.floats(-1, 1), st.floats(-1, 1)))
angles = st.floats(-3.2, 3.2)
NEAR = 1e-3  # [m] from the ends of an interval, where an ellipse's polygon may decide otherwise


@given(footprints, shapes, st.floats(-8, 8), st.floats(-8, 8), angles, angles)
def test_inside_it_they_touch_and_outside_they_do_not(
    footprint: Footprint, shape: Ellipse | Rectangle, x: float, y: float, turn: float, direction: float
) -> None:
    """Contact at each of many places on the line is what the outcome of a run calls contact."""
    along = np.array([np.cos(direction), np.sin(direction)])
    first, last = contact_span(footprint, shape, np.array([x, y]), np.array(turn), along)
    places = np.linspace(-20, 20, 401)
    poses = np.column_stack((x + places * along[0], y + places * along[1], np.full(len(places), turn)))
    touching = touches(Obstacle(shape, Steady((0.0, 0.0))), footprint, poses, np.zeros(len(places)))
    clear = np.minimum(np.abs(places - first), np.abs(places - last)) > NEAR
    assert (touching == ((first <= places) & (places <= last)))[clear].all()


@given(footprints, shapes, st.floats(-8, 8), st.floats(-8, 8), angles)
def test_without_motion_it_is_everywhere_or_nowhere(
    footprint: Footprint, shape: Ellipse | Rectangle, x: float, y: float, turn: float
) -> None:
    """A line that leads nowhere touches for every lambda or for none."""
    first, last = contact_span(footprint, shape, np.array([x, y]), np.array(turn), np.zeros(2))
    assert abs(first) == np.inf
    assert last == -first
