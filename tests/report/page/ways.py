"""Runs whose plans have several ways with paths, as a controller for several obstacles gives them."""

from dataclasses import replace
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np

from swerve.simulate import Run
from tests.report.runs import made

SAMPLES = 40  # of a way's path
SPACING = 1.0  # between two points of it [m]


@cache
def with_ways(*overrides: str, duration: str = "3 s") -> Run:
    """A run of the controller `unified`, each of whose plans has the ways keep, brake, left and right."""
    done = made(f"duration={duration}", *overrides, controller="unified")
    return replace(done, plans=tuple(_plan(plan) for plan in done.plans))


def _plan(plan: Any) -> Any:
    name = "keep" if plan.side is None else plan.side.name.lower()
    start = plan.states[0, [4, 5, 3]]
    bends = {"keep": 0.0, "brake": 0.0, "left": 0.003, "right": -0.003}
    branches = tuple(
        SimpleNamespace(
            name=way,
            passing=(),
            cost=100.0 * (1 + i),
            violation=0.0 if way == name else 0.4,
            off_road=0.0,
            impact_speed=12.0 if way == "keep" else None,
            poses=_bent(start, bend, 0.5 if way == "brake" else 1.0),
        )
        for i, (way, bend) in enumerate(bends.items())
    )
    return SimpleNamespace(
        time=plan.time,
        inputs=plan.inputs,
        states=plan.states,
        side=plan.side,
        name=name,
        is_shaped=plan.side is not None,
        branches=branches if plan.side is not None else (),
        reason="it keeps clear at the lowest cost",
        active=("obstacle 0",) if plan.side is not None else (),
        friction_use=None,
        fallback=plan.fallback,
        solver_failures=plan.solver_failures,
    )


def _bent(start: np.ndarray, bend: float, share: float) -> np.ndarray:
    """A path (n, 3) that bends off from a pose (3,)."""
    along = np.arange(SAMPLES) * SPACING * share
    return np.column_stack([start[0] + along, start[1] + bend * along**2, start[2] + np.arctan(2 * bend * along)])
