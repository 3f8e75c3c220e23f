"""Which layer holds what, and whether it is there."""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

from groundslab.case.dxf.sheet import Sheet, Source
from groundslab.case.dxf.words import named
from groundslab.errors import Issue

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document
    from ezdxf.entities import DXFEntity


@dataclass(frozen=True, slots=True)
class Layers:
    """Which layer holds what; capitals do not matter, and an empty name stands for no layer."""

    outline: str = "OUTLINE"
    openings: str = "OPENINGS"
    zones: str = "ZONES"
    columns: str = "COLUMNS"
    point_loads: str = "LOADS"
    line_loads: str = "LOAD_LINE"
    area_loads: str = "LOAD_AREA"


#: Loads whose layers may go on behind their name with a value, as in "LOAD_LINE 25 kN_m".
WITH_VALUE = ("line_loads", "area_loads")


class Roles(Mapping[str, str]):
    """What each layer holds, by its name in small letters; layers whose names go on with a value are found too."""

    def __init__(self, named: Mapping[str, str]) -> None:
        self._named = named
        self._starts = {name: role for name, role in named.items() if role in WITH_VALUE}
        self._found: dict[str, str | None] = dict(named)

    def __getitem__(self, layer: str) -> str:
        """Return what a layer holds."""
        if layer not in self._found:
            start = self._start(layer)
            self._found[layer] = None if start is None else self._named[start]
        role = self._found[layer]
        if role is None:
            raise KeyError(layer)
        return role

    def __iter__(self) -> Iterator[str]:
        """Yield the names that were asked for."""
        return iter(self._named)

    def __len__(self) -> int:
        """Return how many were asked for."""
        return len(self._named)

    @property
    def known(self) -> tuple[str, ...]:
        """Return what layers hold."""
        return tuple(self._named.values())

    def behind(self, layer: str) -> str:
        """Return what stands behind the name that was asked for in the name of a layer."""
        start = self._start(layer.lower())
        return "" if start is None else layer[len(start) :].strip(" _-=")

    def _start(self, layer: str) -> str | None:
        """Return the name asked for with which that of a layer begins."""
        starts = (name for name in self._starts if layer.startswith(name) and not layer[len(name) :][:1].isalpha())
        return max(starts, key=len, default=None)


def roles_of(layers: Layers, sheet: Sheet) -> Roles:
    """Return what each layer holds."""
    roles: dict[str, str] = {}
    for role in (each.name for each in fields(layers)):
        name: str = getattr(layers, role)
        if name and name.lower() in roles:
            expected = "a layer of its own"
            sheet.issues.append(Issue(f"layer for {role}", f"{named(name)}, as for {roles[name.lower()]}", expected))
        elif name:
            roles[name.lower()] = role
    if not layers.outline:
        sheet.issues.append(Issue("layer for outline", "no name", "the name of a layer"))
    return Roles(roles)


def look_at(
    document: Document,
    layers: Layers,
    roles: Roles,
    entities: dict[str, list[tuple[Source, DXFEntity]]],
    sheet: Sheet,
) -> None:
    """Report layers that are hidden or empty; the outline's, or one that was asked for by name, must not be empty."""
    known = [layer.dxf.name for layer in document.layers]
    usual = Layers()
    for key, role in roles.items():
        name: str = getattr(layers, role)
        if document.layers.has_entry(name):
            layer = document.layers.get(name)
            hidden = [word for word, so in (("frozen", layer.is_frozen()), ("off", layer.is_off())) if so]
            if hidden:
                why = f"the layer is {' and '.join(hidden)}; it was read all the same"
                sheet.tell(Source(layer.dxf.name, "LAYER", layer.dxf.handle or ""), True, why)
        if entities[role] or (role in WITH_VALUE and key == getattr(usual, role).lower()):
            continue
        if role == "outline" or key != getattr(usual, role).lower():
            shown = ", ".join(named(each) for each in known[:12]) + (" ..." if len(known) > 12 else "")
            others = {each.lower(): each for each in known if each.lower() != key}
            close = difflib.get_close_matches(key, others, 1)
            hint = f"did you mean {named(others[close[0]])}? " if close else ""
            hint += f"the drawing has the layers {shown}"
            where = f"{sheet.path}, layer {named(name)}"
            sheet.issues.append(Issue(where, "nothing on it", f"entities for {role.replace('_', ' ')}", hint))
        else:
            sheet.tell(Source(name, "LAYER", ""), False, "nothing on it")
