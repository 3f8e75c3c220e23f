"""Types of arrays, and a cache of values derived from what holds them; loads NumPy."""

from __future__ import annotations

import functools
import weakref
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from typing import Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Indices = NDArray[np.int32]
Flags = NDArray[np.bool_]

Of = TypeVar("Of")
T = TypeVar("T")


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


class Memo(Generic[T]):
    """Cache of values by the identity of an object and of a companion, for as long as the object lives.

    Results are immutable and hold arrays, which have no hash: functools.cache cannot hold what is derived from them.
    The value may not hold the object. A companion is not held if it need not be, as it may be an object of another
    cache whose companion is this one's object: both would live forever.
    """

    def __init__(self) -> None:
        self._kept: dict[int, tuple[_Companion, T]] = {}

    def get(self, of: object, beside: object, make: Callable[[], T]) -> T:
        """Return the cached value of an object and its companion; compute it first if there is none."""
        key = id(of)
        kept = self._kept.get(key)
        if kept is None or not kept[0].is_still(beside):
            if kept is None:
                weakref.finalize(of, self._kept.pop, key, None)
            kept = _Companion(beside), make()
            self._kept[key] = kept
        return kept[1]


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


def made_once(make: Callable[[Of], T]) -> Callable[[Of], T]:
    """Return a function of one object that makes its value once for each, for as long as the object lives (`Memo`)."""
    known: Memo[T] = Memo()

    @functools.wraps(make)
    def get(of: Of) -> T:
        return known.get(of, None, lambda: make(of))

    return get
