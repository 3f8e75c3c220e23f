"""National annexes: what their files say, and what follows from it in resistances, by hand."""

from __future__ import annotations

import dataclasses
import math
from typing import get_args

import numpy as np
import pytest

from groundslab.design.en1992 import beams, bending, cracking, punching, shear
from groundslab.design.en1992.annex import ANNEXES, RECOMMENDED, Annex, annex_of, table
from groundslab.design.en1992.case_materials import materials
from groundslab.design.en1992.materials import Concrete, Steel
from groundslab.errors import InputError
from groundslab.model.design.reinforcement import AnnexName, Exposure, Reinforcement

STEEL = Steel(500e6)
KEYS = {field.name for field in dataclasses.fields(Annex)}


def concrete(annex: str, f_ck: float = 30e6) -> Concrete:
    """Return concrete with the factors of an annex."""
    own = annex_of(annex)
    return Concrete(f_ck, own.gamma_c, own.alpha_cc, own)


@pytest.mark.parametrize("name", ANNEXES)
def test_every_parameter_has_a_clause(name: str) -> None:
    """Each value is one of the parameters, has a clause, and says where it was looked up, if anywhere."""
    for key, each in table(name).items():
        assert key in KEYS
        assert set(each) == {"value", "clause", "source"}
        assert each["clause"]
    if name == "recommended":
        assert set(table(name)) == KEYS


def test_names_of_the_model() -> None:
    """The case file offers exactly the annexes that there are, and exposure classes of the table of crack widths."""
    assert get_args(AnnexName) == tuple(ANNEXES)
    assert set(get_args(Exposure)) == set(RECOMMENDED.w_max) == set(RECOMMENDED.c_min_dur)


def test_an_annex_differs_from_what_is_recommended() -> None:
    """No file repeats a recommended value: what is there is what differs."""
    recommended = table("recommended")
    for name in set(ANNEXES) - {"recommended"}:
        assert not [key for key, each in table(name).items() if each["value"] == recommended[key]["value"]]


def test_defaults_are_the_annex_and_keys_override_it() -> None:
    """Germany has alpha_cc 0.85 and accidental factors 1.3 and 1.0; a key of the case comes first."""
    given = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.05, 0.06), "top": (0.05, 0.06)}
    of, bars = materials(Reinforcement(annex="Germany", **given))
    assert (of.gamma_c, of.alpha_cc, bars.gamma_s) == (1.5, 0.85, 1.15)
    of, bars = materials(Reinforcement(annex="Germany", **given), "accidental")
    assert (of.gamma_c, bars.gamma_s) == (1.3, 1.0)
    of, bars = materials(Reinforcement(annex="Germany", gamma_c=1.4, alpha_cc=0.9, **given))
    assert (of.gamma_c, of.alpha_cc, bars.gamma_s) == (1.4, 0.9, 1.15)
    of, _ = materials(Reinforcement(**given))
    assert (of, of.annex) == (Concrete(30e6), RECOMMENDED)


def test_struts_take_the_alpha_of_shear() -> None:
    """The British annex has alpha_cc 0.85 in bending and 1.0 in shear; an alpha that is given counts in both."""
    own = annex_of("United Kingdom")
    assert concrete("United Kingdom").strut == pytest.approx(0.528 * 20e6)
    assert Concrete(30e6, 1.5, 0.9, own).strut == pytest.approx(0.528 * 18e6)


def test_punching_by_annex() -> None:
    """C30, d = 0.8 m: k = 1.5, 2 % of bars. C_Rd,c 0.12 or 0.10; Germany's 0.5 f_cd / f_yd = 1.96 % counts at most."""
    for name, factor in (("recommended", 0.12), ("United Kingdom", 0.12), ("Germany", 0.10)):
        v = punching.resistance_without_links(concrete(name), 0.8)
        assert v == pytest.approx(factor * 1.5 * 60 ** (1 / 3) * 1e6)
    assert punching.most_bars(concrete("recommended"), STEEL) == 0.02
    assert punching.most_bars(concrete("Germany"), STEEL) == pytest.approx(0.5 * 17 / (500 / 1.15))
    assert punching.max_resistance(concrete("United Kingdom")) == pytest.approx(0.5 * 0.528 * 20e6)
    assert punching.max_resistance(concrete("Germany")) is None
    assert [annex_of(name).k_max for name in ANNEXES] == [1.5, 1.4, 2.0]
    assert [annex_of(name).least_beta for name in ANNEXES] == [1.0, 1.1, 1.0]


