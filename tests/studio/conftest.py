"""One server for all tests of the studio, over a folder with a few runs in it."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from swerve.report.write import write_record
from tests.report.runs import MOST_SHOWN, made
from tests.studio.servers import Server, served

EVIL = '"<img src=x onerror=window.evil=1>"'


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Four runs, one of them with a hostile name, and what is none: a broken one, a file, an empty folder."""
    root = tmp_path_factory.mktemp("runs")
    write_record(made("duration=2 s"), root / "as printed")
    write_record(made("duration=2 s", controller="unified"), root / "unified")
    write_record(made(*MOST_SHOWN, controller="unified"), root / "two-obstacles")
    write_record(made(f"name={EVIL}", "obstacles=[]"), root / "<b>&")
    (root / "broken").mkdir()
    (root / "broken" / "result.json").write_text("{}")
    (root / "broken" / "report.html").write_text("")
    (root / "notes.txt").touch()
    (root / "empty").mkdir()
    return root


@pytest.fixture(scope="session")
def server(folder: Path) -> Iterator[Server]:
    """A server over the folder."""
    with served(folder) as started:
        yield started
