"""What is written in a drawing: words, their place, and the force in them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from groundslab import units
from groundslab.case.dxf.sheet import FARTHEST, Sheet, Source
from groundslab.geometry.bulges import Point

if TYPE_CHECKING:
    from ezdxf.entities import DXFEntity

_STARTS = re.compile(r"(?:^|(?<=[\s=:]))(?=[+-]?\.?[0-9])", re.MULTILINE)
_FIRM = re.compile(r"^(?:|.*[=:])\s*(?=[+-]?\.?[0-9])", re.MULTILINE)
_WITH_UNIT = re.compile(rf"{units.NUMBER}\s*[A-Za-z]+")
_WITH_UNITS = re.compile(rf"{units.NUMBER}\s*[A-Za-z]+(?:\s?/\s?[A-Za-z]+(?:\^?2|²)?)?")
#: What a load is given in, by what its layer holds.
DIMENSION = {"point_loads": "force", "line_loads": "force per length", "area_loads": "pressure"}
LONGEST = 200  # letters of a text, of which no more is read


@dataclass(frozen=True, slots=True)
class Label:
    """Something written: its words, the value in it or why it is none, and the line that it stands on."""

    source: Source
    words: str
    value: float | str | None
    start: Point
    end: Point
    height: float


def value_in(words: str, dimension: str = "force") -> float | str | None:
    """Return the force in a text, or what is wrong with it, or None if the text is only a name.

    What begins with a number, or has one after = or :, is meant to be a value; so is any force in it. The same of a
    force per length or a pressure, if that is the dimension; then any of the three is meant to be a value.
    """
    meant = _WITH_UNIT if dimension == "force" else _WITH_UNITS
    found = meant.findall(words)
    values = [each for each in found if isinstance(_quantity(each, dimension), float)]
    if len(values) > 1:
        return f"more than one {dimension}"
    firm = _FIRM.search(words)
    if firm:
        return _quantity(words[firm.end() :].split("\n")[0], dimension)
    read = [_quantity(words[start.end() :].split("\n")[0], dimension) for start in _STARTS.finditer(words)]
    numbers = [each for each in read if isinstance(each, float)]
    if numbers:
        return numbers[0]
    if any(isinstance(_quantity(each, other), float) for each in found for other in {dimension, *_others(dimension)}):
        return "it is not a name, a number and a unit" if values else f"it is no {dimension}"
    return None


def value_behind(words: str, dimension: str) -> float | str | None:
    """Return the value in what stands behind the name of a layer; "kN_m" is kN/m, as no layer may hold a slash."""
    words = words.replace("_", " ")[:LONGEST]
    value = value_in(words, dimension)
    if isinstance(value, float):
        return value
    divided = value_in(re.sub(r"(?<=[A-Za-z])[ -]+(?=m\^?2?\b)", "/", words), dimension)
    return divided if isinstance(divided, float) else value


def _others(dimension: str) -> set[str]:
    """Return what else a value may be meant to be; beside points forces alone are."""
    return set() if dimension == "force" else set(DIMENSION.values())


def _quantity(words: str, dimension: str) -> float | str:
    """Return a quantity of a dimension, or why the words are none."""
    try:
        return units.parse(words, dimension)
    except units.QuantityError as error:
        return error.reason


def label_of(source: Source, entity: DXFEntity, sheet: Sheet, dimension: str = "force") -> Label | None:
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
    words = words if len(words) <= LONGEST else words[: LONGEST - 3] + "..."
    width = 0.7 * height * max(map(len, words.splitlines()), default=0)
    height = min(abs(height), FARTHEST)
    start = place - along * (shift * width)
    words = "\n".join(" ".join(line.split()) for line in words.splitlines()).strip()
    spots = sheet.point(start), sheet.point(start + along * width)
    return Label(source, words, value_in(words, dimension), *spots, sheet.metres(height))
