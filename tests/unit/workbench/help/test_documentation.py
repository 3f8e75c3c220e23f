"""The documentation as pages: all links lead somewhere, every key of a case file has a place."""

from __future__ import annotations

import re
from collections.abc import Iterator
from html import unescape

import pytest

from groundslab.model.model import json_schema
from groundslab.workbench.help import documentation
from helpers.help_files import copied_help


@pytest.fixture(scope="module", autouse=True)
def pages(tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, str]]:
    """Return all pages by name."""
    with copied_help(tmp_path_factory.mktemp("help") / "static"):
        yield {name: documentation.render_page(name) or "" for name in documentation.list_pages()}


def test_all_links_lead_to_pages_and_anchors(pages: dict[str, str]) -> None:
    """A link within the documentation leads to a page, an anchor to an element there, a picture to a file."""
    ids = {name: set(re.findall(r' id="([^"]+)"', page)) for name, page in pages.items()}
    assert len(pages) > 40
    found = 0
    for name, page in pages.items():
        for link in map(unescape, re.findall(r'<a href="([^"]+)"', page)):
            path, _, anchor = link.partition("#")
            if not path.startswith("http"):
                target = path.removeprefix(documentation.ROOT) if path else name
                assert target in pages, (name, link)
                assert not anchor or anchor in ids[target], (name, link)
                found += bool(anchor)
        for source in re.findall(r'<img src="([^"]+)"', page):
            assert source.removeprefix(documentation.ROOT) in documentation.list_files(), (name, source)
    assert found > 5  # anchors


def test_nothing_of_the_markup_of_the_site_is_left(pages: dict[str, str]) -> None:
    """Cells, roles, tabs and the heads of notebooks are gone or plain."""
    for name, page in pages.items():
        assert not re.search(r"\{(?:code-cell|toctree|doc|download|tab-item)\}|file_format:|remove-cell", page), name


def find_keys(schema: dict[str, object], part: dict[str, object], path: str) -> Iterator[str]:
    """Yield the anchors of the keys at the top of each table of a case file."""
    properties = part["properties"]
    assert isinstance(properties, dict)
    for name, about in properties.items():
        inner = [about, *about.get("allOf", [])]
        references = [each["$ref"] for each in inner if "$ref" in each]
        if references and not path:
            definitions = schema["definitions"]
            assert isinstance(definitions, dict)
            yield from find_keys(schema, definitions[references[0].rpartition("/")[2]], f"{path}-{name}")
        elif about.get("type") not in ("array", None):
            yield f"key{path}-{name}"


def test_every_key_has_a_place(pages: dict[str, str]) -> None:
    """The keys of plate, mesh, contact and so on have anchors; of kinds each has its own."""
    schema = json_schema()
    keys = list(find_keys(schema, schema, ""))
    assert "key-plate-thickness" in keys
    assert len(keys) > 50
    for key in [*keys, "key-loads-P-point", "key-ground-layers-E-vlasov", "key-plate-outline-radius-circle"]:
        assert f' id="{key}"' in pages["input"], key


def test_pages_that_are_not_there() -> None:
    """There is no page of another name, and what is shown instead escapes nothing into the page."""
    assert documentation.render_page("../secret") is None
    assert "There is no such page" in documentation.render_missing("<script>")
    assert "<script>" not in documentation.render_missing("<script>").replace("<script src", "")
