"""Finished runs: their list, reports and pictures, and two of them together."""

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated, Final

from fastapi import FastAPI, Query, Response
from fastapi.responses import FileResponse, HTMLResponse

from swerve.report.exports.folder import read_run_folder
from swerve.report.page import write_comparison
from swerve.simulate import Run
from swerve.studio.answers import RunListed
from swerve.studio.folders import REPORT
from swerve.studio.pages import two_reports
from swerve.studio.routes.common import IN_REPORT, PAGE, Name, found, page_in, told_as
from swerve.studio.runs import Runs
from swerve.studio.thumbnail import thumbnail

NO_RUN: Final = "there is no run of this name in the folder"

OtherName = Annotated[str, Query(min_length=1, max_length=255)]


def add_runs(app: FastAPI, runs: Runs) -> None:
    """Add what is answered about finished runs."""

    @app.get("/api/runs")
    def list_runs() -> list[RunListed]:
        """All finished runs of the folder, the latest first."""
        return [RunListed(**each) for each in runs.listed()]

    @app.get("/runs/{name}/report.html", response_class=Response, responses=PAGE)
    def report(name: Name) -> FileResponse:
        """The report of a run, as its folder has it."""
        return page_in(found(runs.names(), name, NO_RUN) / REPORT)

    @app.get("/runs/{name}/thumbnail.svg", response_class=Response, responses=told_as("image/svg+xml"))
    def picture(name: Name) -> Response:
        """A small picture of a run from above."""
        path = found(runs.names(), name, NO_RUN)
        svg = thumbnail(path, (path / REPORT).stat().st_mtime)
        policy = {"content-security-policy": "default-src 'none'; style-src 'unsafe-inline'"}
        return Response(svg, media_type="image/svg+xml", headers=policy)

    @app.get("/compare", response_class=Response, responses=PAGE)
    def compare(first: OtherName, second: OtherName) -> HTMLResponse:
        """Two runs drawn together; two of different scenes as their reports, side by side."""
        known = runs.names()
        paths = [found(known, name, NO_RUN) for name in (first, second)]
        page = _comparison([read_run_folder(path) for path in paths])
        return HTMLResponse(two_reports(first, second)) if page is None else HTMLResponse(page, headers=IN_REPORT)


def _comparison(both: list[Run]) -> str | None:
    """The page of two runs of one scene; None where they are not."""
    with TemporaryDirectory() as directory:
        path = Path(directory) / "compare.html"
        try:
            write_comparison(both, path)
        except ValueError:
            return None
        return path.read_text(encoding="utf-8")