@pytest.mark.parametrize(("name", "least"), [("recommended", 4.382), ("United Kingdom", 4.382), ("Germany", 4.634)])
def test_least_links_of_beams(name: AnnexName, least: float) -> None:
    """C30/37 over 0.5 m: 0.08 x 30^(1/2) / 500 (9.5N) are 4.382 cm2/m, Germany's 0.16 x 2.896 / 500 4.634 cm2/m."""
    steel = Reinforcement(annex=name, concrete="C30/37", steel="B500B", bottom=(0.05, 0.06), top=(0.05, 0.06))
    assert 0.5e4 * beams.links(steel, "ultimate", np.zeros(1), 0.5)[0] == pytest.approx(least, abs=5e-4)


def test_links_of_two_rows() -> None:
    """1 MN in a slab of d = 0.4 m: f_ywd,ef = 350 MPa, 28.57 cm2."""
    assert punching.links_alone(1e6, 0.4, 435e6) == pytest.approx(1e6 / 350e6)


def test_least_bars_that_a_crack_needs() -> None:
    """Germany: f_ctm h^2 / 6 over 0.9 d f_yk; h = 0.5, d = 0.45 m, C30: 2.896 MPa, 0.1207 MNm, 5.96 cm2/m."""
    least = bending.minimum(np.array(0.45), 0.5, concrete=concrete("Germany"), steel=STEEL)
    assert float(least) == pytest.approx(0.30 * 30 ** (2 / 3) * 0.25 / 6 / (0.9 * 0.45 * 500), rel=1e-12)
    assert float(least) == pytest.approx(5.96e-4, rel=1e-3)
    with pytest.raises(InputError, match="thickness"):
        bending.minimum(np.array(0.45), concrete=concrete("Germany"), steel=STEEL)


def test_crack_spacing_by_annex() -> None:
    """Germany: phi / (3.6 rho), not more than sigma_s phi / (3.6 f_ct,eff); the cover has no part in it."""
    rho, bars = np.array([0.02]), cracking.Bars(0.012, 0.1, 0.05)
    s_r = cracking.largest_spacing(bars, np.array([0.3]), np.array([0.05]), rho, annex_of("Germany"))
    assert s_r == pytest.approx([0.012 / (3.6 * 0.02)])
    few, h, m = cracking.Bars(0.012, 0.2, 0.04), 0.5, 60e3
    d = h - 0.046
    sigma = cracking.steel_stress(np.array(m), np.array(d), np.array(few.area), 200e9 / concrete("Germany").E_cm)
    most = float(sigma) * 0.012 / (3.6 * concrete("Germany").f_ctm)
    rho_eff = few.area / (2.5 * 0.046)
    assert most < 0.012 / (3.6 * rho_eff)
    width = cracking.crack_width(np.array([m]), np.array(h), few, concrete("Germany"), STEEL)
    strain = cracking.mean_strain(sigma, np.array(rho_eff), concrete("Germany"), STEEL)
    assert width[0] == pytest.approx(most * float(strain), rel=1e-6)


def test_shear_links_by_annex() -> None:
    """Small forces: Germany lets struts be as flat as cot theta = 3, the others 2.5; larger ones steepen them."""
    z = np.array([0.36])
    for name, cot in (("recommended", 2.5), ("United Kingdom", 2.5), ("Germany", 3.0)):
        found = shear.required_links(np.array([50e3]), z / shear.LEVER, concrete(name), STEEL)
        assert found.cot_theta == pytest.approx([cot])
    v = 600e3
    steep = shear.required_links(np.array([v]), z / shear.LEVER, concrete("Germany"), STEEL)
    V_cc = 0.24 * 30 ** (1 / 3) * 1e6 * 0.36
    assert steep.cot_theta == pytest.approx([1.2 / (1 - V_cc / v)])
    assert steep.area == pytest.approx([v / (0.36 * STEEL.f_yd * 1.2 / (1 - V_cc / v))])
    assert math.isfinite(float(steep.area[0]))
