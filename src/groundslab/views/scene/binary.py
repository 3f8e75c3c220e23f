"""A scene as bytes: a head in JSON, and numbers in blocks behind it; quantized where a picture needs no more digits.

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
#: Levels of a quantized value above its least one.
LEVELS = 2**16 - 1
#: A field that is told as a sum is right to one part of so many of its range.
PART = 2**12
#: A field whose range is at most such a share of its values is put by itself.
FLAT = 1e-6
#: So is one that is exactly 0 at more of the places than this share.
NOWHERE = 0.01
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

    def put_range(self, values: Array, levels: int = LEVELS) -> dict[str, Any]:
        """Put numbers in some levels from the least one, which is kept exactly, to the largest; return their block."""
        least = float(values.min()) if values.size else 0.0
        step = float(np.ptp(values)) / levels if values.size else 0.0
        steps = np.rint((values - least) / max(step, SMALLEST))
        return self._add(np.clip(steps, 0, levels), "u16" if levels > 255 else "u8", step, least)

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


def put_fields(blocks: Blocks, fields: Array) -> list[dict[str, Any]]:
    """Put one field of several combinations (c, n); return the block of each, or its sum of blocks with their factors.

    Combinations of a few load cases are sums of as many fields where nothing lifts off, and nearly so elsewhere. The
    fields that they are sums of are the leading ones of a proper orthogonal decomposition, each quantized as finely as
    its share asks for: no value is off by more than 1 / PART of the range of its combination.
    """
    flat = np.ptp(fields, axis=1) <= FLAT * np.abs(fields).max(axis=1, initial=0.0)
    # what is nothing, such as the pressure where the plate lifts off, would be a little in a sum
    apart = flat | ((fields == 0).mean(axis=1) > NOWHERE)
    together = iter(_put_sums(blocks, fields[~apart]))
    return [blocks.put_range(values) if alone else next(together) for values, alone in zip(fields, apart, strict=True)]


def _put_sums(blocks: Blocks, fields: Array) -> list[dict[str, Any]]:
    """Put fields none of which is flat; return the block of each, or its sum of blocks."""
    if len(fields) < 2:
        return [blocks.put_range(values) for values in fields]
    ranges = np.ptp(fields, axis=1)
    scaled = fields / ranges[:, None]
    _, directions = np.linalg.eigh(scaled @ scaled.T)
    factors = directions[:, ::-1]  # the largest first
    leading = factors.T @ scaled
    rest = scaled.copy()
    for count in range(1, len(fields)):
        rest -= np.outer(factors[:, count - 1], leading[count - 1])
        if np.abs(rest).max() <= 0.5 / PART:
            break
    else:
        return [blocks.put_range(values) for values in fields]
    # each block may be off by half a step; together they have the other half of what is allowed
    levels = np.ceil(np.abs(factors[:, :count]).max(axis=0) * np.ptp(leading[:count], axis=1) * count * PART)
    if levels.max() > LEVELS:
        return [blocks.put_range(values) for values in fields]
    put = [blocks.put_range(values, max(int(most), 1)) for values, most in zip(leading, levels, strict=False)]
    return [
        {"sum": [[float(factor * scale), block] for factor, block in zip(row, put, strict=False)]}
        for row, scale in zip(factors, ranges, strict=True)
    ]


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
