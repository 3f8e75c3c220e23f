"""Scenes as the browser reads them."""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np

from groundslab.views.scene.binary import TYPES, Scene

LENGTH = struct.Struct("<I")


def unpack(content: bytes) -> Scene:
    """Return the scene that `pack` made bytes of."""
    (length,) = LENGTH.unpack_from(content)
    end = LENGTH.size + length
    return Scene(json.loads(content[LENGTH.size : end].decode()), content[end + -end % 8 :])


def values_of(scene: Scene, block: dict[str, Any]) -> np.ndarray:
    """Return the numbers of a block, or of a sum of blocks, as floats."""
    if "sum" in block:
        return np.asarray(sum(factor * values_of(scene, term) for factor, term in block["sum"]))
    count = int(np.prod(block["shape"]))
    raw = np.frombuffer(scene.data, TYPES[block["type"]], count, block["offset"]).reshape(block["shape"])
    return np.asarray(raw * block["scale"] + block["shift"], dtype=float)
