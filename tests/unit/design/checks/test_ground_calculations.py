"""Calculations of what holds the slab: the ground, its weight against uplift, piles that punch it; by hand."""

from __future__ import annotations

import math
from typing import Any

import pytest
from shapely import Point, box

import groundslab as gs
from groundslab.design.checks import DesignCheck, check_design
from groundslab.design.codes.en1997.bearing import eccentricity, sliding_resistance
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.tables.result_tables import table_makers
from helpers.calculations import follow, follow_steps

DRAINED = {"phi": 32.0, "c": 5e3, "unit_weight": 18e3, "overburden": 9e3, "gamma_phi": 1.25, "gamma_c": 1.25}
UNDRAINED = {"c_u": 60e3, "unit_weight": 18e3, "overburden": 9e3, "gamma_cu": 1.4}


def pad(strength: dict[str, Any], H_x: float = 60e3, M_x: float = 120e3) -> Results:
    """Return a pad of 3 m x 2 m under 600 kN, 1.5 M_x and 1.5 H_x."""
    return gs.solve(
        Model(
            plate={"length_x": 3, "length_y": 2, "thickness": 0.5, "E": 33e9, "nu": 0.2},
            ground={"kind": "winkler", "k": 50e6},
            cases=[{"name": "G"}, {"name": "wind", "action": "variable", "H_x": H_x}],
            loads=[
                {"kind": "point", "P": 600e3, "x": 0, "y": 0, "width_x": 0.4, "width_y": 0.4, "case": "G"},
                {"kind": "point", "P": 0, "M_x": M_x, "x": 0, "y": 0, "width_x": 0.4, "width_y": 0.4, "case": "wind"},
            ],
            combinations=[{"name": "ULS", "factors": {"G": 1.0, "wind": 1.5}}],
            soil_strength=strength,
            mesh={"size": 0.5},
        )
    )


def by_name(combined: Results) -> dict[str, DesignCheck]:
    """Return the checks by their names."""
    return {check.name: check for check in check_design(combined).checks}


@pytest.mark.parametrize("strength", [DRAINED, UNDRAINED])
@pytest.mark.parametrize("H_x", [60e3, 0.0])
def test_bearing_and_sliding_are_followed(strength: dict[str, Any], H_x: float) -> None:
    """Every value from those above it; the shares are those of the checks, in the table without reinforcement, too."""
    combined = pad(strength, H_x)
    checks = by_name(combined)
    assert ("sliding" in checks) == (H_x > 0)
    for check in checks.values():
        if check.name in ("bearing resistance", "sliding"):
            known = follow_steps(check.steps)
            assert known["eta"] == pytest.approx(check.utilization)
            assert known["R_d"] == pytest.approx(check.resistance / 1e3)
    table = table_makers(combined)["calculations"]()
    assert {"bearing resistance"} <= set(table["check"])
    assert follow(table) > 5


def test_the_bearing_resistance_of_a_drained_soil_by_hand() -> None:
    """On 2.4 m x 2 m: tan phi_d = tan 32 / 1.25, N_q 13.2, N_c 24.4, N_gamma 12.2; under 600 kN and 90 kN."""
    known = follow_steps(by_name(pad(DRAINED))["bearing resistance"].steps)
    assert (known["A'"], known["B'"], known["L'"]) == pytest.approx((4.8, 2.0, 2.4))
    tan = math.tan(math.radians(32)) / 1.25
    N_q = math.exp(math.pi * tan) * (tan + math.sqrt(1 + tan**2)) ** 2  # tan(45 + phi / 2) = tan phi + 1 / cos phi
    assert (known["N_q"], known["N_c"], known["N_gamma"]) == pytest.approx((N_q, (N_q - 1) / tan, 2 * (N_q - 1) * tan))
    assert known["c"] == pytest.approx(0.004)
    exponent = (2 + 2 / 2.4) / (1 + 2 / 2.4)
    inclined = 1 - 0.09 / (0.6 + 4.8 * 0.004 / tan)
    assert (known["i_q"], known["i_gamma"]) == pytest.approx((inclined**exponent, inclined ** (exponent + 1)))


def test_an_undrained_soil_slides_at_most_at_0_4_v() -> None:
    """A' c_u / gamma_R;h = 4.8 x 42.86 / 1.1 = 187 kN is below 0.4 x 600 kN; of a stiffer clay the latter counts."""
    assert by_name(pad(UNDRAINED))["sliding"].resistance == pytest.approx(4.8 * 60 / 1.4 / 1.1)
    stiff = by_name(pad(UNDRAINED | {"c_u": 150e3}))["sliding"]
    assert stiff.resistance == pytest.approx(0.4 * 600)
    assert follow_steps(stiff.steps)["R_d"] == pytest.approx(0.24)
    assert sliding_resistance(gs_area(), 100e3, 0.0, 1e6, 1.1) == pytest.approx(400e3)


