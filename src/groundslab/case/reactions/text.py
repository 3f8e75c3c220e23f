"""The text of a case with other imported loads, all else as it is, with its comments."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from typing import Any

from groundslab.case import casefile
from groundslab.case.editing.toml_edits import TomlEditor
from groundslab.case.editing.toml_inline import Replacement, apply_replacements
from groundslab.case.editing.toml_layout import TomlLayout
from groundslab.case.editing.toml_values import Path, equal_values
from groundslab.case.reactions.forces import Key
from groundslab.errors import InputError, Issue
from groundslab.model.model import Model
from groundslab.model.reactions import Reactions

_ORDER = tuple(Model.model_fields)


class CaseText:
    """The text of a case, edited step by step; each step must mean what it should, or is refused."""

    def __init__(self, text: str, data: dict[str, Any]) -> None:
        """Begin with a text and its tables."""
        self.text, self.data = text, data

    def set(self, path: Path, value: Any) -> None:
        """Set the value at a path of keys and positions."""
        expected = _with(self.data, path, value)
        if not equal_values(self.data, expected) and not self._try(self._editor().set(path, value), expected):
            raise InputError([Issue("the case", "a layout that does not allow this edit", "tables with headings")])

    def set_loads(self, loads: Mapping[Key, Mapping[str, str]]) -> None:
        """Put other imported loads in place of those that are there."""
        old = self.data.get("loads", [])
        left = dict(loads)
        kept: list[Any] = []
        changed, gone = dict[int, Any](), list[int]()
        for position, load in enumerate(old):
            if not _is_imported(load):
                kept.append(load)
            elif (new := left.pop(_key(load), None)) is None:
                gone.append(position)
            else:
                # a name that somebody gave to a load stays
                named = {"name": load["name"]} if "name" in load else {}
                kept.append({**named, **_as_written(load, new)})
                changed[position] = kept[-1]
        if not self._replace_loads(old, changed, gone, kept):
            self.set(("loads",), kept)
        self.set(("loads",), [*kept, *map(dict, left.values())])

    def set_reactions(self, reactions: Reactions, before: Reactions | None) -> None:
        """Keep how the table was read: keys that differ from those that are there."""
        data = casefile.tables(casefile.to_toml(reactions))
        if before is None:
            self.set(("reactions",), data)
            return
        for name, value in reactions:
            if value != getattr(before, name):
                if name in data:
                    self.set(("reactions", name), data[name])
                else:
                    rest = {key: each for key, each in self.data["reactions"].items() if key != name}
                    self._remove(("reactions", name), rest, {**self.data, "reactions": rest})

    def _remove(self, path: Path, rest: Any, expected: dict[str, Any]) -> None:
        if not self._try(self._editor().remove(path, rest), expected):
            self.set(path[:-1], rest)

    def _replace_loads(self, old: list[Any], changed: Mapping[int, Any], gone: Sequence[int], kept: list[Any]) -> bool:
        """Change some loads and remove others, all at once; return whether the text then means that."""
        editor = self._editor()
        if editor.layout.is_inline(("loads",)):
            return False
        replacements = [each for n, load in changed.items() for each in editor.set(("loads", n), load)]
        rest = [load for n, load in enumerate(old) if n not in set(gone)]
        replacements += [each for n in gone for each in editor.remove(("loads", n), rest)]
        return self._try(replacements, {**self.data, "loads": kept} if old else self.data)

    def _editor(self) -> TomlEditor:
        try:
            return TomlEditor(TomlLayout(self.text, self.data), _ORDER)
        except (AssertionError, IndexError, RecursionError):  # TOML that our reader does not support
            raise InputError([Issue("the case", "a layout that cannot be edited", "tables with headings")]) from None

    def _try(self, replacements: Sequence[Replacement], expected: dict[str, Any]) -> bool:
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
        return [_with(each, path[1:], value) if n == path[0] else each for n, each in enumerate(data)]
    return {**data, path[0]: _with(data.get(path[0], {}), path[1:], value)}


def _is_imported(load: Any) -> bool:
    return isinstance(load, dict) and bool(load.get("source"))


def _key(load: Mapping[str, Any]) -> Key:
    return load.get("kind", ""), load.get("column") or load.get("wall") or "", load.get("case", "")


def _as_written(load: Mapping[str, Any], new: Mapping[str, str]) -> dict[str, str]:
    """Return a new load with its keys in the order of the one that is there."""
    return {key: new[key] for key in (*(key for key in load if key in new), *(key for key in new if key not in load))}
