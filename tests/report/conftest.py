"""Pages of a report in a real browser, from disk."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

WIDE = {"width": 1280, "height": 800}


@pytest.fixture
def opened(browser: Any) -> Iterator[Callable[..., Any]]:
    """Opens a page, and at the end sees that it neither failed, nor complained, nor asked the network for anything."""
    contexts, complaints = [], []

    def open_page(path: Path, address: str = "", **options: Any) -> Any:
        contexts.append(browser.new_context(**{"viewport": WIDE, **options}))
        page = contexts[-1].new_page()
        page.on("console", lambda message: complaints.append(message.text))
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.on("request", lambda request: request.url.startswith("file:") or complaints.append(request.url))
        page.goto(path.as_uri() + address)
        page.locator("#time:empty").wait_for(state="detached")  # where there is a time to show, it is shown
        return page

    yield open_page
    for context in contexts:
        context.close()
    assert complaints == []
