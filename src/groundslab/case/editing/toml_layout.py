"""Where the statements, values, comments and blank lines of a TOML text are."""

from __future__ import annotations

import re
from collections import defaultdict
from functools import cached_property
from typing import Any

from groundslab.case.editing.toml_positions import Statement, Value, read_statements
from groundslab.case.editing.toml_values import Path

_COMMENT = re.compile(r"[ \t]*#[^\n]*(?:\n|\Z)")
_BLANK_LINE = re.compile(r"[ \t\r]*\n")


class TomlLayout:
    """A TOML text, its data, and where everything stands."""

    def __init__(self, text: str, data: dict[str, Any]) -> None:
        self.text = text
        self.data = data
        self.statements = read_statements(text)
        self.pairs = {statement.path: statement for statement in self.statements if statement.value is not None}

    def find_value(self, path: Path) -> Value | None:
        """Return where the value at a path stands, None for a table with headers or dotted keys of its own."""
        for length in range(len(path), 0, -1):
            pair = self.pairs.get(path[:length])
            if pair is not None and pair.value is not None:
                return pair.value.find(path[length:])
        return None

    def is_inline(self, path: Path) -> bool:
        """Whether a path lies within the value of one pair."""
        return any(path[:length] in self.pairs for length in range(1, len(path) + 1))

    @cached_property
    def _by_item(self) -> dict[Path, list[int]]:
        """The indices of statements by the first two steps of their paths, such as a load in the list of loads."""
        indices: dict[Path, list[int]] = defaultdict(list)
        for index, statement in enumerate(self.statements):
            indices[statement.path[:2]].append(index)
        return indices

    def find_indices(self, path: Path) -> list[int]:
        """Return the indices of the statements at and below a path, from top to bottom."""
        near = self._by_item.get(path[:2], ()) if len(path) > 1 else range(len(self.statements))
        return [index for index in near if self.statements[index].path[: len(path)] == path]

    def find_statements(self, path: Path) -> list[Statement]:
        """Return the statements at and below a path, from top to bottom."""
        return [self.statements[index] for index in self.find_indices(path)]

    def find_line(self, path: Path) -> int | None:
        """Return the line, from 1, of the value at a path or of the nearest table around it."""
        for length in range(len(path), 0, -1):
            part = self.find_value(path[:length]) or next(iter(self.find_statements(path[:length])), None)
            if part is not None:
                return self.text.count("\n", 0, part.start) + 1
        return None

    def complete_line(self, position: int) -> str:
        """Return the line end that is missing before a position at the end of an unfinished line, else nothing."""
        return "\n" if position > 0 and self.text[position - 1] != "\n" else ""

    def find_previous_line(self, start: int) -> int:
        """Return the start of the line above the one that starts at a position."""
        return self.text.rfind("\n", 0, start - 1) + 1 if start > 0 else 0

    def is_blank_line(self, start: int, end: int | None = None) -> bool:
        """Whether a blank line starts at a position, and ends at another one if that is given."""
        match = _BLANK_LINE.match(self.text, start)
        return match is not None and end in (None, match.end())

    def skip_comments_up(self, start: int) -> int:
        """Return the start of the comments right above a line."""
        return self._skip_up(_COMMENT, start)

    def skip_blank_lines_up(self, start: int) -> int:
        """Return the start of the blank lines right above a line."""
        return self._skip_up(_BLANK_LINE, start)

    def _skip_up(self, line: re.Pattern[str], start: int) -> int:
        while start > 0 and line.fullmatch(self.text, self.find_previous_line(start), start):
            start = self.find_previous_line(start)
        return start

    def skip_comments_down(self, end: int) -> int:
        """Return the end of the comments right below, unless what follows them belongs to them."""
        position = end
        while position < len(self.text) and (match := _COMMENT.match(self.text, position)):
            position = match.end()
        return position if position == len(self.text) or self.is_blank_line(position) else end

    def skip_blank_lines_down(self, end: int) -> int:
        """Return the end of the blank lines right below."""
        while match := _BLANK_LINE.match(self.text, end):
            end = match.end()
        return end
