"""Runs of the controller `unified`, whose plans have several ways while an obstacle is in the path."""

from dataclasses import replace
from functools import cache

import numpy as np

from swerve.simulate import Log, Run, Table
from tests.report.runs import made


@cache
def with_ways(*overrides: str, duration: str = "3 s") -> Run:
    """A run of the paper's scene, three ways a step until the obstacle is passed."""
    return made(f"duration={duration}", *overrides, controller="unified")


def busy(run: Run) -> Run:
    """The run as if each of its steps had tried four ways: those of its first step, and one of them once more."""
    first, steps = run.plans[0], run.log.steps
    branches = (*first.branches, first.branches[0])
    told = str(steps["branches"][0])
    listed = f"{told[:-1]}, {told[1 : told.index('}') + 1]}]"
    columns = {**steps.columns, "branches": np.full(len(run.plans), listed)}
    plans = tuple(replace(plan, branches=branches) for plan in run.plans)
    return replace(run, plans=plans, log=Log(run.log.motion, Table(columns, steps.units)))
