"""Coefficients of ACI 318-19 are on the safe side of both editions: in inches and pounds, and in SI units."""

from __future__ import annotations

import math

import numpy as np
import pytest

from groundslab.design.codes.aci318 import beams, development, materials, punching, shear
from groundslab.design.codes.aci318.materials import Concrete, Steel

#: A pound-force per square inch [Pa], and what 1 (f'c)^(1/2) in psi is over (f'c)^(1/2) in MPa.
PSI = 4.4482216152605 / 0.0254**2
ROOT = math.sqrt(PSI / 1e6)
#: What a coefficient may lose by rounding.
ROUNDING = 0.003
#: f'c of 4000 psi.
C4000 = Concrete(4000 * PSI)
ROOT_4000 = math.sqrt(4000) * PSI

#: What counts, in 318M-19, and in psi in 318-19: the least of resistances.
RESISTANCES = {
    "stirrups and one-way shear, v_c": (shear.WITH_LINKS, 0.17, 2 * ROOT),
    "what links add": (shear.BY_LINKS, 0.66, 8 * ROOT),
    "torsion that is neglected": (beams.NEGLECTED, 0.083, 1 * ROOT),
    "the root of f'c": (materials.MOST_ROOT, 8.3, 100 * ROOT),
    "f_yt": (materials.MOST_F_YT / 1e6, 420.0, 60e3 * PSI / 1e6),
    "f_y in least bars": (beams.MOST_F_Y / 1e6, 550.0, 80e3 * PSI / 1e6),
    "development of thin bars": (development.THIN, 2.1, 25 * ROOT),
    "development of thick bars": (development.THICK, 1.7, 20 * ROOT),
}
#: The largest of what is asked for.
DEMANDS = {
    "torsion that cracks": (beams.CRACKS, 0.33, 4 * ROOT),
    "bars along for torsion": (beams.CRACK_BARS, 0.42, 5 * ROOT),
    "least length of development [mm]": (1e3 * development.LEAST, 300.0, 12 * 25.4),
    "least depth with stirrups [mm]": (1e3 * punching.LEAST_DEPTH, 150.0, 6 * 25.4),
}


@pytest.mark.parametrize("name", RESISTANCES)
def test_resistances_are_the_lesser_of_both(name: str) -> None:
    """By no more than rounding below either."""
    counts, si, us = RESISTANCES[name]
    assert min(si, us) * (1 - ROUNDING) <= counts <= min(si, us)


@pytest.mark.parametrize("name", DEMANDS)
def test_demands_are_the_greater_of_both(name: str) -> None:
    """By no more than rounding above either."""
    counts, si, us = DEMANDS[name]
    assert max(si, us) <= counts <= max(si, us) * (1 + ROUNDING)


def test_strengths_of_4000_psi_by_the_edition_in_pounds() -> None:
    """2 (1 + 2 / beta), 4, 2 and 6 (f'c)^(1/2) in two-way shear; 5 (f'c)^(1/2) at most in one-way shear."""
    d, most = 10 * 0.0254, 1 + ROUNDING
    assert C4000.lambda_s(d) == pytest.approx(1.0, abs=0.01)
    small, long, large = (punching.without_links(C4000, d, b_o, beta, 20.0) / C4000.lambda_s(d)
                          for b_o, beta in ((2.0, 1.0), (2.0, 4.0), (8.0, 1.0)))  # fmt: skip
    printed = 4 * ROOT_4000, 2 * (1 + 2 / 4) * ROOT_4000, (2 + 20 * d / 8.0) * ROOT_4000
    for found, of_code in zip((small, long, large), printed, strict=True):
        assert of_code / (1.01 * most) <= found <= of_code
    assert punching.most_with_links(C4000) <= 6 * ROOT_4000 <= punching.most_with_links(C4000) * most
    assert punching.with_links(C4000, d) <= 2 * ROOT_4000 * C4000.lambda_s(d)
    one_way = float(shear.without_links(C4000, np.array(d), np.array(1.0))) / d
    assert one_way <= 5 * ROOT_4000 <= one_way * most
    assert C4000.beta_1 <= 0.85
    assert Concrete(6000 * PSI).beta_1 == pytest.approx(0.75, abs=2e-4)
    assert Concrete(6000 * PSI).beta_1 <= 0.75


def test_least_links_are_those_of_either() -> None:
    """max(0.75 (f'c)^(1/2), 50 psi) / f_yt and max(0.062 (f'c)^(1/2), 0.35 MPa) / f_yt, f_yt at most 60,000 psi."""
    for f_c in (20e6, 30e6, 50e6, 80e6):
        of = Concrete(f_c)
        pounds = max(0.75 * min(math.sqrt(f_c / PSI), 100), 50) / 60e3
        si = max(0.062 * of.root, 0.35e6) / 420e6
        assert shear.links(0.0, 0.4, of, Steel(550e6)) >= max(pounds, si)
