"""Hypothesis strategies and brute-force helpers for the geometry tests."""

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

from swerve.world import Ellipse, Obstacle, Point, Rectangle, Shape, Steady

lengths = st.floats(0.1, 8.0)
coordinates = st.floats(-30.0, 30.0)
angles = st.floats(-np.pi, np.pi)
offsets = st.floats(-2.0, 2.0)

ellipses = st.builds(Ellipse, st.tuples(lengths, lengths))
rectangles = st.builds(Rectangle, lengths, lengths, st.tuples(offsets, offsets))
shapes = st.one_of(st.just(Point()), rectangles, ellipses)
poses = st.tuples(coordinates, coordinates, angles)
velocities = st.tuples(st.floats(-20.0, 20.0), st.floats(-20.0, 20.0))


def obstacles(of: st.SearchStrategy[Shape]) -> st.SearchStrategy[Obstacle]:
    """Obstacles of the given shapes, anywhere, with any heading and velocity."""
    return st.builds(Obstacle, of, st.builds(Steady, st.tuples(coordinates, coordinates), velocities, angles))


def at_start(obstacle: Obstacle) -> tuple[float, float, float]:
    """X [m], Y [m] and heading [rad] of an obstacle at time zero."""
    x, y = obstacle.position_at(0.0)
    return float(x), float(y), float(obstacle.heading_at(0.0))


def boundary(vertices: NDArray[np.float64], per_edge: int) -> NDArray[np.float64]:
    """Evenly spaced points on every edge of the closed polygon (k, 2): (k * per_edge, 2)."""
    share = np.linspace(0.0, 1.0, per_edge, endpoint=False)[:, np.newaxis]
    edges = zip(vertices, np.roll(vertices, -1, axis=0), strict=True)
    return np.concatenate([start + share * (end - start) for start, end in edges])


def placed(
    points: NDArray[np.float64], position: tuple[float, float] | NDArray[np.float64], heading: float
) -> NDArray[np.float64]:
    """Body-frame points (n, 2) in world axes."""
    turn = np.array([[np.cos(heading), -np.sin(heading)], [np.sin(heading), np.cos(heading)]])
    world: NDArray[np.float64] = points @ turn.T + np.asarray(position)
    return world
