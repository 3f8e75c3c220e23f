"""The DXF file: opening it, its unit of length, and what each of its layers holds."""

from __future__ import annotations

import logging
import math
import os
import re
from collections.abc import Mapping
from dataclasses import dataclass, fields
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING

from groundslab import units
from groundslab.errors import InputError, Issue
from groundslab.exchange.dxf.drawing import ReadContext, ReportLine, Source
from groundslab.schema.wording import describe, one_of, suggestion

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document
    from ezdxf.entities import DXFEntity

#: Units by the number that stands in a drawing's header: name and size in meters.
UNITS: dict[int, tuple[str, Fraction]] = {
    1: ("in", Fraction("0.0254")), 2: ("ft", Fraction("0.3048")), 3: ("mi", Fraction("1609.344")),
    4: ("mm", Fraction(1, 1000)), 5: ("cm", Fraction(1, 100)), 6: ("m", Fraction(1)), 7: ("km", Fraction(1000)),
    10: ("yd", Fraction("0.9144")), 14: ("dm", Fraction(1, 10)), 21: ("survey_foot", Fraction(1200, 3937)),
}  # fmt: skip


#: Ways in which a header says that lengths are written ($LUNITS): engineering and architectural ones.
FEET_AND_INCHES = (3, 4)
#: The largest file that is read [bytes]: reading one takes some ten times its size of memory.
LARGEST_FILE = 16_000_000


_SILENT = logging.NullHandler()


def open_drawing(path: str) -> Document:
    """Return the drawing as ezdxf reads it."""
    expected = "a DXF drawing"
    try:
        from ezdxf.filemanagement import readfile
    except ImportError:
        hint = "pip install groundslab[dxf]"
        raise InputError([Issue(path, "a DXF drawing", "ezdxf to read it", hint)]) from None
    try:
        if Path(path).exists() and not (Path(path).is_file() or Path(path).is_dir()):
            raise InputError([Issue(path, "a device or a pipe", "a DXF drawing, which is a file")])
        with Path(path).open("rb") as file:
            start, size = file.read(6), os.fstat(file.fileno()).st_size
    except FileNotFoundError:
        raise InputError([Issue(path, "no file of that name", expected)]) from None
    except IsADirectoryError:
        raise InputError([Issue(path, "a directory", expected)]) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError([Issue(path, f"a file that cannot be read ({reason})", expected)]) from None
    if re.match(rb"AC10\d\d", start):
        raise InputError([Issue(path, "a DWG drawing", expected, "save it as DXF in the CAD program")])
    if size > LARGEST_FILE:
        hint = "save only the layers that are needed in a separate file"
        file_size = f"a file of {size / 1e6:,.0f} MB"
        raise InputError([Issue(path, file_size, f"at most {LARGEST_FILE / 1e6:.0f} MB", hint)])
    # what ezdxf says of a damaged drawing is no message for who reads ours, and may be very long
    logging.getLogger("ezdxf").addHandler(_SILENT)
    try:
        document = readfile(path)
        document.modelspace()  # which a damaged file may lack
    except OSError:
        raise InputError([Issue(path, "a file that is not DXF", expected)]) from None
    except MemoryError:
        raise
    except Exception as error:  # of any kind, as what is damaged may be anything
        damage = f"a damaged DXF file ({error})"
        raise InputError([Issue(path, damage, expected, "save it again in the CAD program")]) from None
    return document


def set_unit(document: Document, unit: str | None, context: ReadContext) -> None:
    """Give the context its unit: the one that was given, else the drawing's own."""
    code = document.header.get("$INSUNITS", 0)
    own_unit = UNITS.get(code)
    if unit is not None:
        try:
            scale = Fraction(repr(units.parse(f"1 {unit}", "length")))
        except units.QuantityError as error:
            expected = 'the name of a length, such as "mm"'
            context.issues.append(Issue("the drawing's unit", describe(unit), expected, error.reason))
            return
        context.unit, context.scale = unit, scale
        if own_unit is not None and not math.isclose(own_unit[1], scale, rel_tol=1e-5):
            why = f"the drawing says that its unit is {own_unit[0]}; it was read in {unit} as given"
            context.report.append(ReportLine("", "HEADER", "", False, why))
    elif own_unit is not None:
        context.unit, context.scale = own_unit
        if document.header.get("$LUNITS", 2) in FEET_AND_INCHES and own_unit[0] not in ("in", "ft", "survey_foot"):
            why = f"the drawing says that its unit is {own_unit[0]}, and writes lengths in feet and inches"
            context.report.append(ReportLine("", "HEADER", "", False, why))
    else:
        drawing_unit = f"unit number {code}" if code else "no unit"
        hint = 'say the unit, such as "mm", or set INSUNITS in the drawing'
        context.issues.append(Issue(f"{context.path}, header, $INSUNITS", drawing_unit, "a unit of length", hint))


@dataclass(frozen=True, slots=True)
class Layers:
    """Which layer holds what; capitals do not matter, and an empty name stands for no layer."""

    outline: str = "OUTLINE"
    openings: str = "OPENINGS"
    zones: str = "ZONES"
    columns: str = "COLUMNS"
    walls: str = "WALLS"
    beams: str = "BEAMS"
    point_loads: str = "LOADS"
    line_loads: str = "LOAD_LINE"
    area_loads: str = "LOAD_AREA"


#: What layers may go on behind their name with a value for, as in "LOAD_LINE 25 kN_m" and "WALLS 25 cm".
WITH_VALUE = ("walls", "beams", "line_loads", "area_loads")


