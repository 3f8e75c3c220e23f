"""A scene as bytes: a head in JSON, and numbers in blocks behind it; quantised where a picture needs no more digits.

A block is described by offset [bytes], shape, type, scale a and shift b: value = a raw + b. All is little endian, every
offset a multiple of 8. A packed scene is the length of its head as four bytes, the head in UTF-8, zeros up to a
multiple of 8, the data.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from groundslab.arrays import Array, Integers

#: Names of the types of blocks, as the browser's typed arrays are called for short, and NumPy's.
TYPES = {"u8": "<u1", "u16": "<u2", "u32": "<u4", "i32": "<i4", "f32": "<f4"}
#: Levels of a quantised value above its least one.
LEVELS = 2**16 - 1
#: Least step between levels, so that no range is too small to be divided.
SMALLEST = 1e-300
_LENGTH = struct.Struct("<I")


@dataclass(frozen=True, slots=True)
class Scene:
    """What a browser draws: a head that JSON can hold, and the numbers that its blocks point into."""

    head: dict[str, Any]
    data: bytes


class Blocks:
    """Numbers that are put one behind the other."""

    def __init__(self) -> None:
        self._parts: list[bytes] = []
        self._length = 0

    @property
    def data(self) -> bytes:
        """Return all that has been put."""
        return b"".join(self._parts)

    def put(self, values: Array | Integers, kind: str) -> dict[str, Any]:
        """Put numbers as they are, rounded to a type of TYPES at most; return their block."""
        return self._add(np.asarray(values), kind, 1.0, 0.0)

    def put_range(self, values: Array) -> dict[str, Any]:
        """Put numbers in 2^16 levels from the least one, which is kept exactly, to the largest; return their block."""
        least = float(values.min()) if values.size else 0.0
        step = float(np.ptp(values)) / LEVELS if values.size else 0.0
        levels = np.rint((values - least) / max(step, SMALLEST))
        return self._add(np.clip(levels, 0, LEVELS), "u16", step, least)

    def put_signed(self, values: Array) -> dict[str, Any]:
        """Put numbers none of which is 0 in 2^16 levels, none of which is 0 either, so that no sign is lost."""
        step = max(float(np.abs(values).max(initial=0.0)) * 2 / LEVELS, SMALLEST)
        middle = (LEVELS + 1) // 2
        levels = np.floor(values / step) + middle
        # a small negative number over the step may round to -0.0
        levels = np.where(values < 0, np.minimum(levels, middle - 1), np.maximum(levels, middle))
        return self._add(np.clip(levels, 0, LEVELS), "u16", step, -step * LEVELS / 2)

    def _add(self, values: Any, kind: str, scale: float, shift: float) -> dict[str, Any]:
        raw = np.ascontiguousarray(values, dtype=TYPES[kind]).tobytes()
        about = {"offset": self._length, "shape": list(values.shape), "type": kind}
        padding = -len(raw) % 8
        self._parts += [raw, bytes(padding)]
        self._length += len(raw) + padding
        return about | {"scale": scale, "shift": shift}


def pack(scene: Scene) -> bytes:
    """Return a scene as bytes."""
    head = json.dumps(scene.head, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
    padding = -(_LENGTH.size + len(head)) % 8
    return b"".join([_LENGTH.pack(len(head)), head, bytes(padding), scene.data])


def with_head(packed: bytes, change: Callable[[dict[str, Any]], None]) -> bytes:
    """Return a packed scene whose head is changed."""
    (length,) = _LENGTH.unpack_from(packed)
    end = _LENGTH.size + length
    head = json.loads(packed[_LENGTH.size : end])
    change(head)
    return pack(Scene(head, packed[end + -end % 8 :]))
