"""Figures: what is on them, with which units, within the page."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from matplotlib.patches import StepPatch
from numpy.typing import NDArray

from swerve.report.figures import FIGURES, states, steering, top_view, wheel_forces, writers
from swerve.report.figures.strips import cut
from swerve.simulate import Log, Run, Table
from tests.report.runs import FAILING, MOST_SHOWN, ONCOMING, made

Array = NDArray[np.float64]


def _diverged() -> Run:
    """A run whose last samples are no numbers, after some that are beyond all bounds."""
    done = made()
    motion = {name: values.copy() for name, values in done.log.motion.columns.items()}
    for name in ("vx", "vy", "r", "psi", "X", "Y", "delta"):
        motion[name][-40:-20] *= 1e200
        motion[name][-20:] = np.nan
    return replace(done, log=Log(Table(motion, done.log.motion.units), done.log.steps))


RUNS: dict[str, Callable[[], Run]] = {
    "static obstacle": lambda: made(controller="unified"),
    "lanes, boxes, one moving": lambda: made(*MOST_SHOWN, controller="unified"),
    "an oncoming lane, one turning, one braking": lambda: made(*ONCOMING),
    "programs without a solution": lambda: made(FAILING),
    "no obstacle, one sample": lambda: made("obstacles=[]", "duration=0.05 s"),
    "at rest": lambda: made("ego.speed=0", "goal.speed=0"),
    "sideways": lambda: made("ego.heading=90 deg", "obstacles=[]"),
    "diverged": _diverged,
    "a name beyond the font": lambda: made("name=$x_ü 雪"),
}


LABELS = {
    "top_view": ({"$X$ [m]"}, {"$Y$ [m]"}),
    "states": (
        {"time [s]", "$X$ [m]"},
        {
            "longitudinal velocity $v_x$ [km/h]",
            "lateral velocity $v_y$ [m/s]",
            "yaw rate $r$ [deg/s]",
            "$Y$ [m]",
        },
    ),
    "wheel_forces": ({"time [s]"}, {"longitudinal force $F_x$ [kN]"}),
    "steering": ({"time [s]"}, {r"road-wheel angle $\delta$ [deg]"}),
}


def _label(axes: Axes, name: str, others: Sequence[Axes]) -> str:
    """The label of an axis, which for x may stand at the lowest axes of a column, for y at the first of a row."""
    own: str = axes.get_xlabel() if name == "x" else axes.get_ylabel()
    if own:
        return own
    place = axes.get_position()
    if name == "x":
        below = [each for each in others if np.isclose(each.get_position().x0, place.x0)]
        return min(below, key=lambda each: each.get_position().y0).get_xlabel()
    beside = [each for each in others if np.isclose(each.get_position().y0, place.y0)]
    return min(beside, key=lambda each: each.get_position().x0).get_ylabel()


@pytest.mark.parametrize("name", FIGURES)
@pytest.mark.parametrize("done", RUNS.values(), ids=list(RUNS))
def test_every_figure_is_whole(name: str, done: Callable[[], Run]) -> None:
    """On every figure of every kind of run each axis has a name and a unit, all is on the page, and it is not blank."""
    figure = FIGURES[name](done())
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    labels = [{_label(axes, axis, figure.axes) for axes in figure.axes} for axis in ("x", "y")]
    assert labels == list(LABELS[name])
    page, used = figure.get_size_inches(), figure.get_tightbbox()
    assert used.x0 >= 0 and used.y0 >= 0
    assert used.x1 <= page[0] and used.y1 <= page[1]
    assert np.asarray(canvas.buffer_rgba())[..., :3].std() > 5  # of 255


def _polygons(axes: Axes, n_vertices: int) -> list[Array]:
    """The polygons on an axes that have so many vertices, each (k, 2)."""
    paths = [path for drawn in axes.collections if isinstance(drawn, PolyCollection) for path in drawn.get_paths()]
    return [path.vertices[:-1] for path in paths if len(path.vertices) == n_vertices + 1]


def _line(axes: Axes, label: str) -> Array:
    """The points (n, 2) of the line of this label."""
    return next(line.get_xydata() for line in axes.lines if str(line.get_label()).startswith(label))


def test_the_top_view_is_to_scale() -> None:
    """A metre is as long along X as along Y, and on every strip; the strips join without gap or overlap."""
    figure = top_view(made("duration=5 s", controller="unified"))
    page = figure.get_size_inches()
    assert len(figure.axes) > 1
    scales = []
    for axes in figure.axes:
        size = axes.get_position().size * page
        scales += [size[0] / np.ptp(axes.get_xlim()), size[1] / np.ptp(axes.get_ylim())]
    np.testing.assert_allclose(scales, scales[0])
    ends = [axes.get_xlim() for axes in figure.axes]
    assert [right for _, right in ends[:-1]] == [left for left, _ in ends[1:]]


def test_the_top_view_shows_obstacles_turned_as_they_are() -> None:
    """A box on a curve is drawn at every quarter of a second, its long side along the velocity of that instant."""
    done = made(*ONCOMING)
    van = done.scenario.obstacles[0].to_world()
    boxes = [
        corners for corners in _polygons(top_view(done).axes[0], 4) if np.isclose(np.ptp(corners, 0).max(), 4.0, 0.3)
    ]
    sides = [(corners.mean(axis=0), corners[0] - corners[1]) for corners in boxes]
    for time in np.arange(0.0, 1.1, 0.25):
        middle, velocity = van.position_at(time), van.velocity_at(time)
        along = [side / 4.0 for centre, side in sides if np.allclose(centre, middle, atol=1e-6)]
        assert len(along) == 1
        np.testing.assert_allclose(along[0], velocity / np.hypot(*velocity), atol=1e-6)


def test_the_top_view_parts_the_directions_with_a_double_line() -> None:
    """The line to the oncoming lane is two unbroken ones; without oncoming traffic it is one, broken."""
    for overrides, n_lines in ((ONCOMING, 2), (("road.lane_width=3.5",), 1)):
        lines = [line for line in top_view(made(*overrides)).axes[0].lines if np.ptp(line.get_ydata()) == 0]
        near = [line for line in lines if abs(line.get_ydata()[0] - 1.75) < 0.5]
        assert len(near) == n_lines
        assert all(line.is_dashed() == (n_lines == 1) for line in near)


def test_the_top_view_names_obstacles_that_have_a_name() -> None:
    """A name is written as it is, but for letters that the font may not have; who has none is not named."""
    axes = top_view(made(*ONCOMING)).axes[0]
    named = [text.get_text() for text in axes.texts if not text.get_text().endswith(" s")]
    assert named == ["van $1_?"]


def test_the_top_view_has_a_body_every_quarter_of_a_second() -> None:
    """Bodies have the vehicle's size, its wheels turn with the steering angle, and they stand on the path."""
    done = made(controller="unified")
    vehicle, motion = done.scenario.ego.to_vehicle(), done.log.motion
    axes = top_view(done).axes[0]
    outlines = _polygons(axes, 4)
    spans = [np.hypot(*(corners[0] - corners[1])) for corners in outlines]
    bodies = [corners for corners, span in zip(outlines, spans, strict=True) if np.isclose(span, vehicle.length)]
    tyres = [
        corners for corners, span in zip(outlines, spans, strict=True) if np.isclose(span, 2 * vehicle.wheel_radius)
    ]
    rows = [0, 250, 500, 750, 1000]
    assert (len(bodies), len(tyres)) == (len(rows), 4 * len(rows))
    offset = vehicle.cg_to_front_end - vehicle.length / 2
    expected = (
        motion.stack("X", "Y")[rows] + offset * np.column_stack([np.cos(motion["psi"]), np.sin(motion["psi"])])[rows]
    )
    centres = np.array([corners.mean(axis=0) for corners in bodies])
    np.testing.assert_allclose(centres[centres[:, 0].argsort()], expected, atol=1e-9)
    headings = {round(float(np.arctan2(*(corners[0] - corners[1])[::-1])), 9) for corners in tyres}
    assert headings >= {round(float(motion["psi"][row] + motion["delta"][row]), 9) for row in rows}
    np.testing.assert_array_equal(_line(axes, "centre of gravity"), motion.stack("X", "Y"))