@pytest.mark.parametrize(
    ("base", "at", "share"),
    [
        (box(-1.5, -1, 1.5, 1), (0.3, 0.0), 0.3 / 1.0),  # 1/3 of 3 m
        (box(-1.5, -1, 1.5, 1), (0.5, -0.6), 0.6 / (2 / 3)),  # 1/3 of 2 m before 1/3 of 3 m
        (box(-1.5, -1, 1.5, 1), (0.0, 0.0), 0.0),
        (Point(1, 2).buffer(3.0, quad_segs=90), (1 + 0.9, 2 + 1.2), 1.5 / 1.8),  # 0.6 R
        (box(0, 0, 4, 4).difference(box(1, 1, 3, 3)), (3.2, 2.0), 1.2 / 1.2),  # no rectangle: 0.6
    ],
)
def test_eccentricity_over_what_may_be(base: Any, at: tuple[float, float], share: float) -> None:
    """A third of a rectangle's width, 0.6 of a circle's radius (EN 1997-1 6.5.4), the latter of other bases, too."""
    e, edge, most = eccentricity(base, *at)
    assert e / (edge * most) == pytest.approx(share, rel=1e-3)


def test_a_pad_with_a_large_eccentricity() -> None:
    """180 kNm of 600 kN, 0.3 m of 1 m; of a third of the weight 0.9 m of 1 m, and more needs attention."""
    check = by_name(pad(DRAINED))["eccentricity on the ground"]
    assert (check.status, check.demand, check.resistance) == ("no failure found", pytest.approx(0.3), pytest.approx(1))
    assert follow_steps(check.steps)["eta"] == pytest.approx(check.utilization)
    check = by_name(pad(DRAINED, M_x=440e3))["eccentricity on the ground"]
    assert (check.status, check.demand) == ("attention", pytest.approx(1.1))


def gs_area() -> Any:
    """Return a large effective area."""
    from groundslab.design.codes.en1997.bearing import EffectiveArea

    return EffectiveArea(100.0, 10.0, 10.0)


@pytest.mark.parametrize("q", [6e3, 7e3])
def test_uplift_is_followed(q: float) -> None:
    """Of 24 m2 of 7.5 kPa 0.9, against 6 and 7 kPa of water: 144 and 168 kN over 162 kN."""
    combined = gs.solve(
        Model(
            plate={"length_x": 6, "length_y": 4, "thickness": 0.3, "E": 30e9, "nu": 0.2},
            ground={"kind": "winkler", "k": 20e6},
            cases=[{"name": "G"}, {"name": "water"}],
            loads=[
                {"kind": "self weight", "unit_weight": 25e3, "case": "G"},
                {"kind": "uniform", "q": -q, "case": "water"},
            ],
            combine={"sets": ["uplift", "quasi-permanent"]},
            mesh={"counts": (6, 4)},
        )
    )
    check = by_name(combined)["uplift by actions"]
    known = follow_steps(check.steps)
    assert (known["V_dst"], known["G_stb"]) == pytest.approx((24e-6 * q, 0.162))
    assert (known["gamma_1"], known["G_1"], known["eta"]) == pytest.approx((0.9, 0.18, 24e-6 * q / 0.162))
    assert check.utilization == pytest.approx(known["eta"])


def raft(code: str, **changes: Any) -> Results:
    """Return a raft of 6 m x 6 m on a pile in its middle, a point support, and soft springs."""
    parts: dict[str, Any] = {
        "plate": {"length_x": 6.0, "length_y": 6.0, "thickness": 0.4, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 5e6},
        "supports": [{"kind": "point", "name": "P", "x": 0.0, "y": 0.0, "stiffness": 100e6, "diameter": 0.5}],
        "cases": [{"name": "G"}],
        "loads": [{"kind": "uniform", "q": 30e3, "case": "G"}],
        "combinations": [{"name": "low", "factors": {"G": 1.0}}, {"name": "high", "factors": {"G": 1.35}}],
        "reinforcement": {"code": code, "f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)},
        "mesh": {"size": 0.25},
    }
    return gs.solve(Model(**parts | changes))


@pytest.mark.parametrize("code", ["EN 1992-1-1", "ACI 318"])
def test_punching_over_a_pile_is_followed(code: str) -> None:
    """Its force and the pressure inside push up, the load inside relieves; the share is that of the check."""
    combined = raft(code)
    table = table_makers(combined)["calculations"]()
    assert follow(table) > 10
    rows = [row for row in table.rows() if row[0] == "punching over piles"]
    assert {(row[1], row[2]) for row in rows} == {("P", "high")}
    known = {str(row[4]): row for row in rows}
    force, punching = ("N_Ed", "V_Ed") if code == "EN 1992-1-1" else ("N_u", "V_u")
    assert known[force][7] == pytest.approx(combined["high"].supports[0].total / 1e6)
    assert known[punching][5] == f"{force} - N_o + N_p"
    assert known["d"][7] == pytest.approx(0.355)
    name = "punching over piles within 2 d" if code == "EN 1992-1-1" else "two-way shear over piles"
    assert known["eta"][7] == pytest.approx(by_name(combined)[name].utilization)
