"""The documentation as pages of the workbench's own server, made from the Markdown files that the package contains."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Mapping
from functools import cache, lru_cache
from html import escape
from itertools import pairwise
from pathlib import Path
from string import Template
from typing import TYPE_CHECKING

from groundslab.workbench.help.examples import STATIC

if TYPE_CHECKING:
    from markdown_it.token import Token

#: Where the server has the pages.
ROOT = "/docs/"
#: Files of the pages themselves, beside this module.
_OWN = ("documentation.css", "documentation.js")
_IMAGES = (".png", ".svg")
_FRONT = re.compile(r"\A---\n.*?\n---\n", re.DOTALL)
_TOCTREE = re.compile(r"```\{toctree\}\n(.*?)```", re.DOTALL)
_CAPTION = re.compile(r":caption: (.+)")
_KIND = re.compile(r'kind = "([^"]+)"')
_HIDDEN = re.compile(r"^:tags: \[[^\]]*remove-(?:cell|input)", re.MULTILINE)
_OPTION = re.compile(r"(?:^:[a-z-]+:[^\n]*\n)+\n?", re.MULTILINE)
_ROLE = re.compile(r"\{(?:doc|download)\}`([^`]*)`")
_FENCE = re.compile(r"^:{3,}.*$", re.MULTILINE)
_PAGE = Template(
    """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>$title – groundslab</title>
<link rel="icon" href="/icon.svg">
<link rel="stylesheet" href="${root}documentation.css">
<script src="${root}documentation.js"></script>
</head>
<body>
<nav aria-label="documentation">$navigation</nav>
<main>$body</main>
</body>
</html>
"""
)


@cache
def list_pages() -> Mapping[str, Path]:
    """Return the files of the pages by name, such as ``howto/draw_a_slab``."""
    folder = STATIC / "docs"
    return {path.relative_to(folder).with_suffix("").as_posix(): path for path in sorted(folder.rglob("*.md"))}


@cache
def list_files() -> Mapping[str, Path]:
    """Return the files that pages load, by name: pictures, style, script."""
    folder = STATIC / "docs"
    images = {path.relative_to(folder).as_posix(): path for path in folder.rglob("*") if path.suffix in _IMAGES}
    return {**images, **{name: Path(__file__).with_name(name) for name in _OWN}}


@lru_cache(maxsize=64)
def render_page(name: str) -> str | None:
    """Return a page as HTML, None if there is none of that name."""
    path = list_pages().get(name)
    if path is None:
        return None
    text = path.read_text(encoding="utf-8")
    body = _render(_simplify(text), name)
    return _PAGE.substitute(title=escape(_find_title(text)), root=ROOT, navigation=_navigate(name), body=body)


def render_missing(name: str) -> str:
    """Return the page for a name that no page has."""
    reason = "There is no such page." if list_pages() else "This installation has no documentation; make pages adds it."
    return _PAGE.substitute(
        title="Not found", root=ROOT, navigation=_navigate(name), body=f"<h1>Not found</h1><p>{reason}</p>"
    )


def _find_title(text: str) -> str:
    """Return the title of a page."""
    match = re.search(r"^# (.+)$", text, re.MULTILINE)
    return match[1].replace("`", "") if match else ""


def _navigate(present: str) -> str:
    """Return the list of pages as on the site, without those that are not here."""
    pages = list_pages()
    if "index" not in pages:
        return ""
    parts = [_link("index", "groundslab", present)]
    for tree in _TOCTREE.findall(pages["index"].read_text(encoding="utf-8")):
        names = [line for line in tree.splitlines() if line in pages]
        titles = {name: _find_title(pages[name].read_text(encoding="utf-8")) for name in names}
        items = "".join(f"<li>{_link(name, title, present)}</li>" for name, title in titles.items())
        if items:
            caption = _CAPTION.search(tree)
            parts.append(f"<h2>{escape(caption[1]) if caption else ''}</h2><ul>{items}</ul>")
    return "".join(parts)


def _link(name: str, title: str, present: str) -> str:
    current = ' aria-current="page"' if name == present else ""
    return f'<a href="{ROOT}{name}"{current}>{escape(title)}</a>'


def _simplify(text: str) -> str:
    """Return a page without what only the site has: options of cells, lists of pages, tabs, roles."""
    text = _TOCTREE.sub("", _FRONT.sub("", text))
    text = re.sub(r"```\{(?:code-cell|eval-rst)\}[^\n]*\n(.*?)```", _show_cell, text, flags=re.DOTALL)
    return _FENCE.sub("", _ROLE.sub(r"`\1`", text))


def _show_cell(match: re.Match[str]) -> str:
    """Return a cell that is run on the site as plain code, nothing for one that the site hides."""
    if _HIDDEN.search(match[1]) or match[0].startswith("```{eval-rst}"):
        return ""
    return f"```\n{_OPTION.sub('', match[1], count=1)}```"


def _render(text: str, name: str) -> str:
    """Return Markdown as HTML, with links between the pages and anchors at headings and keys."""
    from markdown_it import MarkdownIt

    parser = MarkdownIt("commonmark").enable("table")
    tokens = parser.parse(text)
    _add_heading_anchors(tokens)
    _add_key_anchors(tokens)
    for token in tokens:
        if token.children is not None:
            token.children = list(_resolve_links(token.children, posixpath.dirname(name)))
    page = str(parser.renderer.render(tokens, parser.options, {}))
    # what scrolls by itself must be reached by keys
    return re.sub(r"<(pre|table)>", r'<\1 tabindex="0">', page)


def _add_heading_anchors(tokens: list[Token]) -> None:
    """Give headings the ids that the site gives them."""
    for opening, inline in pairwise(tokens):
        if opening.type == "heading_open":
            words = re.sub(r"[^\w\s-]", "", inline.content.lower())
            opening.attrSet("id", re.sub(r"\s+", "-", words.strip()))


def _add_key_anchors(tokens: list[Token]) -> None:
    """Give the rows of keys ids: the steps of the key, then the kinds of the tables above it."""
    kinds, taken = list[str](), set[str]()
    for index, token in enumerate(tokens):
        if token.type == "heading_open":
            kinds = _KIND.findall(tokens[index + 1].content)
        if token.type == "tr_open" and (match := re.fullmatch(r"`([\w.\[\]]+)`", tokens[index + 2].content)):
            keys = match[1].replace("[]", "").split(".")
            anchor = "-".join(["key", *keys, *(kind.replace(" ", "-") for kind in kinds)])
            if anchor not in taken:
                token.attrSet("id", anchor)
            taken.add(anchor)


def _resolve_links(children: list[Token], folder: str) -> Iterator[Token]:
    """Yield the parts of a line, links as the server has them; those to what is not here become plain text."""
    dropped = 0
    for token in children:
        if token.type == "link_open":
            target = _resolve(str(token.attrGet("href") or ""), folder)
            dropped += target is None
            if target is None:
                continue
            token.attrSet("href", target)
        elif token.type == "link_close" and dropped:
            dropped -= 1
            continue
        elif token.type == "image":
            path = posixpath.normpath(posixpath.join(folder, str(token.attrGet("src"))))
            token.attrSet("src", ROOT + path)
            if path not in list_files():
                continue
        yield token


def _resolve(href: str, folder: str) -> str | None:
    """Return the address of a link, None if it leads to something that is not here."""
    if href.startswith(("https://", "http://", "#")):
        return href
    path, mark, anchor = href.partition("#")
    name = posixpath.normpath(posixpath.join(folder, path)).removesuffix(".md")
    return f"{ROOT}{name}{mark}{anchor}" if name in list_pages() else None
