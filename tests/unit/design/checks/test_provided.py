"""Bars that are laid: enough of them, close enough, cracks narrow enough, each by hand on one even moment."""

from __future__ import annotations

import numpy as np
import pytest

from groundslab.design.checks import check_design
from groundslab.design.codes.aci318.checks import bars as aci_bars
from groundslab.design.codes.en1992_2004 import cracking
from groundslab.design.codes.en1992_2004.materials import Concrete, Steel
from groundslab.design.rules.combinations import why_none
from groundslab.errors import InputError
from groundslab.results.results import Results
from helpers import synthetic
from helpers.calculations import follow_steps
from helpers.laid_slab import LAID, STEEL, checks, model_of, stress_by_hand


def test_bars_against_what_bending_needs() -> None:
    """D = 254 mm: 7.54 cm2/m bear A_s f_yd (d - A_s f_yd / (2 f_cd)) = 81.2 kNm/m; a little more and they fail."""
    area, f_yd, f_cd = np.pi * 0.012**2 / 4 / 0.15, 500e6 / 1.15, 20e6
    most = area * f_yd * (0.254 - area * f_yd / (2 * f_cd))
    assert most == pytest.approx(80.6e3, rel=0.01)
    for m, status, used in ((0.999 * most, "no failure found", 1.0), (1.001 * most, "fails", 1.0)):
        check = checks(m)["bars at the bottom x"]
        assert check.status == status
        assert check.utilization == pytest.approx(used, rel=2e-3)
        assert check.resistance == pytest.approx(7.540, rel=1e-3)
    assert checks(most)["bars at the top x"].status == "no failure found"


def test_distance_of_bars() -> None:
    """At most 400 mm (3 h = 900 mm)."""
    assert checks(1e3)["distance of bars"].status == "no failure found"
    far = checks(1e3, top_y={"diameter": 0.012, "spacing": 0.41})["distance of bars"]
    assert (far.status, far.of) == ("fails", "top y")


def test_crack_width() -> None:
    """The width of cracking.crack_width at the bottom along x, none at the top; both sides of the limit."""
    m = 60e3
    width = float(cracking.crack_width(np.array([m]), np.array(0.3), cracking.Bars(0.012, 0.15, 0.04),
                                       Concrete(30e6), Steel(500e6))[0])  # fmt: skip
    found = checks(m, w_max=1.01 * width)
    assert found["crack width at the bottom x"].status == "no failure found"
    assert found["crack width at the bottom x"].demand == pytest.approx(1e3 * width)
    assert found["crack width at the top x"].demand == 0.0
    assert checks(m, w_max=0.99 * width)["crack width at the bottom x"].status == "fails"


def test_least_bars_for_cracks() -> None:
    """0.4 x 1 x 2.8965 x 0.15 / 500 = 3.476 cm2/m where a face is in tension, and only if cracks are limited."""
    for spacing, status in ((0.32, "no failure found"), (0.33, "fails")):
        thin = {"diameter": 0.012, "spacing": spacing}
        row = checks(20e3, bottom_x=thin, w_max=3e-4)["least bars for cracks"]
        assert (row.status, row.of, row.clause) == (status, "bottom x", "EN 1992-1-1 7.3.2(2)")
        assert row.demand == pytest.approx(3.4758, rel=1e-4)
        assert row.resistance == pytest.approx(np.pi * 1.2**2 / 4 / spacing)
    thin = {"diameter": 0.012, "spacing": 0.33}
    assert checks(20e3, bottom_x=thin, exposure="XC2")["least bars for cracks"].status == "fails"
    assert checks(20e3, top_x=thin, w_max=3e-4)["least bars for cracks"].status == "no failure found"
    assert checks(-20e3, top_x=thin, w_max=3e-4)["least bars for cracks"].of == "top x"
    assert "least bars for cracks" not in checks(20e3, bottom_x=thin)


def test_bars_that_yield_fail_instead_of_cracks() -> None:
    """Above f_yk = 500 MPa of an elastic section there is no crack width: the section fails, with its stress."""
    elastic, yielding = 0.99 * 90e3, 1.3 * 90e3
    assert stress_by_hand(elastic) < 500e6 < stress_by_hand(yielding)
    assert checks(elastic, w_max=4e-4)["crack width at the bottom x"].unit == "mm"
    row = checks(yielding, w_max=4e-4)["crack width at the bottom x"]
    assert (row.status, row.unit, row.resistance) == ("fails", "MPa", 500)
    assert row.demand == pytest.approx(stress_by_hand(yielding) / 1e6, rel=1e-3)
    assert "the bars yield" in row.words
    assert "w_k" not in row.words


def test_stress_of_bars_in_characteristic_combinations() -> None:
    """At most 0.8 f_yk = 400 MPa (7.2(5)); above it needs attention, above f_yk the section fails."""
    for m, status, limit in ((60e3, "no failure found", 400), (80e3, "attention", 400), (117e3, "fails", 500)):
        row = checks(m)["stress of the bars"]
        assert (row.status, row.resistance, row.combination) == (status, limit, "SLS")
        assert row.demand == pytest.approx(stress_by_hand(m) / 1e6, rel=1e-3)


