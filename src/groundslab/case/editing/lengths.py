"""Lengths in the units that a file uses, and items of a file translated in plan."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from decimal import ROUND_HALF_EVEN, Context, Decimal
from typing import Any

from groundslab import units
from groundslab.errors import InputError, Issue
from groundslab.schema.wording import describe

#: Resolution of a drag on a plate of a meter or more [m].
STEP = 1e-3
#: Lengths beyond this are none of a plan [m].
LARGEST = 1e9
#: Keys whose values are points in plan, or lists of points.
POINT_KEYS = ("points", "start", "end", "centre", "about")
#: Keys of shapes, which move with the item that they belong to.
SHAPE_KEYS = ("shape", "outline", "openings", "zones", "holes")

_QUANTITY = re.compile(rf"\s*(?P<number>{units.NUMBER})(?P<blank>\s*)(?P<unit>\S.*?)\s*", re.DOTALL)
_EXACT = Context(prec=60)


def choose_resolution(data: Mapping[str, Any]) -> float:
    """Return the resolution of a drag on a plate [m]: a millimeter, or a thousandth of a small plate's size or less."""
    plate = data.get("plate")
    sizes = [abs(length) for length in _iterate_lengths(plate if isinstance(plate, Mapping) else {}) if length]
    size = max(sizes, default=1.0)
    return min(STEP, STEP * 10.0 ** math.floor(math.log10(size)))


def _iterate_lengths(table: Mapping[str, Any]) -> Iterator[float]:
    """Yield the valid sides of a plate and coordinates of its outline [m]."""
    outline = table.get("outline")
    shape = outline if isinstance(outline, Mapping) else {}
    for text in _iterate_texts([table.get("length_x"), table.get("length_y"), *shape.values()]):
        try:
            yield units.parse(text, "length")
        except ValueError:
            continue


def _iterate_texts(value: Any) -> Iterator[str]:
    """Yield all texts in nested lists."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, list):
        for item in value:
            yield from _iterate_texts(item)


def format_lengths(old: Any, new: Any, step: float) -> Any:
    """Return a length or nested lists of lengths [m] as texts in the units of the old ones, else in meters."""
    unit = next((parts["unit"] for text in _iterate_texts(old) if (parts := _split_quantity(text))), "m")
    return _format(old, new, unit, step)


def _format(old: Any, new: Any, unit: str, step: float) -> Any:
    if isinstance(new, list):
        olds = old if isinstance(old, list) else []
        return [
            _format(olds[number] if number < len(olds) else None, length, unit, step)
            for number, length in enumerate(new)
        ]
    if isinstance(new, bool) or not isinstance(new, int | float) or not abs(new) <= LARGEST:
        raise InputError([Issue("the edit", describe(new), "a length in meters, or a list of lengths")])
    parts = _split_quantity(old)
    blank, own_unit = parts.group("blank", "unit") if parts else (" ", unit)
    if parts and abs(units.parse(str(old), "length") - new) < step / 2:
        return old  # unchanged within the step
    return f"{_format_number(_round(new, own_unit, step))}{blank}{own_unit}"


def _split_quantity(value: Any) -> re.Match[str] | None:
    """Return the number, blanks and unit of a length by these names, None for what is not a length."""
    if not isinstance(value, str):
        return None
    try:
        units.parse(value, "length")
    except ValueError:
        return None
    return _QUANTITY.fullmatch(value)


def _round(meters: float, unit: str, step: float) -> Decimal:
    """Return a length in a unit, rounded to the largest power of ten of the unit within the step [m]."""
    size = Decimal(repr(units.parse(f"1 {unit}", "length")))
    exponent = math.floor(math.log10(step / float(size)) + 1e-9)
    return _EXACT.divide(Decimal(repr(float(meters))), size).quantize(
        Decimal(1).scaleb(exponent), rounding=ROUND_HALF_EVEN, context=_EXACT
    )


def _format_number(number: Decimal) -> str:
    """Return a number without exponent and trailing zeros."""
    return f"{_EXACT.plus(number).normalize(_EXACT):f}"  # plus drops the sign of a zero


def translate(item: Any, by: tuple[float, float], step: float, location: str) -> dict[str, Any]:
    """Return an item of the file with all its points translated [m]; raises InputError if it has none."""
    if not isinstance(item, Mapping):
        raise InputError([Issue(location, describe(item), "an item with coordinates")])
    translated = _translate(item, by, step, location)
    if translated == item and any(by):
        host = next((key for key in ("column", "wall") if item.get(key)), None)
        hint = f"move the {host} {describe(item[host])}" if host else "move its axes" if item.get("at") else ""
        raise InputError([Issue(location, "an item without coordinates", "an item with coordinates", hint)])
    return translated


def _translate(item: Mapping[str, Any], by: tuple[float, float], step: float, location: str) -> dict[str, Any]:
    table = dict(item)
    for axis, distance in zip("xy", by, strict=True):
        if axis in table:
            table[axis] = _shift(table[axis], distance, step, f"{location}.{axis}")
    for name in POINT_KEYS:
        if name in table:
            table[name] = _shift_points(table[name], by, step, f"{location}.{name}")
    if item.get("kind") == "circle" and "centre" not in item:
        table["centre"] = format_lengths(item.get("radius"), list(by), step)
    if any(name in item for name in ("slope", "bend")) and "about" not in item:
        # a load that varies does so about the origin by default, and must not change
        table["about"] = format_lengths(_find_coordinate(item), list(by), step)
    for name in SHAPE_KEYS:
        inner = table.get(name)
        if isinstance(inner, Mapping):
            table[name] = _translate(inner, by, step, f"{location}.{name}")
        elif isinstance(inner, list):
            table[name] = [
                _translate(part, by, step, f"{location}.{name}[{number}]") if isinstance(part, Mapping) else part
                for number, part in enumerate(inner, start=1)
            ]
    return table


def _find_coordinate(item: Mapping[str, Any]) -> Any:
    """Return a coordinate of an item, whose unit others may take."""
    return next((item[name] for name in ("x", "y", "points") if name in item), None)


def _shift_points(value: Any, by: tuple[float, float], step: float, location: str) -> Any:
    """Return a point, or a list of points, translated."""
    if isinstance(value, list) and any(isinstance(item, list) for item in value):
        return [_shift_points(point, by, step, f"{location}[{number}]") for number, point in enumerate(value, start=1)]
    if not isinstance(value, list) or len(value) != 2:
        raise InputError([Issue(location, describe(value), "a point of two lengths", "correct it first")])
    return [
        _shift(coordinate, distance, step, f"{location}[{number}]")
        for number, (coordinate, distance) in enumerate(zip(value, by, strict=True), start=1)
    ]


def _shift(value: Any, distance: float, step: float, location: str) -> Any:
    """Return a length, or a list of lengths, shifted by a rounded distance; other digits stay."""
    if isinstance(value, list):
        return [_shift(length, distance, step, f"{location}[{number}]") for number, length in enumerate(value, start=1)]
    parts = _split_quantity(value)
    if parts is None:
        raise InputError([Issue(location, describe(value), units.expectation("length"), "correct it first")])
    number, blank, unit = parts.groups()
    total = _EXACT.add(Decimal(number), _round(distance, unit, step))
    return value if total == Decimal(number) else f"{_format_number(total)}{blank}{unit}"
