"""What is written in a drawing: words, their place, and the force in them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from groundslab import units
from groundslab.dxf.curves import Point
from groundslab.dxf.sheet import Sheet, Source

if TYPE_CHECKING:
    from ezdxf.entities import DXFEntity

_STARTS = re.compile(r"(?:^|(?<=[\s=:]))(?=[+-]?\.?[0-9])", re.MULTILINE)
_FIRM = re.compile(r"^(?:|.*[=:])\s*(?=[+-]?\.?[0-9])", re.MULTILINE)
_WITH_UNIT = re.compile(rf"{units.NUMBER}\s*[A-Za-z]+")


@dataclass(frozen=True, slots=True)
class Label:
    """Something written: its words, the value in it or why it is none, and the line that it stands on."""

    source: Source
    words: str
    value: float | str | None
    start: Point
    end: Point
    height: float


def value_in(words: str) -> float | str | None:
    """Return the force in a text, or what is wrong with it, or None if the text is only a name.

    What begins with a number, or has one after = or :, is meant to be a value; so is any force in it.
    """
    forces = [each for each in _WITH_UNIT.findall(words) if isinstance(_force(each), float)]
    if len(forces) > 1:
        return "more than one force"
    firm = _FIRM.search(words)
    if firm:
        return _force(words[firm.end() :].split("\n")[0])
    read = [_force(words[start.end() :].split("\n")[0]) for start in _STARTS.finditer(words)]
    values = [each for each in read if isinstance(each, float)]
    if values:
        return values[0]
    return "it is not a name, a number and a unit" if forces else None


def _force(words: str) -> float | str:
    """Return a force, or why the words are none."""
    try:
        return units.parse(words, "force")
    except units.QuantityError as error:
        return error.reason


def label_of(source: Source, entity: DXFEntity, sheet: Sheet) -> Label | None:
    """Return what a TEXT, ATTRIB or MTEXT says and where, None for anything else."""
    from ezdxf.entities import MText, Text
    from ezdxf.math import Vec3

    if isinstance(entity, Text):
        alignment, at, _ = entity.get_placement()
        words, height, angle = entity.plain_text(), entity.dxf.height, entity.dxf.rotation
        shift = {"RIGHT": 1.0, "CENTER": 0.5, "MIDDLE": 0.5}.get(alignment.name.rpartition("_")[2], 0.0)
        place = entity.ocs().to_wcs(at)
        along = entity.ocs().to_wcs(Vec3.from_deg_angle(angle))
    elif isinstance(entity, MText):
        words, height, place = entity.plain_text(), entity.dxf.char_height, entity.dxf.insert
        shift = (entity.dxf.attachment_point - 1) % 3 / 2
        along = Vec3.from_deg_angle(entity.get_rotation())
    else:
        return None
    width = 0.7 * height * max(map(len, words.splitlines()), default=0)
    start = place - along * (shift * width)
    words = "\n".join(" ".join(line.split()) for line in words.splitlines()).strip()
    spots = sheet.point(start), sheet.point(start + along * width)
    return Label(source, words, value_in(words), *spots, sheet.metres(height))
