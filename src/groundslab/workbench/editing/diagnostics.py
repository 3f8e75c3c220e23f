"""Issues as JSON for the page, with the paths of the fields and the lines of the text that they concern."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from groundslab.case.editing.toml_layout import TomlLayout
from groundslab.case.editing.toml_values import Path
from groundslab.errors import Issue
from groundslab.model.remarks.remarks import Remark
from groundslab.schema.issues import RelativeIssue

#: What the text is called in messages.
NAME = "the text"
_SYNTAX = re.compile(rf"{NAME}, line (\d+), column (\d+)")
_STEP = re.compile(r'\.?(?:(?P<bare>[A-Za-z0-9_-]+)|(?P<quoted>"(?:[^"\\]|\\.)*")|\[(?P<index>[0-9]+)\])')


def format_path(path: Path) -> str:
    """Return a path as issues write it, indices counted from 1: ``loads[2].x``."""
    return RelativeIssue(path, "", "").issue("").location


def parse_path(location: str) -> Path:
    """Return the path of an issue's location, indices counted from 0; empty for one in words."""
    path: list[str | int] = []
    position = 0
    while match := _STEP.match(location, position):
        position = match.end()
        if match["index"]:
            path.append(int(match["index"]) - 1)
        elif match["quoted"]:
            path.append(tomllib.loads(f"word = {match['quoted']}")["word"])
        else:
            path.append(match["bare"])
    return tuple(path) if position == len(location) else ()


def issues_to_json(issues: Sequence[Issue]) -> list[dict[str, Any]]:
    """Return issues as data for the page."""
    return [asdict(issue) | {"path": list(parse_path(issue.location))} for issue in issues]


def text_issues_to_json(issues: Sequence[Issue], layout: TomlLayout | None, is_toml: bool) -> list[dict[str, Any]]:
    """Return the issues of a text as data for the page, with their lines where known."""
    return [about | _locate(about["location"], layout, is_toml) for about in issues_to_json(issues)]


def remarks_to_json(remarks: Sequence[Remark], layout: TomlLayout | None) -> list[dict[str, Any]]:
    """Return remarks as data for the page, with their lines where known."""
    return [
        {"location": remark.location, "path": list(remark.path), "words": remark.words, "doubtful": remark.doubtful}
        | _locate(remark.location, layout, is_toml=True)
        for remark in remarks
    ]


def _locate(location: str, layout: TomlLayout | None, is_toml: bool) -> dict[str, Any]:
    """Return the position in the text of an issue's location."""
    if not is_toml:
        place = _SYNTAX.fullmatch(location)
        line, column = (int(place[1]), int(place[2])) if place else (1, 1)
        return {"path": [], "line": line, "column": column}
    number = None if layout is None else layout.find_line(parse_path(location))
    return {} if number is None else {"line": number}
