"""Types of arrays, and values kept beside an array for as long as it lives."""

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
    """Values by the identity of an array and of something that belongs to it; kept as long as the array lives.

    Results are frozen and hold arrays, which have no hash: what is made of them for later calls is kept beside them.
    """

    def __init__(self) -> None:
        self._kept: dict[int, tuple[object, T]] = {}

    def get(self, array: Array | Integers, beside: object, make: Callable[[], T]) -> T:
        """Return the value that was made for this very array and what stands beside it, or make it."""
        key = id(array)
        kept = self._kept.get(key)
        if kept is None or kept[0] is not beside:
            if kept is None:
                weakref.finalize(array, self._kept.pop, key, None)
            kept = beside, make()
            self._kept[key] = kept
        return kept[1]
