"""The page of a map in a real browser, from disk: its numbers are the map's, by pointer and by keys."""

import json
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from swerve.report.map import write_map, write_replays
from swerve.report.map.commands import run_command
from swerve.report.map.replays import replay_name
from swerve.study.map.boundary import Condition
from tests.report.map.maps import EXTENT, FRICTIONS, LIMITS, SHARES, SOURCE, SPEEDS, allowed, made, reached
from tests.report.page.colour import contrast
from tests.report.runs import made as made_run

SIZES = {"1280": {"width": 1280, "height": 800}, "390": {"width": 390, "height": 844}}
WATCHED = Condition(20.0, 0.85, 0.0)
Open = Callable[..., Any]


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page of a map, with the runs of one condition drawn together beside it."""
    directory = tmp_path_factory.mktemp("map")
    write_replays({WATCHED: [made_run(), made_run(controller="unified")], Condition(10.0, 0.3, 0.0): []}, directory)
    write_map(made(), directory / "map.html", SOURCE, [WATCHED])
    return directory / "map.html"


@pytest.fixture
def opened(browser: Any) -> Iterator[Open]:
    """Opens a page, and at the end sees that it neither failed, nor complained, nor asked the network for anything."""
    contexts, complaints = [], []

    def open_page(path: Path, **options: Any) -> Any:
        contexts.append(browser.new_context(**{"viewport": SIZES["1280"], **options}))
        page = contexts[-1].new_page()
        page.on("console", lambda message: complaints.append(message.text))
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.on("request", lambda request: request.url.startswith("file:") or complaints.append(request.url))
        page.goto(path.as_uri())
        return page

    yield open_page
    for context in contexts:
        context.close()
    assert complaints == []


def _card(page: Any) -> dict[str, str]:
    """What stands in the card, by name."""
    pairs = page.locator("#card-body dl > div").evaluate_all(
        "all => all.map(x => [...x.children].map(y => y.textContent))"
    )
    return {"who": page.locator("#card-body .who b").text_content(), **dict(pairs)}


def _point_at(page: Any, panel: int, who: str, speed: float, *, click: bool = False) -> None:
    """Move the pointer next to the boundary of a series."""
    over = page.locator(".u-over").nth(panel)
    over.scroll_into_view_if_needed()
    place = page.evaluate(
        """([panel, who, speed]) => {
            const { chart, shown } = MapPage.charts[panel];
            return Marks.place(chart, shown.find(x => x.x === speed && x.look.name === who && x.shape !== "turn"));
        }""",
        [panel, who, speed],
    )
    box = over.bounding_box()
    page.mouse.move(box["x"] + place[0] + 1, box["y"] + place[1])
    if click:
        page.mouse.click(box["x"] + place[0] + 1, box["y"] + place[1])


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_it_opens_from_disk(written: Path, opened: Open, size: str, scheme: str) -> None:
    """Wide and narrow, light and dark: nothing wider than the screen, a chart for each friction and one."""
    page = opened(written, viewport=SIZES[size], color_scheme=scheme)
    assert page.evaluate("document.documentElement.scrollWidth") == SIZES[size]["width"]
    assert page.locator(".uplot").count() == len(FRICTIONS) + 1
    widths = page.locator(".uplot canvas").evaluate_all("all => all.map(each => each.getBoundingClientRect().width)")
    assert min(widths) > 250
    light = page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(244, 246, 248)"
    assert light is (scheme == "light")
    page.locator("#theme").click()
    assert (page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(244, 246, 248)") is not light


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_words_are_readable(written: Path, opened: Open, scheme: str) -> None:
    """Every word of the page stands out from what is behind it by at least 4.5:1."""
    page = opened(written, color_scheme=scheme)
    _point_at(page, 2, "unified", 20.0)
    pairs = page.evaluate(
        """() => {
            const two = x => Number(x).toString(16).padStart(2, "0");
            const hex = colour => "#" + colour.match(/[\\d.]+/g).slice(0, 3).map(two).join("");
            const behind = on => { for (let at = on; at; at = at.parentElement) {
                const colour = getComputedStyle(at).backgroundColor;
                if (!/, 0\\)$/.test(colour)) return hex(colour);
            } };
            const found = new Map();
            for (const on of document.body.querySelectorAll("*:not(script, style, canvas, svg *)")) {
                const isShown = on.checkVisibility() && [...on.childNodes].some(x => x.nodeType === 3 && x.data.trim());
                if (isShown) found.set([hex(getComputedStyle(on).color), behind(on)].join(), on.outerHTML.slice(0, 80));
            }
            return [...found];
        }"""
    )
    assert len(pairs) >= 4
    for colours, where in pairs:
        assert contrast(*colours.split(",")) >= 4.5, (colours, where)


def test_pointing_shows_the_numbers(written: Path, opened: Open) -> None:
    """Next to a boundary its distance is told, and the card has the run's numbers and its command."""
    page = opened(written)
    _point_at(page, 2, "unified", 20.0)
    distance = reached("unified", WATCHED)
    assert page.locator(".tip:visible").text_content() == f"unified: {distance:.2f} m, avoided"
    card = _card(page)
    assert card["who"] == "unified"
    assert card["Speed"] == "20 m/s, 72 km/h"
    assert card["Friction"] == "0.85"
    assert card["Distance"] == f"{distance:.2f} m"
    assert card["Time to collision"] == f"{(distance - EXTENT) / 20:.3f} s"
    assert card["Of the limit"] == "1.040 times"
    assert card["Clearance"] == "0.010 m"
    assert page.locator("#card-body .badge").text_content() == "Avoided"
    assert page.locator("#card-body pre").text_content() == run_command(made(), SOURCE, "unified", WATCHED, distance)


