"""Maps in the studio: listed, shown, and led back to a scene that is run."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from swerve.report.map import write_map, write_replays
from swerve.report.map.replays import replay_name
from swerve.studio.folders import maps as maps_in
from swerve.studio.folders import pages
from swerve.studio.routes.maps import REPLAYS
from swerve.study.map.boundary import Condition
from tests.report.map.maps import SOURCE, made, reached
from tests.report.runs import made as made_run
from tests.studio.servers import Server, served

CONDITION = Condition(20.0, 0.85, 0.0)
FOUND = made(speeds=(20.0,), frictions=(0.85,))


@pytest.fixture(scope="module")
def maps(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a map, whose name is hostile, and a folder that is none."""
    root = tmp_path_factory.mktemp("maps")
    write_replays({CONDITION: [made_run()]}, root / "<b>&")
    write_map(FOUND, root / "<b>&" / "map.html", SOURCE, [CONDITION])
    (root / "empty").mkdir()
    return root


@pytest.fixture(scope="module")
def server(maps: Path) -> Iterator[Server]:
    """A server over it."""
    with served(maps) as started:
        yield started


def test_maps_are_listed_and_served(server: Server) -> None:
    """A map's folder has its page and its replays, and what is in no list is not found."""
    assert [each["name"] for each in server.get("/api/maps")] == ["<b>&"]
    for path in ("map.html", f"replays/{replay_name(CONDITION)}"):
        status, headers, body = server.ask(f"/maps/%3Cb%3E%26/{path}")
        assert status == 200
        assert "default-src 'none'" in headers["content-security-policy"]
        assert body.startswith(b"<!DOCTYPE html>")
    for path in (
        "/maps/empty/map.html",
        "/maps/../map.html",
        "/maps/%3Cb%3E%26/replays/..%2Fmap.html",
        "/maps/x/replays/y",
    ):
        assert server.ask(path)[0] == 404


def test_a_folder_that_is_a_map_is_listed(maps: Path) -> None:
    """A map's own folder is a list of one; pages that are links are not part of it."""
    own = maps / "<b>&"
    assert maps_in(own) == {"<b>&": own.resolve()}
    assert list(pages(own / REPLAYS)) == [replay_name(CONDITION)]


def test_links_are_no_maps(tmp_path: Path) -> None:
    """A folder or a page that is a link to another place is not shown."""
    (tmp_path / "outside" / "replays").mkdir(parents=True)
    (tmp_path / "outside" / "map.html").touch()
    (tmp_path / "root" / "one" / "replays").mkdir(parents=True)
    (tmp_path / "root" / "one" / "map.html").touch()
    (tmp_path / "root" / "one" / "replays" / "a.html").symlink_to("/etc/passwd")
    (tmp_path / "root" / "two").symlink_to(tmp_path / "outside")
    (tmp_path / "root" / "three").mkdir()
    (tmp_path / "root" / "three" / "map.html").symlink_to("/etc/passwd")
    assert list(maps_in(tmp_path / "root")) == ["one"]
    assert pages(tmp_path / "root" / "one" / REPLAYS) == {}


def test_a_point_is_run_in_the_studio(browser: Any, server: Server) -> None:
    """From the list to the map, from a point of it to the studio, which has its scene and runs it."""
    from playwright.sync_api import expect

    page = browser.new_context(viewport={"width": 1280, "height": 900}).new_page()
    complaints: list[str] = []
    page.on("console", lambda message: complaints.append(message.text))
    page.goto(server.address)
    page.locator("#maps a").click()
    over = page.locator(".u-over").first
    over.scroll_into_view_if_needed()
    place = page.evaluate(
        "Marks.place(MapPage.charts[0].chart, MapPage.charts[0].shown.find(x => x.look.name === 'unified'))"
    )
    box = over.bounding_box()
    page.mouse.move(box["x"] + place[0], box["y"] + place[1])
    page.mouse.click(box["x"] + place[0], box["y"] + place[1])
    shown = page.locator("#card-body dd").nth(2).text_content()
    page.get_by_text("Open in the studio").click()
    distance = reached("unified", CONDITION)
    assert shown == f"{distance:.2f} m"
    expect(page.locator("#toml")).to_have_value(re.compile(rf"position = \[\n    {round(distance, 6)},"))
    expect(page.locator("#toml")).to_have_value(re.compile(r"duration = 2\.8"))
    expect(page.locator("#number-speed")).to_have_value("72")
    expect(page.locator("#plant")).to_have_value("planar")
    expect(page.locator("#controller")).to_have_value("unified")
    page.locator("#run").click()
    expect(page.locator("#status")).to_have_text("Done", timeout=30_000)
    assert complaints == []


def test_an_address_that_says_nonsense_is_a_scene(browser: Any, server: Server) -> None:
    """What there is no such choice of is left out; the studio has its usual scene."""
    from playwright.sync_api import expect

    page = browser.new_context().new_page()
    page.goto(f"{server.address}/studio?scenario=none&speed=fast&distance=&controller=%3Cb%3E&seed=-1&plant=x&other=1")
    expect(page.locator("#toml")).to_have_value(re.compile(r'^name = "paper"'))
    expect(page.locator("#plant")).to_have_value("multibody")
    expect(page.locator("#seed")).to_have_value("0")
