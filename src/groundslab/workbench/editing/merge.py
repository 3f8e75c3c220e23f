"""Two versions of a case that come from the same one, merged where they changed different tables."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher, unified_diff
from typing import Any

from groundslab.workbench.editing.document import Document

#: Lines of a comparison that are shown at most.
MOST_LINES = 1000


@dataclass(frozen=True, slots=True)
class Comparison:
    """How a file differs from the text of the page, as lines of a unified diff, and both merged, None if impossible."""

    lines: list[str]
    merged: str | None


def compare(base: str | None, mine: str, theirs: str) -> Comparison:
    """Return how the text of a file differs from mine; base is what both come from, None if that is not known."""
    lines = list(unified_diff(mine.splitlines(), theirs.splitlines(), n=1, lineterm=""))[2:]
    shown = lines if len(lines) <= MOST_LINES else [*lines[:MOST_LINES], "…"]
    return Comparison(shown, None if base is None else merge(base, mine, theirs))


def merge(base: str, mine: str, theirs: str) -> str | None:
    """Return a text with the changes that both made in a base, None where they cannot be told apart.

    They can where each changed other tables and other lines, and the merged text says just that.
    """
    before, ours, other = (Document(text).data for text in (base, mine, theirs))
    if before is None or ours is None or other is None:
        return None
    changed_own, changed_other = _changed(before, ours), _changed(before, other)
    if changed_own & changed_other:
        return None
    merged = _merge_lines(*(text.splitlines(keepends=True) for text in (base, mine, theirs)))
    if merged is None:
        return None
    expected = {key: value for key, value in other.items() if key not in changed_own}
    expected |= {key: value for key, value in ours.items() if key in changed_own}
    try:
        parsed = tomllib.loads(merged)
    except tomllib.TOMLDecodeError:
        return None
    return merged if parsed == expected else None


def _changed(before: Mapping[str, Any], after: Mapping[str, Any]) -> set[str]:
    """Return the names of the tables, and of the keys outside all tables, that differ."""
    missing = object()
    return {key for key in {*before, *after} if before.get(key, missing) != after.get(key, missing)}


def _merge_lines(base: Sequence[str], mine: Sequence[str], theirs: Sequence[str]) -> str | None:
    """Return the lines of a base with the changes of both, None where these touch."""
    changes = sorted({*_changes(base, mine), *_changes(base, theirs)})
    merged: list[str] = []
    at, is_first = 0, True
    for start, end, lines in changes:
        if start < at or (start == at and not is_first):
            return None
        merged += [*base[at:start], *lines]
        at, is_first = end, False
    return "".join([*merged, *base[at:]])


def _changes(base: Sequence[str], after: Sequence[str]) -> list[tuple[int, int, tuple[str, ...]]]:
    """Return which lines of a base others replace: the first, the one after the last, and these."""
    matcher = SequenceMatcher(None, base, after, autojunk=False)
    return [(i, j, tuple(after[k:m])) for tag, i, j, k, m in matcher.get_opcodes() if tag != "equal"]
