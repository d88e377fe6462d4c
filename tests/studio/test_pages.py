"""The studio in a real browser: a scene is moved, run and watched; runs are filtered and compared."""

import json
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from swerve.cli import main
from swerve.scenario import FAMILIES, library_names
from tests.studio.servers import Server

SIZES = {"1280": {"width": 1280, "height": 800}, "390": {"width": 390, "height": 844}}
OF_THE_CLOCK = {"step_time", "wall_time"}
Open = Callable[..., Any]


@pytest.fixture
def opened(browser: Any, server: Server) -> Iterator[Open]:
    """Opens a page, and sees that it neither failed nor asked anybody but this server for anything."""
    contexts, complaints = [], []

    def open_page(path: str, **options: Any) -> Any:
        contexts.append(browser.new_context(**{"viewport": SIZES["1280"], **options}))
        page = contexts[-1].new_page()
        page.on("console", lambda message: complaints.append(message.text))
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.on(
            "request", lambda it: it.url.startswith((server.address, "blob:", "data:")) or complaints.append(it.url)
        )
        page.goto(server.address + path)
        return page

    yield open_page
    for context in contexts:
        context.close()
    assert [each for each in complaints if "the server responded with a status of 422" not in each] == []


def _ready(page: Any) -> Any:
    """The studio once its scene is there."""
    _has(page, "#toml", re.compile("name = "))
    return page


def _has(page: Any, where: str, value: str | re.Pattern[str]) -> None:
    from playwright.sync_api import expect

    expect(page.locator(where)).to_have_value(value)


def _says(page: Any, where: str, words: str | re.Pattern[str]) -> None:
    from playwright.sync_api import expect

    expect(page.locator(where)).to_contain_text(words, timeout=30_000)


@pytest.mark.parametrize(("name", "size"), [("paper", "1280"), ("ccrs-50-il75", "390")])
def test_a_scene_is_moved_run_watched_and_saved(
    opened: Open, tmp_path: Path, capsys: Any, name: str, size: str
) -> None:
    """What is run in the studio and what its TOML gives on the command line have the same numbers."""
    page = _ready(opened("/studio", viewport=SIZES[size]))
    page.locator("#scenario").select_option(name)
    page.locator("#number-distance").fill("28.5")
    page.locator("#number-speed").fill("80")
    page.locator("#number-friction").fill("0.7")
    page.locator("#plant").select_option("planar")
    page.locator("#run").click()
    _says(page, "#status", "Done")
    frame = page.frame_locator("#frame")
    assert frame.locator("h1").text_content() == f"{name}-moved"
    _says(frame, "#play", "Pause")
    shown = frame.locator("data[data-key]").evaluate_all("all => all.map(x => [x.dataset.key, x.value])")
    with page.expect_download() as download:
        page.locator("#save").click()
    assert download.value.suggested_filename == f"{name}-moved.toml"
    download.value.save_as(tmp_path / "scene.toml")
    assert main(["run", str(tmp_path / "scene.toml"), "--plant", "planar", "--json"]) == 0
    expected = json.loads(capsys.readouterr().out)
    watched = json.loads(
        frame.locator("#document").evaluate("x => JSON.stringify(JSON.parse(x.textContent).cars[0].result)")
    )
    assert {key: each for key, each in watched.items() if key not in OF_THE_CLOCK} == {
        key: each for key, each in expected.items() if key not in OF_THE_CLOCK
    }
    assert expected["speed"]["max"] == pytest.approx(80 / 3.6, abs=0.5)
    assert len(shown) >= 8


def test_the_keyboard_is_enough(opened: Open) -> None:
    """Tab reaches everything in the order of reading, arrows move a slider by its step, Enter runs."""
    page = _ready(opened("/studio"))
    seen: list[str] = []
    for _ in range(22):
        page.keyboard.press("Tab")
        on = page.evaluate(
            """() => { const on = document.activeElement, style = getComputedStyle(on);
            return [on.id || on.textContent, parseFloat(style.outlineWidth)]; }"""
        )
        assert on[1] >= 2, on[0]
        seen.append(on[0])
        if on[0] == "range-distance":
            page.keyboard.press("ArrowRight")
            page.keyboard.press("PageUp")
            _has(page, "#number-distance", "30.5")
            _has(page, "#toml", re.compile(r"position = \[\n    30\.5,"))
        if on[0] == "save":
            break
    inputs = [f"{kind}-{key}" for key in ("speed", "distance", "offset", "friction") for kind in ("range", "number")]
    tail = ["controller", "plant", "seed", "run", "save"]
    assert seen == ["Skip to the result", "Runs", "Studio", "theme", "scenario", *inputs, *tail]
    page.locator("#plant").select_option("planar")
    page.locator("#number-speed").press("Enter")
    _says(page, "#status", "Done")


