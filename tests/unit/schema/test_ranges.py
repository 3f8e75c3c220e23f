"""The numbers that keys take: every key with a dimension, every count and every list has limits."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import pytest

from groundslab.case.casefile import loads, starter
from groundslab.errors import InputError
from groundslab.model.model import Model
from groundslab.schema.base import Section
from groundslab.schema.fields import LARGEST_WHOLE, FieldType, Integer, ListOf, Number, Quantity
from groundslab.schema.issues import FieldError
from groundslab.schema.ranges import Range, quantity_range
from groundslab.units import DIMENSIONS


def keys(part: type[Section], seen: set[type[Section]]) -> Iterator[tuple[str, FieldType]]:
    """Yield all keys of a part and of those in it, and the keys of what lists hold."""
    if part in seen:
        return
    seen.add(part)
    for name, field in part.model_fields.items():
        key = field.type
        while key is not None:
            yield f"{part.__name__}.{name}", key
            key = key.each if isinstance(key, ListOf) else None
        for inner in field.sections.parts:
            yield from keys(inner, seen)


KEYS = list(keys(Model, set()))


def refused(key: FieldType, value: Any) -> bool:
    """Return whether a key refuses a value with something to say."""
    try:
        key.read(value, from_file=False)
    except FieldError as error:
        return all(len(relative.expected) > 3 for relative in error.relative_issues)
    return False


def test_sizes_without_sense_are_refused() -> None:
    """No key takes numbers whose products a float cannot hold, be they too large or too near to zero."""
    for name, key in [(n, k) for n, k in KEYS if isinstance(k, Quantity | Number)]:
        for value in (1e19, -1e19, 1e100, 1e308, math.inf, math.nan, 5e-324, 1e-310, 1e-100, -1e-100, 1e-31):
            assert refused(key, value), f"{name} takes {value}"


@pytest.mark.parametrize(("name", "key"), [(n, k) for n, k in KEYS if isinstance(k, Integer)])
def test_counts_are_bounded(name: str, key: Integer) -> None:
    """No count of a case may be so large that nobody could wait for what it counts; only unknowns may be millions."""
    most = 10_000_000 if name.endswith("max_unknowns") else 100_000
    assert key.at_most <= most < LARGEST_WHOLE, name
    assert refused(key, most + 1)
    assert refused(key, 10**9)
    schema = key.json_schema()
    assert schema.get("anyOf", [schema])[0]["maximum"] == key.at_most


@pytest.mark.parametrize(
    ("dimension", "own", "fine", "too_small", "too_large"),
    [
        ("length", Range(above=0), (1e-9, 1e7), 9e-10, 1.1e7),
        ("length", Range(), (-1e7, 0, 6e-17, 5.5e6), -1.1e7, 1.1e7),
        ("length", Range(at_least=0), (0, 1e-12, 1e6), -1e-12, 1.1e7),
        ("pressure", Range(above=0), (1e16, 1e18), 1e-7, 1.1e18),
        ("stiffness", Range(above=0), (1e15,), 1e-7, 1e19),
        ("pressure", Range(at_least=12e6, at_most=90e6), (12e6, 90e6), 11e6, 91e6),
        ("slope", Range(below=0.5), (-1, 0.4), -1e19, 0.5),
    ],
)
def test_range_of_a_dimension(
    dimension: str, own: Range, fine: tuple[float, ...], too_small: float, too_large: float
) -> None:
    """A key's own limits stand within those of its dimension; what research asks for lies inside."""
    limits = quantity_range(own, dimension)
    assert all(limits.holds(value) for value in fine)
    assert not limits.holds(too_small)
    assert not limits.holds(too_large)


def test_every_dimension_has_sizes() -> None:
    """Smallest and largest size of each dimension leave room, and products of several still are floats."""
    for name, known in DIMENSIONS.items():
        assert 0 < known.smallest < 1 <= known.largest, name
        assert known.smallest**4 > 1e-60
        assert known.largest**4 < 1e80


#: A pressure on a rectangle that begins at no place.
PATCH = '\n[[loads]]\nkind = "patch"\nq = "1 kPa"\nx = ["1e-300 m", "2.5 m"]\ny = ["0 m", "1 m"]\n\n[[loads]]'


def test_what_a_wrong_size_is_told() -> None:
    """A size out of range is reported the limit that it passes, with its unit."""
    wrong = {
        '"6 m"': ('"1e100 m"', 'plate.length_x: found "1e100 m", expected a length at most 1e7 m'),
        '"30 GPa"': ('"1e-40 Pa"', 'plate.E: found "1e-40 Pa", expected a pressure at least 1e-6 Pa'),
        "\n[[loads]]": (PATCH, "expected a length that is 0 or has a size of at least 1e-30 m"),
    }
    for text, (other, said) in wrong.items():
        with pytest.raises(InputError) as error:
            loads(starter().replace(text, other, 1))
        assert said in str(error.value)


def test_every_list_has_an_end() -> None:
    """Each list of tables says how many entries it may have, and one more is refused at once, whatever they are."""
    for name, field in Model.model_fields.items():
        most = field.most
        if most is None:
            continue
        with pytest.raises(InputError) as error:
            Model.model_validate({name: [0] * (most + 1)})
        assert [str(issue) for issue in error.value.issues] == [
            f"{name}: found a list of {most + 1}, expected at most {most}"
        ]
