"""The studio's own pages and what they are made of."""

from fastapi import FastAPI, Response
from fastapi.responses import HTMLResponse
from starlette.exceptions import HTTPException

from swerve.studio.pages import ASSETS, asset


def add_pages(app: FastAPI) -> None:
    """Add the list of runs, the studio, and their scripts and styles."""

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
