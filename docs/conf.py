"""The documentation site: `make docs` builds it under out/docs."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import groundslab

if TYPE_CHECKING:
    from sphinx.application import Sphinx

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools"))

import draw_imports  # noqa: E402

project = "groundslab"
author = "the groundslab developers"
copyright = "the groundslab developers, MIT license"  # noqa: A001
version = release = groundslab.__version__

extensions = [
    "myst_nb",  # Markdown; pages with code cells are executed
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "numpydoc",
    "sphinx_copybutton",
    "sphinx_design",  # tabs
    "sphinx_remove_toctrees",
]
exclude_patterns = ["_templates"]
templates_path = ["_templates"]

html_theme = "furo"
html_title = f"groundslab {version}"
html_static_path: list[str] = []
html_show_copyright = False
html_extra_path = ["groundslab.schema.json", "study.schema.json"]
html_theme_options = {"top_of_page_buttons": []}
# the theme writes the whole tree of pages on each of them, which takes most of a build; these stand on pages of lists
remove_from_toctrees = ["api/*", "decisions/[0-9]*", "verification/[!i]*"]

myst_heading_anchors = 4
myst_enable_extensions = ["colon_fence", "deflist"]
copybutton_exclude = ".linenos, .gp, .go"
copybutton_prompt_text = r"\$ |>>> |\.\.\. "
copybutton_prompt_is_regexp = True

# every cell runs, and one that fails ends the build
nb_execution_mode = "cache"
nb_execution_cache_path = "../out/docs-cache"
nb_execution_timeout = 300
nb_execution_in_temp = True
nb_merge_streams = True
nb_execution_raise_on_error = True
nb_execution_show_tb = True

autosummary_generate = True
autodoc_typehints = "none"  # numpydoc's sections say them
numpydoc_show_class_members = False

#: Pages of the repository's root that are pages of the site, too.
ROOT_PAGES = {"contributing": "CONTRIBUTING.md", "changelog": "CHANGELOG.md", "security": "SECURITY.md"}


def read_page(app: Sphinx, docname: str, source: list[str]) -> None:  # noqa: ARG001
    """Replace the pages that stand for those of the root by these, and links to them by links to the pages."""
    up = "../" * docname.count("/")
    if docname in ROOT_PAGES:
        source[0] = (ROOT / ROOT_PAGES[docname]).read_text(encoding="utf-8").replace("](docs/", "](")
        up = ""
    if docname == "architecture":
        source[0] = re.sub(
            r"```mermaid\n.*?```\n", "![Imports between folders](imports.svg)\n", source[0], flags=re.DOTALL
        )
    for page, name in ROOT_PAGES.items():
        source[0] = re.sub(rf"\]\((\.\./)*{name}", f"]({up}{page}.md", source[0])


def setup(app: Sphinx) -> None:
    """Read pages as above; draw the diagram of imports, which hosting services draw from its text."""
    app.connect("source-read", read_page)
    draw_imports.draw(str(ROOT / "docs" / "imports.svg"))
