"""Loads at which yield lines form around point loads on a slab on springs (Meyerhof 1962; TR34, fourth edition).

The load on a circle of radius a makes a fan of sagging yield lines (M_p) inside a circle of hogging ones (M_n). Two
sets of formulas: that of TR34, linear between a / l = 0 and 0.2, and the one for M_0 = M_p + M_n by which
ACI 360R-10 11.3.3.3 goes.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

Location = Literal["internal", "edge", "corner"]

#: From this a / l on the second of TR34's formulas holds.
LARGE = 0.2


@dataclass(frozen=True, slots=True)
class YieldSlab:
    """Radius of relative stiffness l [m], moments of resistance M_p (sagging) and M_n (hogging) [N m/m]."""

    l: float  # noqa: E741  the field's letter
    M_p: float
    M_n: float


def relative_stiffness_radius(E: float, h: float, nu: float, k: float) -> float:
    """Return l = (D / k)^(1/4) [m] of a plate on springs k [Pa/m] (Westergaard 1926)."""
    return float((E * h**3 / (12 * (1 - nu**2) * k)) ** 0.25)


def single(slab: YieldSlab, a: float, location: Location) -> float:
    """Return the load [N] on a circle of radius a [m] at which a slab fails."""
    return _between(a / slab.l, _small(slab, location), lambda ratio: _large(slab, location, ratio))


def group(slab: YieldSlab, a: float, distances: float, location: Location) -> float:
    """Return the sum of two equal loads, or of four on a rectangle, at which a slab fails [N].

    distances [m] is that of two loads, or the sum of both sides of the rectangle; a is the radius of each load. At
    edges and corners the sum is less in the ratio of single loads, as TR34 has it.
    """
    both, spread = slab.M_p + slab.M_n, 1.8 * distances / slab.l
    inside = _between(
        a / slab.l,
        (2 * math.pi + spread) * both,
        lambda ratio: (4 * math.pi / (1 - ratio / 3) + spread / (1 - ratio / 2)) * both,
    )
    return inside * single(slab, a, location) / single(slab, a, "internal")


def _between(ratio: float, small: float, large: Callable[[float], float]) -> float:
    """Return the load [N] for a / l: that for 0, linear to the formula for large ratios, which holds from LARGE on."""
    return large(ratio) if ratio >= LARGE else small + ratio / LARGE * (large(LARGE) - small)


def _small(slab: YieldSlab, location: Location) -> float:
    """Return the load [N] for a / l = 0."""
    both = slab.M_p + slab.M_n
    return {
        "internal": 2 * math.pi * both,
        "edge": math.pi / 2 * both + 2 * slab.M_n,
        "corner": 2 * slab.M_n,
    }[location]


def _large(slab: YieldSlab, location: Location, ratio: float) -> float:
    """Return the load [N] for a / l from 0.2 on."""
    both = slab.M_p + slab.M_n
    return {
        "internal": 4 * math.pi * both / (1 - ratio / 3),
        "edge": (math.pi * both + 4 * slab.M_n) / (1 - 2 * ratio / 3),
        "corner": 4 * slab.M_n / (1 - ratio),
    }[location]


def meyerhof(M_0: float, a: float, l: float, location: Location) -> float:  # noqa: E741  the field's letter
    """Return Meyerhof's load [N] on a circle of radius a [m] for M_0 = M_p + M_n [N m/m] (Meyerhof 1962)."""
    factor, growth = {"internal": (6.0, 2.0), "edge": (3.5, 3.0), "corner": (2.0, 4.0)}[location]
    return factor * (1 + growth * a / l) * M_0
