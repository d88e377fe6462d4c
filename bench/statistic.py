"""Median, 99th percentile and maximum of times, and what is typical of several runs.

Times are those of the processor, in which the other programs on a shared machine have no part; on an idle one they are
the same as by the clock, as all runs in one thread.
"""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass(frozen=True)
class Statistic:
    """Of times, all in [s]."""

    median: float
    p99: float
    max: float

    @classmethod
    def of(cls, times: Sequence[float]) -> "Statistic":
        """Of the times of one run, at least one of them."""
        return cls(float(np.median(times)), float(np.percentile(times, 99)), float(np.max(times)))

    @classmethod
    def typical(cls, runs: Sequence["Statistic"]) -> "Statistic":
        """The median of each number over runs, so that one disturbed run does not count."""
        return cls(*np.median([(run.median, run.p99, run.max) for run in runs], axis=0).tolist())


def durations(n: int, call: Callable[..., Any], *arguments: Any) -> list[float]:
    """How long each of n calls keeps the processor [s]."""
    times = []
    for _ in range(n):
        began = time.process_time()
        call(*arguments)
        times.append(time.process_time() - began)
    return times
