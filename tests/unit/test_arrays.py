"""Values that are derived once from what holds arrays, and forgotten with it."""

from __future__ import annotations

import gc
import weakref
from dataclasses import dataclass

import numpy as np
import pytest

import groundslab
from groundslab import arrays
from groundslab.arrays import Array, derived_from, made_once, made_once_by


@dataclass(frozen=True, slots=True, weakref_slot=True, eq=False)
class Holder:
    """Something that holds an array."""

    values: Array


class Value:
    """Something that is made of it."""


def test_a_value_is_made_once_for_each_object() -> None:
    """The same object gives the same value without another call, an equal one a value of its own."""
    made: list[Holder] = []

    @made_once
    def total(of: Holder) -> float:
        """Return the sum."""
        made.append(of)
        return float(of.values.sum())

    one, other = Holder(np.ones(3)), Holder(np.ones(3))
    assert [total(one), total(one), total(other)] == [3.0, 3.0, 3.0]
    assert made == [one, other]
    assert (total.__name__, total.__doc__) == ("total", "Return the sum.")


def test_functions_keep_their_values_apart() -> None:
    """What one function has made of an object is not what another one makes of it."""
    holder = Holder(np.arange(4.0))
    least, most = made_once(lambda of: float(of.values.min())), made_once(lambda of: float(of.values.max()))
    assert (least(holder), most(holder), least(holder)) == (0.0, 3.0, 0.0)


def test_a_value_is_forgotten_with_its_object() -> None:
    """Nothing is kept of results that nobody holds any more; of arrays it is the same."""
    make = made_once(lambda _: Value())
    for of in (Holder(np.ones(2)), np.ones(2)):
        kept = weakref.ref(make(of))
        assert kept() is make(of)
    del of
    gc.collect()
    assert kept() is None


def test_two_caches_that_cross_hold_nothing() -> None:
    """Nodes with elements as their companion for one value and the other way around for another are both forgotten."""

    @made_once
    def by_nodes(nodes: Array, elements: Array) -> float:
        return float(nodes.sum() + elements.sum())

    by_elements = made_once_by(lambda nodes, elements: (elements, nodes))(lambda nodes, elements: nodes @ elements)
    nodes, elements = np.ones(3), np.ones(3)
    assert (by_nodes(nodes, elements), by_elements(nodes, elements)) == (6.0, 3.0)
    assert len(derived_from(nodes)) == len(derived_from(elements)) == 1
    kept = weakref.ref(nodes), weakref.ref(elements)
    del nodes, elements
    gc.collect()
    assert [each() for each in kept] == [None, None]


def test_another_companion_makes_another_value() -> None:
    """The value is made again for another companion, also for None after one that nobody holds any more."""
    nodes = np.ones(2)
    by_object = made_once_by(lambda nodes, beside, _: (nodes, beside))(lambda _, __, called: called)
    for beside in (np.ones(3), None, (1, 2), np.ones(3)):
        called = type(beside).__name__
        assert by_object(nodes, beside, called) == called
        assert by_object(nodes, beside, "again") == called
    by_object(nodes, np.ones(4), "gone")
    assert by_object(nodes, None, "none") == "none"


def test_a_companion_that_is_left_out_makes_another_value() -> None:
    """A call without a companion has no value of one with it, nor the other way around."""

    @made_once
    def count(_: Array, *beside: object) -> int:
        return len(beside)

    nodes, elements = np.ones(2), np.ones(3)
    assert [count(nodes, elements), count(nodes), count(nodes, elements)] == [1, 0, 1]


@pytest.mark.parametrize("code", ["EN 1992-1-1", "ACI 318"])
def test_all_that_is_derived_of_results_is_forgotten_with_them(code: str) -> None:
    """Solved, designed, summed up and forgotten: no value holds what it was derived from, which would live forever."""
    slab = groundslab.Model.model_validate(
        {
            "plate": {"length_x": 6.0, "length_y": 6.0, "thickness": 0.4, "E": 30e9, "nu": 0.2},
            "ground": {"kind": "winkler", "k": 3e7},
            "columns": [{"name": "C", "x": 0.0, "y": 0.0, "width_x": 0.4, "width_y": 0.4}],
            "cases": [{"name": "G", "action": "permanent"}],
            "loads": [{"kind": "point", "case": "G", "column": "C", "P": 1e6}],
            "combinations": [{"name": "U", "limit_state": "ultimate", "factors": {"G": 1.35}}],
            "reinforcement": {"code": code, "f_ck": 30e6, "f_yk": 500e6, "bottom": (0.05, 0.07), "top": (0.05, 0.07)},
            "mesh": {"size": 0.5},
        }
    )
    before = len(arrays._DERIVED)
    results = groundslab.solve(slab)
    groundslab.check_design(results)
    assert groundslab.tables_of(results)
    assert len(arrays._DERIVED) > before
    kept = weakref.ref(results)
    del results, slab
    gc.collect()
    assert kept() is None
    assert len(arrays._DERIVED) <= before
