"""Punching by EN 1992-1-1: a calculation of another program, Table 6.1, links that carry what they are made for."""

from __future__ import annotations

import math

import pytest

from groundslab.design.codes.en1992_2004.materials import Concrete
from groundslab.design.codes.en1992_2004.punching import (
    edge_ratio,
    links_per_perimeter,
    links_that_count,
    max_resistance,
    outer_perimeter,
    resistance_without_links,
    transfer_share,
)


def test_a_calculation_of_another_program() -> None:
    """eurocodeapplied.com as kept by the program XC: C30, d = 345 mm, 7.54 cm2/m both ways.

    409 kPa use 91.2667 % of v_Rd,c, and 1623 kPa 38.423 % of v_Rd,max.
    """
    rho = math.sqrt(7.54e-4 / 0.35 * 7.54e-4 / 0.34)
    v_Rd_c = resistance_without_links(Concrete(30e6), 0.345, rho)
    assert 0.409e6 / v_Rd_c == pytest.approx(0.9126672, rel=1e-4)
    assert 1.623e6 / max_resistance(Concrete(30e6)) == pytest.approx(0.3842330, rel=1e-6)


@pytest.mark.parametrize(
    ("ratio", "k"), [(0.2, 0.45), (0.5, 0.45), (1, 0.6), (1.5, 0.65), (2, 0.7), (3, 0.8), (9, 0.8)]
)
def test_table_6_1(ratio: float, k: float) -> None:
    """The table's four values, straight lines between, no more beyond."""
    assert transfer_share(ratio) == pytest.approx(k)


@pytest.mark.parametrize(
    ("across", "along", "k"), [(0.4, 0.4, 0.45), (0.8, 0.4, 0.6), (0.4, 0.8, 0.6), (1.6, 0.4, 0.7)]
)
def test_k_at_an_edge(across: float, along: float, k: float) -> None:
    """6.4.3(4): Table 6.1 with c_1 / (2 c_2), 1/2 of a square column, 1 at twice, 2 at four times as deep."""
    assert transfer_share(edge_ratio(across, along)) == pytest.approx(k)


def test_links_carry_what_is_missing() -> None:
    """With the links of 6.52 the resistance is the demand; where 3/4 of the concrete's is enough, none are needed."""
    v_Ed, v_Rd_c, u, d, s_r = 0.9e6, 0.6e6, 4.0, 0.3, 0.225
    A_sw = links_per_perimeter(v_Ed, v_Rd_c, u, d, 1.5 * d / s_r, 435e6)
    f_ywd_ef = (250 + 0.25 * 300) * 1e6
    assert 0.75 * v_Rd_c + 1.5 * d / s_r * A_sw * f_ywd_ef / (u * d) == pytest.approx(v_Ed)
    assert links_per_perimeter(0.4e6, v_Rd_c, u, d, 2.0, 435e6) == 0.0
    assert links_per_perimeter(v_Ed, v_Rd_c, u, d, 2.0, 300e6) == pytest.approx(A_sw * 325 / 300)


@pytest.mark.parametrize(("a", "count"), [(0.4, 1), (0.5, 1), (1.2, 1), (1.25, 2), (2.0, 2)])
def test_links_beyond_a_section_do_not_count(a: float, count: float) -> None:
    """Of links at 0.5 d, 1.25 d and 2 d a section counts on those within it, and on 1.5 d / s_r = 2 at most."""
    d = 0.4
    assert links_that_count(a * d, 0.5 * d, 0.75 * d, d) == pytest.approx(count)


def test_outer_perimeter() -> None:
    """There v_Rd,c is enough: v_Ed u = v_Rd,c u_out."""
    assert outer_perimeter(0.9e6, 0.6e6, 4.0) == pytest.approx(6.0)


def test_links_of_the_spreadsheet_of_the_concrete_centre() -> None:
    """TCC13.xls v4.0, column B3 of 600 mm: beta V_Ed 2578.7 kN, d 355 mm, v_Ed 1.0550 MPa at 2 d, v_Rd,c 0.6267 MPa.

    It has A_sw / s_r of 7.899 mm, and u_out of 11 592 mm.
    """
    u, d = 4 * 0.6 + 4 * math.pi * 0.355, 0.355
    s_r = 0.75 * d
    A_sw = links_per_perimeter(1.0550e6, 0.6267e6, u, d, 1.5 * d / s_r, 435e6)
    assert A_sw / s_r * 1e3 == pytest.approx(7.899, rel=5e-4)
    assert outer_perimeter(2578.7e3 / (u * d), 0.6267e6, u) * 1e3 == pytest.approx(11592, rel=2e-4)
