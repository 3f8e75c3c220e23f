"""Concrete and steel of a case by EN 1992-1-1:2023, with the factors of a limit state."""

from __future__ import annotations

from groundslab.design.codes.en1992_2023.annex import RECOMMENDED
from groundslab.design.codes.en1992_2023.materials import Concrete, Steel
from groundslab.design.codes.eurocode2.materials import strengths
from groundslab.model.design.reinforcement import Reinforcement

#: D_lower [m] where a case gives none.
D_LOWER = 0.016


def materials(steel: Reinforcement, limit_state: str = "ultimate") -> tuple[Concrete, Steel]:
    """Return concrete and steel in a limit state; InputError where EN 1992-1-1:2023 is not made for them.

    Factors that the case does not give are the recommended ones.
    """
    annex, (f_ck, f_yk) = RECOMMENDED, strengths(steel)
    gamma_c = annex.gamma_c if steel.gamma_c is None else steel.gamma_c
    gamma_s = annex.gamma_s if steel.gamma_s is None else steel.gamma_s
    gamma_v = annex.gamma_v if steel.gamma_v is None else steel.gamma_v
    if limit_state == "accidental":
        gamma_c, gamma_s = steel.accidental or annex.accidental[:2]
        gamma_v = annex.accidental[2]
    k_tc = annex.k_tc if steel.k_tc is None else steel.k_tc
    d_lower = D_LOWER if steel.d_lower is None else steel.d_lower
    return Concrete(f_ck, gamma_c, gamma_v, k_tc, d_lower, annex), Steel(f_yk, gamma_s)


def flattest(steel: Reinforcement, concrete: Concrete) -> float:
    """Return the largest cot theta of struts: a fifth less with steel of class A of ductility (8.2.3(4))."""
    brittle = steel.steel is not None and steel.steel.endswith("A")
    return (0.8 if brittle else 1.0) * concrete.annex.flattest
