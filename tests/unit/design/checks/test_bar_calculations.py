"""Calculations of laid bars followed by hand: distances, covers, stresses, yielding, by each code."""

from __future__ import annotations

from typing import Any

import pytest

from groundslab.design.checks import DesignCheck
from helpers.calculations import follow_steps
from helpers.laid_slab import LAID, checks, stress_by_hand

ACI: dict[str, Any] = {"code": "ACI 318", "f_yk": 420e6}
SECOND: dict[str, Any] = {"code": "EN 1992-1-1:2023"}


def followed(check: DesignCheck) -> dict[str, float]:
    """Return the values of a check's steps by their symbols; the share is that of the check."""
    known = follow_steps(check.steps)
    assert known["eta"] == pytest.approx(check.utilization)
    return known


@pytest.mark.parametrize(("code", "most"), [({}, 400.0), ({"annex": "Germany"}, 250.0), (SECOND, 400.0), (ACI, 450.0)])
def test_distance_of_bars(code: dict[str, Any], most: float) -> None:
    """150 mm of 3 h and 400 mm, in Germany of h from 150 mm to 250 mm, of 2 h and 450 mm by ACI 318; h = 300 mm."""
    known = followed(checks(1e3, **code)["distance of bars"])
    assert (known["h"], known["s"], known["s_max"]) == pytest.approx((300, 150, most))


def test_distance_of_bars_where_bent_most() -> None:
    """Of 2 h and 250 mm (9.3.1.1(3))."""
    known = followed(checks(1e3)["distance of bars where bent most"])
    assert (known["s"], known["s_max"]) == pytest.approx((150, 250))


@pytest.mark.parametrize(
    ("code", "aggregate", "least"), [({}, None, 20), ({}, 0.032, 37), (ACI, None, 25), (ACI, 0.03, 40)]
)
def test_clear_distance_of_bars(code: dict[str, Any], aggregate: float | None, least: float) -> None:
    """Of 12 mm every 150 mm 138 mm are clear; 20 mm or d_g + 5 mm must be, 25 mm or 4 / 3 d_agg by ACI 318."""
    size = {} if aggregate is None else {"aggregate": aggregate}
    known = followed(checks(1e3, **code, **size)["clear distance of bars"])
    assert (known["s"], known["s_c"], known["s_min"]) == pytest.approx((150, 138, least))


def test_cover_by_exposure() -> None:
    """Axes at 46 mm of 12 mm bars: 40 mm; XC2 asks for 25 + 10 mm, in Germany 20 + 15 mm, bond for 12 + 10 mm."""
    for annex, durable, deviation in (("recommended", 25, 10), ("Germany", 20, 15)):
        known = followed(checks(1e3, exposure="XC2", annex=annex)["cover"])
        assert (known["a"], known["c"], known["c_nom"]) == pytest.approx((46, 40, 35))
        assert (known["c_min,dur"], known["Delta_c,dev"]) == pytest.approx((durable, deviation))
    known = followed(checks(1e3)["cover"])
    assert (known["c_min,b"], known["c_min"], known["c_nom"]) == pytest.approx((12, 12, 22))
    assert "c_min,dur" not in known
    assert followed(checks(1e3, **SECOND)["cover"])["c_nom"] == pytest.approx(22)


@pytest.mark.parametrize(
    ("bottom", "cover", "least"), [((0.081, 0.093), 40, 19), ((0.06, 0.072), 54, 75), ((0.04, 0.052), 34, 38)]
)
def test_cover_by_aci_318(bottom: tuple[float, float], cover: float, least: float) -> None:
    """At the bottom 38 mm on blinding, 75 mm against the ground; with these 19 mm at the top are nearest."""
    known = followed(checks(1e3, **ACI, bottom=bottom)["cover"])
    assert (known["c"], known["c_nom"]) == pytest.approx((cover, least))


@pytest.mark.parametrize("code", [{}, SECOND])
def test_stress_of_bars(code: dict[str, Any]) -> None:
    """Of 40 kNm/m over 0.8 f_yk, of 117 kNm/m over f_yk: the bars yield, in place of the width of cracks, too."""
    known = followed(checks(40e3, **code)["stress of the bars"])
    assert known["sigma_max"] == pytest.approx(400)
    if not code:  # the moduli of concrete differ
        assert known["sigma_s"] == pytest.approx(stress_by_hand(40e3) / 1e6, rel=1e-3)
    found = checks(117e3, w_max=4e-4, **code)
    for name in ("stress of the bars", "crack width at the bottom x"):
        known = followed(found[name])
        assert found[name].status == "fails"
        assert (known["sigma_max"], known["sigma_s"]) == pytest.approx((500, found[name].demand))


@pytest.mark.parametrize("code", [{}, SECOND])
def test_width_of_cracks(code: dict[str, Any]) -> None:
    """The width over the one that is allowed; where there is no moment there is no crack."""
    found = checks(60e3, w_max=4e-4, **code)
    known = followed(found["crack width at the bottom x"])
    assert known["w_max"] == pytest.approx(0.4)
    assert followed(found["crack width at the top x"])["eta"] == 0


def test_least_bars_for_cracks_of_the_second_generation() -> None:
    """0.2 k_h f_ctm h / f_yk with k_h = 0.8 of 300 mm and f_ctm = 0.3 x 30^(2/3) = 2.8965 MPa: 2.78 cm2/m."""
    known = followed(checks(20e3, w_max=3e-4, **SECOND)["least bars for cracks"])
    assert (known["k_h"], known["A_min"]) == pytest.approx((0.8, 0.2 * 0.8 * 2.8965 * 0.3 / 500 * 1e4), rel=1e-4)
    assert known["A_s"] == pytest.approx(7.54, rel=1e-3)
    assert set(LAID) == {"bottom_x", "bottom_y", "top_x", "top_y"}
