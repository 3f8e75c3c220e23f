"""Edits of a TOML text in place: only what changes is rewritten, everything else keeps its characters.

An edit is a list of replacements of some characters by others. Comments on the line of what is removed go with it, and
those of a removed table that stand in it or, without a blank line between, right below; other comments stay.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import Any

from groundslab.case.editing.toml_inline import Replacement, count_equal_at_start, revise_value, rewrite_list
from groundslab.case.editing.toml_layout import TomlLayout
from groundslab.case.editing.toml_values import MISSING, Path, equal_values, get_value, replace_value
from groundslab.schema import toml_writer


class TomlEditor:
    """Finds the replacements that make an edit of a TOML text."""

    def __init__(self, layout: TomlLayout, order: Sequence[str] = ()) -> None:
        """Edit a text; order names the top-level tables in the order in which new ones are placed."""
        self.layout = layout
        self.text = layout.text
        self.data = layout.data
        self.order = tuple(order)

    def set(self, path: Path, new: Any) -> list[Replacement]:
        """Set the value at a path; missing tables on the way are created, but no list items."""
        depth = len(path)
        while get_value(self.data, path[:depth], MISSING) is MISSING:
            depth -= 1
        if depth == len(path):
            return self._change(path, get_value(self.data, path), new)
        for step in reversed(path[depth + 1 :]):
            new = {step: new}
        above, step = path[:depth], path[depth]
        assert isinstance(step, str)
        if self.layout.is_inline(above):
            old = get_value(self.data, above)
            return self._change(above, old, {**old, step: new})
        return self._add_keys(above, {step: new})

    def remove(self, path: Path, rest: Any) -> list[Replacement]:
        """Remove the value at a path that exists and leave the rest of the table or list that holds it."""
        above, step = path[:-1], path[-1]
        if not self.layout.is_inline(above):
            return self._remove_statements(path)
        old = get_value(self.data, above)
        value = self.layout.find_value(above)
        if value is None or isinstance(old, Mapping):
            return self._change(above, old, rest)
        sources = [index for index in range(len(old)) if index != step]
        return [Replacement(value.start, value.end, rewrite_list(self.text, value, old, rest, sources))]

    def reorder(self, path: Path, index: int, to: int) -> list[Replacement]:
        """Move an item of a list to another index, its comments with it."""
        items = list(get_value(self.data, path))
        items.insert(to, items.pop(index))
        inside = self.layout.find_indices((*path, index))
        if self.layout.is_inline(path) or not inside or inside[-1] - inside[0] + 1 != len(inside) or index == to:
            return self._change(path, get_value(self.data, path), items)
        statements = self.layout.statements
        start = statements[inside[0]].start
        start = self.layout.skip_comments_up(start) if index > 0 else start
        block = self.text[start : self.layout.skip_comments_down(statements[inside[-1]].end)]
        block += self.layout.complete_line(len(self.text)) if not block.endswith("\n") else ""
        before = to + 1 if to > index else to
        return [*self._remove_statements((*path, index)), self._insert_section(path, before, block)]

    def rename(self, path: Path, name: str) -> list[Replacement]:
        """Rename the key at a path that exists, wherever it stands; what it holds stays as it is written."""
        above = path[:-1]
        if self.layout.is_inline(above):
            old = get_value(self.data, above)
            return self._change(above, old, {name if key == path[-1] else key: entry for key, entry in old.items()})
        replacements = []
        for statement in self.layout.find_statements(path):
            section = () if statement.value is None else statement.section
            index = len(_select_keys(above)) - len(_select_keys(section))
            if index >= 0:  # else a header above it has the key
                names = (*statement.key.names[:index], name, *statement.key.names[index + 1 :])
                replacements.append(
                    Replacement(statement.key.start, statement.key.end, ".".join(map(toml_writer.key, names)))
                )
        return replacements

    def _change(self, path: Path, old: Any, new: Any) -> list[Replacement]:
        """Change an old value into a new one, part by part."""
        if equal_values(old, new):
            return []
        value = self.layout.find_value(path)
        if value is not None:
            return [Replacement(value.start, value.end, revise_value(self.text, value, old, new))]
        if self.layout.is_inline(path):
            return self._rewrite_enclosing(path, new)
        if isinstance(old, Mapping) and isinstance(new, Mapping):
            return self._change_table(path, old, new)
        if toml_writer.is_list_of_tables(old) and toml_writer.is_list_of_tables(new):
            return self._change_list_of_tables(path, old, new)
        above, step = path[:-1], path[-1]
        if isinstance(step, str):
            return self._remove_statements(path) + self._add_keys(above, {step: new})
        # a table of a list with headers becomes something else, for which there are none
        items = get_value(self.data, above)
        return self._change(above, items, [*items[:step], new, *items[step + 1 :]])

    def _change_table(self, path: Path, old: Mapping[str, Any], new: Mapping[str, Any]) -> list[Replacement]:
        """Change a table with headers or dotted keys."""
        replacements = []
        for name, entry in old.items():
            below = (*path, name)
            replacements += self._change(below, entry, new[name]) if name in new else self._remove_statements(below)
        missing = {name: entry for name, entry in new.items() if name not in old}
        return replacements + (self._add_keys(path, missing) if missing else [])

    def _change_list_of_tables(self, path: Path, old: list[Any], new: list[Any]) -> list[Replacement]:
        """Change a list of tables with headers; equal tables at both ends stay."""
        first = count_equal_at_start(old, new)
        last = count_equal_at_start(old[first:][::-1], new[first:][::-1])
        before, after = old[first : len(old) - last], new[first : len(new) - last]
        replacements = []
        for index, (a, b) in enumerate(zip(before, after, strict=False), start=first):
            replacements += self._change((*path, index), a, b)
        for index in range(first + len(after), first + len(before)):
            replacements += self._remove_statements((*path, index))
        if new_tables := after[len(before) :]:
            replacements.append(self._insert_tables(path, first + len(before), new_tables))
        return replacements

    def _rewrite_enclosing(self, path: Path, new: Any) -> list[Replacement]:
        """Rewrite the smallest value that holds a path which dotted keys within it scatter."""
        for length in range(len(path) - 1, 0, -1):
            enclosing = self.layout.find_value(path[:length])
            if enclosing is not None:
                value = replace_value(get_value(self.data, path[:length]), path[length:], new)
                return [Replacement(enclosing.start, enclosing.end, toml_writer.value(value))]
        raise AssertionError(path)  # a pair always has a value

    def _remove_statements(self, path: Path) -> list[Replacement]:
        """Remove all statements at and below a path, with the comments that belong to them."""
        # indices that follow each other have the same distance to their positions
        runs = groupby(enumerate(self.layout.find_indices(path)), lambda pair: pair[1] - pair[0])
        inside = [[index for _, index in run] for _, run in runs]
        return [self._delete_statements(indices[0], indices[-1], path) for indices in inside]

    def _delete_statements(self, first: int, last: int, path: Path) -> Replacement:
        """Delete the lines of consecutive statements, given by their indices."""
        layout, statements = self.layout, self.layout.statements
        start, end = statements[first].start, statements[last].end
        if statements[first].value is not None:
            return Replacement(start, end, "")
        end = layout.skip_comments_down(end)
        if isinstance(path[-1], int) and path[-1] > 0:
            start = layout.skip_comments_up(start)
        after_blank = layout.skip_blank_lines_down(end)
        # the heading of a list now belongs to the next table of the list
        following = statements[last + 1 : last + 2]
        heads = path[-1] == 0 and any(statement.path[: len(path) - 1] == path[:-1] for statement in following)
        blank_above = layout.is_blank_line(layout.find_previous_line(start), start)
        if start == 0 or after_blank == len(self.text) or heads or blank_above:
            end = after_blank
        if end == len(self.text):
            start = layout.skip_blank_lines_up(start)
        return Replacement(start, end, "")

    def _add_keys(self, path: Path, missing: Mapping[str, Any]) -> list[Replacement]:
        """Add keys to a table, which may have a header, dotted keys, or no statement of its own yet."""
        names = _select_keys(path)
        sections = {name: entry for name, entry in missing.items() if toml_writer.is_section((*names, name), entry)}
        pairs = {name: entry for name, entry in missing.items() if name not in sections}
        replacements = [self._add_pairs(path, names, pairs)] if pairs else []
        for name, entry in sections.items():
            position = self._find_section_position(path, name)
            replacements.append(self._place_section(position, toml_writer.section((*names, name), entry)))
        return replacements

    def _add_pairs(self, path: Path, names: tuple[str, ...], pairs: Mapping[str, Any]) -> Replacement:
        """Add pairs to a table: behind its own, below its header, or under a new header."""
        inside = self.layout.find_statements(path)
        own_pairs = [statement for statement in inside if statement.value is not None]
        headers = [statement for statement in inside if statement.value is None and statement.path == path]
        direct = [statement for statement in own_pairs if statement.section == path]
        dotted = [statement for statement in own_pairs if len(statement.section) < len(path)]
        neighbors = direct or headers or dotted
        end = len(self.text)
        indent = ""
        prefix = ""
        header = ""
        if neighbors:
            previous = neighbors[-1]
            outside = names if direct or headers else _select_keys(previous.section)
            prefix = "".join(f"{toml_writer.key(name)}." for name in names[len(outside) :])
            indent = self.text[previous.start : previous.key.start] if direct or dotted else ""
            end = previous.end
        elif path:
            header = f"[{'.'.join(map(toml_writer.key, names))}]\n"
        lines = (indent + toml_writer.pair(prefix + toml_writer.key(name), entry) for name, entry in pairs.items())
        text = header + "".join(lines)
        if neighbors or not inside:
            return Replacement(end, end, self.layout.complete_line(end) + text)
        start = self.layout.skip_comments_up(inside[0].start) or inside[0].start
        return Replacement(start, start, text + "\n")

    def _find_section_position(self, path: Path, name: str) -> int:
        """Return where a new table with a header goes: behind what precedes it in the order, or its parent."""
        rank = self.order.index(name) if name in self.order else 0
        statements = self.layout.statements
        for before in [path] if path else [(other,) for other in reversed(self.order[:rank])]:
            inside = [index for index, statement in enumerate(statements) if statement.path[: len(before)] == before]
            if inside and (path or statements[inside[-1]].section):
                last = inside[-1]
                # a header ends the table above it, so all pairs of that one come first
                while last + 1 < len(statements) and statements[last + 1].value is not None:
                    last += 1
                return self.layout.skip_comments_down(statements[last].end)
        return len(self.text)

    def _insert_tables(self, path: Path, index: int, tables: list[Any]) -> Replacement:
        """Insert tables into a list of tables with headers, before the one with an index, or at the end."""
        return self._insert_section(path, index, toml_writer.section(_select_keys(path), tables))

    def _insert_section(self, path: Path, index: int, section: str) -> Replacement:
        """Insert the text of tables of a list with headers, before the one with an index, or at the end."""
        following = self.layout.find_statements((*path, index))
        if following:
            start = self.layout.skip_comments_up(following[0].start) if index > 0 else following[0].start
            return Replacement(start, start, section + "\n")
        end = self.layout.find_statements(path)[-1].end
        return self._place_section(self.layout.skip_comments_down(end), section)

    def _place_section(self, position: int, section: str) -> Replacement:
        """Place a table at the start of a line, with blank lines around it."""
        above = self.text[self.layout.find_previous_line(position) : position]
        before = self.layout.complete_line(position) + ("\n" if above.strip() else "")
        after = "\n" if position < len(self.text) and not self.layout.is_blank_line(position) else ""
        return Replacement(position, position, before + section + after)


def _select_keys(path: Path) -> tuple[str, ...]:
    """Return the keys of a path, without indices."""
    return tuple(step for step in path if isinstance(step, str))
