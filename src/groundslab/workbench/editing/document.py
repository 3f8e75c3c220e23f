"""The case file as it is edited: its text, to the letter, and how edits change it."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from groundslab.case import casefile
from groundslab.errors import InputError, Issue
from groundslab.model.model import Model
from groundslab.schema.wording import describe
from groundslab.workbench.editing import lengths
from groundslab.workbench.editing.diagnostics import where_of
from groundslab.workbench.editing.toml_edits import Layout, Splice, replaced, same, spliced, value_at
from groundslab.workbench.editing.toml_positions import Path

Edit = Mapping[str, Any]
BOM = b"\xef\xbb\xbf"
DEEPEST = 50  # steps of a path
_ORDER = tuple(Model.model_fields)
_MISSING = object()


@dataclass(frozen=True)
class Document:
    """The text of a case file with plain line ends, and what line ends and what mark at its start the file has."""

    text: str
    newline: str = "\n"
    mark: bool = False

    @classmethod
    def read(cls, content: bytes, name: str) -> Document:
        """Return the document that a file's bytes hold; raises InputError if they are no text."""
        mark = content.startswith(BOM)
        if len(content) > casefile.LARGEST:
            expected = f"a TOML file of at most {casefile.LARGEST // 1_000_000} MB"
            raise InputError([Issue(name, "a larger file", expected)])
        try:
            text = content[len(BOM) :].decode("utf-8") if mark else content.decode("utf-8")
        except UnicodeDecodeError as error:
            line = content.count(b"\n", 0, error.start) + 1
            where = f"{name}, line {line}"
            raise InputError([Issue(where, "bytes that are not UTF-8", "UTF-8 text", "save it as UTF-8")]) from None
        windows = "\r\n" in text and text.count("\r\n") == text.count("\n")
        return cls(text.replace("\r\n", "\n"), "\r\n", mark) if windows else cls(text, "\n", mark)

    def content(self) -> bytes:
        """Return the bytes of the file."""
        text = self.text.replace("\n", self.newline) if self.newline != "\n" else self.text
        return (BOM if self.mark else b"") + text.encode("utf-8")

    @cached_property
    def data(self) -> dict[str, Any] | None:
        """What the text says, as tables, None while it is not TOML."""
        try:
            return tomllib.loads(self.text)
        except (ValueError, RecursionError):
            return None

    @cached_property
    def layout(self) -> Layout | None:
        """Where everything stands, None if that cannot be told."""
        if self.data is None:
            return None
        try:
            return Layout(self.text, self.data, _ORDER)
        except (AssertionError, IndexError, RecursionError):  # of a text stranger than any that we know
            return None

    def edited(self, edits: Sequence[Edit]) -> Document:
        """Return the document after some edits, one after the other; raises InputError if one of them cannot be."""
        document = self
        try:
            for edit in edits:
                document = document._edited(edit)
        except RecursionError:
            issue = Issue("the edit", "lists or tables nested too deeply", "those of an input file")
            raise InputError([issue]) from None
        return document

    def _edited(self, edit: Edit) -> Document:
        op, path = edit.get("op"), _path(edit)
        if op == "text":
            return self._with_text(edit.get("value"))
        layout = self.layout
        if layout is None:
            hint = "edit the text, or undo"
            raise InputError([Issue("the text", "text that is not TOML", "TOML, so that parts can be edited", hint)])
        if op == "set":
            return self._put(layout, path, _given(edit))
        if op == "length":
            old = value_at(layout.data, path)
            return self._put(layout, path, lengths.written(old, _given(edit), lengths.step_of(layout.data)))
        if op == "move":
            thing = _require(layout, path)
            by = lengths.moved(thing, _by(edit), lengths.step_of(layout.data), where_of(path))
            return self._put(layout, path, by)
        if op == "add":
            return self._add(layout, path, _given(edit), edit.get("at"))
        if op == "remove":
            return self._remove(layout, path)
        raise InputError([Issue("the edit", describe(op), "one of set, length, add, remove, move, text")])

    def _with_text(self, value: Any) -> Document:
        """Return the document with a text in place of the whole one."""
        if not isinstance(value, str):
            raise InputError([Issue("the text", describe(value), "text")])
        if any("\ud800" <= letter <= "\udfff" for letter in value):
            raise InputError([Issue("the text", "a lone surrogate", "text that a file can hold")])
        if len(value) > casefile.LARGEST:
            raise InputError([Issue("the text", "a longer text", f"at most {casefile.LARGEST:,} characters")])
        return replace(self, text=value if "\r\n" in self.text else value.replace("\r\n", "\n"))

    def _put(self, layout: Layout, path: Path, value: Any) -> Document:
        """Return the document with a value at a path; None takes away what is there."""
        if value is None:
            return self._remove(layout, path)
        _require_place(layout, path)
        if not path:
            if not isinstance(value, Mapping):
                raise InputError([Issue("the description", describe(value), "a table")])
            return self._checked(layout.put(path, value), value)
        return self._checked(layout.put(path, value), replaced(layout.data, path, value))

    def _add(self, layout: Layout, path: Path, value: Any, at: Any) -> Document:
        """Return the document with one more thing in a list, which is made if it is missing."""
        old = value_at(layout.data, path, _MISSING)
        if old is _MISSING:
            old = []
            _require_place(layout, path)
        if not isinstance(old, list) or not path:
            raise InputError([Issue(where_of(path), describe(old), "a list")])
        if at is not None and (isinstance(at, bool) or not isinstance(at, int) or not 0 <= at <= len(old)):
            raise InputError([Issue(where_of(path), describe(at), f"a position from 0 to {len(old)}")])
        position = len(old) if at is None else at
        new = [*old[:position], value, *old[position:]]
        if not old or (not isinstance(value, Mapping) and layout.value(path) is None):
            return self._checked(layout.put(path, new), replaced(layout.data, path, new))
        return self._checked(layout.insert(path, position, value), replaced(layout.data, path, new))

    def _remove(self, layout: Layout, path: Path) -> Document:
        """Return the document without what stands at a path; nothing happens if nothing stands there."""
        if not path or value_at(layout.data, path, _MISSING) is _MISSING:
            return self
        above, step = path[:-1], path[-1]
        around: Any = value_at(layout.data, above)
        left: Any
        if isinstance(around, Mapping):
            left = {name: each for name, each in around.items() if name != step}
        else:
            left = [each for position, each in enumerate(around) if position != step]
        return self._checked(layout.remove(path), replaced(layout.data, above, left))

    def _checked(self, splices: Sequence[Splice], expected: Any) -> Document:
        """Return the document with some text replaced, if it then says what is expected, and nothing else."""
        document = replace(self, text=spliced(self.text, splices))
        if document.data is None or not same(_filled(document.data), _filled(expected)):
            hint = "edit the text instead"
            found = "a file that is laid out too unusually for this edit"
            raise InputError([Issue("the edit", found, "a text in which only that changes", hint)])
        return document


