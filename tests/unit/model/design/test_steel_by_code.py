"""Yield strengths that each code knows: those of EN 1992-1-1 3.2.2(3), and grades 40 to 100 of ACI 318-19."""

from __future__ import annotations

import pytest

from groundslab.design.codes.aci318.bending import deepest_axis
from groundslab.design.codes.aci318.materials import Steel
from groundslab.errors import InputError
from groundslab.model.design.reinforcement import Code, Reinforcement


def reinforcement(code: Code, f_yk: float) -> Reinforcement:
    """Return concrete of 30 MPa with bars of some strength [Pa]."""
    return Reinforcement(code=code, f_ck=30e6, f_yk=f_yk, bottom=(0.04, 0.05), top=(0.04, 0.05))


@pytest.mark.parametrize("f_yk", [276e6, 690e6])
def test_grades_of_aci(f_yk: float) -> None:
    """Grades 40 and 100 (Table 20.2.2.4(a)) are those of ACI 318 alone; the message says what each code knows."""
    assert reinforcement("ACI 318", f_yk).f_yk == f_yk
    for code in ("EN 1992-1-1", "EN 1992-1-1:2023"):
        with pytest.raises(InputError) as refused:
            reinforcement(code, f_yk)
        (issue,) = refused.value.issues
        assert (issue.location, issue.expected) == ("Reinforcement.f_yk", f"400 to 600 MPa by {code}")


@pytest.mark.parametrize(("f_yk", "most"), [(276e6, 0.003 / 0.00738), (690e6, 0.003 / 0.00945)])
def test_tension_controlled_sections(f_yk: float, most: float) -> None:
    """The neutral axis lies at most c / d = 0.003 / (0.006 + f_y / E_s) (Table 21.2.2)."""
    assert deepest_axis(Steel(f_yk)) == pytest.approx(most, rel=1e-12)


def test_beyond_all_grades() -> None:
    """Weaker and stronger bars are refused by all codes."""
    for f_yk in (275e6, 691e6):
        with pytest.raises(InputError, match="MPa"):
            reinforcement("ACI 318", f_yk)
