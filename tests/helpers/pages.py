"""HTML pages as a tree of elements, read by the standard library's parser alone, which knows nothing of templates."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from html.parser import HTMLParser

#: Elements that have no end.
VOID = {"meta", "img", "br", "link", "input", "hr", "base", "col", "source"}


@dataclass
class Element:
    """An element: its name, attributes, what is in it."""

    name: str
    attributes: dict[str, str] = field(default_factory=dict)
    inside: list[Element | str] = field(default_factory=list)

    def all(self, name: str | None = None, **attributes: str) -> Iterator[Element]:
        """Yield the elements within it, in their order, that have a name and attributes."""
        for each in self.inside:
            if isinstance(each, Element):
                fits = all(each.attributes.get(key.rstrip("_")) == value for key, value in attributes.items())
                if fits and name in (None, each.name):
                    yield each
                yield from each.all(name, **attributes)

    def one(self, name: str | None = None, **attributes: str) -> Element:
        """Return the only such element."""
        (found,) = self.all(name, **attributes)
        return found

    @property
    def text(self) -> str:
        """Return all text within it."""
        return "".join(each if isinstance(each, str) else each.text for each in self.inside)


class _Reader(HTMLParser):
    """Builds the tree; an end that does not belong to the innermost open element is an error."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.root = Element("")
        self.open = [self.root]

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Open an element."""
        assert len({name for name, _ in attrs}) == len(attrs), f"an attribute of {tag} stands twice"
        element = Element(tag, {name: value or "" for name, value in attrs})
        self.open[-1].inside.append(element)
        if tag not in VOID:
            self.open.append(element)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Add an element that is closed at once."""
        self.open[-1].inside.append(Element(tag, {name: value or "" for name, value in attrs}))

    def handle_endtag(self, tag: str) -> None:
        """Close an element."""
        assert self.open[-1].name == tag, f"</{tag}> within <{self.open[-1].name}>"
        self.open.pop()

    def handle_data(self, data: str) -> None:
        """Add text."""
        self.open[-1].inside.append(data)

    def handle_comment(self, data: str) -> None:
        """Pages of ours hold no comments but their own checksum."""
        if re.fullmatch(r" groundslab sha256 [0-9a-f]{64} ", data):
            return
        raise AssertionError(f"a comment: {data[:50]}")


def page(text: str) -> Element:
    """Return a page; AssertionError if its elements are not closed in order."""
    reader = _Reader()
    reader.feed(text)
    reader.close()
    assert [element.name for element in reader.open] == [""], "elements are left open"
    return reader.root