def test_cover_without_an_exposure_class() -> None:
    """Bond asks for the bar's diameter, 10 mm at least, and 10 mm of deviation in any class (4.4.1.2(3), 4.4.1.3)."""
    least = checks(1e3)["cover"]
    assert (least.status, least.demand, least.resistance) == ("no failure found", pytest.approx(40), pytest.approx(22))
    assert "durability is not checked" in least.words
    thin = checks(1e3, bottom=(0.007, 0.019))["cover"]
    assert (thin.status, thin.demand, thin.resistance) == ("fails", pytest.approx(1), pytest.approx(22))


def test_cover_by_aci_318() -> None:
    """75 mm cast against the ground, 38 mm of thin bars otherwise, 50 mm of thick ones, 19 mm inside (20.5.1.3.1)."""
    aci = {"code": "ACI 318", "f_yk": 420e6}
    thick = {"bottom_x": {"diameter": 0.022, "spacing": 0.15}}
    for bottom, bars, status, demand, limit in (
        ((0.081, 0.093), {}, "no failure found", 75, 38), ((0.06, 0.072), {}, "attention", 54, 75),
        ((0.04, 0.052), {}, "fails", 34, 38), ((0.06, 0.093), thick, "fails", 49, 50),
    ):  # fmt: skip
        row = checks(1e3, **aci, bottom=bottom, **bars)["cover"]
        assert row.status == status, row.words
        if status != "no failure found":
            assert (row.demand, row.resistance) == (pytest.approx(demand), pytest.approx(limit))
    assert checks(1e3, **aci, bottom=(0.081, 0.093), top=(0.02, 0.032))["cover"].status == "fails"


def test_combinations_that_are_not_there_are_said_to_be_none() -> None:
    """A case without a quasi-permanent combination has none; one whose results are missing has no certified ones."""
    combined = Results(model := model_of(w_max=3e-4), model.combinations[:1], {}, {})
    assert why_none(combined, ("quasi-permanent",), "such combination") == "the case has no such combination"
    missing = Results(model, model.combinations, {}, {})
    assert why_none(missing, ("quasi-permanent",), "one") == "no one has a certified result"


def test_layers_that_are_missing_and_bars_too_thick() -> None:
    """All four layers or none; bars that stick out of their cover; a crack width without bars."""
    with pytest.raises(InputError, match="bars in all four layers"):
        checks(1e3, top_x=None)
    with pytest.raises(InputError, match="bars thinner than"):
        checks(1e3, bottom_x={"diameter": 0.05, "spacing": 0.1}, bottom=(0.02, 0.058))
    with pytest.raises(InputError, match="bars in all four layers"):
        checks(1e3, w_max=3e-4, **dict.fromkeys(LAID))


THICK = {key: {"diameter": 0.016, "spacing": 0.15} for key in ("bottom_x", "bottom_y", "top_x", "top_y")}


def test_bars_against_restraint() -> None:
    """300 mm of C30/37 crack at 2.8965 x 0.15 = 0.4345 MN/m at each face, 8.69 cm2/m of 500 MPa, with any moment."""
    assert "bars against restraint" not in checks(0.0)
    for bars, status in ((LAID, "fails"), (THICK, "no failure found")):
        row = checks(0.0, **bars, restraint={})["bars against restraint"]
        assert (row.status, row.clause) == (status, "EN 1992-1-1 7.3.2(2)")
        assert row.demand == pytest.approx(8.6895, rel=1e-4)
        assert row.resistance == pytest.approx(np.pi * bars["top_x"]["diameter"] ** 2 / 4 / 0.15 * 1e4)
        assert follow_steps(row.steps)["eta"] == pytest.approx(row.utilization)
    early = checks(0.0, **LAID, restraint={"f_ct_eff": 1.45e6})["bars against restraint"]
    assert early.demand == pytest.approx(4.35)


@pytest.mark.parametrize(("annex", "w_k"), [("recommended", 0.7375), ("Germany", 0.4876)])
def test_the_width_of_cracks_by_restraint(annex: str, w_k: float) -> None:
    """Bars of 16 mm at 150 mm, their axis at 58 mm: by hand.

    sigma_s = 434.5 / 1340.4 = 324.1 MPa; rho = 1340.4 / (2.5 x 58) = 0.924 %; 0.6 x 324.1 / 200 000 = 0.972 per mille
    is more than (324.1 - 132.4) / 200 000. s_r = 3.4 x 50 + 0.8 x 0.425 x 16 / 0.00924 = 758 mm; in Germany
    h_c,ef is 0.1 x 300 + 2 x 58 = 146 mm, rho 0.918 %, s_r 16 / (3.6 x 0.00918) = 484 mm, and 3.0 instead of 2.896 MPa
    make 335.7 MPa.
    """
    row = checks(0.0, **THICK, restraint={}, w_max=3e-4, annex=annex)["crack width by restraint"]
    assert (row.status, row.of, row.resistance) == ("fails", "bottom y", pytest.approx(0.3))
    assert row.demand == pytest.approx(w_k, rel=2e-3)
    known = follow_steps(row.steps)
    assert known["w_k"] == pytest.approx(row.demand)
    assert (known["sigma_s"], known["rho"]) == (
        pytest.approx(324.1 if annex == "recommended" else 335.7, rel=1e-3),
        pytest.approx(0.00924 if annex == "recommended" else 0.00918, rel=1e-3),
    )
    assert known["k_2"] == (1.0 if annex == "recommended" else 0.5)


