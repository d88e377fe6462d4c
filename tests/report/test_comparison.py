"""A comparison on the terminal, in files, in figures and on pages: everywhere the numbers of its runs."""

import json
import os
import re
from collections.abc import Callable
from functools import cache
from itertools import pairwise
from math import degrees
from pathlib import Path
from typing import Any

import pyarrow.parquet
import pytest

from swerve.report.comparison import comparison_json, comparison_table, write_comparison
from swerve.report.comparison.files import as_markdown
from swerve.report.comparison.names import file_names
from swerve.report.exports.folder import read_run_folder
from swerve.report.figures.comparison import comparison as figure
from swerve.report.page import write_comparison as write_page
from swerve.report.page.data import document
from swerve.report.page.head import flat
from swerve.scenario.loader import parse
from swerve.simulate import Run
from swerve.studio.runs import Runs
from swerve.study.comparison import Comparison, Entry, Group
from tests.report.exports.folders import diverged
from tests.report.page.ways import busy, with_ways
from tests.report.runs import MOST_SHOWN, ONCOMING, made

EVIL = "</title><script>window.evil=1</script> $x |"
CONTROLLERS = ("unified", "as-printed", "brake", "nonlinear")
REASON = "it needs a <C> compiler | and a folder"
SIZES = {"1280": {"width": 1280, "height": 800}, "390": {"width": 390, "height": 844}}
Open = Callable[..., Any]


@cache
def compared(*scenarios: tuple[str, ...]) -> Comparison:
    """Short runs of three controllers in a scenario for each list of overrides, and a fourth that refuses."""
    return Comparison(CONTROLLERS, "planar", 0, tuple(map(_group, scenarios)))


def _group(overrides: tuple[str, ...]) -> Group:
    runs = [made(*overrides, controller=each) for each in CONTROLLERS[:3]]
    entries = [_entry(run) for run in runs]
    scenario = runs[0].scenario
    return Group(scenario, (*entries, Entry(scenario, "nonlinear", "planar", 0, None, REASON)))


def _entry(run: Run) -> Entry:
    return Entry(run.scenario, run.result.controller, "planar", 0, run, None)


def two() -> Comparison:
    """A hit by two of three, and a scenario whose name would like to be a script."""
    return compared(("duration=3 s",), (*MOST_SHOWN, f"name={EVIL}"))


def test_the_table_has_a_line_for_each_run() -> None:
    """In a line stand the run's own numbers in display units; a star marks the best; no line is wider than 120."""
    lines = comparison_table(two()).splitlines()
    assert max(map(len, lines)) <= 120
    start = next(i for i, line in enumerate(lines) if line.startswith("paper: "))
    for line, entry in zip(lines[start + 1 :], two().groups[0].entries[:3], strict=False):
        result = entry.result
        assert result is not None
        words = line.removeprefix("*").split()
        impact = "-" if result.impact_speed is None else f"{3.6 * result.impact_speed:.1f}"
        assert words[:3] == [entry.controller, result.outcome.value, result.decision]
        assert words[3:7] == [
            f"{result.min_clearance:.3f}",
            impact,
            f"{degrees(result.max_sideslip):.1f}",
            f"{result.lateral_excursion:.2f}",
        ]
        assert words[7] == f"{100 * (result.max_friction_use or 0):.0f}"
        assert words[-1] == str(result.fallback_steps)
        assert line.startswith("*") == (entry.controller == "unified")
    assert lines[start + 4] == f"  nonlinear   refused: {REASON}"


def test_the_json_has_every_result() -> None:
    """It is the results' own JSON, row by row, with what was compared."""
    told = json.loads(comparison_json(two()))
    assert told["controllers"] == list(CONTROLLERS)
    assert told["scenarios"] == ["paper", EVIL]
    entries = [each for group in two().groups for each in group.entries]
    for row, entry in zip(told["runs"], entries, strict=True):
        assert (row["scenario"], row["controller"]) == (entry.scenario.name, entry.controller)
        if entry.result is not None:
            assert entry.result.to_json().items() <= row.items()
    assert [row["best"] for row in told["runs"]][:4] == [True, False, False, False]


