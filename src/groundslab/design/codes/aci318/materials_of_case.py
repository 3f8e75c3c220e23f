"""Concrete and steel of a case by ACI 318-19."""

from __future__ import annotations

from groundslab.design.codes.aci318.materials import Concrete, Steel
from groundslab.model.design.reinforcement import Reinforcement


def materials(steel: Reinforcement) -> tuple[Concrete, Steel]:
    """Return concrete and steel; InputError where ACI 318 is not made for them.

    Strengths are f'c and f_y as they are given: classes are those of EN 1992-1-1.
    """
    assert steel.f_ck is not None
    assert steel.f_yk is not None
    return Concrete(steel.f_ck, size_effect=steel.size_effect), Steel(steel.f_yk)
