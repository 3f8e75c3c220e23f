"""Beams by EN 1992-1-1:2023 beyond what they share with slabs: least bars (12.2(2)) and links (8.2.3, 12.4)."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.design.en1992_2023 import bending, shear
from groundslab.design.en1992_2023.case_materials import flattest, materials
from groundslab.model.design.reinforcement import Reinforcement


def minimum(steel: Reinforcement, limit_state: str, d: float, height: float) -> float:
    """Return the least bars in tension over the width of the zone in tension [m], for a depth and a height [m]."""
    concrete, bars = materials(steel, limit_state)
    return float(bending.minimum(np.array([d]), height, concrete=concrete, steel=bars)[0])


def links(steel: Reinforcement, limit_state: str, v: Array, d: float) -> Array:
    """Return links per area in plan (n,) [m2/m2] for shear forces over the width (n,) [N/m]; inf where none help."""
    concrete, bars = materials(steel, limit_state)
    needed = shear.required_links(v, np.full(len(v), d), concrete, bars, flattest(steel, concrete)).area
    return np.maximum(needed, shear.minimum_links(concrete, bars))
