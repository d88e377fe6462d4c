"""Comparisons in the studio, as `swerve compare` writes them: listed, shown with all pages, and their runs used."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from swerve.cli import main
from swerve.studio.folders import comparisons
from tests.studio.servers import Server, served

RUNS = ["paper-as-printed", "paper-brake", "wet-as-printed", "wet-brake"]
MADE = ("--controllers", "brake,as-printed", "--plant", "planar", "--set", "duration=1 s", "--workers", "1", "--quiet")


@pytest.fixture(scope="module")
def compared(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a comparison of two scenarios, and one of a single one."""
    root = tmp_path_factory.mktemp("compared")
    assert main(["compare", "paper", "wet", *MADE, "--out", str(root / "two of them")]) == 0
    assert main(["compare", "paper", *MADE, "--out", str(root / "one")]) == 0
    return root


@pytest.fixture(scope="module")
def server(compared: Path) -> Iterator[Server]:
    """A server over it."""
    with served(compared) as started:
        yield started


def test_comparisons_are_listed_and_served(server: Server) -> None:
    """The latest is first; each page and each report is the file of the folder, and nothing else of it is served."""
    assert [each["name"] for each in server.get("/api/comparisons")] == ["one", "two of them"]
    assert server.get("/api/runs") == []
    reports = [f"two%20of%20them/{run}/report.html" for run in RUNS]
    for path in ("one/report.html", "two%20of%20them/report.html", "two%20of%20them/paper.html", *reports):
        status, headers, body = server.ask(f"/comparisons/{path}")
        assert (status, headers["content-type"]) == (200, "text/html; charset=utf-8")
        assert "default-src 'none'" in headers["content-security-policy"]
        assert body == (server.directory / path.replace("%20", " ")).read_bytes()
    others = ("comparison.json", "none.html", "paper-brake/result.json", "..%2Fone%2Freport.html", "none/report.html")
    for path in (*(f"one/{each}" for each in others), "none/report.html", "../report.html"):
        assert server.ask(f"/comparisons/{path}")[0] == 404


def test_a_comparison_s_own_folder_is_a_list_of_its_runs(compared: Path) -> None:
    """It is listed by its own name above its runs, of which two can be drawn together."""
    with served(compared / "two of them") as server:
        assert [each["name"] for each in server.get("/api/comparisons")] == ["two of them"]
        assert sorted(each["name"] for each in server.get("/api/runs")) == RUNS
        assert "2 runs of one scene" in server.ask("/compare?first=wet-brake&second=wet-as-printed")[2].decode()


def test_links_are_no_comparisons(compared: Path, tmp_path: Path) -> None:
    """A folder or a page that is a link to another place is not shown."""
    (tmp_path / "two").symlink_to(compared / "one")
    (tmp_path / "three").mkdir()
    (tmp_path / "three" / "comparison.json").touch()
    (tmp_path / "three" / "report.html").symlink_to("/etc/passwd")
    assert comparisons(tmp_path) == {}


def test_from_the_list_to_every_page(browser: Any, server: Server) -> None:
    """The list leads to the table, the table to the cars together and to each run's report."""
    page = browser.new_context(viewport={"width": 390, "height": 844}).new_page()
    complaints: list[str] = []
    page.on("console", lambda message: complaints.append(message.text))
    page.goto(server.address)
    page.get_by_role("link", name="two of them").click()
    page.get_by_role("link", name="Watch them together").first.click()
    page.locator("#play").wait_for()
    page.go_back()
    page.get_by_role("link", name="brake", exact=True).first.click()
    page.locator("#play").wait_for()
    assert page.url == f"{server.address}/comparisons/two%20of%20them/paper-brake/report.html"
    assert complaints == []


def test_a_run_of_a_comparison_is_a_run(compared: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """It is exported and measured as any other, with its own numbers."""
    run = compared / "one" / "paper-brake"
    assert main(["export", str(run), "--to", "csv"]) == 0
    rows = (run / "motion.csv").read_text().splitlines()
    capsys.readouterr()
    assert main(["criticality", str(run), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert float(rows[-1].split(",")[0]) == pytest.approx(1.0)
    assert told["scenario"] == "paper"
