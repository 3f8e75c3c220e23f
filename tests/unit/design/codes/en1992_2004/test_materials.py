"""Concrete and steel: Table 3.1 as printed, and classes."""

from __future__ import annotations

from typing import get_args

import pytest

from groundslab.design.codes.en1992_2004.materials import CONCRETE_CLASSES, STEEL_CLASSES, Concrete
from groundslab.design.codes.en1992_2004.materials_of_case import materials
from groundslab.errors import InputError
from groundslab.model.design.reinforcement import ConcreteClass, Reinforcement, SteelClass

#: EN 1992-1-1 Table 3.1: E_cm [GPa] as printed, by f_ck [MPa].
E_CM = {12: 27, 16: 29, 20: 30, 25: 31, 30: 33, 35: 34, 40: 35, 45: 36, 50: 37, 55: 38, 60: 39, 70: 41, 80: 42, 90: 44}


@pytest.mark.parametrize("f_ck", E_CM)
def test_printed_moduli(f_ck: float) -> None:
    """All of the table, to a gigapascal."""
    assert abs(Concrete(f_ck * 1e6).E_cm / 1e9 - E_CM[int(f_ck)]) < 0.6


#: Classes of BS 8500-1: f_ck, f_cm [MPa], f_ctm [MPa] and E_cm [GPa] by the formulas of Table 3.1, by hand.
BRITISH = {"C28/35": (28, 36, 2.766, 32.31), "C32/40": (32, 40, 3.024, 33.35)}


def test_classes() -> None:
    """Fourteen classes of concrete with all strengths of the table and two British ones; steel by its strength."""
    assert [*CONCRETE_CLASSES.values()] == sorted([*map(float, E_CM), 28.0, 32.0])
    assert CONCRETE_CLASSES["C30/37"] == 30
    assert STEEL_CLASSES["B500B"] == 500
    assert get_args(ConcreteClass) == tuple(CONCRETE_CLASSES)
    assert get_args(SteelClass) == tuple(STEEL_CLASSES)


@pytest.mark.parametrize("name", BRITISH)
def test_british_classes(name: str) -> None:
    """The classes of BS 8500-1 have the values that the formulas of Table 3.1 give for their f_ck."""
    f_ck, f_cm, f_ctm, E_cm = BRITISH[name]
    concrete, _ = materials(Reinforcement(concrete=name, steel="B500B", bottom=(0.04, 0.05), top=(0.04, 0.05)))
    assert (concrete.f_ck, concrete.f_cm) == (f_ck * 1e6, f_cm * 1e6)
    assert concrete.f_ctm / 1e6 == pytest.approx(f_ctm, abs=5e-4)
    assert concrete.E_cm / 1e9 == pytest.approx(E_cm, abs=5e-3)


def test_a_class_is_its_strength() -> None:
    """Concrete and steel by class or by strength, one of both."""
    axes = {"bottom": (0.04, 0.05), "top": (0.04, 0.05)}
    concrete, steel = materials(Reinforcement(concrete="C35/45", steel="B550A", **axes))
    assert (concrete.f_ck, steel.f_yk) == (35e6, 550e6)
    for wrong in ({"steel": "B500B"}, {"concrete": "C30/37", "f_ck": 30e6, "steel": "B500B"}, {"concrete": "C30/37"}):
        with pytest.raises(InputError, match="one of them"):
            Reinforcement(**wrong, **axes)
