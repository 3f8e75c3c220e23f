"""Figures of concrete and steel that stiffness and strength both need (EN 1992-1-1 3.1, 3.2)."""

from __future__ import annotations

import math

#: Modulus of reinforcing steel [Pa], EN 1992-1-1 3.2.7(4).
STEEL_MODULUS = 200e9


def mean_tensile_strength(f_ck: float) -> float:
    """Return f_ctm [Pa] of concrete with the characteristic strength f_ck [Pa], EN 1992-1-1 Table 3.1."""
    f = f_ck / 1e6
    return (0.30 * f ** (2 / 3) if f <= 50 else 2.12 * math.log(1 + (f + 8) / 10)) * 1e6
