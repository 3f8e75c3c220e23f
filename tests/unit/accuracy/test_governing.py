"""Which combinations govern, of made-up errors at made-up places."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from groundslab.accuracy import governing
from groundslab.accuracy.governing import find_governing
from groundslab.accuracy.judgment import JudgedValue
from groundslab.fem.mesh import grid

ACCURACY = 0.05
MESH = grid(np.linspace(-5, 5, 21), np.linspace(-0.5, 0.5, 3))  # elements of 0.5 m, x from -5 to 5 m


def value(share: float, size: float, x: float, label: str = "moment", sign: int = 1) -> JudgedValue:
    """Return a value at a place on the strip whose error is a share of 100."""
    place = (x, 0.0)
    return JudgedValue(share, sign * size, label, place, np.array([place]), sign, 100.0 * share)


def names(monkeypatch: pytest.MonkeyPatch, judged: dict[str, list[JudgedValue]]) -> list[str]:
    """Return the combinations that govern, as letters."""
    plate = SimpleNamespace(nodes=MESH.nodes, elements=MESH.elements)
    results: Any = {name: SimpleNamespace(plate=plate, name=name) for name in judged}
    monkeypatch.setattr(governing, "judge", lambda found: judged[found.name])
    off = {name: [each for each in values if each.share > ACCURACY] for name, values in judged.items()}
    return list(find_governing(results, {name: values for name, values in off.items() if values}))


def test_the_largest_error_at_each_place_governs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of three that are off at one place the worst; and the one that is off elsewhere, though its error is less."""
    judged = {
        "a": [value(0.10, 50.0, -3.0)],
        "b": [value(0.20, 60.0, -3.0)],
        "c": [value(0.19, 55.0, -2.5)],
        "d": [value(0.06, 10.0, 3.0)],
        "e": [value(0.04, 10.0, 0.0)],
    }
    assert names(monkeypatch, judged) == ["b", "d"]


def test_values_of_another_quantity_or_sign_govern_beside(monkeypatch: pytest.MonkeyPatch) -> None:
    """At the same place a sagging moment says nothing about a hogging one, nor a moment about a shear force."""
    judged = {
        "sagging": [value(0.20, 50.0, 0.0)],
        "hogging": [value(0.10, 20.0, 0.0, sign=-1)],
        "shear": [value(0.10, 20.0, 0.0, "shear")],
        "less": [value(0.09, 20.0, 0.0, "shear")],
    }
    assert names(monkeypatch, judged) == ["sagging", "hogging", "shear"]


def test_those_that_may_have_the_largest_value_govern(monkeypatch: pytest.MonkeyPatch) -> None:
    """The largest, and one elsewhere whose error reaches it; not one that it does not reach, or at the same place."""
    judged = {
        "largest": [value(0.01, 100.0, -3.0)],
        "beside it": [value(0.01, 99.5, -3.0)],
        "may be": [value(0.03, 98.0, 3.0)],
        "is not": [value(0.03, 96.0, 0.0)],
    }
    assert names(monkeypatch, judged) == ["largest", "may be"]
    smallest = {"least": [value(0.01, -5.0, 0.0, sign=-1)], "more": [value(0.01, -9.0, 0.0, sign=-1)]}
    assert names(monkeypatch, smallest) == ["least"], "the smallest value is 5, of which the sign makes -5"


def test_no_more_than_a_dozen_govern(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of 20 positions that are off at their own places, those with the largest errors."""
    judged = {f"{k}": [value(0.06 + 0.01 * k, 50.0, 0.0, f"quantity {k}")] for k in range(20)}
    assert names(monkeypatch, judged) == [f"{k}" for k in range(8, 20)]


def test_values_without_a_place_are_of_the_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of the areas in contact the worst governs."""
    areas = {name: [JudgedValue(share, 0.9, "area in contact", None)] for name, share in (("a", 0.1), ("b", 0.2))}
    assert names(monkeypatch, areas) == ["b"]
