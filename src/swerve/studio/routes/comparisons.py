"""Comparisons: their list, pages, and the reports of their runs, at the addresses by which the pages call them."""

from pathlib import Path
from typing import Final

from fastapi import FastAPI, Response
from fastapi.responses import FileResponse

from swerve.studio.answers import PageListed
from swerve.studio.folders import REPORT, comparisons, latest_first, pages
from swerve.studio.routes.common import PAGE, Name, found, page_in
from swerve.studio.runs import Runs

NO_COMPARISON: Final = "there is no comparison of this name in the folder"
NO_PAGE: Final = "there is no such page of this comparison"
NO_RUN: Final = "there is no such run of this comparison"


def add_comparisons(app: FastAPI, directory: Path) -> None:
    """Add what is answered about the comparisons of a folder."""

    @app.get("/api/comparisons")
    def list_comparisons() -> list[PageListed]:
        """All comparisons of the folder, the latest first."""
        return [PageListed(name=path.name, finished=at) for path, at in latest_first(comparisons(directory), REPORT)]

    @app.get("/comparisons/{name}/{page}", response_class=Response, responses=PAGE)
    def page_of(name: Name, page: Name) -> FileResponse:
        """A page of a comparison, as its folder has it; report.html is the first."""
        folder = found(comparisons(directory), name, NO_COMPARISON)
        return page_in(found(pages(folder), page, NO_PAGE))

    @app.get("/comparisons/{name}/{run}/report.html", response_class=Response, responses=PAGE)
    def report_of(name: Name, run: Name) -> FileResponse:
        """The report of one of its runs."""
        folder = found(comparisons(directory), name, NO_COMPARISON)
        return page_in(found(Runs(folder).names(), run, NO_RUN) / REPORT)
