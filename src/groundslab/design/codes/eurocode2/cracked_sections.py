"""Cracked, elastic sections in bending, without bars in compression: what both generations of EN 1992-1-1 share."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array

#: The formulas of the functions here, with moments per width in MN, stresses in MPa and lengths in m.
FORMULAS = {
    "x": "sqrt((alpha_e * A_s)^2 + 2 * alpha_e * A_s * d) - alpha_e * A_s",
    "sigma_s": "m / (A_s * (d - x / 3))",
}


@dataclass(frozen=True, slots=True)
class Bars:
    """Bars of one layer in one direction, the same everywhere or (n,)."""

    diameter: Array | float  # of sets of several diameters that of 7.12 [m]
    spacing: Array | float  # from axis to axis [m]
    cover: Array | float  # of the bars [m]
    total: Array | None = None  # area of sets that lie between each other [m2/m]

    @property
    def area(self) -> Array | float:
        """Return the area [m2/m]."""
        return np.pi * self.diameter**2 / 4 / self.spacing if self.total is None else self.total


def neutral_axis(d: Array, area: Array, modular_ratio: float) -> Array:
    """Return the depth x (n,) [m] that is compressed of a cracked, elastic section: x^2 / 2 = alpha_e A_s (d - x)."""
    steel = modular_ratio * np.asarray(area, dtype=float)
    return np.asarray(np.sqrt(steel**2 + 2 * steel * d) - steel)


def steel_stress(m: Array, d: Array, area: Array, modular_ratio: float) -> Array:
    """Return the stress sigma_s (n,) [Pa] of the bars of a cracked section under moments m (n,) [N m/m]."""
    return np.asarray(m / (area * (d - neutral_axis(d, area, modular_ratio) / 3)))
