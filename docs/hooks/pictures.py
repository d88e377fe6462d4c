"""Pictures of a run's report and of the studio, photographed in a real browser: `make pictures`.

    python docs/hooks/pictures.py RUNS DIRECTORY

RUNS holds finished runs, `paper` among them. It writes report-light.png, report-dark.png, report-narrow.png,
report-view.png, studio-list.png, studio-light.png and studio-narrow.png.
"""

import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from playwright.sync_api import expect, sync_playwright

NAMES = ("chromium", "chromium-browser", "google-chrome")
INSTANT = 0.7  # that is shown [s]
WIDE, NARROW = {"width": 1280, "height": 1500}, {"width": 390, "height": 844}
SCREEN = {"width": 1280, "height": 900}
PICTURES: dict[str, dict[str, Any]] = {
    "report-light": {"viewport": WIDE, "color_scheme": "light"},
    "report-dark": {"viewport": WIDE, "color_scheme": "dark"},
    "report-narrow": {"viewport": NARROW, "color_scheme": "light", "device_scale_factor": 2},
}


def main(runs: Path, directory: Path) -> None:
    """Take every picture."""
    report = runs / "paper" / "report.html"
    with sync_playwright() as driver:
        own = next(filter(None, map(shutil.which, NAMES)), None)
        chromium = driver.chromium.launch(executable_path=own, args=["--no-sandbox"] if os.geteuid() == 0 else [])
        for name, options in PICTURES.items():
            page = _opened(chromium, report, options)
            page.screenshot(path=directory / f"{name}.png")
        wide = _opened(chromium, report, {"viewport": WIDE, "device_scale_factor": 2})
        wide.locator("#view").screenshot(path=directory / "report-view.png")
        with _served(runs) as address:
            _studio(chromium, address, directory)
        chromium.close()


def _opened(chromium: Any, report: Path, options: dict[str, Any]) -> Any:
    page = chromium.new_context(**options).new_page()
    page.goto(f"{report.resolve().as_uri()}#t={INSTANT}")
    page.locator("#time:not(:empty)").wait_for(state="attached")
    return page


@contextmanager
def _served(runs: Path) -> Iterator[str]:
    """The address of a studio over the runs."""
    command = [sys.executable, "-m", "swerve", "view", str(runs), "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout
        yield process.stdout.readline().split()[0]
        process.send_signal(signal.SIGINT)


def _studio(chromium: Any, address: str, directory: Path) -> None:
    listing = chromium.new_context(viewport=SCREEN).new_page()
    listing.goto(address, wait_until="networkidle")
    listing.screenshot(path=directory / "studio-list.png")
    for name, options in (("studio-light", {"viewport": SCREEN}), ("studio-narrow", PICTURES["report-narrow"])):
        page = chromium.new_context(**options, reduced_motion="reduce").new_page()
        page.goto(f"{address}studio")
        expect(page.locator("#toml")).not_to_have_value("")
        page.locator("#number-speed").fill("80")
        page.locator("#number-friction").fill("0.7")
        page.locator("#run").click()
        expect(page.locator("#status")).to_have_text("Done", timeout=60_000)
        scrub = page.frame_locator("#frame").locator("#scrub")
        scrub.fill(str(INSTANT))
        page.evaluate("scrollTo(0, 0)")
        page.wait_for_timeout(300)
        page.screenshot(path=directory / f"{name}.png")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