def test_a_family_s_member_is_picked_with_the_keyboard(opened: Open) -> None:
    """What is typed on the closed list leads to a member, the arrows to the next, and the form begins where it does."""
    page = _ready(opened("/studio", viewport=SIZES["390"]))
    assert page.locator("#scenario optgroup").evaluate_all("all => all.map(x => [x.label, x.children.length])") == [
        ["Library", len(library_names())],
        *([f"{family.pattern}: {family.title}", len(family.members)] for family in FAMILIES),
    ]
    page.locator("#scenario").focus()
    page.keyboard.type("ccrm-9")
    _has(page, "#toml", re.compile(r'^name = "ccrm-90-il0"'))
    page.keyboard.press("ArrowDown")
    _has(page, "#toml", re.compile(r'^name = "ccrm-90-il25"'))
    _says(page, "#description", "90 km/h towards a car at 30 km/h, impact location 25 %")
    _has(page, "#number-speed", "90")
    assert page.evaluate("document.documentElement.scrollWidth") == 390


def test_what_is_wrong_is_told(opened: Open) -> None:
    """A value that cannot be is told in the schema's words as soon as it is there, does not run, and can be mended."""
    page = _ready(opened("/studio"))
    page.locator("#number-friction").fill("3")
    _says(page, "#fault", "scene: road.friction: 3.0 is out of range; write more than 0 and at most 2")
    page.locator("#run").click()
    page.wait_for_timeout(300)
    assert page.locator("#frame").is_hidden()
    assert page.locator("#fault").is_visible()
    page.locator("#number-friction").fill("0.5")
    page.locator("#fault").wait_for(state="hidden")
    page.locator("summary").click()
    page.locator("#toml").fill('nam = "x"')
    page.locator("#run").click()
    _says(page, "#fault", "scene: nam: unknown key; did you mean name?")


def test_a_run_can_be_cancelled(opened: Open, server: Server) -> None:
    """A run that takes long is ended by its button, leaves nothing, and another one can follow."""
    page = _ready(opened("/studio"))
    before = len(server.get("/api/runs"))
    page.locator("summary").click()
    page.locator("#toml").fill(page.locator("#toml").input_value().replace("duration = 5.0", "duration = 300.0"))
    page.locator("#run").click()
    _says(page, "#status", "Running")
    page.locator("#cancel").click()
    _says(page, "#status", "Cancelled")
    assert page.locator("#run").is_enabled()
    assert len(server.get("/api/runs")) == before


def test_the_list_is_filtered(opened: Open) -> None:
    """Words and the outcome choose what is listed; a name is a name, whatever is in it."""
    page = opened("/")
    page.locator("#runs li").first.wait_for()
    names = page.locator("#runs h2")
    assert {"as printed", "unified", "two-obstacles", "<b>&", "broken"} <= set(names.all_text_contents())
    page.locator("#words").fill("two UNIFIED")
    assert names.all_text_contents() == ["two-obstacles"]
    page.locator("#words").fill("")
    page.locator("#outcome").select_option("collided")
    badges = page.locator("#runs .badge").all_text_contents()
    assert badges
    assert set(badges) == {"Collided"}
    page.locator("#words").fill("nothing has this name")
    assert names.count() == 0
    _says(page, "#count", re.compile(r"^0 of \d+ runs$"))
    assert page.evaluate("window.evil") is None


def test_two_runs_are_compared(opened: Open) -> None:
    """Two runs of one scene that are ticked are shown in one page."""
    page = opened("/")
    page.get_by_label("Compare unified", exact=True).check()
    assert page.locator("#compare").is_disabled()
    page.get_by_label("Compare as printed", exact=True).check()
    page.locator("#compare").click()
    _says(page, "header .verdict", "2 runs of one scene")
    assert page.locator("header .badge").count() == 2


def test_two_scenes_are_shown_side_by_side(opened: Open) -> None:
    """Two runs of different scenes are two reports, light or dark as the page round them."""
    page = opened("/compare?first=unified&second=two-obstacles", color_scheme="light")
    frames = [page.frame_locator(f"iframe >> nth={i}") for i in range(2)]
    for frame in frames:
        _says(frame, "#time", "/")
    page.locator("#theme").click()
    for frame in frames:
        frame.locator(":root[data-theme=dark]").wait_for()


@pytest.mark.parametrize(("size", "scheme"), [("1280", "light"), ("390", "dark")])
@pytest.mark.parametrize("path", ["/", "/studio"])
def test_it_fits_the_screen(opened: Open, path: str, scheme: str, size: str) -> None:
    """Nothing is wider than the screen, light or dark is the system's, and the button changes it."""
    page = opened(path, viewport=SIZES[size], color_scheme=scheme)
    page.locator("#runs li, #range-speed").first.wait_for()
    assert page.evaluate("document.documentElement.scrollWidth") == SIZES[size]["width"]
    ground = "getComputedStyle(document.body).backgroundColor"
    assert (page.evaluate(ground) == "rgb(244, 246, 248)") is (scheme == "light")
    page.locator("#theme").click()
    assert (page.evaluate(ground) == "rgb(244, 246, 248)") is (scheme == "dark")
