"""Lengths in the units in which a file has them, and things moved in plan."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from decimal import ROUND_HALF_EVEN, Context, Decimal
from typing import Any

from groundslab import units
from groundslab.errors import InputError, Issue
from groundslab.schema.wording import describe

#: What a drag can mean [m], on a plate of a metre or more.
STEP = 1e-3
#: Keys whose values are places in plan: a length, a pair of them, or a list of such pairs.
PLACES = ("points", "start", "end", "centre", "about")
#: Keys that hold shapes, which move with what they belong to.
SHAPES = ("shape", "outline", "openings", "zones", "holes")

_QUANTITY = re.compile(rf"(\s*)({units.NUMBER})(\s*)(\S.*?)(\s*)", re.DOTALL)
_EXACT = Context(prec=60)
_DIGITS = Decimal("1e-12")


def step_of(data: Mapping[str, Any]) -> float:
    """Return what a drag can mean on a plate [m]: a millimetre, or a thousandth of a small plate's size or less."""
    plate = data.get("plate")
    sizes = [abs(each) for each in _lengths(plate if isinstance(plate, Mapping) else {}) if each]
    size = max(sizes, default=1.0)
    return min(STEP, STEP * 10.0 ** math.floor(math.log10(size)))


def _lengths(table: Mapping[str, Any]) -> Iterator[float]:
    """Yield the sides of a plate, or the coordinates of its outline [m], as far as they can be read."""
    outline = table.get("outline")
    shape = outline if isinstance(outline, Mapping) else {}
    for each in _leaves([table.get("length_x"), table.get("length_y"), *shape.values()]):
        try:
            yield units.parse(each, "length")
        except ValueError:
            continue


def _leaves(value: Any) -> Iterator[str]:
    """Yield all texts in nested lists."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, list):
        for each in value:
            yield from _leaves(each)


def written(old: Any, new: Any, step: float) -> Any:
    """Return lengths [m], one or nested lists of them, as texts in the units of the old ones, metres without any."""
    unit = next((found[3] for each in _leaves(old) if (found := _parts(each))), "m")
    return _written(old, new, unit, step)


def _written(old: Any, new: Any, unit: str, step: float) -> Any:
    if isinstance(new, list):
        olds = old if isinstance(old, list) else []
        return [
            _written(olds[number] if number < len(olds) else None, each, unit, step) for number, each in enumerate(new)
        ]
    if isinstance(new, bool) or not isinstance(new, int | float) or not math.isfinite(new):
        raise InputError([Issue("the edit", describe(new), "a length in metres, or a list of lengths")])
    parts = _parts(old) if isinstance(old, str) else None
    blank, own = (parts[2], parts[3]) if parts else (" ", unit)
    if parts and abs(units.parse(str(old), "length") - new) < step / 2:
        return old  # nobody has moved it
    return f"{_plain(_rounded(new, own, step))}{blank}{own}"


def _parts(text: str) -> tuple[str, str, str, str] | None:
    """Return a length's leading blanks, number, blanks and unit, None if it is not a length."""
    match = _QUANTITY.fullmatch(text)
    if match is None:
        return None
    try:
        units.parse(text, "length")
    except ValueError:
        return None
    return match[1], match[2], match[3], match[4]


def _rounded(metres: float, unit: str, step: float) -> Decimal:
    """Return a length in a unit, rounded to a power of ten of it that is no more than the step [m]."""
    size = Decimal(repr(units.parse(f"1 {unit}", "length")))
    exponent = math.floor(math.log10(step / float(size)) + 1e-9)
    return _EXACT.divide(Decimal(repr(float(metres))), size).quantize(
        Decimal(1).scaleb(exponent), rounding=ROUND_HALF_EVEN, context=_EXACT
    )


def _plain(number: Decimal) -> str:
    """Return a number without an exponent and without zeros at its end."""
    text = format(number, "f")
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if text in ("-0", "") else text


def moved(thing: Any, by: tuple[float, float], step: float, where: str) -> dict[str, Any]:
    """Return a thing of the file with all its places moved [m]; raises InputError for one that has none."""
    if not isinstance(thing, Mapping):
        raise InputError([Issue(where, describe(thing), "something with a place in plan")])
    found = _moved(thing, by, step, where)
    if found == thing and any(by):
        column = thing.get("column")
        hint = f"move the column {describe(column)}" if column else ""
        raise InputError([Issue(where, "something without a place of its own", "something with coordinates", hint)])
    return found


def _moved(thing: Mapping[str, Any], by: tuple[float, float], step: float, where: str) -> dict[str, Any]:
    table = dict(thing)
    for axis, distance in zip("xy", by, strict=True):
        if axis in table:
            table[axis] = _shifted(table[axis], distance, step, f"{where}.{axis}")
    for name in PLACES:
        if name in table:
            table[name] = _shifted_places(table[name], by, step, f"{where}.{name}")
    if thing.get("kind") == "circle" and "centre" not in thing:
        table["centre"] = written(thing.get("radius"), list(by), step)
    if any(name in thing for name in ("slope", "bend")) and "about" not in thing:
        # what varies does so about the origin, unless it says about where; it is to vary as before
        table["about"] = written(_leaf_of(thing), list(by), step)
    for name in SHAPES:
        inner = table.get(name)
        if isinstance(inner, Mapping):
            table[name] = _moved(inner, by, step, f"{where}.{name}")
        elif isinstance(inner, list):
            table[name] = [
                _moved(each, by, step, f"{where}.{name}[{number}]") if isinstance(each, Mapping) else each
                for number, each in enumerate(inner, start=1)
            ]
    return table


def _leaf_of(thing: Mapping[str, Any]) -> Any:
    """Return a coordinate of a thing, whose unit others may take."""
    return next((thing[name] for name in ("x", "y", "points") if name in thing), None)


def _shifted_places(value: Any, by: tuple[float, float], step: float, where: str) -> Any:
    """Return a place, or a list of places, moved."""
    if isinstance(value, list) and any(isinstance(each, list) for each in value):
        return [_shifted_places(each, by, step, f"{where}[{number}]") for number, each in enumerate(value, start=1)]
    if not isinstance(value, list) or len(value) != 2:
        raise InputError([Issue(where, describe(value), "a place of two lengths", "put it right first")])
    return [
        _shifted(each, distance, step, f"{where}[{number}]")
        for number, (each, distance) in enumerate(zip(value, by, strict=True), start=1)
    ]


def _shifted(value: Any, distance: float, step: float, where: str) -> Any:
    """Return a length, or a list of them, moved by a rounded distance; its digits stay."""
    if isinstance(value, list):
        return [_shifted(each, distance, step, f"{where}[{number}]") for number, each in enumerate(value, start=1)]
    parts = _parts(value) if isinstance(value, str) else None
    if parts is None:
        raise InputError([Issue(where, describe(value), units.expectation("length"), "put it right first")])
    total = _EXACT.add(Decimal(parts[1]), _rounded(distance, parts[3], step))
    return value if total == Decimal(parts[1]) else f"{_plain(total)}{parts[2]}{parts[3]}"