def test_keys_are_enough(written: Path, opened: Open) -> None:
    """Arrows go from point to point, what is there is said, Enter goes to the card, Escape back to the chart."""
    page = opened(written)
    page.locator("#shows-limit-individual").focus()
    chart = page.locator(".plot").nth(2)
    for _ in range(40):
        page.keyboard.press("Tab")
        if chart.evaluate("x => x === document.activeElement"):
            break
    assert chart.evaluate("x => parseFloat(getComputedStyle(x).outlineWidth)") >= 2
    page.keyboard.press("Home")
    for speed in SPEEDS[1:3]:
        page.keyboard.press("ArrowRight")
        assert _card(page)["Speed"].startswith(f"{speed:g} m/s")
    assert _card(page)["Distance"] == f"{reached('unified', WATCHED):.2f} m"
    assert page.locator("#told").text_content().startswith("unified, Avoided, Speed 20 m/s, 72 km/h")
    heights = [float(_card(page)["Distance"].split()[0])]
    for _ in range(3):
        page.keyboard.press("ArrowUp")
        heights.append(float(_card(page)["Distance"].split()[0]))
    assert heights == sorted(heights)
    assert heights[-1] > heights[0]
    page.keyboard.press("Enter")
    assert page.evaluate("document.activeElement.textContent") == "Copy the command"
    page.keyboard.press("Escape")
    assert chart.evaluate("x => x === document.activeElement")


def test_a_click_holds_the_point(written: Path, opened: Open) -> None:
    """On the way to the card other points are passed without being shown; a click beside all lets go."""
    page = opened(written)
    _point_at(page, 2, "unified", 20.0, click=True)
    _point_at(page, 2, "hierarchical", 30.0)
    assert _card(page)["who"] == "unified"
    box = page.locator(".u-over").nth(2).bounding_box()
    page.mouse.click(box["x"] + box["width"] - 4, box["y"] + box["height"] - 4)
    assert page.locator("#card-body").is_hidden()
    _point_at(page, 2, "hierarchical", 30.0)
    assert _card(page)["who"] == "hierarchical"


def test_the_command_is_copied(written: Path, opened: Open) -> None:
    """The button puts the command into the clipboard."""
    page = opened(written, permissions=["clipboard-read", "clipboard-write"])
    _point_at(page, 2, "unified", 20.0, click=True)
    page.locator("#card-body button").click()
    page.get_by_text("Copied", exact=True).wait_for()
    command = run_command(made(), SOURCE, "unified", WATCHED, reached("unified", WATCHED))
    assert page.evaluate("navigator.clipboard.readText()") == command


def test_a_point_is_replayed(written: Path, opened: Open) -> None:
    """A condition's runs are drawn together on a page of their own, to which its points and its row lead."""
    page = opened(written)
    assert page.locator("td a").evaluate_all("all => all.map(x => x.getAttribute('href'))") == [
        f"replays/{replay_name(WATCHED)}"
    ]
    _point_at(page, 2, "unified", 20.0, click=True)
    assert page.get_by_text("Open in the studio").count() == 0
    page.get_by_text("Watch all controllers here").click()
    page.locator("#time:not(:empty)").wait_for(state="attached")
    assert page.locator("header tbody th").all_text_contents() == ["as-printed", "unified"]
    assert [each.name for each in (written.parent / "replays").iterdir()] == [replay_name(WATCHED)]


def test_every_run_can_be_seen(written: Path, opened: Open) -> None:
    """With the box for every run each one has a mark, a dot where it avoided and a cross where not."""
    page = opened(written)
    runs = "MapPage.charts[1].open.filter(x => x.point.kind === 'run')"
    shown = f"{runs}.map(x => [x.look.name, x.x, x.point.distance, x.shape])"
    assert len(page.evaluate(shown)) == len(SHARES) * len(SPEEDS)
    page.locator("#shows-runs").check()
    marks = page.evaluate(shown)
    expected = [run for run in made().runs if run.condition.friction == 0.5]
    assert {tuple(mark[:3]) for mark in marks} == {(run.who, run.condition.speed, run.distance) for run in expected}
    shapes = {tuple(mark[:3]): mark[3] for mark in marks}
    for run in expected:
        is_failed = shapes[run.who, run.condition.speed, run.distance] == "cross"
        assert is_failed is not run.is_avoided


