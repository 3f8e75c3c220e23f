"""Codes and annexes of a case: the rows that they yield, each by hand on one even moment and pressure."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from groundslab.design.checks import DesignCheck, check_design
from groundslab.design.rules.wide_beam import cuts, same
from groundslab.errors import InputError
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.tables.result_tables import tables_of
from helpers import synthetic
from helpers.synthetic import LENGTH_X, LENGTH_Y

AXES = {"bottom": (0.04, 0.05), "top": (0.04, 0.05)}
ACI = {"code": "ACI 318", "f_ck": 30e6, "f_yk": 420e6}
EN = {"f_ck": 30e6, "f_yk": 500e6}
BARS = {"diameter": 0.012, "spacing": 0.15}
LAID: dict[str, Any] = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), BARS)
COLUMN = {"name": "C1", "x": 0, "y": 0, "width_x": 0.3, "width_y": 0.3}
D = 0.4 - 0.045
PRESSURE = 50e3


def solved(steel: dict[str, Any], P: float = 100e3, m_x: float = 10e3, M_x: float = 0.0, **changes: Any) -> Results:
    """Return made-up results of a slab of 400 mm with a column: one moment everywhere, an even pressure of 50 kPa."""
    parts: dict[str, Any] = {
        "plate": {"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": 0.4, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 20e6},
        "columns": [COLUMN],
        "cases": [{"name": "G"}],
        "loads": [{"kind": "point", "P": P, "M_x": M_x, "column": "C1", "case": "G"}],
        "combinations": [
            {"name": "ULS", "factors": {"G": 1.2}},
            {"name": "QP", "limit_state": "quasi-permanent", "factors": {"G": 1.0}},
        ],
        "reinforcement": steel,
    }
    model = Model(**parts | changes)
    made = {}
    for each in model.combinations:
        one = synthetic.results(6, model=model, combination=each.name, limit_state=each.limit_state,
                                factors=each.factors)  # fmt: skip
        flat = np.zeros(len(one.plate.nodes))
        fields = {"moment_x": flat + m_x, "moment_y": flat, "moment_xy": flat, "pressure": flat + PRESSURE}
        made[each.name] = replace(one, plate=replace(one.plate, **fields))
    return Results(model, model.combinations, made, {})


def rows(*args: Any, **changes: Any) -> dict[str, DesignCheck]:
    """Return the checks by name, see ``solved``."""
    return {each.name: each for each in check_design(solved(*args, **changes)).checks}


def aci_stress(P: float, M: float = 0.0) -> float:
    """Return v_u of the column inside by hand: b_o = 4 (0.3 + d), gamma_v = 0.4."""
    b = 0.3 + D
    J = D * (b**3 / 6 + b**3 / 2) + b * D**3 / 6
    return (1.2 * P - PRESSURE * b**2) / (4 * b * D) + 0.4 * 1.2 * abs(M) * b / 2 / J


def test_two_way_shear_of_aci_318() -> None:
    """Phi 0.33 lambda_s (f'c)^(1/2) resists, stirrups phi 0.5 (f'c)^(1/2) at most; a moment adds gamma_v M c / J."""
    v_c = 0.75 * 0.33 * math.sqrt(2 / (1 + 4 * D)) * math.sqrt(30)
    for P, M, status in ((0.8e6, 0.0, "no failure found"), (0.8e6, 0.3e6, "fails"), (1.7e6, 0.0, "fails")):
        found = rows({**ACI, **AXES}, P, M_x=M)["two-way shear"]
        assert found.status == status, found.words
        assert found.demand == pytest.approx(aci_stress(P, M) / 1e6, rel=1e-3)
        assert found.resistance == pytest.approx(v_c)
        assert (found.of, found.combination, found.place) == ("C1", "ULS", (0, 0))
        assert found.clause == "ACI 318-19 22.6.5.2, 8.4.4.2"
    neglected = rows({**ACI, **AXES, "size_effect": False})["two-way shear"]
    assert neglected.resistance == pytest.approx(0.75 * 0.33 * math.sqrt(30))


def test_column_table_of_aci_318() -> None:
    """The table has what the check has, and nothing by EN 1992-1-1."""
    of = solved({**ACI, **AXES}, 0.8e6)
    table = {each.name: each for each in tables_of(of)}["columns"]
    names = [column.name for column in table.columns]
    assert "beta" not in names
    assert table["b_o"][0] == pytest.approx(4 * (0.3 + D))
    assert table["v_u"][0] == pytest.approx(aci_stress(0.8e6) / 1e6, rel=1e-3)


def test_bars_of_aci_318() -> None:
    """0.0018 x 400 mm = 7.2 cm2/m are the least; 7.54 are laid; 2 h and 450 mm apart at most, no crack width."""
    found = rows({**ACI, **AXES, **LAID})
    check = found["bars at the bottom x"]
    assert (check.demand, check.status) == (pytest.approx(7.2), "no failure found")
    assert check.clause == "ACI 318-19 22.3, 8.6.1.1"
    assert (found["distance of bars"].resistance, found["distance of bars"].clause) == (450, "ACI 318-19 8.7.2.2")
    assert not [name for name in found if "crack width" in name or "2 d" in name]
    assert not [each.words for each in found.values() if "EN 1992" in each.clause]


def test_one_way_shear_of_aci_318() -> None:
    """Phi v_c is that of the bars provided, 7.54 cm2/m, in the direction of the force."""
    found = rows({**ACI, **AXES, **LAID})["one-way shear"]
    rho = math.pi * 0.012**2 / 4 / 0.15 / D
    lambda_s = math.sqrt(2 / (1 + 4 * D))
    # rho_x cos^4 + rho_y sin^4 of equal nets lies between a half and the whole of one
    bounds = [0.75 * 0.66 * lambda_s * (share * rho) ** (1 / 3) * math.sqrt(30) * D * 1e3 for share in (0.5, 1)]
    assert found.resistance is not None
    assert bounds[0] * 0.999 <= found.resistance <= bounds[1] * 1.001
    assert found.clause == "ACI 318-19 22.5.5.1"


def test_cuts_beside_columns_are_means_over_a_share() -> None:
    """At d from both faces along x and y; between two columns to the middle. Means of linear fields are exact."""
    columns = [COLUMN, {"name": "C2", "x": 0.2, "y": 1.0, "diameter": 0.4}]
    of = solved({**ACI, **AXES}, columns=columns).results["ULS"]
    steel = of.model.reinforcement
    assert steel is not None
    found = [cut for cut in cuts(of, steel) if abs(cut.normal[0]) == 1]
    x, y = of.plate.nodes.T
    assert len(found) == 4
    places = [(-0.15 - D, 0), (0.15 + D, 0), (0.2 - 0.2 - D, 1), (0.2 + 0.2 + D, 1)]
    # from the plate's edge to the middle between the columns at y = 0.5
    shares = [(-LENGTH_Y / 2, 0.5)] * 2 + [(0.5, LENGTH_Y / 2)] * 2
    for cut, (at, _), (low, high) in zip(found, places, shares, strict=True):
        assert cut.place == pytest.approx((at, (low + high) / 2))
        assert cut.mean(3 + 2 * x - y) == pytest.approx(3 + 2 * at - (low + high) / 2)
    bent = replace(of.plate, shear_x=-1e5 * x, moment_x=np.ones_like(x))
    assert found[1].shear(of, bent) == pytest.approx(1e5 * places[1][0])
    assert [found[1].face(replace(bent, moment_x=m * np.ones_like(x))) for m in (1, -1)] == ["bottom", "top"]
    assert same(np.full_like(x, 0.3)) == 0.3
    assert same(0.3 + 1e-6 * y) is None


def test_combinations_of_another_code_need_attention() -> None:
    """Combinations that EN 1990 makes are not those of ACI 318, and the design says so; those of the file are."""
    made = [{"name": "ULS", "factors": {"G": 1.35}, "rule": "EN 1990 6.10"}]
    assert rows({**ACI, **AXES}, combinations=made)["load combinations"].status == "attention"
    assert "load combinations" not in rows({**ACI, **AXES})


def test_keys_of_the_other_code_are_refused() -> None:
    """Classes, annexes and partial factors are those of EN 1992-1-1, the size effect is that of ACI 318."""
    for wrong in ({"annex": "Germany"}, {"gamma_c": 1.4}, {"exposure": "XC2"}, {"w_max": 3e-4, **LAID}):
        with pytest.raises(InputError, match="with ACI 318"):
            Reinforcement(**ACI, **AXES, **wrong)
    with pytest.raises(InputError, match="f_ck is the specified strength"):
        Reinforcement(code="ACI 318", concrete="C30/37", f_yk=420e6, **AXES)
    with pytest.raises(InputError, match="with EN 1992-1-1"):
        Reinforcement(size_effect=False, **EN, **AXES)
    with pytest.raises(InputError, match="17 MPa"):
        rows({**ACI, "f_ck": 15e6, **AXES})


def test_germany_limits_punching_by_what_needs_no_links() -> None:
    """No check at the face; 1.4 v_Rd,c 2 d / a on every perimeter fails, and nothing less; beta is 1.10."""
    rho = min(0.02, 0.5 * 17 / (500 / 1.15))
    v_Rd_c = 0.10 * (1 + math.sqrt(0.2 / D)) * (100 * rho * 30) ** (1 / 3) * 1e6
    used = []
    for ratio in (0.5, 1.0, 1.5, 2.0):
        a = ratio * D
        u, area = 1.2 + 2 * math.pi * a, 0.09 + 1.2 * a + math.pi * a**2
        used.append((1.2, PRESSURE * area, u * D * v_Rd_c * 2 / ratio))
    # of no bars v_Rd,c is 0.0525 / gamma_C k^(3/2) f_ck^(1/2)
    least = 0.0525 / 1.5 * (1 + math.sqrt(0.2 / D)) ** 1.5 * math.sqrt(30) * 1e6 / v_Rd_c
    shares = {0.99 * least: "no failure found", 1.01 * least: "attention", 0.99: "attention", 1.01: "fails",
              1.39: "fails", 1.41: "fails"}  # fmt: skip
    for share, status in shares.items():
        P = min((share * strength / 1.1 + ground) / factor for factor, ground, strength in used)
        found = rows({**EN, **AXES, "annex": "Germany"}, P)
        assert "punching at the column's face" not in found
        assert found["punching within 2 d"].status == status, found["punching within 2 d"].words
    assert "1.4 v_Rd,c" in found["punching within 2 d"].words


def test_annexes_known_in_part_need_attention() -> None:
    """What is known of the French annex is named by its clauses; those looked through, and EN itself, need none."""
    found = rows({**EN, **AXES, "annex": "France"})["national parameters"]
    assert found.status == "attention"
    assert "NF EN 1992-1-1/NA:2007-03" in found.words
    assert "6.2.2(1), 7.3.4(3)" in found.words
    for annex in ("recommended", "Germany", "United Kingdom"):
        assert "national parameters" not in rows({**EN, **AXES, "annex": annex})


def test_distance_of_bars_by_annex() -> None:
    """A slab of 400 mm: 400 mm by EN 1992-1-1, 250 mm in Germany."""
    for annex, most in (("recommended", 400), ("United Kingdom", 400), ("Germany", 250)):
        assert rows({**EN, **AXES, **LAID, "annex": annex})["distance of bars"].resistance == most


def test_distance_of_bars_where_bent_most() -> None:
    """2 h and 250 mm at the largest moment and under columns (9.3.1.1(3)), in Germany 250 mm everywhere."""
    far = {key: {"diameter": 0.012, "spacing": 0.3} for key in LAID}
    for annex in ("recommended", "United Kingdom", "Germany"):
        row = rows({**EN, **AXES, **far, "annex": annex})["distance of bars where bent most"]
        assert (row.status, row.demand, row.resistance) == ("attention", pytest.approx(300), pytest.approx(250))
        assert rows({**EN, **AXES, **LAID, "annex": annex})["distance of bars where bent most"].utilization == 0.6
    # only the bottom along x is bent by m_x > 0, the bottom along y counts under the column alone
    bars = {**LAID, "bottom_y": {"diameter": 0.012, "spacing": 0.3}}
    row = rows({**EN, **AXES, **bars})["distance of bars where bent most"]
    assert (row.status, row.of) == ("attention", "bottom y")
    assert "under C1" in row.words
    bars = {**LAID, "top_y": {"diameter": 0.012, "spacing": 0.3}}
    assert rows({**EN, **AXES, **bars})["distance of bars where bent most"].status == "no failure found"


@pytest.mark.parametrize(
    ("code", "aggregate", "least"),
    [(EN, None, 20), (EN, 0.032, 37), (EN, 0.016, 21), (ACI, None, 25), (ACI, 0.03, 40)],
)
def test_clear_distance_of_bars(code: dict[str, Any], aggregate: float | None, least: float) -> None:
    """The bar, 20 mm or d_g + 5 mm (EN 1992-1-1 8.2(2)); 25 mm or 4 / 3 d_agg (ACI 318-19 25.2.1)."""
    size = {} if aggregate is None else {"aggregate": aggregate}
    for more, status in ((-0.5e-3, "fails"), (0.5e-3, "no failure found")):
        bars = LAID | {"top_x": {"diameter": 0.016, "spacing": 0.016 + least / 1e3 + more}}
        row = rows({**code, **AXES, **bars, **size})["clear distance of bars"]
        assert (row.status, row.of) == (status, "top x")
        assert (row.demand, row.resistance) == (pytest.approx(least + more * 1e3), pytest.approx(least))
    thick = LAID | {"top_x": {"diameter": 0.05, "spacing": 0.099}}
    assert rows({**code, **AXES, **thick, "top": (0.07, 0.08)})["clear distance of bars"].resistance == 50


def test_clear_distance_of_bars_in_zones() -> None:
    """Of 12 mm and 16 mm at 150 mm each there is a bar every 75 mm: 59 mm between the thick ones."""
    shape = {"kind": "rectangle", "x": (-1, 1), "y": (-1, 1)}
    zone = {"name": "Z", "shape": shape, "layers": ("top_x",), "diameter": 0.016, "spacing": 0.15}
    row = rows({**EN, **AXES, **LAID, "zones": [zone]})["clear distance of bars"]
    assert (row.demand, row.of) == (pytest.approx(59), "top x")


def test_links_name_the_outer_perimeter() -> None:
    """Of 1.2 v_Rd,c at 2 d: u_out = 1.2 u, and 0.2 u / (2 pi) farther out than 2 d (6.54)."""
    v_Rd_c = 0.12 * (1 + math.sqrt(0.2 / D)) * 60 ** (1 / 3) * 1e6
    u, area = 1.2 + 4 * math.pi * D, 0.09 + 1.2 * 2 * D + math.pi * (2 * D) ** 2
    P = (1.2 * v_Rd_c * u * D + PRESSURE * area) / 1.2
    words = rows({**EN, **AXES}, P)["punching within 2 d"].words
    assert f"u_out {1.2 * u:.2f} m long, {2 * D + 0.2 * u / (2 * math.pi):.2f} m from the column" in words


def test_axes_by_cover_and_bars() -> None:
    """40 mm of cover: axes of 12 mm bars at 46 and 58 mm, the outer ones along x, or along y if wanted."""
    of = Reinforcement(**EN, **LAID, cover=(0.04, 0.03))
    assert of.bottom_axes == pytest.approx((0.046, 0.058))
    assert of.top_axes == pytest.approx((0.036, 0.048))
    assert Reinforcement(**EN, **LAID, cover=(0.04, 0.03), outer="y").bottom_axes == pytest.approx((0.058, 0.046))
    assert Reinforcement(**EN, **LAID, cover=(0.04, 0.03), bottom=(0.1, 0.1)).bottom_axes == (0.1, 0.1)
    for wrong in ({"cover": (0.04, 0.03)}, LAID):
        with pytest.raises(InputError, match="distances of the bars' axes"):
            Reinforcement(**EN, **wrong)


def test_cover_by_exposure() -> None:
    """XC2 asks for 25 + 10 mm, in Germany for 20 + 15 mm; in Britain BS 8500 rules it. Thick bars ask for more."""
    for cover, status in ((0.0351, "no failure found"), (0.0349, "fails")):
        for annex in ("recommended", "Germany"):
            steel = {**EN, **LAID, "annex": annex, "exposure": "XC2", "cover": (0.06, cover)}
            found = rows(steel)["cover"]
            assert (found.status, found.resistance, found.of) == (status, pytest.approx(35), "top x")
    steel = {**EN, **LAID, "exposure": "XC2", "cover": (0.06, 0.03)}
    assert rows({**steel, "annex": "United Kingdom"})["cover"].status == "attention"
    thick = {key: {"diameter": 0.032, "spacing": 0.15} for key in LAID}
    assert rows({**EN, **thick, "exposure": "XC2", "cover": (0.04, 0.04)})["cover"].resistance == pytest.approx(42)


def test_crack_width_by_exposure() -> None:
    """XC1 allows 0.4 mm, in Britain 0.3 mm; w_max of the case comes first; without any nothing is checked."""
    name, steel = "crack width at the bottom x", {**EN, **LAID, **AXES}
    assert name not in rows(steel)
    for more, most in (
        ({"exposure": "XC1"}, 0.4),
        ({"exposure": "XC1", "annex": "United Kingdom"}, 0.3),
        ({"exposure": "XC1", "w_max": 2e-4}, 0.2),
        ({"exposure": "XD3"}, 0.3),
    ):
        assert rows({**steel, **more})[name].resistance == pytest.approx(most)
