"""Bending reinforcement that a slab needs in the ultimate limit state, per meter of width, by EN 1992-1-1.

Plane sections and no tension in the concrete (6.1(2)), the rectangular stress block of 3.1.7(3), eta f_cd over
lambda x, with eps_cu3 at the compressed face, steel with a horizontal top branch and no limit of its strain
(3.2.7(2)b), no normal force (`design/rules/bending`).

The neutral axis is kept above x / d = 0.45 for f_ck <= 50 MPa and 0.35 beyond (5.6.3(2)), unless another limit is
given: 5.5(4), for one, gives 0.448 without redistribution for f_ck <= 50 MPa. It is never allowed below the depth at
which the bars in tension just yield. Where that is not enough, bars in compression take the rest of the moment; links
must hold them (9.2.1.2(3)).
"""

from __future__ import annotations

from functools import partial

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.demands.design_moments import DesignMoments
from groundslab.design.rules import bending
from groundslab.design.rules.bending import Axes, BendingRule, Block, Reinforcement, SlabReinforcement
from groundslab.errors import InputError, Issue

__all__ = ["Axes", "Reinforcement", "SlabReinforcement", "deepest_axis", "minimum", "required", "rule", "slab"]

_MPA = 1e6
#: The formulas of `minimum` by kinds of annexes, with stresses in MPa and lengths in m.
MINIMUM = {
    "by strength": "max({of_strength:g} * f_ctm / f_yk, {least:g}) * d * 10000",
    "by cracking": "f_ctm * h^2 / 6 / (0.9 * d * f_yk) * 10000",
}
#: Lever arm over effective depth of bars that carry the moment at which a section cracks.
_LEVER = 0.9


def deepest_axis(concrete: Concrete, steel: Steel, xi_lim: float | None = None) -> float:
    """Return the largest x / d: xi_lim, by default that of EN 1992-1-1 5.6.3(2), or less, so that the steel yields."""
    if xi_lim is None:
        xi_lim = 0.45 if concrete.f_ck <= 50 * _MPA else 0.35
    elif not 0 < xi_lim < 1:
        raise InputError([Issue("xi_lim", f"{xi_lim:g}", "a limit of x / d between 0 and 1")])
    yields = concrete.eps_cu3 / (concrete.eps_cu3 + steel.f_yd / steel.E_s)
    return min(xi_lim, yields)


def required(
    m: Array,
    d: Array | float,
    concrete: Concrete,
    steel: Steel,
    *,
    d_2: Array | float | None = None,
    thickness: Array | float | None = None,
    xi_lim: float | None = None,
) -> Reinforcement:
    """Return the required reinforcement for moments m >= 0 (n,) [N m/m] with effective depths d (n,) or one [m].

    d_2, thickness: see ``bending.required``. Sources: EN 1992-1-1 3.1.7(3), 3.2.7(2), 6.1(2), 9.3.1.1.
    """
    xi = deepest_axis(concrete, steel, xi_lim)
    # no layer has more than most_bars A_c outside laps (9.2.1.1(3), by 9.3.1.1(1))
    most, f_c = concrete.annex.most_bars, concrete.eta * concrete.f_cd
    block = Block(f_c, concrete.lam, concrete.eps_cu3, steel.f_yd, steel.E_s, xi, most)
    least = partial(minimum, concrete=concrete, steel=steel)
    return bending.required(block, m, d, d_2=d_2, thickness=thickness, minimum=least)


def minimum(d: Array, thickness: Array | float | None = None, *, concrete: Concrete, steel: Steel) -> Array:
    """Return the least area of bars in tension (n,) [m2/m] for depths d (n,) [m], by EN 1992-1-1 9.2.1.1(1).

    Where the annex asks for bars that yield under the moment at which the section cracks, f_ctm h^2 / 6, its thickness
    (n,) or one [m] is needed.
    """
    d = np.asarray(d, dtype=float)
    if concrete.annex.minimum_by_cracking:
        if thickness is None:
            raise InputError([Issue("thickness", "None", "the section's thickness, in m")])
        return np.asarray(concrete.f_ctm * np.asarray(thickness) ** 2 / 6 / (_LEVER * d * steel.f_yk))
    of_strength, least = concrete.annex.minimum
    return max(of_strength * concrete.f_ctm / steel.f_yk, least) * d


def rule(concrete: Concrete, steel: Steel) -> BendingRule:
    """Return how bars are found for some concrete and steel."""
    return BendingRule(
        partial(required, concrete=concrete, steel=steel), partial(minimum, concrete=concrete, steel=steel)
    )


def slab(
    moments: DesignMoments,
    thickness: Array | float,
    axes: Axes,
    concrete: Concrete,
    steel: Steel,
    *,
    xi_lim: float | None = None,
) -> SlabReinforcement:
    """Return the four layers for design moments (n,) of a slab of thickness (n,) or one [m], by ``required``."""
    return bending.slab(moments, thickness, axes, partial(required, concrete=concrete, steel=steel, xi_lim=xi_lim))
