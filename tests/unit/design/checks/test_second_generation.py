"""Checks by EN 1992-1-1:2023: the rows that a case yields, each by hand on one even moment and pressure."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from groundslab.design.checks import DesignCheck, check_design
from groundslab.design.codes.en1992_2023.checks.punching_demand import column_demands
from groundslab.model.model import Model
from groundslab.results.results import Results
from groundslab.views.tables.result_tables import table_makers
from helpers import synthetic
from helpers.synthetic import LENGTH_X, LENGTH_Y

STEEL: dict[str, Any] = {
    "code": "EN 1992-1-1:2023", "f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05),
}  # fmt: skip
BARS = {"diameter": 0.012, "spacing": 0.15}
LAID: dict[str, Any] = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), BARS)
C, H = 0.3, 0.4
D = H - 0.045
COLUMN = {"name": "C1", "x": 0, "y": 0, "width_x": C, "width_y": C}
PRESSURE = 50e3
ULTIMATE = {"name": "ULS", "factors": {"G": 1.2}}
LASTING = {"name": "QP", "limit_state": "quasi-permanent", "factors": {"G": 1.0}}


def solved(steel: dict[str, Any], P: float = 100e3, m: float = 10e3, M_x: float = 0.0, **changes: Any) -> Results:
    """Return made-up results of a slab of 400 mm with a column: m_x everywhere the same, an even pressure of 50 kPa."""
    parts: dict[str, Any] = {
        "plate": {"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": H, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 20e6},
        "columns": [COLUMN],
        "cases": [{"name": "G"}],
        "loads": [{"kind": "point", "P": P, "M_x": M_x, "column": "C1", "case": "G"}],
        "combinations": [ULTIMATE, LASTING],
        "reinforcement": STEEL | steel,
    }
    model = Model(**parts | changes)
    made = {}
    for each in model.combinations:
        one = synthetic.results(12, model=model, combination=each.name, limit_state=each.limit_state,
                                factors=each.factors)  # fmt: skip
        flat = np.zeros(len(one.plate.nodes))
        fields = {"moment_x": flat + m, "moment_y": flat, "moment_xy": flat, "pressure": flat + PRESSURE}
        made[each.name] = replace(one, plate=replace(one.plate, **fields))
    return Results(model, model.combinations, made, {})


def rows(*args: Any, **changes: Any) -> dict[str, DesignCheck]:
    """Return the checks by name, see ``solved``."""
    return {each.name: each for each in check_design(solved(*args, **changes)).checks}


def area(distance: float) -> float:
    """Return what lies within a distance from the column's faces [m2]."""
    return C**2 + 4 * C * distance + math.pi * distance**2


B_05 = 4 * C + math.pi * D
K_PB = 3.6 * math.sqrt(1 - 4 * C / B_05)


def resistance(rho: float, gamma_v: float = 1.4) -> float:
    """Return tau_Rd,c [MPa], its depth not reduced."""
    return min(0.6 / gamma_v * K_PB * (100 * rho * 30 * 32 / (1e3 * D)) ** (1 / 3), 0.5 / gamma_v * math.sqrt(30))


def stress(P: float, M: float = 0.0, reach: float = 0.67) -> float:
    """Return tau_Ed [MPa] of the column, with the pressure up to a distance in d_v that relieves."""
    beta = max(1.05, 1 + 1.1 * M / P / (C + D))
    return beta * (1.2 * P - PRESSURE * area(reach * D)) / (B_05 * D) / 1e6


@pytest.mark.parametrize(
    ("P", "M", "status"),
    [(0.3e6, 0.0, "no failure found"), (0.9e6, 0.0, "bars"), (0.9e6, 0.3e6, "links"), (1.6e6, 0.0, "links"),
     (2.3e6, 0.0, "fails")],
)  # fmt: skip
def test_punching(P: float, M: float, status: str) -> None:
    """tau_Ed, with the eccentricity by Table 8.3, over tau_Rd,c of bars of 2 %; links bear eta_sys tau_Rd,c at most."""
    found = rows({}, P, M_x=M)["punching"]
    assert found.status == {"bars": "attention", "links": "fails"}.get(status, status), found.words
    needs = f"needs bars in tension of {2 * (stress(P, M) / resistance(0.02)) ** 3:.2g} % of the section"
    assert (needs in found.words) == (status == "bars")
    assert found.demand == pytest.approx(stress(P, M), rel=1e-3)
    assert found.resistance == pytest.approx(resistance(0.02), rel=1e-4)
    assert (found.of, found.combination, found.place) == ("C1", "ULS", (0, 0))
    most = (0.5 + 0.63 * (4 * C / D) ** 0.25) * resistance(0.02)
    assert (stress(P, M, 0.5) > most) == (status == "fails")
    if status == "links":
        tau, tau_Rd_c = stress(P, M, 0.5), resistance(0.02)
        phi = 10 * math.sqrt(D / 0.2)
        eta_c = tau_Rd_c / tau
        eta_s = min(0.8, 1e3 * D / 150 / phi + math.sqrt(15 * 32 / (1e3 * D)) / (eta_c * K_PB) ** 1.5)
        links = (tau - eta_c * tau_Rd_c) / eta_s / (500 / 1.15) * 1e4
        assert f"links of {links:.3g} cm2/m2" in found.words
        out = B_05 * (D / (D - 0.045) / eta_c) ** 2
        assert f"b_0.5,out {out:.2f} m" in found.words


