"""The maps of a folder, with the pages that replay their points, and nothing outside of it."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Final

from fastapi import FastAPI, Response
from fastapi import Path as PathValue
from fastapi.responses import FileResponse
from pydantic import BaseModel
from starlette.exceptions import HTTPException

from swerve.studio.answers import Fault

MAP: Final = "map.html"
REPLAYS: Final = "replays"
NO_MAP: Final = "there is no map of this name in the folder"
NO_REPLAY: Final = "there is no such page of this map"

Name = Annotated[str, PathValue(min_length=1, max_length=255)]


class MapListed(BaseModel):
    """A map: its folder's name, and when it was finished, in seconds since 1970."""

    name: str
    finished: float


@dataclass(frozen=True)
class Maps:
    """A folder with a map's folder in each of some of its own, or that of a single map.

    Attributes:
        directory: where they are.
    """

    directory: Path

    def names(self) -> dict[str, Path]:
        """Each map's folder by its name; links that lead out are no maps of this folder."""
        root = self.directory.resolve()
        inside = [each for each in sorted(root.iterdir()) if each.is_dir() and each.resolve() == each]
        return {each.name: each for each in [root, *inside] if _is_file(each / MAP)}

    def replays(self, name: str) -> dict[str, Path]:
        """The pages of a map's points by their names. A name is looked up, and never part of a path."""
        folder = self.names()[name] / REPLAYS
        inside = folder.iterdir() if folder.is_dir() and not folder.is_symlink() else ()
        return {each.name: each for each in inside if each.suffix == ".html" and _is_file(each)}

    def listed(self) -> list[MapListed]:
        """What the list shows, the latest first."""
        found = [MapListed(name=name, finished=(path / MAP).stat().st_mtime) for name, path in self.names().items()]
        return sorted(found, key=lambda each: each.finished, reverse=True)


def add_maps(app: FastAPI, maps: Maps, headers: Mapping[str, str]) -> None:
    """Add to an application what answers for maps, their pages with these headers."""
    told: dict[int | str, dict[str, Any]] = {404: {"model": Fault}, 200: {"content": {"text/html": {}}}}

    @app.get("/api/maps")
    def list_maps() -> list[MapListed]:
        """All maps of the folder, the latest first."""
        return maps.listed()

    @app.get("/maps/{name}/map.html", response_class=Response, responses=told)
    def page(name: Name) -> FileResponse:
        """The page of a map, as its folder has it."""
        return _page(maps.names(), name, NO_MAP, MAP, headers)

    @app.get("/maps/{name}/replays/{replay}", response_class=Response, responses=told)
    def replay_page(name: Name, replay: Name) -> FileResponse:
        """The runs of all controllers in one condition of a map, drawn together."""
        if name not in maps.names():
            raise HTTPException(404, NO_MAP)
        return _page(maps.replays(name), replay, NO_REPLAY, "", headers)


def _page(known: Mapping[str, Path], name: str, fault: str, file: str, headers: Mapping[str, str]) -> FileResponse:
    if name not in known:
        raise HTTPException(404, fault)
    return FileResponse(known[name] / file, media_type="text/html", headers=dict(headers))


def _is_file(path: Path) -> bool:
    return path.is_file() and not path.is_symlink()
