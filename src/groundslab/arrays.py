"""Types of arrays, and a cache of values derived from an array."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from typing import Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
Indices = NDArray[np.int32]
Flags = NDArray[np.bool_]

T = TypeVar("T")


class Memo(Generic[T]):
    """Cache of values by the identity of an array and of a companion object, for as long as the array lives.

    Results are immutable and hold arrays, which have no hash: functools.cache cannot hold what is derived from them.
    """

    def __init__(self) -> None:
        self._kept: dict[int, tuple[object, T]] = {}

    def get(self, array: Array | Integers, beside: object, make: Callable[[], T]) -> T:
        """Return the cached value of an array and its companion; compute it first if there is none."""
        key = id(array)
        kept = self._kept.get(key)
        if kept is None or kept[0] is not beside:
            if kept is None:
                weakref.finalize(array, self._kept.pop, key, None)
            kept = beside, make()
            self._kept[key] = kept
        return kept[1]
