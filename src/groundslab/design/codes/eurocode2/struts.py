"""Struts and vertical links that carry one-way shear, by truss: what both generations of EN 1992-1-1 share.

    v_Rd,max = z nu f_cd / (cot theta + tan theta)
    a_sw = v_Ed / (z f_ywd cot theta)

What concrete the struts have, and how flat they may be, each generation says itself.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.rules.calculation import Step

#: Lever arm over effective depth (EN 1992-1-1:2004 6.2.3(1), EN 1992-1-1:2023 8.2.1(3)).
LEVER = 0.9
#: Links, with forces per width in MN/m, stresses in MPa and lengths in m.
LINKS = "v_Ed / (z * f_ywd * cot) * 10000"
#: The shear force over the most that struts at 45 degrees bear.
SHARE = "2 * v_Ed / (z * nu_f_cd)"


@dataclass(frozen=True, slots=True)
class Links:
    """Links per area of the plan (n,) [m2/m2], with the struts cot theta; inf where the concrete is too weak."""

    area: Array
    cot_theta: Array

    @property
    def fails(self) -> Flags:
        """Return where no links help (n,)."""
        return np.isinf(self.area)


def links_by_struts(v: Array, z: Array, strut: float, f_ywd: float, flattest: Array | float) -> Links:
    """Return vertical links for shear forces v (n,) [N/m], with the flattest struts that the concrete bears.

    Where no struts bear, cot theta is 1 and the area inf.

    Parameters
    ----------
    v, z : array_like
        Shear forces (n,) [N/m] and lever arms (n,) [m].
    strut, f_ywd : float
        Strength of the struts, nu f_cd, and of links [Pa].
    flattest : array_like
        The largest cot theta (n,) or one.
    """
    # v = z nu f_cd sin(2 theta) / 2
    sine = np.asarray(2 * v / (z * strut))
    steepest = np.minimum(sine, 1.0)
    borne = (1 + np.sqrt(1 - steepest**2)) / np.maximum(steepest, 1e-12)
    cot = np.clip(borne, 1.0, flattest)
    return Links(np.where(sine > 1, np.inf, v / (z * f_ywd * cot)), cot)


def struts_in_steps(v: float, z: float, strut: float, cot: float, clause: str) -> Iterator[Step]:
    """Yield how flat struts are for a shear force v [N/m], a lever arm z [m] and their strength nu f_cd [Pa].

    What stands above are v_Ed, z, nu_f_cd and cot_max, the largest cot theta.
    """
    share = 2 * v / (z * strut)
    yield Step("shear force over what struts at 45 degrees bear", "w", share, "", SHARE, clause)
    yield flattest_step(cot, ("w", share), clause)


def flattest_step(cot: float, share: tuple[str, float], clause: str) -> Step:
    """Return how flat struts are, by the symbol and size of the share used of what those at 45 degrees bear."""
    words, (w, used) = "cot theta, the flattest struts that are borne", share
    formula = f"max(1, min(cot_max, (1 + sqrt(1 - {w}^2)) / {w}))" if used > 0 else "cot_max"
    return Step(words, "cot", cot, "", formula, clause)
