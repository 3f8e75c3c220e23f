"""What calculations by ACI 318-19 have of the concrete in shear."""

from __future__ import annotations

from collections.abc import Iterator

from groundslab.design.codes.aci318.materials import FORMULAS, Concrete
from groundslab.design.rules.calculation import MEGA, Step


def concrete_in_shear(concrete: Concrete, d: float) -> Iterator[Step]:
    """Yield strength, its root that counts, and the factor of size for an effective depth d [m]."""
    yield Step("specified strength of the concrete", "f_c", concrete.f_c / MEGA, "MPa", clause="19.2.1.1")
    yield Step("its root that counts", "r", concrete.root / MEGA, "MPa^0.5", FORMULAS["root"], "22.5.3.1, 22.6.3.1")
    formula = FORMULAS["lambda_s"] if concrete.size_effect else ""
    clause = "22.5.5.1.3" if concrete.size_effect else "13.2.6.2"
    yield Step("factor of size", "lambda_s", concrete.lambda_s(d), "", formula, clause)
