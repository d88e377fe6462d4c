"""What goes over the studio's API as JSON, in both directions."""

from pydantic import BaseModel, ConfigDict, Field

from swerve.simulate import DEFAULT_CONTROLLER, DEFAULT_PLANT
from swerve.studio.job import Job, State
from swerve.studio.scene import LONGEST_TOML


class Fault(BaseModel):
    """An answer that something is wrong: what, where, and what would be right."""

    detail: str


class RunListed(BaseModel):
    """A finished run, in SI; all is null but name, time and fault where it cannot be read."""

    name: str
    finished: float
    scenario: str | None
    controller: str | None
    plant: str | None
    seed: int | None
    outcome: str | None
    decision: str | None
    min_clearance: float | None
    impact_speed: float | None
    fault: str | None


class PageListed(BaseModel):
    """A folder with pages, of a map or a comparison: its name, and when it was finished, in seconds since 1970."""

    name: str
    finished: float


class ScenarioListed(BaseModel):
    """A scenario of the library or member of a family, with where what can be moved is, in SI."""

    name: str
    description: str
    start: dict[str, float | None]


class FamilyListed(BaseModel):
    """A family of scenarios: the form of its members' names, what happens in them, and which there are."""

    pattern: str
    title: str
    members: list[str]


class Choices(BaseModel):
    """What there is to choose from; `scenarios` are those of the library, then the members of all families."""

    version: str
    scenarios: list[ScenarioListed]
    families: list[FamilyListed]
    controllers: list[str]
    plants: list[str]


class SceneToml(BaseModel):
    """A scene as a TOML document."""

    toml: str


class NewJob(BaseModel):
    """A run to be made."""

    model_config = ConfigDict(extra="forbid")

    toml: str = Field(max_length=LONGEST_TOML)
    controller: str = Field(DEFAULT_CONTROLLER, max_length=100)
    plant: str = Field(DEFAULT_PLANT, max_length=100)
    seed: int = Field(0, ge=0, lt=10**15, strict=True)


class JobTold(BaseModel):
    """How far a job is; `run` is the name of its folder once it is done."""

    number: int
    state: State
    share: float
    message: str
    run: str | None

    @classmethod
    def of(cls, job: Job) -> "JobTold":
        """What is told of a job."""
        return cls(number=job.number, state=job.state, share=job.share, message=job.message, run=job.run)
