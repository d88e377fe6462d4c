"""Ships MathJax with the pages, so that they show their formulas without a network.

One file of the installed package becomes javascripts/mathjax.js of the site: TeX with all its extensions in, SVG out.
"""

from importlib.resources import files
from typing import Any

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

SCRIPT = "javascripts/mathjax.js"


def on_files(pages: Files, config: MkDocsConfig, **_: Any) -> Files:
    """Adds MathJax to what is built."""
    script = files("mathjax") / "static" / "mathjax" / "es5" / "tex-svg-full.js"
    pages.append(File.generated(config, SCRIPT, content=script.read_bytes()))
    return pages
