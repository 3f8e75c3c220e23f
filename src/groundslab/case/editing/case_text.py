"""The text of a case that is edited step by step, all else as it is, with its comments."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from typing import Any

from groundslab.case.editing.toml_edits import TomlEditor
from groundslab.case.editing.toml_inline import Replacement, apply_replacements
from groundslab.case.editing.toml_layout import TomlLayout
from groundslab.case.editing.toml_values import Path, equal_values
from groundslab.errors import InputError, Issue
from groundslab.model.model import Model

_ORDER = tuple(Model.model_fields)


class CaseText:
    """The text of a case, edited step by step; each step must mean what it should, or is refused."""

    def __init__(self, text: str, data: dict[str, Any]) -> None:
        """Begin with a text and its tables."""
        self.text, self.data = text, data

    def set(self, path: Path, value: Any) -> None:
        """Set the value at a path of keys and positions."""
        expected = _with(self.data, path, value)
        if not equal_values(self.data, expected) and not self.apply(self.editor().set(path, value), expected):
            raise InputError([Issue("the case", "a layout that does not allow this edit", "tables with headings")])

    def editor(self) -> TomlEditor:
        """Return an editor of the text; raises InputError where its layout cannot be edited."""
        try:
            return TomlEditor(TomlLayout(self.text, self.data), _ORDER)
        except (AssertionError, IndexError, RecursionError):  # TOML that our reader does not support
            raise InputError([Issue("the case", "a layout that cannot be edited", "tables with headings")]) from None

    def apply(self, replacements: Sequence[Replacement], expected: dict[str, Any]) -> bool:
        """Apply replacements if the text then has the expected tables; return whether it has."""
        text = apply_replacements(self.text, replacements)
        try:
            data = tomllib.loads(text)
        except ValueError:
            return False
        if not equal_values(_filled(data), _filled(expected)):
            return False
        self.text, self.data = text, data
        return True


def _filled(data: Mapping[str, Any]) -> dict[str, Any]:
    """Return tables without empty ones, which leave nothing in a file."""
    return {key: value for key, value in data.items() if value not in ([], {})}


def _with(data: Any, path: Path, value: Any) -> Any:
    """Return tables with another value at a path; tables on the way that are missing are made."""
    if not path:
        return value
    if isinstance(path[0], int):
        return [_with(item, path[1:], value) if n == path[0] else item for n, item in enumerate(data)]
    return {**data, path[0]: _with(data.get(path[0], {}), path[1:], value)}
