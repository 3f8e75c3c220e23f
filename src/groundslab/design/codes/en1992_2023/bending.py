"""Bending reinforcement that a slab needs in the ultimate limit state, per meter of width, by EN 1992-1-1:2023.

Plane sections and no tension in the concrete (8.1.1), the parabola-rectangle of 8.1.2(1), steel with a horizontal top
branch and no limit of its strain (5.2.4(2)), no normal force. With eps_cu at the compressed face a parabola-rectangle
over the depth x has, with r = eps_c2 / eps_cu,

    F_c = (1 - r / 3) f_cd x     at     a_c = (1/2 - r/3 + r^2/12) / (1 - r/3) x     from that face

and so has a block of the depth 2 a_c with the stress F_c / (2 a_c): in a rectangular section both are the same, exactly
(`design/rules/bending`). The neutral axis is kept above the depth up to which formula 7.16 lets moments of a linear
elastic analysis be without redistribution, delta_M = 1, and above that at which bars in tension just yield.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2023.materials import EPS_C2, EPS_CU, Concrete, Steel
from groundslab.design.rules import bending
from groundslab.design.rules.bending import BendingRule, Block, Reinforcement
from groundslab.errors import InputError, Issue

_R = EPS_C2 / EPS_CU
#: F_c over f_cd x, and where it acts over x: 0.8095 and 0.4160.
FILL = 1 - _R / 3
CENTER = (1 / 2 - _R / 3 + _R**2 / 12) / FILL
#: The same as a block: its depth over x, and its stress over f_cd.
DEPTH = 2 * CENTER
STRESS = FILL / DEPTH
#: The formulas of the functions here, with stresses in MPa and lengths in m.
FORMULAS = {
    "f_c": "(1 - r / 3)^2 / (1 - 2 * r / 3 + r^2 / 6) * f_cd",
    "A_min": "f_ctm * h^2 / 6 / (0.9 * d * f_yk) * 10000",
}
#: Lever arm over effective depth of bars that carry the moment at which a section cracks.
_LEVER = 0.9
#: The largest area of bars of a layer over the section's: the first generation's 9.2.1.1(3), as no other was read.
MOST_BARS = 0.04


def deepest_axis(steel: Steel) -> float:
    """Return the largest x / d: that of formula 7.16 without redistribution, or less, so that the steel yields."""
    unredistributed = 1 - 1 / (1 + 0.7 * EPS_CU * steel.E_s / steel.f_yd)
    yields = EPS_CU / (EPS_CU + steel.f_yd / steel.E_s)
    return min(unredistributed, yields)


def required(
    m: Array,
    d: Array | float,
    concrete: Concrete,
    steel: Steel,
    *,
    d_2: Array | float | None = None,
    thickness: Array | float | None = None,
) -> Reinforcement:
    """Return the required reinforcement for moments m >= 0 (n,) [N m/m] with effective depths d (n,) or one [m].

    d_2, thickness: see ``bending.required``. Sources: EN 1992-1-1:2023 8.1.1, 8.1.2(1), 5.2.4, 12.2(2).
    """
    xi = deepest_axis(steel)
    block = Block(STRESS * concrete.f_cd, DEPTH, EPS_CU, steel.f_yd, steel.E_s, xi, MOST_BARS)
    least = partial(minimum, concrete=concrete, steel=steel)
    return bending.required(block, m, d, d_2=d_2, thickness=thickness, minimum=least)


def minimum(d: Array, thickness: Array | float | None = None, *, concrete: Concrete, steel: Steel) -> Array:
    """Return the least area of bars in tension (n,) [m2/m] for depths d (n,) and thicknesses (n,) or one [m].

    They yield, with f_yk and the lever arm 0.9 d, under the moment at which the section cracks, f_ctm h^2 / 6
    (EN 1992-1-1:2023 12.2(2), 12.1).
    """
    if thickness is None:
        raise InputError([Issue("thickness", "None", "the section's thickness, in m")])
    return np.asarray(concrete.f_ctm * np.asarray(thickness) ** 2 / 6 / (_LEVER * np.asarray(d) * steel.f_yk))


def rule(concrete: Concrete, steel: Steel) -> BendingRule:
    """Return how bars are found for some concrete and steel."""
    return BendingRule(
        partial(required, concrete=concrete, steel=steel), partial(minimum, concrete=concrete, steel=steel)
    )
