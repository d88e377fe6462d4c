"""One HTML file with all that it needs in it, so that it opens from disk and can be sent.

What is written into it cannot run: words are escaped, "<" never stands in the document as it is, and a content security
policy allows the page's own scripts alone, by their hashes, and no network at all.
"""

import json
from base64 import b64encode
from collections.abc import Sequence
from dataclasses import dataclass
from hashlib import sha256
from importlib.resources import files
from string import Template
from typing import Any


@dataclass(frozen=True)
class Asset:
    """A file beside the modules of a package."""

    package: str
    path: str

    @property
    def text(self) -> str:
        """What is in it."""
        return files(self.package).joinpath(self.path).read_text(encoding="utf-8")


def single_file(
    template: Asset, styles: Sequence[Asset], scripts: Sequence[Asset], content: dict[str, Any], **words: str
) -> str:
    """The text of a page.

    Args:
        template: with a place for policy, styles, document, scripts and each of the words.
        styles: in their order.
        scripts: each uses only those before it.
        content: the document, which is all that the scripts know.
        words: HTML by the name of its place, whatever comes from outside being escaped in it.
    """
    codes = [each.text for each in scripts]
    return Template(template.text).substitute(
        words,
        policy=_policy(codes),
        styles="".join(f"<style>\n{each.text}</style>\n" for each in styles),
        document=embedded(content),
        scripts="".join(f"<script>{code}</script>\n" for code in codes),
    )


def embedded(content: dict[str, Any]) -> str:
    """A document as JSON that can stand between script tags, whatever words are in it."""
    text = json.dumps(content, allow_nan=False, separators=(",", ":"))  # other letters than ASCII are escaped as well
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def _policy(scripts: Sequence[str]) -> str:
    hashes = " ".join(f"'sha256-{b64encode(sha256(script.encode()).digest()).decode()}'" for script in scripts)
    return f"default-src 'none'; style-src 'unsafe-inline'; script-src {hashes}"
