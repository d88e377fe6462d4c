"""What the studio answers: pages, finished runs, maps, scenes, and jobs. Its API is told at /api/openapi.json."""

from collections.abc import AsyncIterator, Collection
from contextlib import asynccontextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated, Any, Final

from fastapi import FastAPI, Query, Request, Response
from fastapi import Path as PathValue
from fastapi.exceptions import RequestValidationError
from fastapi.responses import FileResponse, HTMLResponse, JSONResponse
from starlette.exceptions import HTTPException

from swerve import __version__
from swerve.errors import InputError, one_line, unknown
from swerve.report.exports.folder import read_run_folder
from swerve.report.page import write_comparison
from swerve.simulate import CONTROLLERS, PLANTS, Run
from swerve.simulate.assemble import controller_named, plant_named
from swerve.studio.answers import Choices, Fault, JobTold, NewJob, RunListed, ScenarioListed, SceneToml
from swerve.studio.guard import Guard
from swerve.studio.jobs import Job, Jobs, QueueFull
from swerve.studio.maps import Maps, add_maps
from swerve.studio.pages import ASSETS, asset, two_reports
from swerve.studio.runs import REPORT, Runs
from swerve.studio.scene import Moved, library, moved_toml, read_scene, start_of
from swerve.studio.thumbnail import thumbnail
from swerve.studio.worker import Order

NO_RUN: Final = "there is no run of this name in the folder"
NO_JOB: Final = "there is no job of this number"
IN_REPORT: Final = {  # a report has a stricter policy of its own; a file that only looks like one has this
    "content-security-policy": "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'self'"
}

RunName = Annotated[str, PathValue(min_length=1, max_length=255)]
OtherName = Annotated[str, Query(min_length=1, max_length=255)]
JobNumber = Annotated[int, PathValue(ge=1, le=2**31)]


def studio_app(directory: Path, hosts: Collection[str], jobs: Jobs | None = None) -> FastAPI:
    """The studio over a folder of finished runs.

    Args:
        directory: with the runs; new ones go there too.
        hosts: by which it may be called, such as "127.0.0.1:8000".
        jobs: that make the new runs; by default such with the usual limits.
    """
    runs = Runs(directory)
    jobs = jobs or Jobs(runs)

    @asynccontextmanager
    async def life(app: FastAPI) -> AsyncIterator[None]:
        jobs.start()
        yield
        jobs.stop()

    faults: dict[int | str, dict[str, Any]] = {code: {"model": Fault} for code in (400, 403, 408, 413, 422)}
    app = FastAPI(
        title="swerve studio",
        version=__version__,
        openapi_url="/api/openapi.json",
        docs_url=None,
        redoc_url=None,
        lifespan=life,
        responses=faults,
    )
    app.add_middleware(Guard, hosts=hosts)
    app.add_exception_handler(RequestValidationError, _tell_validation)
    app.add_exception_handler(InputError, _tell_input)
    _add_pages(app)
    _add_runs(app, runs)
    add_maps(app, Maps(directory), IN_REPORT)
    _add_scenes(app)
    _add_jobs(app, jobs)
    return app


def _add_pages(app: FastAPI) -> None:
    @app.get("/", include_in_schema=False)
    def listing() -> HTMLResponse:
        return HTMLResponse(asset("list.html"))

    @app.get("/studio", include_in_schema=False)
    def studio() -> HTMLResponse:
        return HTMLResponse(asset("studio.html"))

    @app.get("/assets/{name}", include_in_schema=False)
    def page_asset(name: str) -> Response:
        if name not in ASSETS:
            raise HTTPException(404, "there is no such file")
        return Response(asset(name), media_type=ASSETS[name].kind)


