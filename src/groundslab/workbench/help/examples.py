"""The examples of the repository, which the package contains: opened as new cases."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

from groundslab.case import casefile
from groundslab.errors import InputError, Issue
from groundslab.schema.wording import describe, suggestion

#: Copies of the repository's files, which the build makes.
STATIC = Path(__file__).with_name("static")
#: What the page draws of an example.
_DRAWN = ("plate", "plates", "columns")
_COMMENTS = re.compile(r"(?:#[^\n]*\n)*")


@cache
def list_examples() -> list[dict[str, Any]]:
    """Return name, title, one line about each example, and what its picture shows, by title."""
    examples = [_describe(path) for path in sorted((STATIC / "examples").glob("*.toml"))]
    return sorted(examples, key=lambda example: str(example["title"]).lower())


def read_example(name: str) -> str:
    """Return the text of an example; raises InputError for a name that none has."""
    names = [str(example["name"]) for example in list_examples()]
    if name not in names:
        raise InputError([Issue("the example", describe(name), "the name of an example", suggestion(name, names))])
    return (STATIC / "examples" / f"{name}.toml").read_text(encoding="utf-8")


def _describe(path: Path) -> dict[str, Any]:
    """Return the description of an example for the page."""
    text = path.read_text(encoding="utf-8")
    data = casefile.tables(text, path.name)
    drawn = {key: data[key] for key in _DRAWN if key in data}
    return {"name": path.stem, "title": data["title"], "about": _first_sentence(text), "data": drawn}


def _first_sentence(text: str) -> str:
    """Return the first sentence of the comment at the start of a text."""
    match = _COMMENTS.match(text)
    comment = "" if match is None else match.group()
    words = " ".join(line.removeprefix("#").strip() for line in comment.splitlines())
    return re.split(r"(?<=\.)\s", words, maxsplit=1)[0]