def test_the_parquet_file_is_the_json(tmp_path: Path) -> None:
    """Every column has a unit and the values of the JSON, and every scenario can be run again from the file."""
    write_comparison(two(), tmp_path)
    read = pyarrow.parquet.read_table(tmp_path / "comparison.parquet")
    rows = [flat(row) for row in two().to_json()["runs"]]
    for name in read.column_names:
        for value, row in zip(read[name].to_pylist(), rows, strict=True):
            expected = row.get(name)
            assert value == expected or (expected is None and (value == "" or value != value)), name
    assert set(rows[0]) - set(read.column_names) == {"divergence"}
    units = {field.name: field.metadata[b"unit"].decode() for field in read.schema}
    shown = {"min_clearance": "m", "max_sideslip": "rad", "step_time.p99": "s", "outcome": "", "max_friction_use": "1"}
    assert shown.items() <= units.items()
    about = read.schema.metadata
    assert (about[b"swerve.plant"], about[b"swerve.seed"]) == (b"planar", b"0")
    scenarios = json.loads(about[b"swerve.scenarios"])
    for group in two().groups:
        assert parse(scenarios[group.scenario.name].encode(), "x.toml") == group.scenario


def test_markdown_has_a_table_for_each_scenario() -> None:
    """As many cells in each row as in its header, whatever is in a reason."""
    tables = [part for part in as_markdown(two()).split("\n\n") if part.startswith("|")]
    assert len(tables) == 2
    for each in tables:
        cells = {len(re.findall(r"(?<!\\)\|", line)) for line in each.strip().splitlines()}
        assert len(cells) == 1
        assert "**avoided**" in each or "**collided**" in each


def test_its_runs_are_runs_for_every_other_command(tmp_path: Path) -> None:
    """Each run's folder reads back as the run, and `swerve view` lists them all, and nothing else."""
    paths = write_comparison(two(), tmp_path)
    folders = [path for path in paths if path.is_dir()]
    assert sorted(Runs(tmp_path).names()) == sorted(path.name for path in folders)
    runs = [each.run for group in two().groups for each in group.runs]
    for folder, run in zip(folders, runs, strict=True):
        assert run is not None
        assert read_run_folder(folder).result == run.result
    names = {path.name for path in paths} - {path.name for path in folders}
    safe = "_title_script_window.evil_1_script_x_"
    pages = {f"{name}.{end}" for name in ("paper", safe) for end in ("html", "png", "pdf")}
    assert names == pages | {"report.html", "comparison.json", "comparison.md", "comparison.parquet"}


def test_one_scenario_has_one_page(tmp_path: Path) -> None:
    """Its page is the cars together; where all refused it is the table with their reasons."""
    single = compared(("duration=3 s",))
    assert "paper.html" not in {path.name for path in write_comparison(single, tmp_path)}
    text = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert 'id="document"' in text
    assert "nonlinear refused: it needs a &lt;C&gt; compiler | and a folder" in text
    refused = Group(single.groups[0].scenario, single.groups[0].entries[3:])
    nobody = Comparison(("nonlinear",), "planar", 0, (refused,))
    assert {path.suffix for path in write_comparison(nobody, tmp_path / "new")} == {".json", ".parquet", ".md", ".html"}
    assert "it needs a &lt;C&gt; compiler" in (tmp_path / "new" / "report.html").read_text(encoding="utf-8")


def test_a_failure_leaves_nothing(tmp_path: Path) -> None:
    """Interrupted in the middle, it leaves neither files nor folders."""

    def interrupt(share: float) -> None:
        if share > 0.5:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_comparison(compared(("duration=3 s",)), tmp_path / "new", interrupt)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("names", "expected"),
    [
        (["paper", "wet"], ["paper", "wet"]),
        (["Report", "report.x"], ["Report-2", "report.x"]),
        (["../a b", "..", "雪", "氷"], ["_a_b", "_", "_-2", "_-3"]),
        (["a", "A", "a-2"], ["a", "A-2", "a-2-2"]),
    ],
)
def test_names_of_files_are_safe_and_distinct(names: list[str], expected: list[str]) -> None:
    """They stay in the folder, on any file system, and no file is another's."""
    assert file_names(names) == expected