def _add_runs(app: FastAPI, runs: Runs) -> None:
    missing: dict[int | str, dict[str, Any]] = {404: {"model": Fault}}

    @app.get("/api/runs")
    def list_runs() -> list[RunListed]:
        """All finished runs of the folder, the latest first."""
        return [RunListed(**each) for each in runs.listed()]

    @app.get("/runs/{name}/report.html", response_class=Response, responses={**missing, **_told_as("text/html")})
    def report(name: RunName) -> FileResponse:
        """The report of a run, as its folder has it."""
        return FileResponse(_found(runs, name) / REPORT, media_type="text/html", headers=IN_REPORT)

    @app.get("/runs/{name}/thumbnail.svg", response_class=Response, responses={**missing, **_told_as("image/svg+xml")})
    def picture(name: RunName) -> Response:
        """A small picture of a run from above."""
        path = _found(runs, name)
        svg = thumbnail(path, (path / REPORT).stat().st_mtime)
        policy = {"content-security-policy": "default-src 'none'; style-src 'unsafe-inline'"}
        return Response(svg, media_type="image/svg+xml", headers=policy)

    @app.get("/compare", response_class=Response, responses={**missing, **_told_as("text/html")})
    def compare(first: OtherName, second: OtherName) -> HTMLResponse:
        """Two runs drawn together; two of different scenes as their reports, side by side."""
        paths = [_found(runs, name) for name in (first, second)]
        page = _comparison([read_run_folder(path) for path in paths])
        return HTMLResponse(two_reports(first, second)) if page is None else HTMLResponse(page, headers=IN_REPORT)


def _told_as(kind: str) -> dict[int | str, dict[str, Any]]:
    """The description of a success that is no JSON, but of this media type."""
    return {200: {"content": {kind: {}}}}


def _add_scenes(app: FastAPI) -> None:
    @app.get("/api/choices")
    def choices() -> Choices:
        """Scenarios, controllers and plants."""
        scenarios = [
            ScenarioListed(name=name, description=each.description, start=start_of(each))
            for name, each in library().items()
        ]
        return Choices(version=__version__, scenarios=scenarios, controllers=[*CONTROLLERS], plants=[*PLANTS])

    @app.post("/api/scene")
    def scene(moved: Moved) -> SceneToml:
        """A scenario of the library with something moved, as a TOML document."""
        return SceneToml(toml=moved_toml(moved))


def _add_jobs(app: FastAPI, jobs: Jobs) -> None:
    missing: dict[int | str, dict[str, Any]] = {404: {"model": Fault}}

    @app.post("/api/jobs", status_code=202, responses={429: {"model": Fault}})
    def new_job(wanted: NewJob) -> JobTold:
        """Make a run, as soon as those before it are done."""
        _check(wanted)
        try:
            return JobTold.of(jobs.add(Order(**wanted.model_dump())))
        except QueueFull as error:
            raise HTTPException(429, str(error)) from error

    @app.get("/api/jobs/{number}", responses=missing)
    def job(number: JobNumber) -> JobTold:
        """How far a job is."""
        return _told(jobs.get(number))

    @app.delete("/api/jobs/{number}", responses=missing)
    def cancel(number: JobNumber) -> JobTold:
        """Cancel a job; one that is over stays as it is."""
        return _told(jobs.cancel(number))


def _check(wanted: NewJob) -> None:
    """InputError for a run that cannot be made, before it waits for its turn."""
    for kind, name, known in (("controller", wanted.controller, CONTROLLERS), ("plant", wanted.plant, PLANTS)):
        if name not in known:
            raise InputError(unknown(kind, name, known))
    scenario = read_scene(wanted.toml)
    controller_named(wanted.controller, scenario, wanted.plant)
    plant_named(wanted.plant, scenario)


def _told(job: Job | None) -> JobTold:
    if job is None:
        raise HTTPException(404, NO_JOB)
    return JobTold.of(job)


def _found(runs: Runs, name: str) -> Path:
    path = runs.path(name)
    if path is None:
        raise HTTPException(404, NO_RUN)
    return path


def _comparison(both: list[Run]) -> str | None:
    """The page of two runs of one scene; None where they are not."""
    with TemporaryDirectory() as directory:
        path = Path(directory) / "compare.html"
        try:
            write_comparison(both, path)
        except ValueError:
            return None
        return path.read_text(encoding="utf-8")


def _tell_input(request: Request, error: Exception) -> JSONResponse:
    return JSONResponse({"detail": str(error)}, 422)


def _tell_validation(request: Request, error: Exception) -> JSONResponse:
    """The first fault in a line: a request's own words are not repeated, as they may be no text at all."""
    assert isinstance(error, RequestValidationError)
    first = error.errors()[0]
    where = ".".join(str(part) for part in first["loc"])
    return JSONResponse({"detail": f"{one_line(where)}: {one_line(str(first['msg']), 200)}"}, 422)
