"""The text of a case file, and edits of it."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from groundslab.case import casefile
from groundslab.case.editing import lengths
from groundslab.case.editing.toml_edits import TomlEditor
from groundslab.case.editing.toml_inline import Replacement, apply_replacements
from groundslab.case.editing.toml_layout import TomlLayout
from groundslab.case.editing.toml_values import MISSING, Path, equal_values, get_value, replace_value
from groundslab.errors import InputError, Issue
from groundslab.model.model import Model
from groundslab.schema.wording import describe
from groundslab.workbench.editing.diagnostics import format_path

Edit = Mapping[str, Any]
BOM = b"\xef\xbb\xbf"
MAX_DEPTH = 50  # steps of a path
_ORDER = tuple(Model.model_fields)


@dataclass(frozen=True)
class Document:
    """The text of a case file with line ends ``\\n``; the file has its own line ends, and perhaps a byte order mark."""

    text: str
    newline: str = "\n"
    has_bom: bool = False

    @classmethod
    def from_bytes(cls, content: bytes, name: str) -> Document:
        """Decode the content of a file; raises InputError if it is not UTF-8 or too large."""
        has_bom = content.startswith(BOM)
        if len(content) > casefile.LARGEST:
            expected = f"a TOML file of at most {casefile.LARGEST // 1_000_000} MB"
            raise InputError([Issue(name, "a larger file", expected)])
        try:
            text = content[len(BOM) :].decode("utf-8") if has_bom else content.decode("utf-8")
        except UnicodeDecodeError as error:
            line = content.count(b"\n", 0, error.start) + 1
            location = f"{name}, line {line}"
            raise InputError([Issue(location, "bytes that are not UTF-8", "UTF-8 text", "save it as UTF-8")]) from None
        windows = "\r\n" in text and text.count("\r\n") == text.count("\n")
        return cls(text.replace("\r\n", "\n"), "\r\n", has_bom) if windows else cls(text, "\n", has_bom)

    def to_bytes(self) -> bytes:
        """Return the content of the file."""
        text = self.text.replace("\n", self.newline) if self.newline != "\n" else self.text
        return (BOM if self.has_bom else b"") + text.encode("utf-8")

    @cached_property
    def data(self) -> dict[str, Any] | None:
        """The parsed text, None while it is not TOML."""
        try:
            return tomllib.loads(self.text)
        except (ValueError, RecursionError):
            return None

    @cached_property
    def layout(self) -> TomlLayout | None:
        """The positions in the text, None if they cannot be determined."""
        if self.data is None:
            return None
        try:
            return TomlLayout(self.text, self.data)
        except (AssertionError, IndexError, RecursionError):  # TOML that our reader does not support
            return None

    def apply(self, edits: Sequence[Edit]) -> Document:
        """Return the document after some edits in order; raises InputError if one of them is invalid."""
        document = self
        try:
            for edit in edits:
                document = document._apply(edit)
        except RecursionError:
            issue = Issue("the edit", "lists or tables nested too deeply", "those of an input file")
            raise InputError([issue]) from None
        return document

    def _apply(self, edit: Edit) -> Document:
        op, path = edit.get("op"), _get_path(edit)
        if op == "text":
            return self._with_text(edit.get("value"))
        if self.layout is None:
            hint = "edit the text, or undo"
            raise InputError([Issue("the text", "text that is not TOML", "TOML, so that parts can be edited", hint)])
        editor = TomlEditor(self.layout, _ORDER)
        if op == "set":
            return self._set(editor, path, _get_value(edit))
        if op in ("length", "move"):
            old, resolution = get_value(editor.data, path, MISSING), lengths.choose_resolution(editor.data)
            if op == "length":
                return self._set(editor, path, lengths.format_lengths(old, _get_value(edit), resolution))
            if old is MISSING:
                raise InputError([Issue(format_path(path), "nothing", "an item to move")])
            return self._set(editor, path, lengths.translate(old, _get_distances(edit), resolution, format_path(path)))
        if op == "add":
            return self._add(editor, path, _get_value(edit), edit.get("at"))
        if op == "remove":
            return self._remove(editor, path)
        if op == "reorder":
            return self._reorder(editor, path, edit.get("value"))
        if op == "rename":
            return self._rename(editor, path, _get_value(edit))
        raise InputError(
            [Issue("the edit", describe(op), "one of set, length, add, remove, rename, reorder, move, text")]
        )

    def _with_text(self, value: Any) -> Document:
        """Return the document with another text."""
        if not isinstance(value, str):
            raise InputError([Issue("the text", describe(value), "text")])
        if any("\ud800" <= letter <= "\udfff" for letter in value):
            raise InputError([Issue("the text", "a lone surrogate", "text that a file can hold")])
        if len(value) > casefile.LARGEST:
            raise InputError([Issue("the text", "a longer text", f"at most {casefile.LARGEST:,} characters")])
        return replace(self, text=value if "\r\n" in self.text else value.replace("\r\n", "\n"))

    def _set(self, editor: TomlEditor, path: Path, value: Any) -> Document:
        """Return the document with a value at a path; None removes what is there."""
        if value is None:
            return self._remove(editor, path)
        _require_parent(editor.data, path)
        if not path and not isinstance(value, Mapping):
            raise InputError([Issue("the description", describe(value), "a table")])
        return self._replace(editor.set(path, value), replace_value(editor.data, path, value))

    def _add(self, editor: TomlEditor, path: Path, value: Any, at: Any) -> Document:
        """Return the document with a value added to a list, which is created if it is missing."""
        old = get_value(editor.data, path, MISSING)
        if old is MISSING:
            old = []
            _require_parent(editor.data, path)
        if not isinstance(old, list) or not path:
            raise InputError([Issue(format_path(path), describe(old), "a list")])
        if at is not None and (isinstance(at, bool) or not isinstance(at, int) or not 0 <= at <= len(old)):
            raise InputError([Issue(format_path(path), describe(at), f"a position from 0 to {len(old)}")])
        index = len(old) if at is None else at
        new = [*old[:index], value, *old[index:]]
        return self._replace(editor.set(path, new), replace_value(editor.data, path, new))

    def _remove(self, editor: TomlEditor, path: Path) -> Document:
        """Return the document without the value at a path, unchanged if there is none."""
        if not path or get_value(editor.data, path, MISSING) is MISSING:
            return self
        above, step = path[:-1], path[-1]
        parent: Any = get_value(editor.data, above)
        rest: Any
        if isinstance(parent, Mapping):
            rest = {name: entry for name, entry in parent.items() if name != step}
        else:
            rest = [item for index, item in enumerate(parent) if index != step]
        return self._replace(editor.remove(path, rest), replace_value(editor.data, above, rest))

    def _reorder(self, editor: TomlEditor, path: Path, to: Any) -> Document:
        """Return the document with an item of a list at another position, its comments with it."""
        above: Any = get_value(editor.data, path[:-1], MISSING) if path else MISSING
        if not isinstance(above, list) or get_value(editor.data, path, MISSING) is MISSING:
            raise InputError([Issue(format_path(path), "nothing", "an item of a list to move")])
        if isinstance(to, bool) or not isinstance(to, int) or not 0 <= to < len(above):
            raise InputError([Issue(format_path(path), describe(to), f"a position from 0 to {len(above) - 1}")])
        index = path[-1]
        assert isinstance(index, int)
        new = list(above)
        new.insert(to, new.pop(index))
        return self._replace(editor.reorder(path[:-1], index, to), replace_value(editor.data, path[:-1], new))

    def _rename(self, editor: TomlEditor, path: Path, name: Any) -> Document:
        """Return the document with another name for a key."""
        table: Any = get_value(editor.data, path[:-1], MISSING)
        if not path or not isinstance(table, Mapping) or path[-1] not in table:
            raise InputError([Issue(format_path(path), "nothing", "a key to rename")])
        if not isinstance(name, str) or name in table:
            raise InputError([Issue(format_path(path), describe(name), "a name that is free")])
        renamed = {name if key == path[-1] else key: entry for key, entry in table.items()}
        return self._replace(editor.rename(path, name), replace_value(editor.data, path[:-1], renamed))

    def _replace(self, replacements: Sequence[Replacement], expected: Any) -> Document:
        """Return the document with some text replaced; raises InputError unless its data are then as expected."""
        document = replace(self, text=apply_replacements(self.text, replacements))
        if document.data is None or not equal_values(_drop_empty(document.data), _drop_empty(expected)):
            rigid_layout, hint = "a file whose layout does not allow this edit", "edit the text instead"
            raise InputError([Issue("the edit", rigid_layout, "a text in which only that changes", hint)])
        return document


def _get_path(edit: Edit) -> Path:
    """Return the path of an edit; raises InputError if it is not valid."""
    path = edit.get("path", [])
    fits = isinstance(path, list) and all(
        isinstance(step, str) or (isinstance(step, int) and not isinstance(step, bool) and step >= 0) for step in path
    )
    if not fits or len(path) > MAX_DEPTH:
        raise InputError([Issue("the edit", describe(path), "a path of keys and of positions from 0")])
    return tuple(path)


def _get_value(edit: Edit) -> Any:
    """Return the value of an edit, without keys whose value is None."""
    if "value" not in edit:
        raise InputError([Issue("the edit", "no value", f"a value for {describe(edit.get('op'))}")])
    return _drop_none(edit["value"])


def _drop_none(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {str(name): _drop_none(entry) for name, entry in value.items() if entry is not None}
    return [_drop_none(item) for item in value] if isinstance(value, list) else value


def _get_distances(edit: Edit) -> tuple[float, float]:
    """Return the translation of an edit [m]."""
    match edit.get("by"):
        case [int() | float() as x, int() | float() as y] if abs(x) <= lengths.LARGEST and abs(y) <= lengths.LARGEST:
            return float(x), float(y)
        case by:
            raise InputError([Issue("the edit", describe(by), "two distances in meters")])


def _require_parent(data: Any, path: Path) -> None:
    """Raise InputError where no value can be set: below one that is not a table, or at a missing index of a list."""
    for depth, step in enumerate(path):
        if isinstance(step, int):
            if not isinstance(data, list) or step >= len(data):
                expected = f"a list of more than {step}; another one is added to a list, not set"
                described = describe(None if data is MISSING else data)
                raise InputError([Issue(format_path(path[:depth]), described, expected)])
            data = data[step]
        elif data is MISSING or isinstance(data, Mapping):
            data = MISSING if data is MISSING else data.get(step, MISSING)
        else:
            expected = f"a table that can have {describe(step)}"
            raise InputError([Issue(format_path(path[:depth]), describe(data), expected)])


def _drop_empty(value: Any) -> Any:
    """Return data without empty tables and lists, which leave nothing in a file of headers."""
    if isinstance(value, Mapping):
        filled = {name: _drop_empty(entry) for name, entry in value.items()}
        return {name: entry for name, entry in filled.items() if entry != {} and entry != []}
    return [_drop_empty(item) for item in value] if isinstance(value, list) else value
