"""The text of a case with other imported loads, all else as it is, with its comments."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from groundslab.case import casefile
from groundslab.case.editing.case_text import CaseText
from groundslab.case.editing.toml_values import Path
from groundslab.exchange.reactions.forces import Key
from groundslab.model.reactions import Reactions


class LoadsText(CaseText):
    """The text of a case whose imported loads are edited."""

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
                    rest = {key: item for key, item in self.data["reactions"].items() if key != name}
                    self._remove(("reactions", name), rest, {**self.data, "reactions": rest})

    def _remove(self, path: Path, rest: Any, expected: dict[str, Any]) -> None:
        if not self.apply(self.editor().remove(path, rest), expected):
            self.set(path[:-1], rest)

    def _replace_loads(self, old: list[Any], changed: Mapping[int, Any], gone: Sequence[int], kept: list[Any]) -> bool:
        """Change some loads and remove others, all at once; return whether the text then means that."""
        editor = self.editor()
        if editor.layout.is_inline(("loads",)):
            return False
        replacements = [replacement for n, load in changed.items() for replacement in editor.set(("loads", n), load)]
        rest = [load for n, load in enumerate(old) if n not in set(gone)]
        replacements += [replacement for n in gone for replacement in editor.remove(("loads", n), rest)]
        return self.apply(replacements, {**self.data, "loads": kept} if old else self.data)


def _is_imported(load: Any) -> bool:
    return isinstance(load, dict) and bool(load.get("source"))


def _key(load: Mapping[str, Any]) -> Key:
    return load.get("kind", ""), load.get("column") or load.get("wall") or "", load.get("case", "")


def _as_written(load: Mapping[str, Any], new: Mapping[str, str]) -> dict[str, str]:
    """Return a new load with its keys in the order of the one that is there."""
    return {key: new[key] for key in (*(key for key in load if key in new), *(key for key in new if key not in load))}
