"""National annexes: what their files say, and what follows from it in resistances, by hand."""

from __future__ import annotations

import dataclasses
import math
import re
from typing import get_args

import numpy as np
import pytest

from groundslab.design.codes.en1992_2004 import anchorage, beams, bending, cracking, punching, shear
from groundslab.design.codes.en1992_2004.annex import ANNEXES, RECOMMENDED, Annex, annex_of, file_of
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.codes.en1992_2004.materials_of_case import largest_cover, least_cover, materials
from groundslab.design.codes.eurocode2.annex_files import Table
from groundslab.design.rules.webs import Web
from groundslab.errors import InputError
from groundslab.model.design.bars import Bars
from groundslab.model.design.reinforcement import Exposure, Reinforcement
from groundslab.model.loads.annexes import AnnexName, action_parameters
from helpers.paths import ROOT

STEEL = Steel(500e6)
KEYS = {field.name for field in dataclasses.fields(Annex)}


def table(name: str) -> Table:
    """Return the parameters in an annex's file."""
    return file_of(name).parameters


def concrete(annex: str, f_ck: float = 30e6) -> Concrete:
    """Return concrete with the factors of an annex."""
    own = annex_of(annex)
    return Concrete(f_ck, own.gamma_c, own.alpha_cc, own)


@pytest.mark.parametrize("name", ANNEXES)
def test_every_parameter_has_a_clause(name: str) -> None:
    """Each value is a parameter, has a clause, and says where it was looked up; recommended ones also what they are."""
    for key, each in table(name).items():
        assert key in KEYS
        more = {"quantity", "tests"} if name == "recommended" else set()
        assert set(each) == {"value", "clause", "sources", *more}
        assert each["clause"]
        assert len(set(each["sources"])) == len(each["sources"])
    if name == "recommended":
        assert set(table(name)) == KEYS


def test_every_parameter_is_held_by_tests() -> None:
    """The tests that the table names are there."""
    there = {each for path in ROOT.glob("tests/**/test_*.py")
             for each in re.findall(r"^def (test_\w+)", path.read_text("utf-8"), re.M)}  # fmt: skip
    for row in [*table("recommended").values(), *action_parameters()["rows"]]:
        assert row["tests"], row
        assert not set(row["tests"]) - there, row


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
    """The British annex has alpha_cc 0.85 in bending and 1.0 in shear; an alpha that is given counts in both.

    nu f_cd of C30: 0.6 (1 - 30 / 250) = 0.528 of 20 MPa, in Germany 0.75 and in Italy 0.5 of 17 MPa; in Poland 0.528 of
    21.43 MPa. In Italy nu is 0.5 of C70 too, and less beyond.
    """
    own = annex_of("United Kingdom")
    assert concrete("United Kingdom").strut == pytest.approx(0.528 * 20e6)
    assert Concrete(30e6, 1.5, 0.9, own).strut == pytest.approx(0.528 * 18e6)
    assert concrete("Germany").strut == pytest.approx(0.75 * 17e6)
    assert concrete("Italy").strut == pytest.approx(0.5 * 17e6)
    assert concrete("Poland").strut == pytest.approx(0.528 * 30e6 / 1.4)
    assert concrete("Italy", 70e6).strut == pytest.approx(0.5 * 0.85 * 70e6 / 1.5)
    assert concrete("Italy", 80e6).strut == pytest.approx(0.4 * 0.85 * 80e6 / 1.5)


def test_punching_by_annex() -> None:
    """C30, d = 0.8 m: k = 1.5, 2 % of bars. C_Rd,c 0.12 or 0.10; Germany's 0.5 f_cd / f_yd = 1.96 % counts at most."""
    for name, factor in (("recommended", 0.12), ("United Kingdom", 0.12), ("Germany", 0.10)):
        v = punching.resistance_without_links(concrete(name), 0.8)
        assert v == pytest.approx(factor * 1.5 * 60 ** (1 / 3) * 1e6)
    assert punching.most_bars(concrete("recommended"), STEEL) == 0.02
    assert punching.most_bars(concrete("Germany"), STEEL) == pytest.approx(0.5 * 17 / (500 / 1.15))
    assert punching.max_resistance(concrete("United Kingdom")) == pytest.approx(0.5 * 0.528 * 20e6)
    assert punching.max_resistance(concrete("Germany")) is None
    differ = {"Germany": (1.4, 1.1), "United Kingdom": (2.0, 1.0)}
    for name in ANNEXES:
        assert (annex_of(name).k_max, annex_of(name).least_beta) == differ.get(name, (1.5, 1.0))


