"""Scenes: what there is to choose from, and a scenario with something moved."""

from fastapi import FastAPI

from swerve import __version__
from swerve.scenario import FAMILIES
from swerve.simulate import CONTROLLERS, PLANTS
from swerve.studio.answers import Choices, FamilyListed, ScenarioListed, SceneToml
from swerve.studio.scene import Moved, moved_toml, scenarios, start_of


def add_scenes(app: FastAPI) -> None:
    """Add what is answered about scenes."""

    @app.get("/api/choices")
    def choices() -> Choices:
        """Scenarios of the library, families with their members, controllers and plants."""
        return Choices(
            version=__version__,
            scenarios=[
                ScenarioListed(name=name, description=each.description, start=start_of(each))
                for name, each in scenarios().items()
            ],
            families=[
                FamilyListed(pattern=each.pattern, title=each.title, members=[*each.members]) for each in FAMILIES
            ],
            controllers=[*CONTROLLERS],
            plants=[*PLANTS],
        )

    @app.post("/api/scene")
    def scene(moved: Moved) -> SceneToml:
        """A scenario with something moved, as a TOML document."""
        return SceneToml(toml=moved_toml(moved))
