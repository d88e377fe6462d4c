"""Jobs: a run is ordered, asked about, and cancelled."""

from typing import Annotated, Final

from fastapi import FastAPI
from fastapi import Path as PathValue
from starlette.exceptions import HTTPException

from swerve.errors import InputError, unknown
from swerve.simulate import CONTROLLERS, PLANTS
from swerve.simulate.assemble import controller_named, plant_named
from swerve.studio.answers import Fault, JobTold, NewJob
from swerve.studio.job import Job
from swerve.studio.jobs import Jobs, QueueFull
from swerve.studio.routes.common import MISSING
from swerve.studio.scene import read_scene
from swerve.studio.worker import Order

NO_JOB: Final = "there is no job of this number"

JobNumber = Annotated[int, PathValue(ge=1, le=2**31)]


def add_jobs(app: FastAPI, jobs: Jobs) -> None:
    """Add what is answered about jobs."""

    @app.post("/api/jobs", status_code=202, responses={429: {"model": Fault}})
    def new_job(wanted: NewJob) -> JobTold:
        """Make a run, as soon as those before it are done."""
        _check(wanted)
        try:
            return JobTold.of(jobs.add(Order(**wanted.model_dump())))
        except QueueFull as error:
            raise HTTPException(429, str(error)) from error

    @app.get("/api/jobs/{number}", responses=MISSING)
    def job(number: JobNumber) -> JobTold:
        """How far a job is."""
        return _told(jobs.get(number))

    @app.delete("/api/jobs/{number}", responses=MISSING)
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