def _path(edit: Edit) -> Path:
    """Return the path of an edit; raises InputError for what is none."""
    path = edit.get("path", [])
    fits = isinstance(path, list) and all(
        isinstance(step, str) or (isinstance(step, int) and not isinstance(step, bool) and step >= 0) for step in path
    )
    if not fits or len(path) > DEEPEST:
        raise InputError([Issue("the edit", describe(path), "a path of keys and positions from 0")])
    return tuple(path)


def _given(edit: Edit) -> Any:
    """Return the value of an edit, without keys whose value is nothing."""
    if "value" not in edit:
        raise InputError([Issue("the edit", "no value", f"a value for {describe(edit.get('op'))}")])
    return _without_nothing(edit["value"])


def _without_nothing(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {str(name): _without_nothing(each) for name, each in value.items() if each is not None}
    return [_without_nothing(each) for each in value] if isinstance(value, list) else value


def _by(edit: Edit) -> tuple[float, float]:
    """Return how far an edit moves things [m]."""
    match edit.get("by"):
        case [int() | float() as x, int() | float() as y] if math.isfinite(x) and math.isfinite(y):
            return float(x), float(y)
        case by:
            raise InputError([Issue("the edit", describe(by), "two distances in metres")])


def _require(layout: Layout, path: Path) -> Any:
    """Return what stands at a path; raises InputError if nothing does."""
    found = value_at(layout.data, path, _MISSING)
    if found is _MISSING:
        raise InputError([Issue(where_of(path), "nothing", "something to move")])
    return found


def _require_place(layout: Layout, path: Path) -> None:
    """Raise InputError where no value can stand: below one that is no table, or at a position that a list lacks."""
    around: Any = layout.data
    for number, step in enumerate(path):
        above = path[:number]
        if isinstance(step, int):
            if not isinstance(around, list) or step >= len(around):
                expected = f"a list of more than {step}; another one is added to a list, not set"
                raise InputError([Issue(where_of(above), describe(None if around is _MISSING else around), expected)])
            around = around[step]
        else:
            if around is not _MISSING and not isinstance(around, Mapping):
                raise InputError([Issue(where_of(above), describe(around), f"a table that can have {describe(step)}")])
            around = around.get(step, _MISSING) if isinstance(around, Mapping) else _MISSING


def _filled(value: Any) -> Any:
    """Return data without empty tables and lists: where all of a list is removed, nothing of it is left."""
    if isinstance(value, Mapping):
        filled = {name: _filled(each) for name, each in value.items()}
        return {name: each for name, each in filled.items() if each != {} and each != []}
    return [_filled(each) for each in value] if isinstance(value, list) else value
