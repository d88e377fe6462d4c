"""GIF and WebP, read back by Pillow: how many pictures, for how long, and what is where on them."""

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image, ImageSequence

from swerve.report.exports.animation import write_animation
from swerve.report.exports.frames import BEHIND, PANEL, SIZE, STRETCH, Frames
from swerve.simulate import Log, Run, Table
from tests.report.exports.folders import diverged, with_motion
from tests.report.runs import MOST_SHOWN, made

SCALE = PANEL[2] * SIZE[0] / STRETCH  # [pixel/m]
HUES = {"blue": ((86, 180, 233), 25), "orange": ((246, 213, 195), 12)}  # of what is filled, and how far off it may be


def _middle(picture: NDArray[np.uint8], colour: str) -> tuple[float, float]:
    """The middle of the box round all pixels of a colour, from the picture's left upper corner [pixel]."""
    hue, tolerance = HUES[colour]
    rows, columns = np.nonzero((np.abs(picture.astype(int) - hue) < tolerance).all(axis=-1))
    return (columns.min() + columns.max()) / 2, (rows.min() + rows.max()) / 2


@pytest.mark.parametrize("suffix", ["gif", "webp"])
def test_an_animation_is_in_real_time(tmp_path: Path, suffix: str) -> None:
    """A picture every 50 ms and one of the end, which stays for a second; then it begins again."""
    path = tmp_path / f"view.{suffix}"
    write_animation(made(controller="unified"), path)
    with Image.open(path) as image:
        assert (image.size, image.n_frames, image.info["loop"]) == (SIZE, 21, 0)
        durations = []
        for frame in ImageSequence.Iterator(image):
            frame.load()
            durations.append(frame.info["duration"])
    assert durations == [50] * 20 + [1000]


@pytest.mark.parametrize("suffix", ["gif", "webp"])
def test_pictures_come_back(tmp_path: Path, suffix: str) -> None:
    """What is read is what was drawn: bit by bit as WebP, nearly so with a GIF's few colours."""
    done = made(controller="unified")
    drawn = list(Frames.of(done).draw())
    write_animation(done, tmp_path / f"view.{suffix}")
    with Image.open(tmp_path / f"view.{suffix}") as image:
        for frame, picture in zip(ImageSequence.Iterator(image), drawn, strict=True):
            error = np.abs(np.asarray(frame.convert("RGB")).astype(int) - picture)
            assert error.max() == 0 if suffix == "webp" else error.mean() < 2


def test_the_vehicle_keeps_its_place_and_the_road_comes_by() -> None:
    """The body is where its frame is on the picture, an obstacle as far ahead as it is in the run, to one scale."""
    done = made("duration=0.5 s", controller="unified")
    frames, motion, vehicle = Frames.of(done), done.log.motion, done.scenario.ego.to_vehicle()
    height = PANEL[3] * SIZE[1]
    for row, picture in zip(frames.rows, frames.draw(), strict=True):
        x, y, psi = (motion[name][row] for name in ("X", "Y", "psi"))
        ahead = vehicle.cg_to_front_end - vehicle.length / 2
        origin = PANEL[0] * SIZE[0] + BEHIND * SCALE, (1 - PANEL[1] - PANEL[3]) * SIZE[1] + height / 2
        body = origin[0] + ahead * np.cos(psi) * SCALE, origin[1] - (y + ahead * np.sin(psi)) * SCALE
        assert _middle(picture, "blue") == pytest.approx(body, abs=2.0)
        assert _middle(picture, "orange") == pytest.approx((origin[0] + (25 - x) * SCALE, origin[1]), abs=2.0)


def test_an_obstacle_that_moves_is_where_it_is_at_that_time() -> None:
    """The distance to an obstacle that comes towards the vehicle shrinks on the picture as it does in the run."""
    done = made(
        "obstacles=[{position=[35, 3], velocity=[-10, 0], size=[4, 2]}]", "duration=0.5 s", controller="unified"
    )
    frames, motion = Frames.of(done), done.log.motion
    places = [_middle(picture, "orange")[0] for picture in frames.draw()]
    times, x = motion["time"][frames.rows], motion["X"][frames.rows]
    np.testing.assert_allclose(places, PANEL[0] * SIZE[0] + (BEHIND + 35 - 10 * times - x) * SCALE, atol=2.0)


def test_the_view_goes_with_a_vehicle_that_goes_aside() -> None:
    """Far from Y = 0 the vehicle is still on the picture."""
    aside = with_motion(made(), Y=made().log.motion["Y"] - 80.0)
    *_, picture = Frames.of(aside).draw()
    assert 0 < _middle(picture, "blue")[1] < SIZE[1]


def test_lanes_are_drawn() -> None:
    """Edges and lines between lanes are dark rows on the picture, at their places."""
    done = made(*MOST_SHOWN, controller="unified")
    picture = next(Frames.of(done).draw())
    middle = (1 - PANEL[1] - PANEL[3] / 2) * SIZE[1]
    for edge in (-5.25, 5.25):
        row = round(middle - edge * SCALE)
        assert (picture[row - 2 : row + 3, 200:800].min(axis=0) < 60).all()


def test_the_line_between_directions_is_double() -> None:
    """Where traffic comes the other way there are two dark rows beside each other, and none between them."""
    done = made("road.lane_width=3.5", "road.lanes_left=1", "road.lanes_oncoming=1", "obstacles=[]")
    picture = next(Frames.of(done).draw())
    middle = (1 - PANEL[1] - PANEL[3] / 2) * SIZE[1]
    column = picture[:, 700].max(axis=1)
    first, second = (round(middle - (1.75 + half) * SCALE) for half in (0.15, -0.15))
    assert column[first - 1 : first + 2].min() < 120
    assert column[second - 1 : second + 2].min() < 120
    assert column[round((first + second) / 2)] > 200


def _lasting(duration: float) -> Run:
    """A run whose second lasted longer [s]."""
    motion = made().log.motion
    columns = {**motion.columns, "time": motion["time"] * duration}
    return replace(made(), log=Log(Table(columns, motion.units), made().log.steps))


@pytest.mark.parametrize(("duration", "interval"), [(0.05, 0.05), (20.0, 0.05), (20.1, 0.06), (300.0, 0.75)])
def test_a_long_run_has_fewer_pictures_for_a_second(duration: float, interval: float) -> None:
    """There are no more than 401 pictures of any run, at equal times that a GIF can keep, from its start to its end."""
    run = _lasting(duration)
    frames = Frames.of(run)
    assert frames.interval == pytest.approx(interval)
    assert len(frames.rows) <= 401
    times = run.log.motion["time"][frames.rows]
    assert times[0] == 0 and abs(times[-1] - duration) <= interval
    np.testing.assert_allclose(np.diff(times), interval, atol=duration * 1.01e-3)
    assert all(a <= b for a, b in pairwise(frames.rows))


def test_a_run_that_diverged_ends_where_it_was_lost(tmp_path: Path) -> None:
    """What is no motion is not drawn."""
    lost = diverged()
    assert Frames.of(lost).rows[-1] < len(lost.log.motion["time"]) - 40
    write_animation(lost, tmp_path / "view.gif")
    with Image.open(tmp_path / "view.gif") as image:
        assert image.n_frames == len(Frames.of(lost).rows)
