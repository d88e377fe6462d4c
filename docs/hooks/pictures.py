"""Pictures of a run's report, photographed in a real browser: `make pictures`.

    python docs/hooks/pictures.py REPORT.html DIRECTORY

writes report-light.png, report-dark.png, report-narrow.png and report-view.png.
"""

import os
import shutil
import sys
from pathlib import Path
from typing import Any

from playwright.sync_api import sync_playwright

NAMES = ("chromium", "chromium-browser", "google-chrome")
INSTANT = 0.7  # that is shown [s]
WIDE, NARROW = {"width": 1280, "height": 1500}, {"width": 390, "height": 844}
PICTURES: dict[str, dict[str, Any]] = {
    "report-light": {"viewport": WIDE, "color_scheme": "light"},
    "report-dark": {"viewport": WIDE, "color_scheme": "dark"},
    "report-narrow": {"viewport": NARROW, "color_scheme": "light", "device_scale_factor": 2},
}


def main(report: Path, directory: Path) -> None:
    """Take every picture."""
    with sync_playwright() as driver:
        own = next(filter(None, map(shutil.which, NAMES)), None)
        chromium = driver.chromium.launch(executable_path=own, args=["--no-sandbox"] if os.geteuid() == 0 else [])
        for name, options in PICTURES.items():
            page = _opened(chromium, report, options)
            page.screenshot(path=directory / f"{name}.png")
        wide = _opened(chromium, report, {"viewport": WIDE, "device_scale_factor": 2})
        wide.locator("#view").screenshot(path=directory / "report-view.png")
        chromium.close()


def _opened(chromium: Any, report: Path, options: dict[str, Any]) -> Any:
    page = chromium.new_context(**options).new_page()
    page.goto(f"{report.resolve().as_uri()}#t={INSTANT}")
    page.wait_for_function("document.getElementById('time').textContent !== ''")
    return page


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
