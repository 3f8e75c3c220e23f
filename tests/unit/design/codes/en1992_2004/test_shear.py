"""One-way shear: printed tables, a strut at its balance, and limits."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from groundslab.design.codes.en1992_2004.annex import RECOMMENDED
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.codes.en1992_2004.shear import (
    LEVER,
    minimum_links,
    required_links,
    resistance_without_links,
)
from groundslab.design.demands.design_moments import principal_shear, ratio_along

#: The Concrete Centre, "How to design concrete structures using Eurocode 2", Table 7 of slabs (7A on its pages on
#: shear): v_Rd,c / d [MPa] of C30/37 by ratio of bars [%] over effective depth [mm].
DEPTHS = (200, 225, 250, 275, 300, 350, 400, 450, 500, 600, 750)
TABLE_7A = {
    0.25: "0.54 0.52 0.50 0.48 0.47 0.45 0.43 0.41 0.40 0.38 0.36",
    0.50: "0.59 0.57 0.56 0.55 0.54 0.52 0.51 0.49 0.48 0.47 0.45",
    0.75: "0.68 0.66 0.64 0.63 0.62 0.59 0.58 0.56 0.55 0.53 0.51",
    1.00: "0.75 0.72 0.71 0.69 0.68 0.65 0.64 0.62 0.61 0.59 0.57",
    1.25: "0.80 0.78 0.76 0.74 0.73 0.71 0.69 0.67 0.66 0.63 0.61",
    1.50: "0.85 0.83 0.81 0.79 0.78 0.75 0.73 0.71 0.70 0.67 0.65",
    1.75: "0.90 0.87 0.85 0.83 0.82 0.79 0.77 0.75 0.73 0.71 0.68",
    2.00: "0.94 0.91 0.89 0.87 0.85 0.82 0.80 0.78 0.77 0.74 0.71",
}
#: The flattest strut that may be chosen, cot theta.
FLATTEST = RECOMMENDED.flattest
#: A digit in the last place: the table was cut here, rounded there.
LAST = 0.0101


@pytest.mark.parametrize("percent", TABLE_7A)
def test_printed_table(percent: float) -> None:
    """All rows of the table, to its last digit."""
    d = np.array(DEPTHS) / 1e3
    found = resistance_without_links(Concrete(30e6), d, np.full(d.shape, percent / 100)) / d / 1e6
    assert np.abs(found - np.array(TABLE_7A[percent].split(), dtype=float)).max() < LAST


def test_more_bars_than_count_change_nothing() -> None:
    """Beyond 2 % the resistance stays."""
    d = np.array([0.3, 0.3])
    two, five = resistance_without_links(Concrete(30e6), d, np.array([0.02, 0.05]))
    assert two == five


@pytest.mark.parametrize(("f_ck", "flat", "steep"), [(25, 3.10, 4.50)])
def test_struts(f_ck: float, flat: float, steep: float) -> None:
    """What struts bear, over the lever arm (The Concrete Centre, Table 7 of beams, its first row) [MPa]."""
    concrete, steel, z = Concrete(f_ck * 1e6), Steel(500e6), LEVER
    links = required_links(np.array([flat - 0.01, flat + 0.02, steep - 0.01, steep + 0.01]) * 1e6 * z, np.ones(4),
                           concrete, steel, 0.0)  # fmt: skip
    assert links.cot_theta[0] == FLATTEST
    assert 1.0 < links.cot_theta[2] < 1.1 < links.cot_theta[1] < FLATTEST
    assert links.fails.tolist() == [False, False, False, True]


def test_a_beam_at_its_balance() -> None:
    """Two legs of 12 mm every 150 mm in a width of 150 mm, z = 500 mm, C30, 450 MPa: 382.9 kN (program XC)."""
    concrete, steel = Concrete(30e6), Steel(450e6)
    legs = 2 * math.pi * 0.012**2 / 4 / 0.15 / 0.15
    links = required_links(np.array([382.9130152e3 / 0.15]), np.array([0.5 / LEVER]), concrete, steel, 0.0)
    assert links.area == pytest.approx([legs], rel=1e-6)


@given(st.floats(0.01, 0.999), st.floats(0.1, 2.0))
def test_links_and_struts_are_in_equilibrium(share: float, d: float) -> None:
    """Links carry the force, and the strut that they hold is not stressed beyond nu f_cd."""
    concrete, steel = Concrete(35e6), Steel(500e6)
    z, strength = LEVER * d, 0.6 * (1 - 35 / 250) * concrete.f_cd
    v = np.array([share * z * strength / 2])
    links = required_links(v, np.array([d]), concrete, steel, 0.0)
    cot = links.cot_theta[0]
    assert links.area[0] * steel.f_yd * z * cot == pytest.approx(v[0])
    assert v[0] * (cot + 1 / cot) / z <= strength * (1 + 1e-12)
    assert 1 <= cot <= FLATTEST


@given(st.integers(-500_000, 500_000), st.integers(-500_000, 500_000))
def test_principal_shear_is_the_largest_of_any_direction(q_x: int, q_y: int) -> None:
    """No direction has more."""
    size, share = principal_shear(np.array([float(q_x)]), np.array([float(q_y)]))
    t = np.linspace(0, 2 * math.pi, 721)
    of_any = q_x * np.cos(t) + q_y * np.sin(t)
    assert of_any.max() <= size[0] * (1 + 1e-12)
    assert of_any.max() >= size[0] * (1 - 1e-4)
    assert 0 <= share[0] <= 1


def test_ratio_along_the_bars_is_theirs() -> None:
    """Along x, along y, and halfway between equal nets, where half of each bar's stiffness counts."""
    share, rho_x, rho_y = np.array([1.0, 0.0, 0.5]), 0.01 * np.ones(3), 0.004 * np.ones(3)
    assert ratio_along(share, rho_x, rho_y).tolist() == pytest.approx([0.01, 0.004, (0.01 + 0.004) / 4])


def test_least_links() -> None:
    """C30 and B500: 0.08 sqrt(30) / 500."""
    assert minimum_links(Concrete(30e6), Steel(500e6)) == pytest.approx(8.7636e-4, rel=1e-4)
