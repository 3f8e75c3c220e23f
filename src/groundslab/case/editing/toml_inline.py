"""Inline TOML values (lists, inline tables) rewritten with the layout and comments of their text."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from groundslab.case.editing.toml_positions import Value
from groundslab.case.editing.toml_values import equal_values
from groundslab.schema import toml_writer

_COMMENT = re.compile(r"#[^\n]*")


@dataclass(frozen=True, slots=True)
class Replacement:
    """A text that replaces the characters from start to end."""

    start: int
    end: int
    text: str


def apply_replacements(text: str, replacements: Iterable[Replacement]) -> str:
    """Return a text with some of it replaced; insertions at the same position keep their order."""
    pieces, position = [], 0
    for replacement in sorted(replacements, key=lambda replacement: (replacement.start, replacement.end)):
        pieces += [text[position : replacement.start], replacement.text]
        position = max(position, replacement.end)
    return "".join([*pieces, text[position:]])


def revise_value(text: str, value: Value, old: Any, new: Any) -> str:
    """Return the text of a value changed to a new one; unchanged parts keep their text."""
    if equal_values(old, new):
        return text[value.start : value.end]
    if value.kind == "list" and isinstance(new, list):
        if len(old) == len(new):
            items = zip(value.parts, old, new, strict=True)
            return _replace_parts(text, value, [revise_value(text, *item) for item in items])
        return rewrite_list(text, value, old, new, _align(old, new))
    if value.kind == "table" and isinstance(new, Mapping) and all(len(key.names) == 1 for key in value.keys):
        entries = [(key.names[0], key, part) for key, part in zip(value.keys, value.parts, strict=True)]
        revised = {name: revise_value(text, part, old[name], new[name]) for name, _, part in entries if name in new}
        if new.keys() == old.keys():
            return _replace_parts(text, value, list(revised.values()))
        kept = [text[key.start : part.start] + revised[name] for name, key, part in entries if name in new]
        kept += [f"{toml_writer.key(name)} = {toml_writer.value(new[name])}" for name in new if name not in old]
        padding = " " if text[value.start + 1] == " " and kept else ""
        return f"{{{padding}{', '.join(kept)}{padding}}}"
    return toml_writer.value(new)


def _replace_parts(text: str, value: Value, new_parts: list[str]) -> str:
    """Return the text of a value with other texts for its parts."""
    replacements = [
        Replacement(part.start - value.start, part.end - value.start, new)
        for part, new in zip(value.parts, new_parts, strict=True)
    ]
    return apply_replacements(text[value.start : value.end], replacements)


def rewrite_list(text: str, value: Value, old: list[Any], new: list[Any], sources: Sequence[int | None]) -> str:
    """Return the text of a list with other items; ``sources`` holds each new item's index in the old list, or None.

    Every old item keeps the comment behind it on its line and what precedes it: line ends, blanks, comments.
    """
    parts = value.parts
    if not parts or not new:
        return toml_writer.value(new)
    opening = text[value.start + 1 : parts[0].start]
    behind = list[str]()
    before = [""]
    for part, end in zip(parts, [*(part.start for part in parts[1:]), value.end - 1], strict=True):
        tail, rest = _split_separator(text[part.end : end])
        behind.append(tail)
        before.append(rest)
    closing = before.pop()
    ends_with_comma = "," in _COMMENT.sub("", text[parts[-1].end : value.end - 1])
    indent = "\n" + opening[opening.rfind("\n") + 1 :] if "\n" in opening else " "
    between = next((blank for blank in before[1:] if not blank.strip()), indent)
    leads = [between if source is None else before[source] for source in sources]
    leads[0] = opening + (leads[0].lstrip() if leads[0].strip() else "")
    pieces = ["["]
    for index, source in enumerate(sources):
        is_last = index + 1 == len(sources)
        after = closing if is_last else leads[index + 1]
        # a comment needs a line end behind it
        tail = behind[source] if source is not None and after.startswith("\n") else ""
        item = new[index]
        written = toml_writer.value(item) if source is None else revise_value(text, parts[source], old[source], item)
        pieces += [leads[index], written, "" if is_last and not ends_with_comma else ",", tail]
    return "".join([*pieces, closing, "]"])


def count_equal_at_start(a: Sequence[Any], b: Sequence[Any]) -> int:
    """Return the number of items that two lists have in common at their start."""
    return next(
        (count for count, pair in enumerate(zip(a, b, strict=False)) if not equal_values(*pair)), min(len(a), len(b))
    )


def _align(old: list[Any], new: list[Any]) -> list[int | None]:
    """Return the old index of each new item: equal ones at both ends, those between in order."""
    first = count_equal_at_start(old, new)
    last = count_equal_at_start(old[first:][::-1], new[first:][::-1])
    between = [index if index < len(old) - last else None for index in range(first, len(new) - last)]
    return [*range(first), *between, *range(len(old) - last, len(old))]


def _split_separator(between: str) -> tuple[str, str]:
    """Return the text after an item on its line and the text before the next one, without the comma."""
    plain = _COMMENT.sub(lambda match: " " * len(match.group()), between)
    comma = plain.find(",")
    without = between[:comma] + between[comma + 1 :] if comma >= 0 else between
    end = without.find("\n")
    return ("", without) if end < 0 else (without[:end].rstrip(), without[end:])
