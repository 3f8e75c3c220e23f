"""The limit depth, where stresses have fallen to a share of the overburden (DIN 4019, EN 1997-1, 6.6.2)."""

from __future__ import annotations

import numpy as np

from groundslab.arrays import Array
from groundslab.fem.continuum.cells import Cells
from groundslab.model.ground import ConstrainedModulus

#: The depth is sought between this share of the layers' depth and all of it, at so many depths.
LEAST, DEPTHS = 1e-3, 400


def find_limit_depth(ground: ConstrainedModulus, cells: Cells, load: float) -> float | None:
    """Return the limit depth below a slab under a load [N] [m], at most the depth of the layers; None if none is asked.

    The stress is that by a uniform pressure on the slab, less the relief of the excavation if that leaves any, below
    the middle of its area; Boussinesq's 3 z^3 / (2 pi R^5) of each cell. The overburden is the effective weight of the
    soil below the slab and the relief, which is that of the soil above.
    """
    if ground.limit_ratio is None or ground.unit_weight is None or load <= 0:
        return None
    area = cells.area.sum()
    pressure = load / area - ground.relief
    pressure = pressure if pressure > 0 else load / area
    bottom = sum(layer.thickness for layer in ground.layers)
    z = bottom * np.geomspace(LEAST, 1.0, DEPTHS)
    middle = cells.area @ cells.center / area
    r2 = ((cells.center - middle) ** 2).sum(axis=1)
    stress = np.array([3 * d**3 / (2 * np.pi) * (cells.area * (r2 + d**2) ** -2.5).sum() for d in z]) * pressure
    ratio = stress / overburden(ground, z)
    below = np.flatnonzero(ratio > ground.limit_ratio)
    last = below[-1] if len(below) else 0
    if last == len(z) - 1:
        return bottom
    steps = np.log(ratio[last : last + 2] / ground.limit_ratio)
    return float(np.exp(np.interp(0.0, -steps, np.log(z[last : last + 2]))))


def overburden(ground: ConstrainedModulus, z: Array) -> Array:
    """Return the effective overburden at depths z (n,) below the slab [Pa]; the soil must have a weight."""
    assert ground.unit_weight is not None
    if ground.groundwater is None or ground.unit_weight_below_water is None:
        return ground.relief + ground.unit_weight * z
    dry = np.minimum(z, ground.groundwater)
    return ground.relief + ground.unit_weight * dry + ground.unit_weight_below_water * (z - dry)
