"""Faults with the paths of keys and positions that a form knows its fields by, and lines of the text."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Sequence
from typing import Any

from groundslab.errors import Issue
from groundslab.schema.issues import RelativeIssue
from groundslab.workbench.editing.toml_edits import Layout
from groundslab.workbench.editing.toml_positions import Path

#: What the text is called in messages.
NAME = "the text"
_SYNTAX = re.compile(rf"{NAME}, line (\d+), column (\d+)")
_STEP = re.compile(r'\.?(?:(?P<bare>[A-Za-z0-9_-]+)|(?P<quoted>"(?:[^"\\]|\\.)*")|\[(?P<position>[0-9]+)\])')


def where_of(path: Path) -> str:
    """Return a path as faults write it, positions counted from 1: ``loads[2].x``."""
    return RelativeIssue(path, "", "").issue("").location


def path_of(where: str) -> Path:
    """Return the path that a fault names, positions counted from 0; as much of it as can be read."""
    path: list[str | int] = []
    position = 0
    while match := _STEP.match(where, position):
        position = match.end()
        if match["position"]:
            path.append(int(match["position"]) - 1)
        elif match["quoted"]:
            path.append(tomllib.loads(f"word = {match['quoted']}")["word"])
        else:
            path.append(match["bare"])
    # words such as "the description" are no path
    return tuple(path) if position == len(where) else ()


def issues_to_json(issues: Sequence[Issue]) -> list[dict[str, Any]]:
    """Return faults as data for the page, with the paths of what they speak of."""
    return [
        {
            "where": issue.location,
            "path": list(path_of(issue.location)),
            "got": issue.found,
            "expected": issue.expected,
            "mend": issue.hint,
        }
        for issue in issues
    ]


def text_issues_to_json(issues: Sequence[Issue], layout: Layout | None, is_toml: bool) -> list[dict[str, Any]]:
    """Return the faults of a text as data for the page, with their lines as far as those are known."""
    return [about | _place(issue, layout, is_toml) for issue, about in zip(issues, issues_to_json(issues), strict=True)]


def _place(issue: Issue, layout: Layout | None, is_toml: bool) -> dict[str, Any]:
    """Return where in the text a fault is."""
    if not is_toml:
        place = _SYNTAX.fullmatch(issue.location)
        line, column = (int(place[1]), int(place[2])) if place else (1, 1)
        return {"path": [], "line": line, "column": column}
    line_of_path = None if layout is None else layout.line(path_of(issue.location))
    return {} if line_of_path is None else {"line": line_of_path}
