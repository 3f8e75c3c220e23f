"""Types of arrays, and a store of values derived from what holds them; loads NumPy."""

from __future__ import annotations

import functools
import weakref
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from typing import Any, TypeVar, cast

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Indices = NDArray[np.int32]
Flags = NDArray[np.bool_]

#: A function that makes a value.
Made = TypeVar("Made", bound=Callable[..., Any])


class _Companion:
    """An object that is known again; it is held only if nothing can refer to it weakly, as to numbers and tuples."""

    def __init__(self, known: object) -> None:
        self._weak: weakref.ref[object] | None = None
        self._held: object = None
        try:
            self._weak = weakref.ref(known)
        except TypeError:
            self._held = known

    def is_still(self, other: object) -> bool:
        """Return whether an object is this one."""
        if self._weak is None:
            return self._held is other
        return other is not None and self._weak() is other


#: The values derived from objects that live, by the objects' identity and by what made them, with what is beside.
_DERIVED: dict[int, dict[Callable[..., Any], tuple[tuple[_Companion, ...], Any]]] = {}


def derived_from(of: object) -> dict[Callable[..., Any], tuple[tuple[_Companion, ...], Any]]:
    """Return the store of all values that are derived from an object, which lives as long as the object does."""
    if id(of) not in _DERIVED:
        weakref.finalize(of, _DERIVED.pop, id(of), None)
    return _DERIVED.setdefault(id(of), {})


def freeze(value: object) -> None:
    """Make every array read-only that a dataclass or tuple holds, at any depth; nothing is copied."""
    if isinstance(value, np.ndarray):
        value.flags.writeable = False
    elif isinstance(value, tuple):
        for each in value:
            freeze(each)
    elif is_dataclass(value):
        for field in fields(value):
            freeze(getattr(value, field.name))


def made_once(make: Made) -> Made:
    """Return a function that makes its value once for its arguments, for as long as the first one lives.

    Results are immutable and hold arrays, which have no hash: functools.cache cannot hold what is derived from them.
    The value may not hold the first argument, or both would live forever. With other arguments beside it the value is
    made anew, and that of the last ones is kept.
    """
    return made_once_by(lambda *args: args)(make)


def made_once_by(objects: Callable[..., tuple[object, ...]]) -> Callable[[Made], Made]:
    """Return what makes a function do so by the objects that its value depends on, which follow from its arguments."""

    def keeping(make: Made) -> Made:
        @functools.wraps(make)
        def get(*args: Any) -> Any:
            of, *beside = objects(*args)
            store = derived_from(of)
            kept = store.get(make)
            if kept is None or len(kept[0]) != len(beside) or not all(map(_Companion.is_still, kept[0], beside)):
                kept = tuple(map(_Companion, beside)), make(*args)
                store[make] = kept
            return kept[1]

        return cast("Made", get)

    return keeping
