"""Loads at which yield lines form around point loads on a slab on springs (Meyerhof 1962; TR34, fourth edition).

The load on a circle of radius a makes a fan of sagging yield lines (M_p) inside a circle of hogging ones (M_n). Two
sets of formulas: that of TR34, linear between a / l = 0 and 0.2, and the one for M_0 = M_p + M_n by which
ACI 360R-10 11.3.3.3 goes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

Location = Literal["internal", "edge", "corner"]

#: From this a / l on the second of TR34's formulas holds.
LARGE = 0.2
#: Factors of Meyerhof's loads: of M_0, and of a / l.
MEYERHOF: dict[Location, tuple[float, float]] = {"internal": (6.0, 2.0), "edge": (3.5, 3.0), "corner": (2.0, 4.0)}
#: The formulas of the functions here, with forces in MN and lengths in m; {r} is a / l.
FORMULAS = {
    "l": "(E * h^3 / (12 * (1 - nu^2) * k))^(1/4)",
    "small_internal": "2 * pi * (M_p + M_n)",
    "small_edge": "pi / 2 * (M_p + M_n) + 2 * M_n",
    "small_corner": "2 * M_n",
    "large_internal": "4 * pi * (M_p + M_n) / (1 - {r} / 3)",
    "large_edge": "(pi * (M_p + M_n) + 4 * M_n) / (1 - 2 * {r} / 3)",
    "large_corner": "4 * M_n / (1 - {r})",
    "small_group": "(2 * pi + 1.8 * x / l) * (M_p + M_n)",
    "large_group": "(4 * pi / (1 - {r} / 3) + 1.8 * x / l / (1 - {r} / 2)) * (M_p + M_n)",
}


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
    inside = _between(a / slab.l, *_of_group(slab, distances))
    return inside * single(slab, a, location) / single(slab, a, "internal")


def together(slab: YieldSlab, radii: Sequence[float], distances: float, location: Location) -> float:
    """Return the sum of one, two or four loads on circles of radii [m] that fail a slab [N]: each alone, or all."""
    alone = sum(single(slab, a, location) for a in radii)
    return alone if len(radii) == 1 else min(alone, group(slab, min(radii), distances, location))


def _of_group(slab: YieldSlab, distances: float) -> tuple[float, Callable[[float], float]]:
    """Return the sum of loads inside [N] for a / l = 0, and that by a / l from 0.2 on."""
    both, spread = slab.M_p + slab.M_n, 1.8 * distances / slab.l
    return (2 * math.pi + spread) * both, lambda r: (4 * math.pi / (1 - r / 3) + spread / (1 - r / 2)) * both


def bounds_of_single(slab: YieldSlab, location: Location) -> tuple[float, float]:
    """Return the loads [N] for a / l = 0 and for 0.2, between which it is linear."""
    return _small(slab, location), _large(slab, location, LARGE)


def bounds_of_group(slab: YieldSlab, distances: float) -> tuple[float, float]:
    """Return the sums of loads inside [N] for a / l = 0 and for 0.2, see `group`."""
    small, large = _of_group(slab, distances)
    return small, large(LARGE)


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
    factor, growth = MEYERHOF[location]
    return factor * (1 + growth * a / l) * M_0
