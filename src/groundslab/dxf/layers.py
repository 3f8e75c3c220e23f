"""Which layer holds what, and whether it is there."""

from __future__ import annotations

import difflib
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

from groundslab.dxf.sheet import Sheet, Source
from groundslab.dxf.words import named
from groundslab.errors import Fault

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


def roles_of(layers: Layers, sheet: Sheet) -> dict[str, str]:
    """Return what each layer holds, by its name in small letters."""
    roles: dict[str, str] = {}
    for role in (each.name for each in fields(layers)):
        name: str = getattr(layers, role)
        if name and name.lower() in roles:
            expected = "a layer of its own"
            sheet.faults.append(Fault(f"layer for {role}", f"{named(name)}, as for {roles[name.lower()]}", expected))
        elif name:
            roles[name.lower()] = role
    if not layers.outline:
        sheet.faults.append(Fault("layer for outline", "no name", "the name of a layer"))
    return roles


def look_at(
    document: Document,
    layers: Layers,
    roles: dict[str, str],
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
        if entities[role]:
            continue
        if role == "outline" or key != getattr(usual, role).lower():
            shown = ", ".join(named(each) for each in known[:12]) + (" ..." if len(known) > 12 else "")
            others = {each.lower(): each for each in known if each.lower() != key}
            close = difflib.get_close_matches(key, others, 1)
            mend = f"did you mean {named(others[close[0]])}? " if close else ""
            mend += f"the drawing has the layers {shown}"
            where = f"{sheet.path}, layer {named(name)}"
            sheet.faults.append(Fault(where, "nothing on it", f"entities for {role.replace('_', ' ')}", mend))
        else:
            sheet.tell(Source(name, "LAYER", ""), False, "nothing on it")
