"""A real browser for the tests of pages: Chromium without a window, the machine's own or Playwright's."""

import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    """Chromium; a test is skipped where there is none."""
    playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed: make test installs it")
    as_root = hasattr(os, "geteuid") and os.geteuid() == 0  # Chromium's sandbox refuses root
    with playwright.sync_playwright() as driver:
        own = next(filter(None, map(shutil.which, NAMES)), None) or driver.chromium.executable_path
        if not Path(own).exists():
            pytest.skip("there is no Chromium: apt-get install chromium, or playwright install chromium")
        chromium = driver.chromium.launch(executable_path=own, args=["--no-sandbox"] if as_root else [])
        yield chromium
        chromium.close()