@pytest.mark.parametrize(
    ("name", "beam", "slab"),
    [("recommended", 4.382, 8.764), ("United Kingdom", 4.382, 8.764), ("Germany", 4.634, 5.561)],
)
def test_least_links(name: AnnexName, beam: float, slab: float) -> None:
    """C30/37: 0.08 x 30^(1/2) / 500 (9.5N) are 8.764 cm2/m2, in Germany 0.16 x 2.896 / 500, and 0.6 of that in slabs.

    Beams are 0.5 m wide.
    """
    steel = Reinforcement(annex=name, concrete="C30/37", steel="B500B", bottom=(0.05, 0.06), top=(0.05, 0.06))
    idle = Web(np.zeros(1), np.zeros(1), 0.5, np.full(1, 0.6), np.full(1, 0.5), 0.06)
    assert 1e4 * beams.web(steel, "ultimate", idle).links[0] == pytest.approx(beam, abs=5e-4)
    assert 1e4 * shear.minimum_links(*materials(steel)) == pytest.approx(slab, abs=1e-3)


@pytest.mark.parametrize(
    ("name", "bars", "least"),
    [("recommended", 0.12, 0.035), ("United Kingdom", 0.12, 0.035), ("Poland", 0.18 / 1.4, 0.035),
     ("France", 0.12, 0.053 / 1.5), ("Germany", 0.10, 0.0525 / 1.5)],
)  # fmt: skip
def test_one_way_shear_by_annex(name: str, bars: float, least: float) -> None:
    """C30, d = 0.5 m: k = 1.6325; 1 % of bars, and so few that the least counts: v_min k^(3/2) 30^(1/2)."""
    d, k = np.array([0.5]), 1 + 0.4**0.5
    many, few = (shear.resistance_without_links(concrete(name), d, np.array([rho]))[0] / 0.5e6 for rho in (0.01, 1e-4))
    assert many == pytest.approx(bars * k * 30 ** (1 / 3))
    assert few == pytest.approx(least * k**1.5 * 30**0.5)
    thick = shear.resistance_without_links(concrete("Germany"), np.array([0.8]), np.array([1e-4]))[0] / 0.8e6
    assert thick == pytest.approx(0.0375 / 1.5 * 1.5**1.5 * 30**0.5)


def test_strong_concrete_in_shear_by_annex() -> None:
    """C90 counts as C50 in the United Kingdom, for v_Rd,c of one-way shear and punching and for struts."""
    d, rho = np.array([0.5]), np.array([0.01])
    for other, f_ck in (("United Kingdom", 50.0), ("recommended", 90.0)):
        strong = concrete(other, 90e6)
        v = shear.resistance_without_links(strong, d, rho)[0] / 0.5e6
        assert v == pytest.approx(0.12 * (1 + 0.4**0.5) * f_ck ** (1 / 3))
        punched = punching.resistance_without_links(strong, 0.8, 0.02) / 1e6
        assert punched == pytest.approx(0.12 * 1.5 * (2 * f_ck) ** (1 / 3))
        assert strong.strut == pytest.approx(0.6 * (1 - f_ck / 250) * f_ck / 1.5 * 1e6)