def test_the_top_view_has_moving_obstacles_at_the_same_instants() -> None:
    """An obstacle that moves is drawn at each of the vehicle's instants, one at rest once; lanes are lines."""
    axes = top_view(made(*MOST_SHOWN, controller="unified")).axes[0]
    boxes = [c for c in _polygons(axes, 4) if np.isclose(np.hypot(*(c[0] - c[1])), 4.5)]
    ahead = sorted(c.mean(axis=0)[0] for c in boxes if c.mean(axis=0)[1] > 3)
    np.testing.assert_allclose(ahead, 45 - 5 * np.arange(1.0, -0.1, -0.25))
    assert len(boxes) == len(ahead) + 1
    across = {float(line.get_ydata()[0]) for line in axes.lines if len(set(line.get_ydata())) == 1}
    assert across >= {-5.25, -1.75, 1.75, 5.25}


def test_the_top_view_marks_the_closest_approach() -> None:
    """The mark is where the footprint is nearest to an obstacle."""
    done = made("duration=2 s", controller="unified")
    nearest = np.hypot(done.log.motion["X"] - 25, done.log.motion["Y"]).argmin()
    (mark,) = _line(top_view(done).axes[0], "closest")
    np.testing.assert_allclose(mark, done.log.motion.stack("X", "Y")[nearest], atol=0.05)


