"""One-way shear of slabs by ACI 318-19 22.5, nominal strengths per meter of width; f'c in MPa, d in mm.

    v_c = 0.66 lambda_s rho_w^(1/3) (f'c)^(1/2) d <= 0.415 (f'c)^(1/2) d   without links, Table 22.5.5.1 (c), 22.5.5.1.1
    v_c = 0.166 (f'c)^(1/2) d                                             with links, Table 22.5.5.1 (a)
    v_u <= phi (v_c + 0.66 (f'c)^(1/2) d)                                  22.5.1.2
    a_v = (v_u / phi - v_c) / (f_yt d)                                     22.5.8.5.3
        >= max(0.0623 (f'c)^(1/2), 0.35 MPa) / f_yt                        9.6.3.4

lambda_s = (2 / (1 + 0.004 d))^(1/2) <= 1 (22.5.5.1.3). A slab needs links where v_u > phi v_c (7.6.3.1).
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from groundslab.arrays import Array
from groundslab.design.codes.aci318.materials import FORMULAS as OF_CONCRETE
from groundslab.design.codes.aci318.materials import PHI_SHEAR, Concrete, Steel
from groundslab.design.rules.calculation import MEGA, Step

_MPA = 1e6
#: v_c with links, and the most that links add, over (f'c)^(1/2) d (Table 22.5.5.1 (a), 22.5.1.2).
WITH_LINKS, BY_LINKS = 0.166, 0.66
#: The formulas of the functions here, with forces per width in MN/m, stresses in MPa and lengths in m.
FORMULAS = {
    "v_c": "min(0.66 * lambda_s * rho_w^(1/3), 0.415) * r * d",
    "a_v": "max((v_u / phi - 0.166 * r * d) / (f_yt * d), max(0.0623 * r, 0.35) / f_yt) * 10000",
}


def without_links(concrete: Concrete, d: Array, rho: Array) -> Array:
    """Return v_c (n,) [N/m] for effective depths d (n,) [m] and ratios of bars in tension rho (n,)."""
    d = np.asarray(d, dtype=float)
    size = np.minimum(1.0, np.sqrt(2 / (1 + 4 * d))) if concrete.size_effect else np.ones(d.shape)
    return np.asarray(np.minimum(0.66 * size * np.cbrt(rho), 0.415) * concrete.root * d)


def links(v_u: float, d: float, concrete: Concrete, steel: Steel) -> float:
    """Return links per area of the plan [m2/m2] for a factored shear force v_u [N/m]; inf where none help."""
    most = PHI_SHEAR * (WITH_LINKS + BY_LINKS) * concrete.root * d
    if v_u > most:
        return float("inf")
    least = max(0.0623 * concrete.root, 0.35 * _MPA) / steel.f_yt
    return float(max((v_u / PHI_SHEAR - WITH_LINKS * concrete.root * d) / (steel.f_yt * d), least))


def concrete_in_shear(concrete: Concrete, d: float) -> Iterator[Step]:
    """Yield strength, its root that counts, and the factor of size for an effective depth d [m]."""
    yield Step("specified strength of the concrete", "f_c'", concrete.f_c / MEGA, "MPa", clause="19.2.1.1")
    yield Step("its root that counts", "r", concrete.root / MEGA, "MPa^0.5", OF_CONCRETE["root"], "22.5.3.1, 22.6.3.1")
    formula = OF_CONCRETE["lambda_s"] if concrete.size_effect else ""
    clause = "22.5.5.1.3" if concrete.size_effect else "13.2.6.2"
    yield Step("factor of size", "lambda_s", concrete.lambda_s(d), "", formula, clause)