def test_lever_arm_by_annex() -> None:
    """A depth of 450 mm: 405 mm; in Germany with a cover of 50 mm 370 mm, with one of 20 mm 405 mm.

    Links grow as it falls: v / (z f_yd cot theta).
    """
    d, v = np.array([0.45]), np.array([50e3])
    for name, cover, z in (("recommended", 0.05, 0.405), ("Germany", 0.05, 0.37), ("Germany", 0.02, 0.405)):
        assert shear.lever(concrete(name), d, cover) == pytest.approx([z])
        links = shear.required_links(v, d, concrete(name), STEEL, cover)
        assert links.area == pytest.approx([50e3 / (z * 500e6 / 1.15 * links.cot_theta[0])])
    axes = Reinforcement(f_ck=30e6, f_yk=500e6, bottom=(0.05, 0.06), top=(0.04, 0.07))
    assert largest_cover(axes) == 0.07
    bars = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), Bars(diameter=0.012, spacing=0.15))
    assert largest_cover(axes.replace(**bars)) == pytest.approx(0.064)


def test_partial_factors_by_annex() -> None:
    """gamma_C is 1.4 in Poland; accidental ones 1.3 and 1.0 in Germany and Spain, 1.0 in Italy; alpha_cc 0.85 there."""
    accidental = {"Germany": (1.3, 1.0), "Spain": (1.3, 1.0), "Italy": (1.0, 1.0)}
    for name in ANNEXES:
        own = annex_of(name)
        assert (own.gamma_c, own.gamma_s) == (1.4 if name == "Poland" else 1.5, 1.15)
        assert own.accidental == accidental.get(name, (1.2, 1.0))
        assert own.alpha_cc == (0.85 if name in {"Germany", "Italy", "United Kingdom"} else 1.0)


def test_most_bars_by_annex() -> None:
    """C90, d = 450 mm of 500 mm, 3.9 MNm: 4.5 % of bars, more than the recommended 4 %; in Germany 8 % are allowed.

    x = 0.35 d: 48 x 0.7 x 0.1575 = 5.29 MN at 0.395 m, the other 1.81 MNm at 0.4 m: 9.82 MN / 434.8 MPa = 226 cm2.
    """
    d, h, m = np.array([0.45]), 0.5, np.array([3.9e6])
    enough = {name: bool(np.isfinite(bending.required(m, d, Concrete(90e6, annex=annex_of(name)), STEEL, d_2=0.05,
              thickness=h).tension[0])) for name in ("recommended", "Germany")}  # fmt: skip
    assert enough == {"recommended": False, "Germany": True}


def test_least_tensile_strength_by_annex() -> None:
    """C20, 500 mm thick, k = 0.86: 0.4 x 0.86 x 2.21 x 250 / 500 = 3.80 cm2/m, in Germany by 3.0 MPa 5.16 cm2/m."""
    for name, area in (("recommended", 3.801), ("Germany", 5.16)):
        least = cracking.minimum_area(np.array([0.5]), concrete(name, 20e6), 500e6)
        assert 1e4 * least == pytest.approx([area], rel=1e-3)


def test_cover_by_annex() -> None:
    """XC1, bars of 12 mm: 15 + 10 mm, in Germany 12 + 10 mm of bond; XD2: 40 + 10 and 40 + 15 mm; others leave it.

    5 mm are added in the Netherlands and in Austria, where XD2 has 30 mm. Without exposure it is 12 mm and what is
    added to bond, 10 mm in Germany.
    """
    for exposure, most in (
        ("XC1", {"recommended": 25, "Germany": 22, "Netherlands": 20, "Austria": 20}),
        ("XD2", {"recommended": 50, "Germany": 55, "Netherlands": 45, "Austria": 35}),
        (None, {"recommended": 22, "Netherlands": 17, "Austria": 17}),
    ):
        for name in ANNEXES:
            steel = Reinforcement(
                annex=name, exposure=exposure, f_ck=30e6, f_yk=500e6, bottom=(0.1, 0.1), top=(0.1, 0.1)
            )
            found = least_cover(steel, 0.012)
            if name in {"United Kingdom", "Spain"} and exposure is not None:
                assert found is None
            else:
                assert found == pytest.approx(most.get(name, most["recommended"]) / 1e3)


