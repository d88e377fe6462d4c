"""The studio's own pages: HTML, scripts and styles beside this file, and the styles that they share with a report."""

from dataclasses import dataclass
from html import escape
from importlib.resources import files
from typing import Final
from urllib.parse import quote


@dataclass(frozen=True)
class Asset:
    """A file of a page.

    Attributes:
        package: in which it is.
        path: in that package.
        kind: its media type.
    """

    package: str
    path: str
    kind: str


REPORT_PAGE: Final = "swerve.report.page"
STUDIO: Final = "swerve.studio"
CSS: Final = "text/css; charset=utf-8"
SCRIPT: Final = "text/javascript; charset=utf-8"
HTML: Final = "text/html; charset=utf-8"
ASSETS: Final = {
    "palette.css": Asset(REPORT_PAGE, "css/palette.css", CSS),
    "style.css": Asset(REPORT_PAGE, "css/style.css", CSS),
    "studio.css": Asset(STUDIO, "page/studio.css", CSS),
    "common.js": Asset(STUDIO, "page/common.js", SCRIPT),
    "list.js": Asset(STUDIO, "page/list.js", SCRIPT),
    "studio.js": Asset(STUDIO, "page/studio.js", SCRIPT),
    "list.html": Asset(STUDIO, "page/list.html", HTML),
    "studio.html": Asset(STUDIO, "page/studio.html", HTML),
    "two.html": Asset(STUDIO, "page/two.html", HTML),
}


def asset(name: str) -> str:
    """The text of one of the ASSETS."""
    found = ASSETS[name]
    return files(found.package).joinpath(*found.path.split("/")).read_text(encoding="utf-8")


def two_reports(first: str, second: str) -> str:
    """The page that shows the reports of two runs, each in its frame."""
    page = asset("two.html")
    for mark, name in (("FIRST", first), ("SECOND", second)):
        page = page.replace(f"{mark}_PATH", quote(name, safe="")).replace(f"{mark}_NAME", escape(name))
    return page