def test_restraint_that_is_not_checked_is_told() -> None:
    """Without bars, without a width that is allowed, and where bars yield."""
    model = model_of().replace(reinforcement={**STEEL, "restraint": {}})
    one = synthetic.results(6, model=model, combination="ULS", limit_state="ultimate", factors=(("G", 1.35),))
    design = check_design(Results(model, model.combinations[:1], {"ULS": one}, {}))
    (row,) = [check for check in design.checks if check.name == "bars against restraint"]
    assert (row.status, row.words.partition(";")[0]) == ("attention", "not judged: no bars are laid")
    yielding = checks(0.0, **LAID, restraint={}, w_max=3e-4)["crack width by restraint"]
    assert (yielding.status, yielding.utilization) == ("attention", None)
    assert "crack width by restraint" not in checks(0.0, **THICK, restraint={})
    with pytest.raises(InputError, match="restraint"):
        model_of(code="ACI 318", restraint={})


def test_the_stress_of_bars_is_followed() -> None:
    """The calculation gives the stress of the check, which is by hand above."""
    row = checks(40e3)["stress of the bars"]
    known = follow_steps(row.steps)
    assert (known["sigma_s"], known["sigma_max"]) == (pytest.approx(stress_by_hand(40e3) / 1e6, rel=1e-3), 400)
    assert known["eta"] == pytest.approx(row.utilization)


def test_least_bars_for_cracks_are_followed() -> None:
    """The calculation gives the area of the check."""
    row = checks(20e3, w_max=3e-4)["least bars for cracks"]
    known = follow_steps(row.steps)
    assert (known["A_min"], known["eta"]) == (pytest.approx(row.demand), pytest.approx(row.utilization))


def test_distance_of_bars_for_cracks_by_aci_318() -> None:
    """At f_s = 280 MPa 380 mm - 2.5 x 52 mm = 250 mm along y, at 210 MPa the bars may be 300 mm x 280 / 210 apart."""
    aci = {"code": "ACI 318", "f_yk": 420e6}
    for spacing, status in ((0.24, "no failure found"), (0.26, "attention")):
        far = {key: {"diameter": 0.012, "spacing": spacing} for key in LAID}
        row = checks(1e3, **aci | far)["distance of bars for cracks"]
        assert (row.status, row.of, row.clause) == (status, "bottom y", "ACI 318-19 24.3.2")
        assert (row.demand, row.resistance) == (pytest.approx(spacing * 1e3), pytest.approx(250))
        assert follow_steps(row.steps)["eta"] == pytest.approx(row.utilization)
    assert aci_bars.crack_spacing(210e6, np.array([0.02]), "SI") == pytest.approx([0.4])


def test_editions_of_aci_318() -> None:
    """In inches bars may be 15 in - 2.5 x 4.564 in = 3.59 in apart at 40,000 psi, by 318M 3.78 in; cover is 2 in."""
    f_s, cover, inch = 275.79e6, np.array([4.564 * 0.0254]), 0.0254
    assert aci_bars.crack_spacing(f_s, cover, "US") == pytest.approx([3.59 * inch], rel=1e-3)
    assert aci_bars.crack_spacing(f_s, cover, "SI") == pytest.approx([3.78 * inch], rel=1e-3)
    covers = [
        aci_bars.least_cover(*bar, "US") / inch for bar in (("bottom_x", 0.02), ("bottom_y", 0.016), ("top_x", 0.02))
    ]
    assert covers == pytest.approx([2.0, 1.5, 0.75])


def test_bars_for_shrinkage_and_temperature_by_aci_318() -> None:
    """0.0018 of 300 mm are 5.4 cm2/m: both faces together, not each."""
    aci = {"code": "ACI 318", "f_yk": 420e6}
    for spacing, status in ((0.4, "no failure found"), (0.42, "fails")):
        far = {key: {"diameter": 0.012, "spacing": spacing} for key in LAID}
        row = checks(0.0, **aci | far)["bars for shrinkage and temperature"]
        assert (row.status, row.clause) == (status, "ACI 318-19 24.4.3.2")
        assert (row.demand, row.resistance) == (pytest.approx(5.4), pytest.approx(2 * np.pi * 1.2**2 / 4 / spacing))
        assert follow_steps(row.steps)["eta"] == pytest.approx(row.utilization)
