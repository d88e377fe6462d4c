"""The page in a real browser, from disk: it opens, plays, scrubs, links its charts, and obeys the keys."""

import json
import os
import re
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from swerve.report import result_json
from swerve.report.page import write_comparison, write_page
from swerve.report.write import write_record
from tests.report.page.ways import busy, with_ways
from tests.report.runs import made

EVIL = "x</title><script>window.evil=1</script><img src=x onerror=window.evil=1>"
SIZES = {"1280": {"width": 1280, "height": 800}, "390": {"width": 390, "height": 844}}
Open = Callable[..., Any]


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page of a run of three seconds."""
    path = tmp_path_factory.mktemp("run") / "report.html"
    write_page(with_ways(), path)
    return path


def _time(page: Any) -> float:
    """The time that is shown [s], once the frame is drawn."""
    page.evaluate("() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    return float(page.locator("#time").text_content().split()[0])


def _ink(page: Any, canvas: str) -> str:
    """What is on a canvas, as a picture."""
    return str(page.evaluate("id => document.getElementById(id).toDataURL()", canvas))


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_it_opens_from_disk(report: Path, opened: Open, size: str, scheme: str) -> None:
    """Wide and narrow, light and dark: no complaint, nothing wider than the screen, every chart drawn."""
    page = opened(report, viewport=SIZES[size], color_scheme=scheme)
    assert page.evaluate("document.documentElement.scrollWidth") == SIZES[size]["width"]
    assert page.locator(".uplot").count() == 10
    widths = page.locator(".uplot canvas").evaluate_all("all => all.map(each => each.getBoundingClientRect().width)")
    assert min(widths) > 200
    light = page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(244, 246, 248)"
    assert light is (scheme == "light")
    page.locator("#theme").click()
    assert (page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(244, 246, 248)") is not light


def test_it_plays_and_pauses(report: Path, opened: Open) -> None:
    """Playing moves the time and both pictures on, at about the speed that is set; pausing holds them."""
    page = opened(report)
    before = [_ink(page, name) for name in ("view", "wheels")]
    page.locator("#speed").select_option("0.5")
    began = page.evaluate("performance.now()")
    page.locator("#play").click()
    page.wait_for_timeout(1000)
    page.locator("#play").click()
    lasted = (page.evaluate("performance.now()") - began) / 1000  # a busy machine takes its time to click
    reached = _time(page)
    assert 0.3 < reached <= 0.5 * lasted + 0.05
    assert all(_ink(page, name) != was for name, was in zip(("view", "wheels"), before, strict=True))
    page.wait_for_timeout(200)
    assert _time(page) == reached


def test_it_stops_at_the_end_and_starts_anew(report: Path, opened: Open) -> None:
    """Playing ends with the run; the next play begins at its start."""
    page = opened(report, "#t=2.9")
    page.locator("#play").click()
    page.wait_for_timeout(600)
    assert _time(page) == 3.0
    assert page.locator("#play").text_content() == "Play"
    page.locator("#play").click()
    page.wait_for_timeout(150)
    assert _time(page) < 1.0


@pytest.mark.slow
def test_it_plays_smoothly(report: Path, opened: Open) -> None:
    """At full speed the page draws at least 30 frames a second, drawing included."""
    page = opened(report)
    frames = page.evaluate(
        """() => new Promise(done => {
            let drawn = 0;
            Report.player.listen(() => { drawn += 1; });
            Report.player.toggle();
            const start = performance.now();
            setTimeout(() => done(1000 * drawn / (performance.now() - start)), 2000);
        })"""
    )
    assert frames >= 30


def test_keys_are_enough(report: Path, opened: Open) -> None:
    """Space plays, arrows go by steps, with Shift by ten, Home and End to the ends, plus and minus set the speed."""
    page = opened(report)
    page.keyboard.press("ArrowRight")
    assert _time(page) == 0.05
    page.keyboard.press("Shift+ArrowRight")
    assert _time(page) == 0.55
    page.keyboard.press("ArrowLeft")
    assert _time(page) == 0.5
    page.keyboard.press("End")
    assert _time(page) == 3.0
    page.keyboard.press("Home")
    assert _time(page) == 0.0
    for key, speed in (("+", "2"), ("-", "1"), ("-", "0.5")):
        page.keyboard.press(key)
        _time(page)
        assert page.locator("#speed").input_value() == speed
    page.keyboard.press("Space")
    page.wait_for_timeout(300)
    assert page.locator("#play").text_content() == "Pause"
    page.keyboard.press("Space")
    assert 0.0 < _time(page) < 1.0
    assert page.locator("#play").text_content() == "Play"


def test_a_focused_control_keeps_its_keys(report: Path, opened: Open) -> None:
    """Space on a check box ticks it and plays nothing; arrows on the scrubber move by one step, not by two."""
    page = opened(report)
    page.locator("#layer-forces").focus()
    page.keyboard.press("Space")
    assert not page.locator("#layer-forces").is_checked()
    assert _time(page) == 0.0
    page.locator("#scrub").focus()
    page.keyboard.press("ArrowRight")
    assert _time(page) == 0.05


def test_focus_goes_from_top_to_bottom_and_is_seen(report: Path, opened: Open) -> None:
    """Tab visits every control in the order of reading, and each shows that it has the focus."""
    page = opened(report)
    seen: list[str] = []
    for _ in range(30):
        page.keyboard.press("Tab")
        focus = page.evaluate(
            """() => { const on = document.activeElement, style = getComputedStyle(on);
            return [on.id || on.className || on.tagName, on === document.body, parseFloat(style.outlineWidth)]; }"""
        )
        if focus[1]:
            break
        assert focus[2] >= 2, focus[0]
        seen.append(focus[0])
    expected = ["skip", "theme", "play", "scrub", "speed", *(f"layer-{x}" for x in ("follow", "forces", "plan"))]
    assert seen[: len(expected)] == expected
    assert seen.count("SUMMARY") == 3


def test_scrubbing_goes_to_the_instant(report: Path, opened: Open) -> None:
    """The scrubber, a moment's button, a click in a chart and the address each set the time everywhere."""
    page = opened(report, "#t=0.7")
    assert _time(page) == 0.7
    page.locator("#scrub").fill("1.5")
    assert _time(page) == 1.5
    button = page.locator("#moments button", has_text="closest")
    button.click()
    assert _time(page) == float(button.locator("b").text_content().split()[0])
    over = page.locator(".u-over").nth(3)
    box = over.bounding_box()
    over.click(position={"x": box["width"] / 2, "y": 20})
    page.mouse.move(0, 0)
    assert _time(page) == pytest.approx(1.5, abs=0.02)
    assert float(page.locator("#scrub").input_value()) == pytest.approx(1.5, abs=0.02)