def test_the_top_view_of_a_long_run_keeps_to_the_event() -> None:
    """Of a road longer than fits, the 200 m round the closest approach are drawn, and the obstacle with them."""
    figure = top_view(made("duration=30 s", "obstacles.0.position=[400, 0]"))
    assert figure.axes[0].get_xlim()[0] == pytest.approx(298, abs=0.1)  # contact at 398 m
    assert any(_polygons(axes, 64) for axes in figure.axes)


@pytest.mark.parametrize(
    ("x", "y", "n"), [((0.0, 25.0), (-3.0, 3.0), 1), ((0.0, 100.0), (-3.0, 3.0), 3), ((0.0, 30.0), (0.0, 90.0), 1)]
)
def test_a_map_is_cut_where_that_makes_it_larger(x: tuple[float, float], y: tuple[float, float], n: int) -> None:
    """A short or high map stays whole; a long, flat one is cut; what is left fits the page and covers the map."""
    strips = cut(x, y)
    assert len(strips.x) - 1 == n
    assert strips.x[0] <= x[0] and strips.x[-1] >= x[1]
    assert strips.figure_height < 8.0


def test_the_states_are_in_the_usual_units() -> None:
    """km/h for the longitudinal velocity, deg/s for the yaw rate, and the goals as lines."""
    done = made(controller="unified")
    motion = done.log.motion
    speed, lateral, yaw_rate, path = states(done).axes
    np.testing.assert_allclose(speed.lines[0].get_ydata(), 3.6 * motion["vx"])
    np.testing.assert_allclose(lateral.lines[0].get_ydata(), motion["vy"])
    np.testing.assert_allclose(yaw_rate.lines[0].get_ydata(), np.degrees(motion["r"]))
    np.testing.assert_array_equal(path.lines[0].get_xydata(), motion.stack("X", "Y"))
    assert _line(speed, "goal")[0, 1] == pytest.approx(72)


def test_commands_are_stairs_beside_what_acts() -> None:
    """Each commanded value is held for a sample; the acting one is a line of another width, so that grey print does."""
    done = made(controller="unified")
    wheels = wheel_forces(done).axes
    assert [axes.get_title() for axes in wheels] == ["front left", "front right", "rear left", "rear right"]
    (turned,) = steering(done).axes
    for axes, name, unit in ((wheels[1], "Fx_fr", 1e3), (turned, "delta", np.pi / 180)):
        (stairs,) = (patch for patch in axes.patches if isinstance(patch, StepPatch))
        values, edges, _ = stairs.get_data()
        np.testing.assert_allclose(values * unit, done.log.steps[name])
        np.testing.assert_allclose(edges, np.arange(21) * 0.05)
        np.testing.assert_allclose(_line(axes, "acting")[:, 1] * unit, done.log.motion[name])
        assert stairs.get_linewidth() > 2 * axes.lines[0].get_linewidth()


def test_steps_of_the_fallback_are_hatched() -> None:
    """A figure of commands says which were the fallback's, and says nothing of it where there were none."""
    failed = {text.get_text() for text in steering(made(FAILING)).legends[0].get_texts()}
    assert failed == {"commanded", "acting", "answered by the fallback"}
    fine = {text.get_text() for text in steering(made(controller="unified")).legends[0].get_texts()}
    assert fine == {"commanded", "acting"}


def test_a_flat_line_looks_flat() -> None:
    """Where nothing moves, rounding errors are not blown up to the height of the page."""
    done = made()
    for axes in (*states(done).axes, *steering(done).axes):
        assert np.ptp(axes.get_ylim()) >= 0.2


def test_the_caption_says_what_was_run() -> None:
    """At the foot of every figure: scenario, controller, plant, seed, version and verdict."""
    done = made(FAILING, "name=from here to there and back again in one go and further on")
    for draw in FIGURES.values():
        (caption,) = (text.get_text() for text in draw(done).texts)
        assert caption.startswith("from here to there and back again in ...: as-printed on planar, seed 0, swerve ")
        assert caption.endswith(". Avoided, smallest √ρ 2.500 (1 is contact).")  # noqa: RUF001


def test_the_same_run_gives_the_same_files(tmp_path: Path) -> None:
    """Files hold no date: the same figure written twice has the same bytes."""
    for name, write in writers({"steering": steering}, made()).items():
        write(tmp_path / f"a_{name}")
        write(tmp_path / f"b_{name}")
        assert (tmp_path / f"a_{name}").read_bytes() == (tmp_path / f"b_{name}").read_bytes()
