"""Values that are derived once from what holds arrays, and forgotten with it."""

from __future__ import annotations

import gc
import weakref
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Memo, made_once


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
    """Nodes with elements as their companion in one cache and the other way around in another are both forgotten."""
    by_nodes, by_elements = Memo[float](), Memo[float]()
    nodes, elements = np.ones(2), np.ones(3)
    by_nodes.get(nodes, elements, lambda: 1.0)
    by_elements.get(elements, nodes, lambda: 2.0)
    kept = weakref.ref(nodes), weakref.ref(elements)
    del nodes, elements
    gc.collect()
    assert [each() for each in kept] == [None, None]


def test_another_companion_makes_another_value() -> None:
    """The value is made again for another companion, also for None after one that nobody holds any more."""
    memo, nodes = Memo[str](), np.ones(2)
    for beside in (np.ones(3), None, (1, 2), np.ones(3)):
        name = f"{type(beside).__name__}"
        assert memo.get(nodes, beside, lambda name=name: name) == name  # type: ignore[misc]
    memo.get(nodes, np.ones(4), lambda: "gone")
    assert memo.get(nodes, None, lambda: "none") == "none"
