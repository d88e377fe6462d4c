"""Runs to report about, each made once."""

from functools import cache

from swerve.scenario import load
from swerve.simulate import Run, run

MOVING = (
    '[{position=[20, 0.2], size=[4.5, 1.8], heading="6 deg"}, {position=[45, 3.5], velocity=[-5, 0], size=[4.5, 1.8]}]'
)
FAILING = 'controller.as_printed.corrections=["drift"]'  # programs without a solution, answered by the fallback
MOST_SHOWN = ("ego.footprint=rectangle", "road.lane_width=3.5", "road.lanes_right=1", f"obstacles={MOVING}")

ONCOMING = (
    "road.lane_width=3.5",
    "road.lanes_oncoming=1",
    'obstacles=[{size=[4, 1.7], name="van $1_雪", waypoints=[{time=0, position=[30, 0]}, {time=1, position=[20, 1]},'
    " {time=2, position=[18, 8]}]}, {semi_axes=[2, 1], position=[60, 0], velocity=[15, 0], acceleration=[-30, 0]},"
    " {semi_axes=[0.4, 0.4], position=[30, -5], velocity=[0, 1.5], moves_at=0.5}]",
)


@cache
def made(*overrides: str, scenario: str = "paper", controller: str = "as-printed", seed: int = 0) -> Run:
    """A run of one second, unless the overrides say otherwise."""
    return run(load(scenario, ["duration=1 s", *overrides]), controller, "planar", seed=seed)
