"""A TOML text as its statements, each with its place among the characters, so that one can be changed alone.

Python's ``tomllib`` says what a text means and whether it is TOML at all, but not where anything stands. Here the text
is read a second time for the places only; it is taken for granted that ``tomllib`` accepts it.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

#: Keys and positions (from 0) from the top of a file downwards.
Path = tuple[str | int, ...]

_BARE = re.compile(r"[A-Za-z0-9_-]+")
_SPACE = re.compile(r"[ \t]*")
_BLANK = re.compile(r"(?:[ \t\r\n]|#[^\n]*)*")
_QUOTED = re.compile(r'"(?:[^"\\\n]|\\.)*"|\'[^\'\n]*\'')
# three quotes end a text; up to two more before them belong to it
_LONG = re.compile(r'"""(?:[^\\]|\\.)*?"""(?:"{0,2})|\'\'\'.*?\'\'\'(?:\'{0,2})', re.DOTALL)
_PLAIN = re.compile(r"[^,\]}#\r\n]*")


@dataclass(frozen=True, slots=True)
class FieldType:
    """A key, dotted or not, and where it stands."""

    start: int
    end: int
    names: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Value:
    """A value and where it stands; a list or an inline table has parts, the latter's with keys."""

    start: int
    end: int
    kind: Literal["plain", "list", "table"] = "plain"
    parts: tuple[Value, ...] = ()
    keys: tuple[FieldType, ...] = ()

    def at(self, path: Path) -> Value | None:
        """Return what stands at a path below, None if nothing does or if dotted keys scatter it."""
        if not path:
            return self
        if self.kind == "list" and isinstance(path[0], int) and path[0] < len(self.parts):
            return self.parts[path[0]].at(path[1:])
        for key, part in zip(self.keys, self.parts, strict=self.kind == "table"):
            if key.names == path[: len(key.names)]:
                return part.at(path[len(key.names) :])
        return None


@dataclass(frozen=True, slots=True)
class Statement:
    """A header or a pair of key and value, with the path of what it says and the table that it stands in."""

    start: int  # of the line
    end: int  # after the line's end
    path: Path
    section: Path  # of a header: its own path
    value: Value | None  # of a pair
    key: FieldType


def statements(text: str) -> list[Statement]:
    """Return the statements of a text that is TOML, from top to bottom."""
    return list(_read(text))


def _read(text: str) -> Iterator[Statement]:
    section: Path = ()
    counts: dict[Path, int] = {}  # of the lists of tables, as far as they have been read
    position = _blank(text, 0)
    while position < len(text):
        start = text.rfind("\n", 0, position) + 1
        if text[position] == "[":
            double = text.startswith("[[", position)
            key = _key(text, _space(text, position + 1 + double))
            section = _section(key.names, double, counts)
            position = _space(text, key.end) + 1 + double
            path, value = section, None
        else:
            key = _key(text, position)
            value = _value(text, _space(text, _space(text, key.end) + 1))
            path, position = (*section, *key.names), value.end
        end = text.find("\n", position)
        end = len(text) if end < 0 else end + 1
        yield Statement(start, end, path, section, value, key)
        position = _blank(text, end)


def _section(names: tuple[str, ...], double: bool, counts: dict[Path, int]) -> Path:
    """Return the path of a header's table; of a list of tables the latest one is meant."""
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


def _space(text: str, position: int) -> int:
    """Return the position after spaces and tabs."""
    match = _SPACE.match(text, position)
    assert match
    return match.end()


def _blank(text: str, position: int) -> int:
    """Return the position after blanks, line ends and comments."""
    match = _BLANK.match(text, position)
    assert match
    return match.end()


def _key(text: str, start: int) -> FieldType:
    """Return the key at a position."""
    names: list[str] = []
    position = end = start
    while True:
        match = _BARE.match(text, position) or _QUOTED.match(text, position)
        assert match, f"no key at {position}"
        word = match.group()
        names.append(tomllib.loads(f"word = {word}")["word"] if word[0] in "\"'" else word)
        end = match.end()
        dot = _space(text, end)
        if not text.startswith(".", dot):
            return FieldType(start, end, tuple(names))
        position = _space(text, dot + 1)


def _value(text: str, start: int) -> Value:
    """Return the value at a position."""
    if text[start] == "[":
        parts: list[Value] = []
        position = _blank(text, start + 1)
        while text[position] != "]":
            parts.append(_value(text, position))
            position = _after_part(text, parts[-1].end)
        return Value(start, position + 1, "list", tuple(parts))
    if text[start] == "{":
        keys: list[FieldType] = []
        parts = []
        position = _blank(text, start + 1)
        while text[position] != "}":
            keys.append(_key(text, position))
            parts.append(_value(text, _blank(text, _blank(text, keys[-1].end) + 1)))
            position = _after_part(text, parts[-1].end)
        return Value(start, position + 1, "table", tuple(parts), tuple(keys))
    match = _LONG.match(text, start) or _QUOTED.match(text, start)
    if match is None:
        match = _PLAIN.match(text, start)
        assert match
        return Value(start, start + len(match.group().rstrip()))
    return Value(start, match.end())


def _after_part(text: str, position: int) -> int:
    """Return where the next part begins or the list or table ends."""
    position = _blank(text, position)
    return _blank(text, position + 1) if text[position] == "," else position