def test_charts_share_their_cursor(report: Path, opened: Open) -> None:
    """Pointing in one chart shows that instant in every other and in the top view; leaving undoes it."""
    page = opened(report)
    before, over = _ink(page, "view"), page.locator(".u-over").nth(2)
    over.scroll_into_view_if_needed()
    box = over.bounding_box()
    page.mouse.move(box["x"] + 0.4 * box["width"], box["y"] + 40)
    assert _time(page) == pytest.approx(1.2, abs=0.02)
    shares = page.locator(".u-over").evaluate_all(
        """all => all.map(over => new DOMMatrix(getComputedStyle(over.querySelector(".u-cursor-x")).transform).m41
            / over.clientWidth)"""
    )
    assert len(shares) == 10
    assert shares == pytest.approx([0.4] * 10, abs=0.01)
    assert _ink(page, "view") != before
    page.mouse.move(2, 2)
    assert _time(page) == 0.0
    assert _ink(page, "view") == before


def test_zooming_one_chart_zooms_all(report: Path, opened: Open) -> None:
    """Dragging along time in a chart shows that stretch in every chart; a double click shows all again."""
    page = opened(report)
    over = page.locator(".u-over").nth(2)
    over.scroll_into_view_if_needed()
    box = over.bounding_box()
    ranges = "Report.charts.charts.map(({ chart }) => [chart.scales.x.min, chart.scales.x.max])"
    page.mouse.move(box["x"] + 0.2 * box["width"], box["y"] + 40)
    page.mouse.down()
    page.mouse.move(box["x"] + 0.6 * box["width"], box["y"] + 50, steps=4)
    page.mouse.up()
    zoomed = page.evaluate(ranges)
    assert all(each == pytest.approx([0.6, 1.8], abs=0.05) for each in zoomed)
    page.mouse.dblclick(box["x"] + 0.5 * box["width"], box["y"] + 40)
    assert all(each == pytest.approx([0.0, 3.0], abs=1e-6) for each in page.evaluate(ranges))


def test_numbers_are_the_json_s(report: Path, opened: Open) -> None:
    """Every number at the top, and every one in the table, is the run's own; what is shown is that number, rounded."""
    page, result = opened(report), json.loads(result_json(with_ways().result))

    def of(key: str) -> Any:
        value = result
        for part in key.split("."):
            value = value[part]
        return value

    shown = page.locator("data[data-key]").evaluate_all("all => all.map(x => [x.dataset.key, x.value, x.textContent])")
    assert len(shown) >= 8
    assert all(json.loads(exact) == of(key) for key, exact, _ in shown)
    text = {key: text for key, _, text in shown}
    assert text["min_clearance"] == f"{result['min_clearance']:.3f}"
    assert text["speed.min"] == f"{3.6 * result['speed']['min']:.1f}"
    rows = page.locator(".exact tbody tr").evaluate_all("all => all.map(x => [...x.cells].map(y => y.textContent))")
    assert {key: text for key, text in rows if not isinstance(of(key), str)} == {
        key: json.dumps(of(key)) for key, _ in rows if not isinstance(of(key), str)
    }