class Roles:
    """What layers hold, by their names in lower case.

    A name may go on with a value where its role allows one, unless all layers are named; then usual names may.
    """

    def __init__(self, named: Mapping[str, str], every: bool = False) -> None:
        self.named = named
        self._every = every
        usual = {getattr(Layers(), role).lower(): role for role in Layers.__dataclass_fields__}
        #: Known names as they may be spelled: with other signs between words, usual ones in the singular or plural too.
        self._forms: dict[str, str] = {}
        for name, role in (usual if every else named).items():
            self._forms[_flat(name)] = role
            if usual.get(name) == role:
                singular = _flat(name).removesuffix("s")
                self._forms |= {form: role for form in (singular, f"{singular}s") if form not in named}

    def of(self, layer: str) -> str | None:
        """Return the role of a layer, None if it is not read."""
        role = self.named.get(layer.lower())
        if role is not None or self._every:
            return role
        name = _flat(layer)
        return self._forms.get(name) or self._forms.get(self._start(name))

    def suffix(self, layer: str) -> str:
        """Return the part of a layer's name after the known name."""
        start = self._start(_flat(layer))
        return layer.strip()[len(start) :].strip(" _-=") if start else ""

    def _start(self, layer: str) -> str:
        """Return the known name with which that of a layer begins and may go on, empty if there is none."""
        starts = (name for name, role in self._forms.items() if role in WITH_VALUE and layer.startswith(name))
        return max((name for name in starts if not layer[len(name) :][:1].isalpha()), key=len, default="")


def _flat(layer: str) -> str:
    """Return the name of a layer in small letters, with one sign between words and no spaces around it."""
    return layer.strip().lower().translate(_BETWEEN)


_BETWEEN = str.maketrans(" -", "__")


def assign_roles(layers: Layers, context: ReadContext) -> Roles:
    """Return the role of each layer; a usual name that another role was given is that one's."""
    roles: dict[str, str] = {}
    names = {field.name: str(getattr(layers, field.name)) for field in fields(layers)}
    taken = {name.lower() for role, name in names.items() if name != getattr(Layers(), role)}
    for role, name in names.items():
        if role != "outline" and name == getattr(Layers(), role) and name.lower() in taken:
            continue
        if name and name.lower() in roles:
            expected = "a separate layer"
            context.issues.append(
                Issue(f"layer for {role}", f"{describe(name)}, as for {roles[name.lower()]}", expected)
            )
        elif name:
            roles[name.lower()] = role
    if not layers.outline:
        context.issues.append(Issue("layer for outline", "no name", "the name of a layer"))
    return Roles(roles)


def name_roles(layers: Mapping[str, str], context: ReadContext) -> Roles:
    """Return the role of each layer from a full list of names, of which several may have the same role."""
    roles = [field.name for field in fields(Layers)]
    for layer, role in layers.items():
        if role not in roles:
            where = f"layer {describe(layer)}"
            context.issues.append(Issue(where, describe(role), one_of(roles), suggestion(role, roles)))
    if "outline" not in layers.values():
        context.issues.append(Issue("layer for outline", "no layer", "the layer that holds the slab's edge"))
    return Roles({layer.lower(): role for layer, role in layers.items()}, every=True)


def check_named_layers(
    document: Document, layers: Mapping[str, str], entities: dict[str, list[tuple[Source, DXFEntity]]],
    context: ReadContext,
) -> None:  # fmt: skip
    """Report layers that are hidden or empty, where all that are read are named; that of the outline must not be."""
    full = {source.layer.lower() for sources in entities.values() for source, _ in sources}
    for name, role in layers.items():
        _report_hidden(document, name, context)
        if name.lower() not in full:
            context.report_entity(Source(name, "LAYER", ""), False, "nothing on it")
        if role == "outline" and not entities["outline"]:
            where = f"{context.path}, layer {describe(name)}"
            context.issues.append(Issue(where, "nothing on it", "entities for outline"))


def _report_hidden(document: Document, name: str, context: ReadContext) -> None:
    """Report a layer that is not shown."""
    if not document.layers.has_entry(name):
        return
    layer = document.layers.get(name)
    hidden = [word for word, so in (("frozen", layer.is_frozen()), ("off", layer.is_off())) if so]
    if hidden:
        why = f"the layer is {' and '.join(hidden)}; it was read all the same"
        context.report_entity(Source(layer.dxf.name, "LAYER", layer.dxf.handle or ""), True, why)


def check_layers(
    document: Document,
    layers: Layers,
    roles: Roles,
    entities: dict[str, list[tuple[Source, DXFEntity]]],
    context: ReadContext,
) -> None:
    """Report layers that are hidden or empty; the outline's, or one given by name, must not be empty."""
    names = [layer.dxf.name for layer in document.layers]
    usual = Layers()
    for key, role in roles.named.items():
        name: str = getattr(layers, role)
        _report_hidden(document, name, context)
        if entities[role] or (role in WITH_VALUE and key == getattr(usual, role).lower()):
            continue
        if role == "outline" or key != getattr(usual, role).lower():
            shown = ", ".join(describe(layer) for layer in names[:12]) + (" ..." if len(names) > 12 else "")
            meant = suggestion(name, [layer for layer in names if layer.lower() != key])
            hint = f"{meant} the drawing has the layers {shown}".lstrip()
            where = f"{context.path}, layer {describe(name)}"
            context.issues.append(Issue(where, "nothing on it", f"entities for {role.replace('_', ' ')}", hint))
        else:
            context.report_entity(Source(name, "LAYER", ""), False, "nothing on it")
