"""Concrete and steel of a case by EN 1992-1-1, with the factors of a limit state."""

from __future__ import annotations

from groundslab.arrays import made_once
from groundslab.design.codes.en1992_2004.annex import Annex, annex_of
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.codes.eurocode2.materials import strengths
from groundslab.model.design.laid_bars import axis_of, bars_of
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.results.fields import LAYERS

__all__ = ["deviation", "largest_cover", "least_cover", "materials", "strengths", "widest_crack"]


def materials(steel: Reinforcement, limit_state: str = "ultimate") -> tuple[Concrete, Steel]:
    """Return concrete and steel in a limit state; InputError where EN 1992-1-1 is not made for them.

    Factors that the case does not give are those of its annex.
    """
    annex, (f_ck, f_yk) = annex_of(steel.annex), strengths(steel)
    gamma_c = annex.gamma_c if steel.gamma_c is None else steel.gamma_c
    gamma_s = annex.gamma_s if steel.gamma_s is None else steel.gamma_s
    if limit_state == "accidental":
        gamma_c, gamma_s = steel.accidental or annex.accidental
    alpha_cc = annex.alpha_cc if steel.alpha_cc is None else steel.alpha_cc
    return Concrete(f_ck, gamma_c, alpha_cc, annex), Steel(f_yk, gamma_s)


def widest_crack(steel: Reinforcement) -> float | None:
    """Return the largest crack width that is allowed [m]: the case's, else that of its exposure class, if any."""
    if steel.w_max is not None or steel.exposure is None:
        return steel.w_max
    return annex_of(steel.annex).w_max[steel.exposure]


def least_cover(steel: Reinforcement, diameter: float) -> float | None:
    """Return c_min + Delta c_dev [m] of a bar [m] (4.4.1); None where the annex leaves the exposure to others.

    Without exposure it is what bond asks for: the bar's diameter and at least 10 mm (4.4.1.2(2), (3)). Some annexes
    add less to it than to what durability asks for.
    """
    annex = annex_of(steel.annex)
    if steel.exposure is not None and steel.exposure not in annex.c_min_dur:
        return None
    of_bond = max(diameter, 0.010) + deviation(annex, None)
    if steel.exposure is None:
        return of_bond
    return max(of_bond, annex.c_min_dur[steel.exposure] + deviation(annex, steel.exposure))


def deviation(annex: Annex, exposure: str | None) -> float:
    """Return Delta c_dev [m] that an annex adds to the cover for durability in an exposure class, or for bond."""
    durable, lower = annex.delta_c_dev
    return lower if exposure in (None, "XC1") else durable


@made_once
def largest_cover(steel: Reinforcement) -> float:
    """Return the largest cover [m] of longitudinal bars at both faces; their axis if none lie."""
    thinnest = {layer: min(bars.diameter for bars in bars_of(steel, layer)) if steel.laid else 0.0 for layer in LAYERS}
    return max(axis_of(steel, layer) - thinnest[layer] / 2 for layer in LAYERS)