def test_bars_provided_count_and_thin_slabs_have_no_links() -> None:
    """With 0.21 % of bars the least stress 8.20 counts instead; below 200 mm no links help."""
    rho = math.pi * 0.012**2 / 4 / 0.15 / D
    least = 11 / 1.4 * math.sqrt(30 / (500 / 1.15) * 32 / (1e3 * D))
    found = rows(LAID, 0.9e6)["punching"]
    assert found.resistance == pytest.approx(max(resistance(rho), least), rel=1e-4)
    assert "with the bars provided" in found.words
    plate = {"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": 0.19, "E": 30e9, "nu": 0.2}
    thin = rows({"bottom": (0.03, 0.03), "top": (0.03, 0.03)}, 0.5e6, plate=plate)
    assert thin["punching"].status == "fails"
    assert "too thin for links (12.4.2(2))" in thin["punching"].words


def test_what_needs_attention_stands_before_what_uses_more() -> None:
    """A column whose links hold at distances that are not known, beside one with hardly enough without any."""
    links = {"of": "C1", "diameter": 0.016, "distances": (0.15, 0.4, 0.65), "legs": (32,)}
    thick = {key: {"diameter": 0.02, "spacing": 0.1} for key in LAID}
    forces = [
        {"kind": "point", "P": P, "column": name, "case": "G"} for name, P in (("C1", 1.05e6), ("C2", 0.9e6))
    ]  # fmt: skip
    columns = [COLUMN | {"x": -2.0}, COLUMN | {"name": "C2", "x": 2.0}]
    found = {
        name: rows(thick | given, loads=of, columns=columns)["punching"]
        for name, given, of in (
            ("C1", {"links": [links]}, forces[:1]), ("C2", {}, forces[1:]), ("both", {"links": [links]}, forces)
        )
    }  # fmt: skip
    assert (found["C1"].status, found["C2"].status) == ("attention", "no failure found")
    assert (found["C1"].utilization or 0.0) < (found["C2"].utilization or 0.0)
    assert (found["both"].status, found["both"].of) == ("attention", "C1")


def test_partial_factors() -> None:
    """gamma_V of the case in ultimate combinations, that of Table 4.3 in accidental ones."""
    assert rows({"gamma_v": 1.2}, 0.5e6)["punching"].resistance == pytest.approx(resistance(0.02, 1.2), rel=1e-4)
    rare = {"name": "A", "limit_state": "accidental", "factors": {"G": 1.3}}
    both = column_demands(solved({"gamma_v": 1.2}, 0.5e6, combinations=[ULTIMATE, rare])).found
    assert both["A", "C1"].tau_Rd_c / 1e6 == pytest.approx(resistance(0.02, 1.15), rel=1e-4)


def test_contraflexure_near_the_column_helps() -> None:
    """Moments that are zero 1 m away along x and 0.64 m along y: a_p 0.8 m, a_pd (0.8 d / 8)^(1/2)."""
    combined = solved(LAID, 0.9e6)
    one = combined.results["ULS"]
    x, y = one.plate.nodes.T
    plate = replace(one.plate, moment_x=1e4 * (1 - x**2), moment_y=1e4 * (1 - (y / 0.64) ** 2))
    near = Results(combined.model, combined.combinations, {"ULS": replace(one, plate=plate)}, {})
    (demand,) = column_demands(near).found.values()
    assert demand.a_p == pytest.approx(0.8, rel=1e-2)
    assert demand.a_pd == pytest.approx(math.sqrt(0.8 * D / 8), rel=1e-2)
    (far,) = (each for each in column_demands(combined).found.values())
    assert far.a_pd == far.d == pytest.approx(D)
    assert demand.tau_Rd_c / far.tau_Rd_c == pytest.approx((D / demand.a_pd) ** (1 / 3))


