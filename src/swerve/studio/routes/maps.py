"""Maps: their list, pages, and the pages that replay their points."""

from pathlib import Path
from typing import Final

from fastapi import FastAPI, Response
from fastapi.responses import FileResponse

from swerve.studio.answers import PageListed
from swerve.studio.folders import MAP, latest_first, maps, pages
from swerve.studio.routes.common import PAGE, Name, found, page_in

REPLAYS: Final = "replays"
NO_MAP: Final = "there is no map of this name in the folder"
NO_REPLAY: Final = "there is no such page of this map"


def add_maps(app: FastAPI, directory: Path) -> None:
    """Add what is answered about the maps of a folder."""

    @app.get("/api/maps")
    def list_maps() -> list[PageListed]:
        """All maps of the folder, the latest first."""
        return [PageListed(name=path.name, finished=at) for path, at in latest_first(maps(directory), MAP)]

    @app.get("/maps/{name}/map.html", response_class=Response, responses=PAGE)
    def page(name: Name) -> FileResponse:
        """The page of a map, as its folder has it."""
        return page_in(found(maps(directory), name, NO_MAP) / MAP)

    @app.get("/maps/{name}/replays/{replay}", response_class=Response, responses=PAGE)
    def replay_page(name: Name, replay: Name) -> FileResponse:
        """The runs of all controllers in one condition of a map, drawn together."""
        folder = found(maps(directory), name, NO_MAP)
        return page_in(found(pages(folder / REPLAYS), replay, NO_REPLAY))
