"""Changes of a TOML text in place: what is said otherwise is written otherwise, all else keeps its characters.

Text is replaced between two positions (a splice). Comments on the line of what is removed go with it, and those of a
removed table that stand in it or, without a blank line between, right below; other comments stay.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from groundslab.schema import toml_writer
from groundslab.workbench.editing.toml_positions import Path, Value, statements

_COMMENT = re.compile(r"[ \t]*#[^\n]*(?:\n|\Z)")
_COMMENT_WORDS = re.compile(r"#[^\n]*")
_BLANK_LINE = re.compile(r"[ \t\r]*\n")
_MISSING = object()


@dataclass(frozen=True, slots=True)
class Splice:
    """Characters start to end are replaced by a text."""

    start: int
    end: int
    text: str


def spliced(text: str, splices: Sequence[Splice]) -> str:
    """Return a text with some of it replaced; of several insertions at one place the first comes first."""
    pieces, position = [], 0
    for each in sorted(splices, key=lambda each: (each.start, each.end)):
        pieces += [text[position : each.start], each.text]
        position = max(position, each.end)
    return "".join([*pieces, text[position:]])


def same(a: Any, b: Any) -> bool:
    """Whether two values mean the same in a file: 1 is 1.0, but not true."""
    if isinstance(a, Mapping) and isinstance(b, Mapping):
        return a.keys() == b.keys() and all(same(a[name], b[name]) for name in a)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(map(same, a, b))
    return isinstance(a, bool) is isinstance(b, bool) and bool(a == b or (a != a and b != b))


def value_at(data: Any, path: Path, otherwise: Any = None) -> Any:
    """Return what stands at a path of the data, else something else."""
    for step in path:
        has = step in data if isinstance(data, Mapping) else isinstance(data, list) and step in range(len(data))
        if not has:
            return otherwise
        data = data[step]
    return data


class Layout:
    """A TOML text, its data, and where everything stands; makes splices."""

    def __init__(self, text: str, data: dict[str, Any], order: Sequence[str] = ()) -> None:
        """Read a text and what it says; order names the tables at the top in the order in which new ones are put."""
        self.text = text
        self.data = data
        self.statements = statements(text)
        self.order = tuple(order)
        self.pairs = {each.path: each for each in self.statements if each.value is not None}

    def value(self, path: Path) -> Value | None:
        """Return where the value at a path stands, None for what has headers or dotted keys of its own."""
        for length in range(len(path), 0, -1):
            pair = self.pairs.get(path[:length])
            if pair is not None and pair.value is not None:
                return pair.value.at(path[length:])
        return None

    def inline(self, path: Path) -> bool:
        """Whether what stands at a path, if anything, stands within the value of one pair."""
        return any(path[:length] in self.pairs for length in range(1, len(path) + 1))

    def line(self, path: Path) -> int | None:
        """Return the line, from 1, of what stands at a path or of the nearest thing around it."""
        for length in range(len(path), 0, -1):
            found = self.value(path[:length])
            if found is not None:
                return self.text.count("\n", 0, found.start) + 1
            for each in self.statements:
                if each.path[:length] == path[:length]:
                    return self.text.count("\n", 0, each.start) + 1
        return None

    def put(self, path: Path, new: Any) -> list[Splice]:
        """Return what gives the value at a path another one; tables that are missing on the way are made.

        The list that a position belongs to must have it already.
        """
        known = len(path)
        while value_at(self.data, path[:known], _MISSING) is _MISSING:
            known -= 1
        if known == len(path):
            return self._changed(path, value_at(self.data, path), new)
        for step in reversed(path[known + 1 :]):
            new = {step: new}
        step = path[known]
        assert isinstance(step, str)
        above = path[:known]
        if self.inline(above):
            old = value_at(self.data, above)
            return self._changed(above, old, {**old, step: new})
        return self._added(above, {step: new})

    def insert(self, path: Path, position: int, new: Any) -> list[Splice]:
        """Return what puts a value into a list that is there, before the one at a position, or at its end."""
        old = value_at(self.data, path)
        found = self.value(path)
        if found is not None:
            items = [*old[:position], new, *old[position:]]
            keep: list[int | None] = [*range(position), None, *range(position, len(old))]
            return [self._relisted(found, old, items, keep)]
        names = tuple(step for step in path if isinstance(step, str))
        return [self._inserted(path, position, toml_writer.section(names, [new]))]

    def remove(self, path: Path) -> list[Splice]:
        """Return what takes away the thing at a path that is there."""
        above, step = path[:-1], path[-1]
        if not self.inline(above):
            return self._removed(path)
        old = value_at(self.data, above)
        if isinstance(old, Mapping):
            return self._changed(above, old, {name: each for name, each in old.items() if name != step})
        found = self.value(above)
        if found is None:
            kept = [each for position, each in enumerate(old) if position != step]
            return self._rewritten(above, kept)
        keep = [position for position in range(len(old)) if position != step]
        return [self._relisted(found, old, [old[position] for position in keep], list(keep))]

    def _changed(self, path: Path, old: Any, new: Any) -> list[Splice]:
        """Return what makes a new value of the old one, part by part."""
        if same(old, new):
            return []
        found = self.value(path)
        if found is not None:
            return [Splice(found.start, found.end, self._revised(found, old, new))]
        if self.inline(path):
            return self._rewritten(path, new)
        if isinstance(old, Mapping) and isinstance(new, Mapping):
            return self._changed_table(path, old, new)
        if toml_writer.is_list_of_tables(old) and toml_writer.is_list_of_tables(new):
            return self._changed_tables(path, old, new)
        step = path[-1]
        assert isinstance(step, str)
        return self._removed(path) + self._added(path[:-1], {step: new})

    def _changed_table(self, path: Path, old: Mapping[str, Any], new: Mapping[str, Any]) -> list[Splice]:
        """Return what makes another table of one with headers or dotted keys."""
        splices = []
        for name, each in old.items():
            below = (*path, name)
            splices += self._changed(below, each, new[name]) if name in new else self._removed(below)
        missing = {name: each for name, each in new.items() if name not in old}
        return splices + (self._added(path, missing) if missing else [])

    def _changed_tables(self, path: Path, old: list[Any], new: list[Any]) -> list[Splice]:
        """Return what makes other tables of a list of them; those that are the same at both ends stay."""
        first = _same_at_the_start(old, new)
        last = _same_at_the_start(old[first:][::-1], new[first:][::-1])
        before, after = old[first : len(old) - last], new[first : len(new) - last]
        splices = []
        for number, (a, b) in enumerate(zip(before, after, strict=False), start=first):
            splices += self._changed((*path, number), a, b)
        for number in range(first + len(after), first + len(before)):
            splices += self._removed((*path, number))
        names = tuple(step for step in path if isinstance(step, str))
        position = first + len(before)
        splices += [self._inserted(path, position, toml_writer.section(names, [each])) for each in after[len(before) :]]
        return splices

    def _rewritten(self, path: Path, new: Any) -> list[Splice]:
        """Return what writes anew the smallest value that holds a path scattered by dotted keys within it."""
        for length in range(len(path) - 1, 0, -1):
            found = self.value(path[:length])
            if found is not None:
                whole = replaced(value_at(self.data, path[:length]), path[length:], new)
                return [Splice(found.start, found.end, toml_writer.value(whole))]
        raise AssertionError(path)  # a pair's own value always stands somewhere

    def _revised(self, found: Value, old: Any, new: Any) -> str:
        """Return the text of a value changed to a new one, with all that need not change."""
        text = self.text[found.start : found.end]
        if same(old, new):
            return text
        if found.kind == "list" and isinstance(new, list):
            if len(old) == len(new):
                return self._in_place(found, [self._revised(*each) for each in zip(found.parts, old, new, strict=True)])
            return self._relisted(found, old, new, _alignment(old, new)).text
        if found.kind == "table" and isinstance(new, Mapping) and all(len(key.names) == 1 for key in found.keys):
            names = [key.names[0] for key in found.keys]
            if new.keys() == old.keys():
                parts = zip(names, found.parts, strict=True)
                return self._in_place(found, [self._revised(part, old[name], new[name]) for name, part in parts])
            kept = [
                self.text[key.start : part.start] + self._revised(part, old[name], new[name])
                for name, key, part in zip(names, found.keys, found.parts, strict=True)
                if name in new
            ]
            kept += [
                f"{toml_writer.key(name)} = {toml_writer.value(each)}" for name, each in new.items() if name not in old
            ]
            padding = " " if text[1] == " " and kept else ""
            return f"{{{padding}{', '.join(kept)}{padding}}}"
        return toml_writer.value(new)

    def _in_place(self, found: Value, parts: list[str]) -> str:
        """Return the text of a value with other texts for its parts."""
        splices = [
            Splice(part.start - found.start, part.end - found.start, text)
            for part, text in zip(found.parts, parts, strict=True)
        ]
        return spliced(self.text[found.start : found.end], splices)

    def _relisted(self, found: Value, old: list[Any], new: list[Any], keep: list[int | None]) -> Splice:
        """Return what makes another list of one; keep tells of each new item which old one it was.

        Every item keeps the comment behind it on its line and what stands before it: line ends, blanks, comments.
        """
        text, parts = self.text, found.parts
        if not parts or not new:
            return Splice(found.start, found.end, toml_writer.value(new))
        opening, behind, before = text[found.start + 1 : parts[0].start], list[str](), [""]
        for part, end in zip(parts, [*(part.start for part in parts[1:]), found.end - 1], strict=True):
            tail, rest = _halves(text[part.end : end])
            behind.append(tail)
            before.append(rest)
        closing = before.pop()
        ends_with_comma = "," in _COMMENT_WORDS.sub("", text[parts[-1].end : found.end - 1])
        usual = "\n" + opening[opening.rfind("\n") + 1 :] if "\n" in opening else " "
        between = next((each for each in before[1:] if not each.strip()), usual)
        leads, items = list[str](), list[str]()
        for number, was in enumerate(keep):
            lead = before[was] if was else between  # the first one's is the list's own
            if number == 0:
                lead = opening + (lead.lstrip() if lead.strip() else "")
            leads.append(lead)
            items.append(
                toml_writer.value(new[number]) if was is None else self._revised(parts[was], old[was], new[number])
            )
        pieces = ["["]
        for number, (lead, item) in enumerate(zip(leads, items, strict=True)):
            is_last, was = number + 1 == len(items), keep[number]
            after = closing if is_last else leads[number + 1]
            # a comment needs the line's end behind it
            tail = behind[was] if was is not None and after.startswith("\n") else ""
            pieces += [lead, item, "" if is_last and not ends_with_comma else ",", tail]
        return Splice(found.start, found.end, "".join([*pieces, closing, "]"]))

    def _removed(self, path: Path) -> list[Splice]:
        """Return what takes away all statements of a thing, with the comments that belong to it."""
        runs: list[list[int]] = []
        for number, each in enumerate(self.statements):
            if each.path[: len(path)] == path:
                if runs and runs[-1][-1] == number - 1:
                    runs[-1].append(number)
                else:
                    runs.append([number])
        return [self._cut(run[0], run[-1], path) for run in runs]

    def _cut(self, one: int, other: int, path: Path) -> Splice:
        """Return what removes the lines from one statement to another, by their numbers."""
        first = self.statements[one]
        start, end = first.start, self.statements[other].end
        if first.value is not None:
            return Splice(start, end, "")
        end = self._after_comments(end)
        if isinstance(path[-1], int) and path[-1] > 0:
            start = self._before_comments(start)
        blank = self._after_blank_lines(end)
        following = self.statements[other + 1 : other + 2]
        # the heading of a list goes on to the list's next table
        heads = path[-1] == 0 and any(each.path[: len(path) - 1] == path[:-1] for each in following)
        above = self._line_before(start)
        if start == 0 or blank == len(self.text) or heads or _BLANK_LINE.fullmatch(self.text, above, start):
            end = blank
        if end == len(self.text):
            start = self._before_blank_lines(start)
        return Splice(start, end, "")

    def _added(self, path: Path, missing: Mapping[str, Any]) -> list[Splice]:
        """Return what adds keys to a table with a header, with dotted keys, or without anything of its own yet."""
        names = tuple(step for step in path if isinstance(step, str))
        below = {name: each for name, each in missing.items() if toml_writer.is_section((*names, name), each)}
        pairs = {name: each for name, each in missing.items() if name not in below}
        splices = [self._added_pairs(path, names, pairs)] if pairs else []
        for name, each in below.items():
            place = self._place_for(path, name)
            splices.append(self._set_apart(place, toml_writer.section((*names, name), each)))
        return splices

    def _added_pairs(self, path: Path, names: tuple[str, ...], pairs: Mapping[str, Any]) -> Splice:
        """Return what adds pairs to a table: behind its own, or below its header, or in a place made for them."""
        own = [each for each in self.statements if each.value is not None and each.path[: len(path)] == path]
        headers = [each for each in self.statements if each.value is None and each.path == path]
        direct = [each for each in own if each.section == path]
        dotted = [each for each in own if len(each.section) < len(path)]
        if direct or headers or dotted:
            behind = (direct or headers or dotted)[-1]
            outside = 0 if direct or headers else len([step for step in behind.section if isinstance(step, str)])
            prefix = "" if direct or headers else "".join(f"{toml_writer.key(name)}." for name in names[outside:])
            indent = self.text[behind.start : behind.key.start] if direct or dotted else ""
            lines = "".join(
                indent + toml_writer.pair(prefix + toml_writer.key(name), each) for name, each in pairs.items()
            )
            return Splice(behind.end, behind.end, self._newline_before(behind.end) + lines)
        lines = "".join(toml_writer.pair(toml_writer.key(name), each) for name, each in pairs.items())
        inside = [each for each in self.statements if each.path[: len(path)] == path]
        if path:
            lines = f"[{'.'.join(map(toml_writer.key, names))}]\n{lines}"
        if not inside:
            end = len(self.text)
            return Splice(end, end, self._newline_before(end) + lines)
        start = self._before_comments(inside[0].start) or inside[0].start
        return Splice(start, start, lines + "\n")

    def _place_for(self, path: Path, name: str) -> int:
        """Return where a new table with a header goes: behind what comes before it in the order, or around it."""
        befores = [path] if path else [(other,) for other in self.order[: self._rank(name)]]
        for before in reversed(befores):
            inside = [n for n, each in enumerate(self.statements) if each.path[: len(before)] == before]
            if inside and (path or self.statements[inside[-1]].section):
                last = inside[-1]
                # a header ends the table above it, so all pairs of that one come first
                while last + 1 < len(self.statements) and self.statements[last + 1].value is not None:
                    last += 1
                return self._after_comments(self.statements[last].end)
        return len(self.text)

    def _rank(self, name: str) -> int:
        """Return the place of a table at the top in the order of new ones."""
        return self.order.index(name) if name in self.order else 0

    def _inserted(self, path: Path, position: int, section: str) -> Splice:
        """Return what puts a table into a list of tables, before the one at a position, or at its end."""
        at = [each for each in self.statements if each.path[: len(path) + 1] == (*path, position)]
        if at:
            start = self._before_comments(at[0].start) if position > 0 else at[0].start
            return Splice(start, start, section + "\n")
        inside = [each for each in self.statements if each.path[: len(path)] == path]
        return self._set_apart(self._after_comments(inside[-1].end), section)

    def _set_apart(self, place: int, section: str) -> Splice:
        """Return what puts a table at the start of a line, with blank lines around it."""
        above = self.text[self._line_before(place) : place]
        before = self._newline_before(place) + ("\n" if above.strip() else "")
        after = "\n" if place < len(self.text) and not _BLANK_LINE.match(self.text, place) else ""
        return Splice(place, place, before + section + after)

    def _newline_before(self, place: int) -> str:
        """Return the line end that is missing before a place, if it is the end of an unfinished line."""
        return "\n" if place > 0 and self.text[place - 1] != "\n" else ""

    def _line_before(self, start: int) -> int:
        """Return the start of the line above the one that starts there."""
        return self.text.rfind("\n", 0, start - 1) + 1 if start > 0 else 0

    def _before_comments(self, start: int) -> int:
        """Return the start of the comments right above a line."""
        while start > 0 and _COMMENT.fullmatch(self.text, self._line_before(start), start):
            start = self._line_before(start)
        return start

    def _before_blank_lines(self, start: int) -> int:
        """Return the start of the blank lines right above a line."""
        while start > 0 and _BLANK_LINE.fullmatch(self.text, self._line_before(start), start):
            start = self._line_before(start)
        return start

    def _after_comments(self, end: int) -> int:
        """Return the end of the comments right below, unless they belong to what follows without a blank line."""
        position = end
        while match := _COMMENT.match(self.text, position):
            position = match.end()
            if position == len(self.text):
                break
        if position == len(self.text) or _BLANK_LINE.match(self.text, position):
            return position
        return end

    def _after_blank_lines(self, end: int) -> int:
        """Return the end of the blank lines right below."""
        while match := _BLANK_LINE.match(self.text, end):
            end = match.end()
        return end


def replaced(data: Any, path: Path, new: Any) -> Any:
    """Return a copy of the data with another value at a path, tables made where they are missing."""
    if not path:
        return new
    step, rest = path[0], path[1:]
    if isinstance(step, int):
        return [replaced(each, rest, new) if position == step else each for position, each in enumerate(data)]
    table = dict(data) if isinstance(data, Mapping) else {}
    table[step] = replaced(table.get(step), rest, new)
    return table


def _same_at_the_start(a: Sequence[Any], b: Sequence[Any]) -> int:
    """Return how many items two lists have in common at their start."""
    count = 0
    while count < min(len(a), len(b)) and same(a[count], b[count]):
        count += 1
    return count


def _alignment(old: list[Any], new: list[Any]) -> list[int | None]:
    """Return which item of the old list each of the new one was: the same ones at both ends, those between in order."""
    first = _same_at_the_start(old, new)
    last = _same_at_the_start(old[first:][::-1], new[first:][::-1])
    between = [number if number < len(old) - last else None for number in range(first, len(new) - last)]
    return [*range(first), *between, *range(len(old) - last, len(old))]


def _halves(between: str) -> tuple[str, str]:
    """Return what stands behind an item on its line, and what stands before the next one; the comma is left out."""
    plain = _COMMENT_WORDS.sub(lambda match: " " * len(match.group()), between)
    comma = plain.find(",")
    without = between[:comma] + between[comma + 1 :] if comma >= 0 else between
    end = without.find("\n")
    if end < 0:
        return "", without
    return without[:end].rstrip(), without[end:]