def test_depth_in_tension_by_annex() -> None:
    """h_c,ef of bars at 50 mm: 125 mm; in Germany 0.05 h + 2 x 50 mm in bending, 0.1 h + 100 in tension, 250 at most.

    300, 800 and 4000 mm: 125, 140 and 250 mm in bending, 130, 180 and 250 mm in tension. A crack at 300 kNm/m in
    800 mm, 5 bars of 20 mm per meter: rho = 15.708 / 1400 instead of 15.708 / 1250 cm2/cm2.
    """
    h = np.array([0.3, 0.8, 4.0])
    depths = {"recommended": ((125, 125, 125), (125, 125, 125)), "Germany": ((125, 140, 250), (130, 180, 250))}
    for name, (bent, pulled) in depths.items():
        k_bent, k_pulled = annex_of(name).tension_depth
        assert 1e3 * cracking.effective_depth(h, 0.05, k_bent) == pytest.approx(bent)
        assert 1e3 * cracking.effective_depth(h, 0.05, k_pulled) == pytest.approx(pulled)
        d, x, area = np.array([0.75]), np.array([0.1]), np.array([15.708e-4])
        rho = cracking.effective_ratio(np.array([0.8]), d, x, area, annex_of(name))
        assert rho == pytest.approx([15.708e-4 / (bent[1] * 1e-3)])
        ratio = cracking.tension_ratio(np.array(0.8), cracking.Bars(0.02, 0.2, 0.04), annex_of(name))
        assert ratio == pytest.approx(1.5708e-3 / (pulled[1] * 1e-3), rel=1e-4)


def test_laps_by_annex() -> None:
    """alpha_6 is 1.5; in Germany 1.4 of bars thinner than 16 mm and 2.0 of others, and alpha_2 is 1."""
    for name, thin, thick in (("recommended", 1.5, 1.5), ("Germany", 1.4, 2.0)):
        for diameter, alpha_6 in ((0.012, thin), (0.016, thick)):
            basic = anchorage.basic_length(concrete(name), STEEL, diameter, good=True)
            alpha_2 = 0.7 if name == "recommended" else 1.0
            lap = anchorage.lap_length(concrete(name), STEEL, diameter, 0.1, good=True)
            assert lap == pytest.approx(alpha_2 * alpha_6 * basic)
            assert anchorage.anchorage_length(concrete(name), STEEL, diameter, 0.1, good=True) == alpha_2 * basic


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
    """Germany: phi / (3.6 rho), not more than sigma_s phi / (3.6 f_ct,eff); the cover has no part in it.

    France: k_3 c = 3.4 (25 / 50)^(2/3) 50 = 107.1 mm instead of 170 mm of a cover of 50 mm, and the same at 25 mm.
    """
    thin = cracking.Bars(0.012, 0.1, 0.025)
    for name, of_cover in (("recommended", 0.170), ("France", 0.10709)):
        deep = cracking.Bars(0.012, 0.1, 0.05)
        far = cracking.largest_spacing(deep, np.array([0.3]), np.array([0.05]), np.array([0.02]), annex_of(name))
        assert far == pytest.approx([of_cover + 0.8 * 0.5 * 0.425 * 0.012 / 0.02], rel=1e-4)
        near = cracking.largest_spacing(thin, np.array([0.3]), np.array([0.05]), np.array([0.02]), annex_of(name))
        assert near == pytest.approx([0.085 + 0.102])
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
    """Small forces: Germany lets struts be as flat as cot theta = 3, Poland 2, the others 2.5; large ones steepen."""
    z = np.array([0.36])
    for name, cot in (("recommended", 2.5), ("United Kingdom", 2.5), ("Germany", 3.0), ("Poland", 2.0)):
        found = shear.required_links(np.array([50e3]), z / shear.LEVER, concrete(name), STEEL, 0.0)
        assert found.cot_theta == pytest.approx([cot])
    v = 600e3
    steep = shear.required_links(np.array([v]), z / shear.LEVER, concrete("Germany"), STEEL, 0.0)
    V_cc = 0.24 * 30 ** (1 / 3) * 1e6 * 0.36
    assert steep.cot_theta == pytest.approx([1.2 / (1 - V_cc / v)])
    assert steep.area == pytest.approx([v / (0.36 * STEEL.f_yd * 1.2 / (1 - V_cc / v))])
    assert math.isfinite(float(steep.area[0]))