@pytest.mark.parametrize("overrides", [("duration=3 s",), MOST_SHOWN, ONCOMING, ("obstacles=[]",)])
def test_the_figure_has_every_run(overrides: tuple[str, ...]) -> None:
    """Each path is drawn as driven; panels have a row for each entry, and a point for each number."""
    group = _group(overrides)
    drawn = figure(group)
    _, labels = drawn.axes[0].get_legend_handles_labels()
    assert {"unified", "as-printed", "brake"} <= set(labels)
    for entry in group.runs:
        assert entry.run is not None
        line = next(each for each in drawn.axes[0].lines if each.get_label() == entry.controller)
        assert (line.get_xydata() == entry.run.log.motion.stack("X", "Y")).all()
    panel = drawn.axes[-6]
    assert [each.get_text() for each in panel.get_yticklabels()][3] == "nonlinear: refused"
    points = [float(each.get_xdata()[0]) for each in panel.lines if each.get_marker() == "o"]
    gaps = [each.result.min_clearance for each in group.runs if each.result is not None]
    assert points == [gap for gap in gaps if gap is not None]


def test_a_run_that_diverged_is_drawn_and_written(tmp_path: Path) -> None:
    """What is no motion stops neither figure nor pages."""
    runs = [made(controller="brake"), diverged()]
    group = Group(runs[0].scenario, tuple(map(_entry, runs)))
    write_comparison(Comparison(("brake", "as-printed"), "planar", 0, (group,)), tmp_path)
    assert (tmp_path / "paper.png").stat().st_size > 10_000


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_the_pages_open_from_disk(tmp_path: Path, opened: Open, size: str, scheme: str) -> None:
    """Wide and narrow, light and dark: the table leads to the cars together and to each run, without a complaint."""
    write_comparison(two(), tmp_path)
    page = opened(tmp_path / "report.html", viewport=SIZES[size], color_scheme=scheme)
    assert page.evaluate("document.documentElement.scrollWidth") == SIZES[size]["width"]
    light = page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(244, 246, 248)"
    assert light is (scheme == "light")
    assert page.locator("section[id] tbody th").all_text_contents() == [*CONTROLLERS] * 2
    assert page.locator("section[id] .badge").all_text_contents()[3] == "Refused"
    assert page.locator(".above svg").count() == 2
    assert page.evaluate("window.evil") is None
    links = page.locator("section[id] a").evaluate_all("all => all.map(each => each.getAttribute('href'))")
    assert len(links) == 2 * (1 + 3)
    assert all((tmp_path / link).is_file() for link in links)
    page.locator("section[id] a").first.click()
    page.locator("#time:not(:empty)").wait_for(state="attached")
    assert page.locator("header tbody th").all_text_contents() == ["unified", "as-printed", "brake"]
    assert page.evaluate("document.documentElement.scrollWidth") == SIZES[size]["width"]


def test_names_of_cars_do_not_meet(tmp_path: Path, opened: Open) -> None:
    """Where the cars are side by side at the start, the names below them stand one below the other."""
    write_comparison(compared(("duration=3 s",)), tmp_path)
    page = opened(tmp_path / "report.html")
    page.evaluate(
        """() => { window.written = {}; const write = CanvasRenderingContext2D.prototype.fillText;
        CanvasRenderingContext2D.prototype.fillText = function (text, x, y) {
            if (this.canvas.id === "view") written[text] = y;
            return write.call(this, text, x, y);
        }; Report.player.draw(); }"""
    )
    heights = sorted(page.evaluate("[written.unified, written['as-printed'], written.brake]"))
    assert all(below - above >= 12 for above, below in pairwise(heights))


def test_ghosts_have_the_way_they_take_alone() -> None:
    """Of the first car every way has its path; of the others the one that is taken, as no other one is drawn."""
    first, ghost = document([with_ways(), with_ways()])["cars"]
    assert first["plans"][6]["taken"] is not None
    for full, thin in zip(first["plans"], ghost["plans"], strict=True):
        assert thin["path"] == full["path"]
        for i, (before, after) in enumerate(zip(full["branches"], thin["branches"], strict=True)):
            assert after == {**before, "path": before["path"] if i == full["taken"] else []}


@pytest.mark.slow
def test_ten_seconds_of_four_cars_have_three_megabytes(tmp_path: Path) -> None:
    """The page of four runs of ten seconds, each with four ways in every step, has at most 3 MB."""
    write_page([busy(with_ways(duration="10 s"))] * 4, tmp_path / "report.html")
    assert os.path.getsize(tmp_path / "report.html") <= 3_000_000
