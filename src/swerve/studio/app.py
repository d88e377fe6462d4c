"""The studio as an application: its pages, finished runs, maps, comparisons, scenes and jobs, behind its guard.

Its API is told at /api/openapi.json.
"""

from collections.abc import AsyncIterator, Collection
from contextlib import asynccontextmanager
from pathlib import Path

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse

from swerve import __version__
from swerve.errors import InputError, one_line
from swerve.studio.answers import Fault
from swerve.studio.guard import Guard
from swerve.studio.jobs import Jobs
from swerve.studio.routes.common import Told
from swerve.studio.routes.comparisons import add_comparisons
from swerve.studio.routes.jobs import add_jobs
from swerve.studio.routes.maps import add_maps
from swerve.studio.routes.pages import add_pages
from swerve.studio.routes.runs import add_runs
from swerve.studio.routes.scenes import add_scenes
from swerve.studio.runs import Runs


def studio_app(directory: Path, hosts: Collection[str], jobs: Jobs | None = None) -> FastAPI:
    """The studio over a folder of finished runs.

    Args:
        directory: with the runs; new ones go there too.
        hosts: by which it may be called, such as "127.0.0.1:8000".
        jobs: that make the new runs; by default such with the usual limits.
    """
    runs = Runs(directory)
    jobs = jobs or Jobs(runs)
    app = _application(jobs)
    app.add_middleware(Guard, hosts=hosts)
    app.add_exception_handler(RequestValidationError, _tell_validation)
    app.add_exception_handler(InputError, _tell_input)
    add_pages(app)
    add_runs(app, runs)
    add_maps(app, directory)
    add_comparisons(app, directory)
    add_scenes(app)
    add_jobs(app, jobs)
    return app


def _application(jobs: Jobs) -> FastAPI:
    """An application without routes, in whose life jobs are made."""

    @asynccontextmanager
    async def life(app: FastAPI) -> AsyncIterator[None]:
        jobs.start()
        yield
        jobs.stop()

    faults: Told = {code: {"model": Fault} for code in (400, 403, 408, 413, 422)}
    return FastAPI(
        title="swerve studio",
        version=__version__,
        openapi_url="/api/openapi.json",
        docs_url=None,
        redoc_url=None,
        lifespan=life,
        responses=faults,
    )


def _tell_input(request: Request, error: Exception) -> JSONResponse:
    return JSONResponse({"detail": str(error)}, 422)


def _tell_validation(request: Request, error: Exception) -> JSONResponse:
    """The first fault in a line: a request's own words are not repeated, as they may be no text at all."""
    assert isinstance(error, RequestValidationError)
    first = error.errors()[0]
    where = ".".join(str(part) for part in first["loc"])
    return JSONResponse({"detail": f"{one_line(where)}: {one_line(str(first['msg']), 200)}"}, 422)