def test_upwards_can_be_time(written: Path, opened: Open) -> None:
    """With time to collision every boundary is its distance before contact by its speed; lines go through the marks."""
    page = opened(written)
    page.locator("#axis-time").check()
    marks = page.evaluate("MapPage.charts[0].open.map(x => [x.x, x.point.distance, x.y])")
    assert all(y == pytest.approx((distance - EXTENT) / speed) for speed, distance, y in marks)
    assert page.locator("figcaption").first.text_content().endswith("time to collision [s] over speed [m/s]")
    seen = page.evaluate("MapPage.charts[0].chart.data.slice(1).flatMap(x => x.filter(y => typeof y === 'number'))")
    assert min(abs(each - marks[0][2]) for each in seen) < 1e-9


def test_a_series_can_be_hidden(written: Path, opened: Open) -> None:
    """A box takes a series' line and marks out of every chart, and puts them back."""
    page = opened(written)
    count = "MapPage.charts[0].open.filter(x => x.look.name === 'unified').length"
    before = page.evaluate(count)
    page.locator("#shows-unified").uncheck()
    assert page.evaluate(count) == 0
    lines = "MapPage.charts[0].chart.series.filter(x => x.show).length"
    hidden = page.evaluate(lines)
    page.locator("#shows-unified").check()
    assert page.evaluate(count) == before > 0
    assert page.evaluate(lines) == hidden + 2  # its boundary, and where it turns


def test_far_boundaries_can_be_seen(written: Path, opened: Open) -> None:
    """At first the axes show what lies near the limit; with the box they show every mark."""
    page = opened(written)
    top = "MapPage.charts[0].chart.scales.y.max"
    assert page.evaluate(top) == pytest.approx(1.35 * allowed("limit: both", Condition(35.0, 0.3, 0.0)))
    page.locator("#shows-far").check()
    assert page.evaluate(top) > reached("brake", Condition(35.0, 0.3, 0.0))


def test_the_torques_have_their_panel(written: Path, opened: Open) -> None:
    """What the torques buy can be pointed at as well: both limits and their difference."""
    page = opened(written)
    _point_at(page, 4, "friction 0.85", 20.0)
    both, individual = allowed("limit: both", WATCHED), allowed("limit: individual", WATCHED)
    card = _card(page)
    assert (card["Both"], card["Individual"]) == (f"{both:.2f} m", f"{individual:.2f} m")
    assert card["Bought"] == f"{both - individual:.2f} m"
    assert page.locator("#card-body pre").text_content().endswith("--means both,individual")


def test_the_table_is_the_map(written: Path, opened: Open) -> None:
    """Without any script the page has every last avoided distance, exactly, and its ratio to the limit."""
    page = opened(written, java_script_enabled=False)
    head = page.locator(".numbers thead th").all_text_contents()
    rows = page.locator(".numbers tbody tr")
    assert rows.count() == len(FRICTIONS) * len(SPEEDS)
    for i, condition in enumerate(sorted(made().conditions, key=lambda each: (each.friction, each.speed))):
        values = [cell.locator("data").get_attribute("value") for cell in rows.nth(i).locator("td").all()[:4]]
        expected = [condition.friction, condition.speed, reached("unified", condition)]
        assert [json.loads(each) for each in values[:3]] == expected
        assert json.loads(values[3]) == pytest.approx(1.04)
    assert head[:4] == ["friction", "speed [m/s]", "unified [m]", "unified / limit"]
    assert {f"{who} [m]" for who in (*SHARES, *LIMITS)} <= set(head)


def test_it_prints(written: Path, opened: Open) -> None:
    """On paper the page is light, its charts two abreast; then the screen is as before."""
    page = opened(written, color_scheme="dark")
    before = page.evaluate("MapPage.charts[0].chart.width")
    document = page.pdf(prefer_css_page_size=True)
    assert 1 <= len(re.findall(rb"/Type\s*/Page\b", document)) <= 5
    assert page.evaluate("document.documentElement.dataset.theme") is None
    assert page.evaluate("MapPage.charts[0].chart.width") == before


def test_names_cannot_run(tmp_path: Path, opened: Open) -> None:
    """A controller's name is shown as it is written, and nothing in it is obeyed."""
    evil = "</script><img src=x onerror=window.evil=1>"
    found = made(speeds=(20.0,), frictions=(0.85,), controllers=("unified",))
    renamed = replace(
        found,
        scenario=evil,
        controllers=(evil,),
        boundaries=tuple(replace(each, who=evil) if each.who == "unified" else each for each in found.boundaries),
        runs=tuple(replace(each, who=evil) for each in found.runs),
    )
    write_map(renamed, tmp_path / "map.html", SOURCE)
    page = opened(tmp_path / "map.html")
    assert page.locator("h1").text_content() == f"Map of {evil}"
    assert page.locator("#series label").first.text_content() == evil
    assert page.evaluate("window.evil") is None
