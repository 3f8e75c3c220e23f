"""Repairs of issues: edits of what is at a place, and the words of the button that makes them."""

from __future__ import annotations

import itertools
import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import Any

from groundslab import units
from groundslab.errors import Edit, Repair
from groundslab.schema import ranges
from groundslab.schema.wording import describe, find_nearest, listed, spelled_alike, suggestion

Place = tuple[str | int, ...]
MOST_CHOICES = 4  # names that are offered one by one


def move_below(place: Sequence[str | int], repair: Repair) -> Repair:
    """Return a repair as seen from further up."""
    return replace(repair, edits=tuple(replace(edit, path=(*place, *edit.path)) for edit in repair.edits))


def set_value(place: Place, value: Any, label: str = "") -> Repair:
    """Return the repair that sets a value."""
    return Repair(label or f"set {_name(place)} to {describe(value)}", (Edit("set", place, value),))


def remove(*places: Place, label: str = "") -> Repair:
    """Return the repair that removes what is at some places."""
    words = label or f"remove {listed(map(_name, places), 'and')}"
    return Repair(words, tuple(Edit("remove", place) for place in places))


def rename_key(place: Place, name: str) -> Repair:
    """Return the repair that renames a key."""
    return Repair(f"rename to {name}", (Edit("rename", place, name),))


def add_item(place: Place, value: dict[str, Any], label: str) -> Repair:
    """Return the repair that adds an item to a list."""
    return Repair(label, (Edit("add", place, value),))


def use_nearest(place: Place, word: object, words: Collection[str]) -> tuple[Repair, ...]:
    """Return the repair that takes the known word which a word resembles; of few known ones it offers all."""
    nearest = find_nearest(word, words)
    few = tuple(words) if len(words) <= MOST_CHOICES else ()
    names = few if nearest is None else (nearest,)
    return tuple(set_value(place, name, f"use {describe(name)}") for name in names)


def meant_word(word: object, words: Collection[str], unlisted: str | None) -> tuple[str, tuple[Repair, ...]]:
    """Return the hint for a word that is none of the known ones, and the repairs.

    With a hint for ``unlisted`` words only the known word of the same letters and digits is taken for the meant one:
    one that resembles it may be a stronger concrete, or another limit state.
    """
    if unlisted is not None:
        words = spelled_alike(word, words)
    return suggestion(word, words) or unlisted or "", use_nearest((), word, words)


def use_free_name(place: Place, name: str, taken: Collection[str]) -> tuple[Repair, ...]:
    """Return the repair that makes a name its own: ``A1 2`` beside ``A1``."""
    free = next(candidate for number in itertools.count(2) if (candidate := f"{name} {number}") not in taken)
    return (set_value(place, free, f"rename to {describe(free)}"),)


def add_unit(value: object, dimension: str, limits: ranges.Range) -> Iterator[Repair]:
    """Yield repairs of a bare number: with each unit of its dimension that leaves it in the range, the usual first."""
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        return
    text = str(value).strip()
    if not re.fullmatch(units.NUMBER, text):
        return
    quantity, limits = units.DIMENSIONS[dimension], ranges.quantity_range(limits, dimension)
    usual = quantity.example.split(" ", 1)[1]
    for size, unit in sorted(quantity.steps, key=lambda step: step[1] != usual):
        if limits.holds(float(text) * size):
            yield set_value((), f"{text} {unit}", f"{text} {unit}")


def _name(place: Place) -> str:
    """Return the name of a place on a button: ``beyond.kind``, ``loads[2]``."""
    return "".join(f"[{step + 1}]" if isinstance(step, int) else f".{step}" for step in place).lstrip(".")
