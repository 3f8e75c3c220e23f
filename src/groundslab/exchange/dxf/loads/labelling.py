"""Texts in a drawing, the quantities in them, and which load each belongs to."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from groundslab import units
from groundslab.case.numbers import format_number, readings, why_unclear
from groundslab.exchange.dxf.drawing import FARTHEST, ReadContext, Source
from groundslab.geometry.plan import Place
from groundslab.schema.wording import describe, with_article

if TYPE_CHECKING:
    from ezdxf.entities import DXFEntity
    from shapely.geometry.base import BaseGeometry


_STARTS = re.compile(r"(?:^|(?<=[\s=:]))(?=[+-]?\.?[0-9])", re.MULTILINE)
_FIRM = re.compile(r"^(?:|.*[=:])\s*(?=[+-]?\.?[0-9])", re.MULTILINE)
_WITH_UNIT = re.compile(rf"{units.NUMBER}\s*[A-Za-z]+")
_WITH_UNITS = re.compile(rf"{units.NUMBER}\s*[A-Za-z]+(?:\s?/\s?[A-Za-z]+(?:\^?2|²)?)?")
#: A number with commas: 600,5 or 1,234.5 or 1.234,5.
_COMMA = re.compile(r"(?<![\w.,])\d[\d.]*,[\d.,]*\d(?![.,]?\d)")
#: What a load is given in, and a wall by its thickness, by what the layer holds.
DIMENSION = {
    "point_loads": "force", "walls": "length", "beams": "section", "line_loads": "force per length",
    "area_loads": "pressure",
}  # fmt: skip
#: Of these dimensions none is mistaken for another.
ALONE = ("force", "length", "section")
LONGEST = 200  # letters of a text, of which no more is read


@dataclass(frozen=True, slots=True)
class Label:
    """Something written: its words, the value in it or why it is none, and the line that it stands on."""

    source: Source
    words: str
    value: float | str | None
    start: Place
    end: Place
    height: float


def find_quantity(words: str, dimension: str = "force") -> float | str | None:
    """Return the force in a text, or what is wrong with it, or None if the text is only a name.

    What begins with a number, or has one after = or :, is meant to be a value; so is any force in it. The same of a
    force per length or a pressure, if that is the dimension; then any of the three is meant to be a value. Commas may
    stand for the decimal point or between thousands; where both are possible, the value is not taken. A section, which
    is two lengths, is no value.
    """
    if dimension == "section":
        return None
    value = _find_quantity(_COMMA.sub(_with_point, words), dimension)
    unclear = [why for match in _COMMA.finditer(words) if (why := why_unclear(match[0]))]
    return f"{unclear[0]}; write it without a comma" if unclear and isinstance(value, float) else value


def _with_point(match: re.Match[str]) -> str:
    """Return a number that has commas as one with a decimal point; what is none stays as it is."""
    numbers = readings(match[0])
    return format_number(numbers[0]) if numbers else match[0]


def _find_quantity(words: str, dimension: str) -> float | str | None:
    """Return the value in a text whose numbers have decimal points."""
    meant = _WITH_UNIT if dimension == "force" else _WITH_UNITS
    texts = meant.findall(words)
    values = [text for text in texts if isinstance(_quantity(text, dimension), float)]
    if len(values) > 1:
        return f"more than one {dimension}"
    firm = _FIRM.search(words)
    if firm:
        return _quantity(words[firm.end() :].split("\n")[0], dimension)
    read = [_quantity(words[start.end() :].split("\n")[0], dimension) for start in _STARTS.finditer(words)]
    numbers = [value for value in read if isinstance(value, float)]
    if numbers:
        return numbers[0]
    others = {dimension} if dimension in ALONE else {*DIMENSION.values()} - {*ALONE[1:]}
    if any(isinstance(_quantity(text, other), float) for text in texts for other in others):
        return "it is not a name, a number and a unit" if values else f"it is no {dimension}"
    return None


def find_layer_quantity(words: str, dimension: str) -> float | str | None:
    """Return the value in what stands behind the name of a layer; "kN_m" is kN/m, as no layer may hold a slash."""
    words = words.replace("_", " ")[:LONGEST]
    value = find_quantity(words, dimension)
    if isinstance(value, float):
        return value
    divided = find_quantity(re.sub(r"(?<=[A-Za-z])[ -]+(?=m\^?2?\b)", "/", words), dimension)
    return divided if isinstance(divided, float) else value


def _quantity(words: str, dimension: str) -> float | str:
    """Return a quantity of a dimension, or why the words are none."""
    try:
        return units.parse(words, dimension)
    except units.QuantityError as error:
        return error.reason


def read_label(source: Source, entity: DXFEntity, context: ReadContext, dimension: str = "force") -> Label | None:
    """Return the words of a TEXT, ATTRIB or MTEXT and their place, None for anything else."""
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
    spots = context.point(start), context.point(start + along * width)
    return Label(source, words, find_quantity(words, dimension), *spots, context.to_meters(height))


NEAR = 10  # heights of a text between it and the load that it belongs to
NEAREST = 8  # loads of which one may be that of a text
MOST_BESIDE = 20_000_000  # pairs of texts and loads that are looked at
HALVINGS = 12  # of the distance within which loads are sought first
AT_ONCE = 256  # texts


def find_nearest_loads(
    texts: Sequence[Label], shapes: Sequence[BaseGeometry | None], context: ReadContext
) -> Iterator[tuple[float, int, int]]:
    """Yield distance [m], text and shape of the few shapes that are nearest to each text and near enough to be its."""
    import shapely

    if not texts or not shapes:
        return
    lines = shapely.linestrings([(text.start, text.end) for text in texts])
    reach = NEAR * np.array([text.height for text in texts])
    every = np.array(shapes, dtype=object)
    tree = shapely.STRtree(every)
    left = np.arange(len(texts))
    for halvings in range(HALVINGS, -1, -1):
        # in twice the distance at a time: of many shapes within reach only the nearest are ever met
        within = reach * 0.5**halvings
        again = []
        for first in range(0, len(left), AT_ONCE):
            chunk = left[first : first + AT_ONCE]
            t, s = tree.query(lines[chunk], predicate="dwithin", distance=within[chunk])
            context.count_work(len(t), MOST_BESIDE, "pairs of texts and loads near each other", "write smaller texts")
            count = np.bincount(t, minlength=len(chunk))
            done = (count >= NEAREST) | (halvings == 0)
            again.append(chunk[~done])
            keep = done[t]
            t, s = chunk[t[keep]], s[keep]
            yield from _keep_nearest(shapely.distance(lines[t], every[s]), t, s)
        left = np.concatenate(again)
        if not len(left):
            return


def _keep_nearest(gap: np.ndarray, text: np.ndarray, shape: np.ndarray) -> Iterator[tuple[float, int, int]]:
    """Yield the first few of each text, the smallest distances first."""
    order = np.lexsort((shape, gap, text))
    gap, text, shape = gap[order], text[order], shape[order]
    starts = np.flatnonzero(np.diff(text, prepend=-1))
    rank = np.arange(len(text)) - np.repeat(starts, np.diff(np.append(starts, len(text))))
    few = rank < NEAREST
    yield from zip(gap[few].tolist(), text[few].tolist(), shape[few].tolist(), strict=True)


@dataclass(slots=True)
class PendingLoad:
    """A load while its value is sought."""

    source: Source
    point: Place
    shape: BaseGeometry | None  # what texts stand beside
    size: float = 0.0  # of loads in which a text stands, it is that of the smallest
    values: list[float] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)
    unclear: list[str] = field(default_factory=list)
    column: bool = False  # a column that takes the values beside it, where no load is near them


def assign_texts(marks: Sequence[PendingLoad], texts: Sequence[Label], role: str, context: ReadContext) -> None:
    """Give each text to the nearest mark; the nearest pairs first, and one value to a mark."""
    what = role.replace("_", " ").removesuffix("s")
    pairs = (
        (marks[m].column, gap, marks[m].size, t, m)
        for gap, t, m in find_nearest_loads(texts, [mark.shape for mark in marks], context)
    )
    assigned: set[int] = set()
    near: set[int] = set()
    beside: set[int] = set()  # of these the texts that only columns are near
    for of_column, *_, t, m in sorted(pairs):
        text, mark = texts[t], marks[m]
        if of_column and (not isinstance(text.value, float) or t in near - beside):
            continue
        near.add(t)
        beside |= {t} if of_column else set()
        if t in assigned or (isinstance(text.value, float) and mark.values):
            continue
        assigned.add(t)
        mark.texts.append(text.words)
        if isinstance(text.value, float):
            mark.values.append(text.value)
        where = f"{mark.source.entity} {mark.source.handle}".strip()
        context.report_entity(text.source, True, f"{describe(text.words)}, beside {where}")
    expected = units.expectation(DIMENSION[role]) if DIMENSION[role] in units.DIMENSIONS else ""
    for t, text in enumerate(texts):
        if isinstance(text.value, str):
            context.issue([text.source], text.start, describe(text.words), expected, text.value)
        elif t in assigned:
            continue
        elif text.value is None:
            context.report_entity(text.source, False, f"{describe(text.words)}, with no {what} next to it")
        elif t in near:
            hint = "write the sum, or move the text nearer to its own load"
            context.issue(
                [text.source], text.start, f"{describe(text.words)}, a second value", "one value a load", hint
            )
        else:
            hint = f"draw the load, at most {NEAR} heights of the text away, or move the text to another layer"
            context.issue(
                [text.source], text.start, describe(text.words), f"{with_article(what)} beside the value", hint
            )


def choose_value(
    mark: PendingLoad, role: str, context: ReadContext, of_layers: Mapping[str, float] = MappingProxyType({})
) -> tuple[float | None, str]:
    """Return the value of a load, its own or that of its layer, if any, and what the report says of it.

    Several values, or one that cannot be read, are issues.
    """
    dimension = DIMENSION[role]
    if len(mark.values) > 1:
        shown = " and ".join(units.show(value, dimension) for value in mark.values)
        context.issue([mark.source], mark.point, shown, "one value a load", "write the sum")
    if mark.unclear and not mark.values:
        context.issue([mark.source], mark.point, ", ".join(mark.unclear), units.expectation(dimension), "add the unit")
    value, how = mark.values[0] if mark.values else None, ""
    if value is None and mark.source.layer in of_layers:
        value, how = of_layers[mark.source.layer], ", by the name of its layer"
    if dimension == "section":
        return None, ""
    return value, ", no value" if value is None else f" of {units.show(value, dimension)}{how}"


def join_texts(mark: PendingLoad) -> str:
    """Return the text next to a load."""
    return " ".join(" ".join(mark.texts).split())
