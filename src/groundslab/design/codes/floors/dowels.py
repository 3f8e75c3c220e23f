"""Resistance of dowels across joints by TR34, fourth edition, 6.5, from a digest of it.

A dowel shears off at 0.6 f_yd over 0.9 of its section, or it bends: the concrete bears k_3 f_cd over the dowel's width
on both sides, and the dowel becomes plastic inside. With M_p = f_yd d^3 / 6 of a round bar, f_yd W T^2 / 4 of a plate,
and e from the face of the concrete to the middle of the joint,

    P e + P^2 / (2 k_3 f_cd W) = M_p,  P = ((k_3 f_cd W e)^2 + 2 k_3 f_cd W M_p)^(1/2) - k_3 f_cd W e.

That the dowels burst out of the slab is not in it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

#: What the concrete bears beside a dowel, over f_cd.
K_3 = 3.0
#: Partial factor of the dowels' steel.
GAMMA_S = 1.15
#: The formulas of the functions here, with forces in MN, stresses in MPa and lengths in m.
FORMULAS = {
    "A round": "pi * W^2 / 4",
    "A plate": "W * T",
    "M_p round": "f_yd * W^3 / 6",
    "M_p plate": "f_yd * W * T^2 / 4",
    "P_sh": "0.6 * f_yd * 0.9 * A",
    "P_b": f"sqrt(({K_3:g} * f_cd * W * e)^2 + 2 * {K_3:g} * f_cd * W * M_p) - {K_3:g} * f_cd * W * e",
}


@dataclass(frozen=True, slots=True)
class Dowel:
    """A dowel: its width W [m], a plate's thickness T [m] or None of a round bar, and f_yd [Pa]."""

    width: float
    height: float | None
    f_yd: float

    @property
    def area(self) -> float:
        """Return the section [m2]."""
        return math.pi * self.width**2 / 4 if self.height is None else self.width * self.height

    @property
    def plastic_moment(self) -> float:
        """Return M_p [N m]."""
        if self.height is None:
            return self.f_yd * self.width**3 / 6
        return self.f_yd * self.width * self.height**2 / 4


def shear_resistance(dowel: Dowel) -> float:
    """Return P_sh [N]."""
    return 0.6 * dowel.f_yd * 0.9 * dowel.area


def bending_resistance(dowel: Dowel, f_cd: float, e: float) -> float:
    """Return P [N] at which the dowel bends in concrete of f_cd [Pa], e [m] from its face to the joint's middle."""
    bears = K_3 * f_cd * dowel.width
    return math.sqrt((bears * e) ** 2 + 2 * bears * dowel.plastic_moment) - bears * e
