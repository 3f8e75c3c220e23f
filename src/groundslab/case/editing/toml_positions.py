"""Positions of the statements, keys and values of a TOML text.

Python's ``tomllib`` parses and validates a text but does not report positions. Here a text that ``tomllib`` accepts is
read a second time, for the positions only.
"""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from typing import Literal

from groundslab.case.editing.toml_values import Path

_BARE = re.compile(r"[A-Za-z0-9_-]+")
_SPACE = re.compile(r"[ \t]*")
_BLANK = re.compile(r"(?:[ \t\r\n]|#[^\n]*)*")
_QUOTED = re.compile(r'"(?:[^"\\\n]|\\.)*"|\'[^\'\n]*\'')
# three quotes end a text; up to two more before them belong to it
_LONG = re.compile(r'"""(?:[^\\]|\\.)*?"""(?:"{0,2})|\'\'\'.*?\'\'\'(?:\'{0,2})', re.DOTALL)
_PLAIN = re.compile(r"[^,\]}#\r\n]*")


@dataclass(frozen=True, slots=True)
class Key:
    """A key, dotted or not, and its position."""

    start: int
    end: int
    names: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Value:
    """A value and its position; a list or an inline table has parts, those of a table have keys."""

    start: int
    end: int
    kind: Literal["plain", "list", "table"] = "plain"
    parts: tuple[Value, ...] = ()
    keys: tuple[Key, ...] = ()

    def find(self, path: Path) -> Value | None:
        """Return the value at a path below, None if there is none or if dotted keys scatter it."""
        if not path:
            return self
        if self.kind == "list" and isinstance(path[0], int) and path[0] < len(self.parts):
            return self.parts[path[0]].find(path[1:])
        for key, part in zip(self.keys, self.parts, strict=self.kind == "table"):
            if key.names == path[: len(key.names)]:
                return part.find(path[len(key.names) :])
        return None


@dataclass(frozen=True, slots=True)
class Statement:
    """A header or a pair of key and value, with the path of its value and that of its table."""

    start: int  # of the line
    end: int  # after the line's end
    path: Path
    section: Path  # of a header: its own path
    value: Value | None  # of a pair
    key: Key


def read_statements(text: str) -> list[Statement]:
    """Return the statements of a valid TOML text, from top to bottom."""
    statements: list[Statement] = []
    section: Path = ()
    counts: dict[Path, int] = {}  # lengths of the lists of tables so far
    position = _skip(_BLANK, text, 0)
    while position < len(text):
        start = text.rfind("\n", 0, position) + 1
        if text[position] == "[":
            double = text.startswith("[[", position)
            key = _read_key(text, _skip(_SPACE, text, position + 1 + double))
            section = _find_section(key.names, double, counts)
            position = _skip(_SPACE, text, key.end) + 1 + double
            path, value = section, None
        else:
            key = _read_key(text, position)
            value = _read_value(text, _skip(_SPACE, text, _skip(_SPACE, text, key.end) + 1))
            path, position = (*section, *key.names), value.end
        end = text.find("\n", position)
        end = len(text) if end < 0 else end + 1
        statements.append(Statement(start, end, path, section, value, key))
        position = _skip(_BLANK, text, end)
    return statements


def _find_section(names: tuple[str, ...], double: bool, counts: dict[Path, int]) -> Path:
    """Return the path of a header's table, with the index of the latest one in each list of tables."""
    path: Path = ()
    for name in names[:-1] if double else names:
        path = (*path, name)
        if path in counts:
            path = (*path, counts[path] - 1)
    if not double:
        return path
    path = (*path, names[-1])
    counts[path] = counts.get(path, 0) + 1
    return (*path, counts[path] - 1)


def _skip(pattern: re.Pattern[str], text: str, position: int) -> int:
    """Return the end of a match that may be empty."""
    match = pattern.match(text, position)
    assert match
    return match.end()


def _read_key(text: str, start: int) -> Key:
    """Return the key at a position."""
    names: list[str] = []
    position = end = start
    while True:
        match = _BARE.match(text, position) or _QUOTED.match(text, position)
        assert match, f"no key at {position}"
        word = match.group()
        names.append(tomllib.loads(f"word = {word}")["word"] if word[0] in "\"'" else word)
        end = match.end()
        dot = _skip(_SPACE, text, end)
        if not text.startswith(".", dot):
            return Key(start, end, tuple(names))
        position = _skip(_SPACE, text, dot + 1)


def _read_value(text: str, start: int) -> Value:
    """Return the value at a position."""
    if text[start] not in "[{":
        match = _LONG.match(text, start) or _QUOTED.match(text, start) or _PLAIN.match(text, start)
        assert match
        return Value(start, start + len(match.group().rstrip()))
    keys: list[Key] = []
    parts: list[Value] = []
    position = _skip(_BLANK, text, start + 1)
    while text[position] not in "]}":
        if text[start] == "{":
            keys.append(_read_key(text, position))
            position = _skip(_BLANK, text, _skip(_BLANK, text, keys[-1].end) + 1)
        parts.append(_read_value(text, position))
        position = _skip(_BLANK, text, parts[-1].end)
        if text[position] == ",":
            position = _skip(_BLANK, text, position + 1)
    return Value(start, position + 1, "list" if text[start] == "[" else "table", tuple(parts), tuple(keys))