def test_names_cannot_run(tmp_path: Path, opened: Open) -> None:
    """A scenario's name and description are shown as they are written, and nothing in them is obeyed."""
    toml = json.dumps(EVIL)
    write_page(made(f"name={toml}", f"description={toml}", f"source={toml}"), tmp_path / "report.html")
    page = opened(tmp_path / "report.html")
    assert page.evaluate("window.evil") is None
    assert page.locator("h1").text_content() == EVIL
    assert page.locator(".lead").text_content() == EVIL
    assert page.title().startswith(EVIL)


def test_the_decision_is_told(report: Path, opened: Open) -> None:
    """At an instant the ways that were tried are listed with their costs, the one that was taken marked."""
    page = opened(report, "#t=0.3")
    rows = page.locator("#decision tbody tr").all_text_contents()
    tried = with_ways().plans[6]
    assert len(rows) == len(tried.branches) == 3
    assert [each.split(" ✓")[0] for each in rows if "✓" in each] == [tried.name]
    assert f"Active limits: {', '.join(tried.active)}." in page.locator("#decision").text_content()
    assert "Friction asked for: " in page.locator("#decision").text_content()


def test_ways_not_taken_are_seen(report: Path, opened: Open) -> None:
    """Each way has its name, one that touches an obstacle is marked and tells the speed; a box hides them."""
    page = opened(report, "#t=0.3")
    page.evaluate(
        """() => { window.written = []; const write = CanvasRenderingContext2D.prototype.fillText;
        CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
            if (this.canvas.id === "view") written.push(text);
            return write.call(this, text, ...rest);
        }; Report.player.draw(); }"""
    )
    tried = with_ways().plans[6]
    words = {
        each.name if each.impact_speed is None else f"✕ {each.name}, {3.6 * each.impact_speed:.0f} km/h"
        for each in tried.branches
    }
    assert words <= set(page.evaluate("written"))
    before = _ink(page, "view")
    page.locator("#layer-branches").uncheck()
    page.evaluate("() => { written.length = 0; Report.player.draw(); }")
    assert set(page.evaluate("written")) & words == {tried.name}
    assert _ink(page, "view") != before


def test_the_reason_is_under_the_band(report: Path, opened: Open) -> None:
    """Below the band stands the decision of the instant that is shown, or pointed at, and why."""
    page = opened(report, "#t=0.3")
    tried = with_ways().plans[6]
    line = page.locator("#reason").text_content()
    assert line == f"0.30 s  ·  {tried.name}: {tried.reason}; held by {', '.join(tried.active)}"
    over = page.locator("#band .u-over")
    over.scroll_into_view_if_needed()
    box = over.bounding_box()
    page.mouse.move(box["x"] + 0.9 * box["width"], box["y"] + 15)
    assert _time(page) == pytest.approx(2.7, abs=0.02)
    assert page.locator("#reason").text_content().endswith("keep: the only way")


def test_it_prints(report: Path, opened: Open) -> None:
    """On paper the page is light and its charts as wide as half a page; then the screen is as before."""
    page = opened(report, color_scheme="dark")
    document = page.pdf(prefer_css_page_size=True)
    assert document.startswith(b"%PDF")
    assert 2 <= len(re.findall(rb"/Type\s*/Page\b", document)) <= 8
    assert page.evaluate("document.documentElement.dataset.theme") is None
    assert page.evaluate("Report.charts.charts[1].chart.width") > 340


def test_a_comparison_has_every_car(tmp_path: Path, opened: Open) -> None:
    """Two runs of one scene are drawn together: a row each in the table, a line each in the charts, both named."""
    runs = [with_ways(), made("duration=3 s")]
    write_comparison(runs, tmp_path / "compare.html")
    page = opened(tmp_path / "compare.html", "#t=0.5")
    assert page.locator("header tbody th").all_text_contents() == ["unified", "as-printed"]
    assert page.locator("header .badge").count() == 2
    assert page.evaluate("Report.charts.charts[1].chart.series.filter(each => each.show !== false).length") == 1 + 2 + 1
    assert page.locator(".legend", has_text="as-printed").count() == 9


@pytest.mark.slow
def test_ten_seconds_are_written_in_two(tmp_path: Path) -> None:
    """The page of ten seconds, with four ways in each step, is written in two seconds and has at most 3 MB."""
    done = busy(with_ways(duration="10 s"))
    assert min(len(plan.branches) for plan in done.plans) == 4
    began = time.perf_counter()
    write_page(done, tmp_path / "report.html")
    assert time.perf_counter() - began <= 2.0
    assert os.path.getsize(tmp_path / "report.html") <= 3_000_000


def test_a_run_s_files_have_the_page(tmp_path: Path) -> None:
    """Beside result and log is the page, of the same numbers."""
    write_record(made(), tmp_path)
    text = (tmp_path / "report.html").read_text(encoding="utf-8")
    (embedded,) = re.findall(r'<script type="application/json" id="document">(.*?)</script>', text, re.DOTALL)
    assert json.loads(embedded)["cars"][0]["result"] == json.loads((tmp_path / "result.json").read_text())