def test_the_analysis_counts_beside_a_large_force() -> None:
    """A neighbor 1 m away with as large a force: tau_Ed is that of the shear forces along the perimeter, if larger."""
    columns = [COLUMN, {"name": "C2", "x": 1.0, "y": 0, "width_x": C, "width_y": C}]
    loads = [{"kind": "point", "P": 0.5e6, "column": name, "case": "G"} for name in ("C1", "C2")]
    combined = solved({}, columns=columns, loads=loads)
    one = combined.results["ULS"]
    x, y = one.plate.nodes.T
    even = 2e6  # N/m2 from the plate's middle: the mean inwards around C1 is that times its area over its length
    plate = replace(one.plate, shear_x=-even * x, shear_y=-even * y)
    found = column_demands(Results(combined.model, combined.combinations, {"ULS": replace(one, plate=plate)}, {})).found
    demand = found["ULS", "C1"]
    assert demand.concentrated
    assert demand.of_analysis is not None
    # at a side in the middle between corners 0.3275 m from the center, at a corner farther away
    assert 2e6 * (C / 2 + D / 2) < demand.of_analysis * D < 2e6 * math.hypot(C / 2 + D / 2, C / 2)
    assert demand.tau_Ed == demand.of_analysis
    assert not column_demands(solved({}, 0.9e6)).found["ULS", "C1"].concentrated


def test_laid_bars() -> None:
    """Spacing, cover by bond alone, least bars for cracks, widths; of durability it says that it is not checked."""
    found = rows(LAID | {"w_max": 3e-4}, m=60e3)
    assert found["distance of bars"].resistance == 400
    cover = found["cover"]
    assert (cover.demand, cover.resistance) == pytest.approx((34, 22))
    assert "durability by exposure resistance classes is not checked" in cover.words
    least = found["least bars for cracks"]
    assert least.demand == pytest.approx(0.2 * (0.8 - 0.6 * 0.1) * 0.3 * 30 ** (2 / 3) * 0.4 / 500 * 1e4)
    d, cover_x, f_ctm = 0.36, 0.034, 0.3 * 30 ** (2 / 3)
    A, alpha = math.pi * 0.012**2 / 4 / 0.15, 200e3 / (9500 * 38 ** (1 / 3))
    x = math.sqrt((alpha * A) ** 2 + 2 * alpha * A * d) - alpha * A
    sigma = 60e-3 / A / (d - x / 3)
    h_c = min(0.04 + 5 * 0.012, 0.12, 3.5 * 0.04, H - x, H / 2)
    rho = A / h_c / (0.12 / 0.15)
    s_r = min(1.5 * cover_x + (H - h_c) / H * 0.9 / 7.2 * 0.012 / rho, 1.3 * (H - x) / 1.7)
    strain = max(sigma - 0.4 * f_ctm / rho * (1 + alpha * rho), 0.6 * sigma) / 200e3
    width = found["crack width at the bottom x"]
    assert width.demand == pytest.approx(1.7 * (H - x) / (d - x) * s_r * strain * 1e3, rel=1e-6)
    assert width.clause == "EN 1992-1-1:2023 9.2.3"
    open_ = rows(LAID)["crack width"]
    assert (open_.status, "w_max is not given" in open_.words) == ("attention", True)


def test_what_is_not_checked_is_said() -> None:
    """Where formulas were read, and what the code has besides."""
    found = rows({}, 0.5e6)
    assert "second hand" in found["formulas of the code"].words
    assert found["formulas of the code"].status == "attention"
    rest = found["rest of EN 1992-1-1:2023"]
    assert rest.status == "attention"
    for word in ("durability", "fatigue", "anchorage", "deflection"):
        assert word in rest.words


def test_the_table_of_columns() -> None:
    """Its figures are those of the demand."""
    table = table_makers(solved(LAID, 0.9e6))["columns"]()
    row = dict(zip([column.name for column in table.columns], table.rows()[0], strict=True))
    assert row["b_0.5"] == pytest.approx(B_05, rel=1e-4)
    assert row["b_0"] == pytest.approx(4 * C)
    assert row["k_pb"] == pytest.approx(K_PB, rel=1e-4)
    assert row["V_Ed"] == pytest.approx((1.2 * 0.9e6 - PRESSURE * area(0.67 * D)) / 1e3, rel=1e-4)
    assert row["pressure inside"] == pytest.approx(PRESSURE * area(0.67 * D) / 1e3, rel=1e-3)
    assert row["tau_Ed / tau_Rd,c"] == pytest.approx(row["tau_Ed"] / max(row["tau_Rd,c"], row["tau_Rdc,min"]))
    assert any("second hand" in note for note in table.notes)
