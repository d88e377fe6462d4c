"""What the routes have in common: names in an address, what is not there, and files that are shown as they are."""

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, Final

from fastapi import Path as PathValue
from fastapi.responses import FileResponse
from starlette.exceptions import HTTPException

from swerve.studio.answers import Fault

Told = dict[int | str, dict[str, Any]]  # what is told of the answers of a route, by their status

MISSING: Final[Told] = {404: {"model": Fault}}
IN_REPORT: Final = {  # a report has a stricter policy of its own; a file that only looks like one has this
    "content-security-policy": "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'self'"
}

Name = Annotated[str, PathValue(min_length=1, max_length=255)]


def told_as(kind: str) -> Told:
    """The answers of a route whose success is no JSON, but of this media type, and that may find nothing."""
    return {**MISSING, 200: {"content": {kind: {}}}}


PAGE: Final = told_as("text/html")


def found(known: Mapping[str, Path], name: str, fault: str) -> Path:
    """What has this name; a status of 404 with the fault where nothing has."""
    if name not in known:
        raise HTTPException(404, fault)
    return known[name]


def page_in(path: Path) -> FileResponse:
    """A page that is a file of the folder, as it is."""
    return FileResponse(path, media_type="text/html", headers=IN_REPORT)
