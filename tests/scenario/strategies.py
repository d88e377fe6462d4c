"""Hypothesis strategies for scenarios."""

from typing import Any

import numpy as np
from hypothesis import strategies as st

from swerve.scenario import CORRECTIONS


def numbers(low: float, high: float) -> st.SearchStrategy[float]:
    """Floats from `low` to `high`."""
    return st.floats(low, high, allow_subnormal=False)


def pairs(low: float, high: float) -> st.SearchStrategy[list[float]]:
    """Lists of two floats from `low` to `high`."""
    return st.lists(numbers(low, high), min_size=2, max_size=2)


TEXTS = st.text(st.characters(exclude_categories=("C", "Z")), max_size=40)

ROADS = st.fixed_dictionaries({"friction": numbers(1e-3, 2.0)}) | st.fixed_dictionaries(
    {"friction": numbers(1e-3, 2.0), "lane_width": numbers(1.0, 10.0)},
    optional={"lanes_left": st.integers(1, 10), "lanes_right": st.integers(0, 10), "lanes_oncoming": st.integers(0, 1)},
)

EGOS = st.fixed_dictionaries(
    {
        "position": pairs(-50.0, 50.0),
        "speed": numbers(0.0, 150.0),
        "footprint": st.sampled_from(["point", "rectangle"]),
    },
    optional={
        "heading": numbers(-6.0, 6.0),
        "parameters": st.fixed_dictionaries({}, optional={"mass": numbers(1.0, 1e5), "cg_height": numbers(0.0, 2.0)}),
    },
)


POSITIONS = st.tuples(numbers(300.0, 1e4), numbers(-1e4, 1e4)).map(list)  # far from any start that `EGOS` gives
CHANGES: list[st.SearchStrategy[dict[str, Any]]] = [
    st.fixed_dictionaries({}, optional={"velocity": pairs(-150.0, 150.0)}),
    st.fixed_dictionaries(
        {"velocity": pairs(-150.0, 150.0), "acceleration": pairs(-100.0, 100.0)},
        optional={"accelerates_at": numbers(0.0, 300.0)},
    ),
    st.fixed_dictionaries({"acceleration": pairs(0.1, 100.0), "final_speed": numbers(0.1, 150.0)}),
    st.fixed_dictionaries({"velocity": pairs(1.0, 150.0), "moves_at": numbers(0.0, 300.0)}),
]


@st.composite
def _waypoints(draw: st.DrawFn) -> dict[str, Any]:
    """Two or three way-points ahead of the start, and time."""
    times = np.cumsum(draw(st.lists(numbers(0.01, 90.0), min_size=2, max_size=3))).tolist()
    places = [[draw(numbers(300.0, 400.0)) + 400.0 * k, draw(numbers(-1e4, 1e4))] for k in range(len(times))]
    return {"waypoints": [{"time": time, "position": place} for time, place in zip(times, places, strict=True)]}


@st.composite
def _obstacles(draw: st.DrawFn, shape: str) -> dict[str, Any]:
    """Obstacles of one shape that are far from any start that `EGOS` gives, with any motion."""
    optional = {"heading": numbers(-6.0, 6.0), "name": TEXTS.filter(bool)}
    looks = draw(st.fixed_dictionaries({shape: pairs(0.01, 100.0)}, optional=optional))
    from_start = st.builds(lambda position, change: {"position": position, **change}, POSITIONS, st.one_of(CHANGES))
    return looks | draw(from_start | _waypoints().filter(_starts_ahead))


def _starts_ahead(keys: dict[str, Any]) -> bool:
    first, second = keys["waypoints"][:2]
    speed = (second["position"][0] - first["position"][0]) / (second["time"] - first["time"])
    return bool(first["time"] * 3 * speed < 50.0)  # before its first way-point it is no further back


def _controllers(substeps: int, step: float, horizons: list[int]) -> dict[str, Any]:
    clocks = {"sample_time": substeps * step, "prediction_horizon": max(horizons), "control_horizon": min(horizons)}
    return {"controller": clocks, "plant": {"step": step}}


CLOCKS = st.builds(
    _controllers,
    st.integers(2, 50),
    numbers(1e-3, 0.02),
    st.lists(st.integers(1, 200), min_size=2, max_size=2),
)


@st.composite
def tables(draw: st.DrawFn) -> dict[str, Any]:
    """The tables of a right scenario file, in SI."""
    result: dict[str, Any] = {
        "name": draw(TEXTS.filter(bool)),
        "description": draw(TEXTS),
        "duration": draw(numbers(1e-3, 300.0)),
        "road": draw(ROADS),
        "ego": draw(EGOS),
        "obstacles": draw(st.lists(_obstacles("semi_axes") | _obstacles("size"), max_size=3)),
        "goal": {"speed": draw(numbers(0.0, 150.0)), "lateral_offset": draw(numbers(-100.0, 100.0))},
        **draw(CLOCKS),
    }
    result["controller"]["weights"] = {"speed": draw(numbers(0.0, 1e6)), "force_rate": draw(numbers(0.0, 1.0))}
    result["controller"]["as_printed"] = {"corrections": draw(st.lists(st.sampled_from(CORRECTIONS), unique=True))}
    return result
