"""The design codes, by the words of the key `code`. A new one is a folder of its rules and a line here."""

from __future__ import annotations

from groundslab.design.codes.aci318.code import ACI318
from groundslab.design.codes.en1992_2004.code import EN1992
from groundslab.design.codes.en1992_2023.code import EN1992_2023
from groundslab.design.rules.design_code import DesignCode
from groundslab.model.design.reinforcement import Reinforcement

CODES: dict[str, DesignCode] = {"EN 1992-1-1": EN1992, "ACI 318": ACI318, "EN 1992-1-1:2023": EN1992_2023}


def code_of(steel: Reinforcement) -> DesignCode:
    """Return the code by which a case's slab is designed."""
    return CODES[steel.code]
