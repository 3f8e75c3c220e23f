"""Calculations of checks that can be followed by hand: every formula with its numbers gives its value."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.design.checks import check_design
from groundslab.design.codes.aci318.checks.two_way_demand import two_way
from groundslab.design.codes.en1992_2004.checks.governing_perimeters import column_demands as demands
from groundslab.design.codes.en1992_2004.checks.punching_demand import Demand, Stress, outer
from groundslab.design.codes.en1992_2023.checks.punching_demand import column_demands
from groundslab.design.rules.calculation import CONSTANTS, FUNCTIONS, Step, with_numbers
from groundslab.views.report.drawings.perimeter_sketch import tangents
from groundslab.views.report.drawings.perimeter_tables import tables_of_pieces
from groundslab.views.tables.calculations import perimeters
from groundslab.views.tables.result_tables import table_makers, tables_of
from groundslab.views.tables.table import Table
from helpers.calculations import NAMES, evaluate, follow
from helpers.solve_once import solve_once

STEEL = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)}
ACI = {"code": "ACI 318"}
SECOND = {"code": "EN 1992-1-1:2023"}
MIDDLE = {"name": "M", "x": 0.0, "y": 0.0, "width_x": 0.4, "width_y": 0.3}
EDGE = {"name": "E", "x": 2.8, "y": 0.0, "width_x": 0.4, "width_y": 0.4}
CORNER = {"name": "C", "x": 2.8, "y": 1.8, "width_x": 0.4, "width_y": 0.4}
TOP = {"name": "T", "x": 0.0, "y": 1.8, "width_x": 0.4, "width_y": 0.4}
ROUND = {"name": "R", "x": 0.0, "y": 0.0, "diameter": 0.4}
HOLE = {"kind": "rectangle", "x": (0.5, 0.9), "y": (-0.2, 0.2)}


def sheets(*columns: dict[str, Any], steel: dict[str, Any] | None = None, thickness: float = 0.4, wanted: str = "all",
           openings: tuple[dict[str, Any], ...] = (), M_y: float = 0.0, P: float = 900e3,
           name: str = "calculations") -> Table:  # fmt: skip
    """Return the calculations, or another table, of a slab of 6 m by 4 m with columns that press and turn it."""
    results = solved(*columns, steel=steel, thickness=thickness, wanted=wanted, openings=openings, M_y=M_y, P=P)
    return table_makers(results)[name]()


def solved(*columns: dict[str, Any], steel: dict[str, Any] | None, thickness: float, wanted: str,
           openings: tuple[dict[str, Any], ...], M_y: float, P: float) -> gs.Results:  # fmt: skip
    """Return the results of the slab of `sheets`."""
    model = gs.Model(
        plate={"length_x": 6.0, "length_y": 4.0, "thickness": thickness, "E": 30e9, "nu": 0.2, "openings": openings},
        ground={"kind": "pasternak", "k0": 20e6, "k1": 5e6},
        columns=columns,
        cases=[{"name": "G"}],
        loads=[{"kind": "point", "column": each["name"], "P": P, "M_y": M_y, "case": "G"} for each in columns]
        + [{"kind": "uniform", "q": 12e3, "case": "G"}],
        combinations=[{"name": name, "limit_state": state, "factors": {"G": factor}} for name, state, factor in (
            ("low", "ultimate", 1.0), ("high", "ultimate", 1.35), ("lasting", "quasi-permanent", 0.8))],
        reinforcement=STEEL | (steel or {}),
        report={"sheets": wanted},
        mesh={"size": 0.5},
    )  # fmt: skip
    return solve_once(model)


def of(table: Table, check: str) -> dict[str, float]:
    """Return the values of the first calculation of a check by their symbols."""
    rows = zip(table["check"], table["symbol"], table["value"], strict=True)
    found: dict[str, float] = {}
    for name, symbol, value in rows:
        if name == check:
            assert isinstance(value, float)
            found.setdefault(str(symbol), value)
    return found


CASES: dict[str, tuple[tuple[dict[str, Any], ...], dict[str, Any]]] = {
    "middle": ((MIDDLE,), {}),
    "with a moment": ((MIDDLE,), {"M_y": 80e3}),
    "edge and corner": ((EDGE, CORNER, MIDDLE), {"P": 300e3}),
    "beside an opening": ((MIDDLE,), {"openings": (HOLE,)}),
    "edge and corner, bent outwards": ((TOP, CORNER), {"P": 300e3, "M_y": 40e3}),
    "by the German annex, bent outwards": ((TOP,), {"steel": {"annex": "Germany"}, "P": 300e3, "M_y": 40e3}),
    "thin, with links": ((ROUND,), {"thickness": 0.25, "P": 700e3}),
    "by the German annex": ((EDGE, ROUND), {"steel": {"annex": "Germany"}, "P": 300e3}),
    "ACI": ((MIDDLE,), {"steel": ACI, "M_y": 80e3}),
    "ACI, edge and corner": ((EDGE, CORNER), {"steel": ACI, "P": 300e3}),
    "ACI, beside an opening": ((ROUND,), {"steel": ACI, "openings": (HOLE,)}),
    "ACI, with stirrups": ((ROUND,), {"steel": ACI, "thickness": 0.25, "P": 450e3}),
    "2023": ((MIDDLE,), {"steel": SECOND, "M_y": 80e3}),
    "2023, edge and corner": ((EDGE, CORNER, MIDDLE), {"steel": SECOND, "P": 300e3}),
    "2023, beside an opening": ((MIDDLE,), {"steel": SECOND, "openings": (HOLE,)}),
    "2023, with links": ((ROUND,), {"steel": SECOND, "thickness": 0.25, "P": 480e3}),
    "2023, of high strength": ((ROUND,), {"steel": SECOND | {"f_ck": 80e6, "d_lower": 0.032}}),
    "ACI, without the effect of size": ((MIDDLE,), {"steel": ACI | {"size_effect": False}}),
}


@pytest.mark.parametrize("case", list(CASES))
def test_every_value_follows_from_its_numbers(case: str) -> None:
    """By hand, as far as six digits go; all symbols of a formula stand above it."""
    columns, changes = CASES[case]
    table = sheets(*columns, **changes)
    assert follow(table) >= 6 * len(columns)
    names = [of for of, check in zip(table["of"], table["check"], strict=True) if check == "punching"]
    assert set(names) == {column["name"] for column in columns}
    assert set(table["check"]) - {"edge line force"} == {"bending", "punching", "one-way shear"}
    assert set(table["combination"]) == {"high"}  # no bars are laid, whose cracks the lasting one opens


def test_a_corner_column_that_is_bent_outwards_a_little_is_followed() -> None:
    """Its governing perimeter has the constant factor, the face that of moments, whose shares need both extents."""
    model = gs.Model(
        plate={"length_x": 6.0, "length_y": 5.0, "thickness": 0.5, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        columns=[{"name": "K", "x": 2.7, "y": 2.2, "width_x": 0.4, "width_y": 0.4}],
        cases=[{"name": "G"}],
        loads=[{"kind": "point", "column": "K", "P": 300e3, "M_x": 2e3, "M_y": 2e3, "case": "G"}],
        combinations=[{"name": "U", "limit_state": "ultimate", "factors": {"G": 1.35}}],
        reinforcement={"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.06, 0.08), "top": (0.06, 0.08)},
        mesh={"size": 0.5},
    )
    table = table_makers(solve_once(model))["calculations"]()
    assert follow(table) > 60
    sheet = of(table, "punching")
    assert sheet["beta"] == 1.5
    assert sheet["beta_0"] > 1.5


@pytest.mark.parametrize("openings", [(HOLE | {"x": (-0.2, 0.2), "y": (0.6, 1.0)},), ()])
@pytest.mark.parametrize("M_y", [-40e3, 40e3])
def test_both_values_of_beta_are_shown_where_the_larger_one_counts(
    openings: tuple[dict[str, Any], ...], M_y: float
) -> None:
    """Beside an opening, or where the column is bent outwards over the edge; else there is one alone."""
    found = of(sheets(TOP, P=300e3, M_y=M_y, openings=openings), "punching")
    assert ("beta_g" in found) == (bool(openings) or M_y > 0)
    if "beta_g" in found:
        assert found["beta"] == pytest.approx(max(found["beta_g"], found["beta_e"]))
        assert {"M_2", "W_2", "k_2", "s", "k_e"} <= found.keys()
    else:
        assert "M_2" not in found


def test_the_sheet_is_the_check() -> None:
    """Of both combinations the one that governs; its shares are those of the table of columns."""
    found = of(sheets(MIDDLE, M_y=80e3), "punching")
    assert {"M_1", "M_2", "W_1", "beta", "rho_l", "v_Rd,c", "eta", "eta_0"} <= found.keys()
    assert found["beta"] > 1.02
    columns = sheets(MIDDLE, M_y=80e3, name="columns")
    row = columns["combination"].index("high")
    assert found["eta"] == pytest.approx(columns["v_Ed / v_Rd"][row], rel=1e-9)
    assert found["v_Ed,0"] == pytest.approx(columns["v_Ed at the face"][row], rel=1e-9)
    assert found["v_Rd,max"] == pytest.approx(columns["v_Rd,max"][row], rel=1e-9)


def test_the_sheet_of_two_way_shear_is_the_check() -> None:
    """By ACI 318 the share is that of the table of columns, v_u over 0.75 v_c."""
    found = of(sheets(MIDDLE, M_y=80e3, steel=ACI), "punching")
    columns = sheets(MIDDLE, M_y=80e3, steel=ACI, name="columns")
    row = columns["combination"].index("high")
    assert found["v_u"] == pytest.approx(columns["v_u"][row], rel=1e-9)
    assert 0.75 * found["v_c"] == pytest.approx(columns["phi v_c"][row], rel=1e-9)
    assert found["eta"] == pytest.approx(found["v_u"] / (0.75 * found["v_c"]))
    assert abs(found["gamma_v1"] - 0.4) < 0.05
    assert found["v_u"] > found["V_u"] / (found["b_o"] * found["d"])


@pytest.mark.parametrize(("steel", "length"), [({}, "u"), (ACI, "b_o"), (SECOND, "b_05")])
def test_the_sketch_is_the_perimeter(steel: dict[str, Any], length: str) -> None:
    """What is drawn thick is as long as what counts; tangents to an opening pass through its corners."""
    results = solved(MIDDLE, steel=steel, thickness=0.4, wanted="all", openings=(HOLE,), M_y=0.0, P=900e3)
    ((key, sketch),) = perimeters(results).items()
    assert key == ("punching", "M", "high")
    table = table_makers(results)["calculations"]()
    drawn = np.linalg.norm(sketch.legs[:, 1] - sketch.legs[:, 0], axis=1).sum()
    assert drawn == pytest.approx(of(table, "punching")[length], rel=1e-6)
    ends = np.array([end for end in tangents(sketch) if end[0] > 0])
    corners = np.array([[0.5, -0.2], [0.5, 0.2]])
    assert {round(y / x, 4) for x, y in ends} >= {round(y / x, 4) for x, y in corners}


@pytest.mark.parametrize(
    "columns", [(MIDDLE,), (EDGE,), (CORNER,), (MIDDLE, HOLE)], ids=["in", "edge", "corner", "hole"]
)
@pytest.mark.parametrize("steel", [{}, ACI, SECOND], ids=["2004", "ACI", "2023"])
def test_pieces_add_up_to_the_sheet(columns: tuple[dict[str, Any], ...], steel: dict[str, Any]) -> None:
    """Straight pieces anew from their ends, from the center; lengths, centers, W and I of all add up to the sheet.

    Of arcs the chord is known by their ends, and their angle by chord and radius.
    """
    holes = tuple(each for each in columns if each is HOLE)
    placed = [each for each in columns if each is not HOLE]
    changes: dict[str, Any] = {"steel": steel, "thickness": 0.4, "wanted": "all", "openings": holes, "M_y": 0.0}
    results = solved(*placed, **changes, P=300e3)
    sheet = of(table_makers(results)["calculations"](), "punching")
    ((_, sketch),) = perimeters(results).items()
    (table, *_) = tables_of_pieces(sketch, frozenset(sheet))
    names = [str(head.text) + head.symbol for head in table.heads]
    rows = [dict(zip(names, (cell.text for cell in row), strict=True)) for row in table.rows]
    length = next(name for name in names if name.startswith("length"))
    for row in rows[:-1]:
        start, end = (np.array([float(row[f"{word}, along {n}"]) for n in (1, 2)]) for word in ("from", "to"))
        chord = math.dist(start, end)
        r = float(row.get("radius") or math.inf)
        # an arc of a perimeter is a quarter of a circle at most
        by_hand = chord if r == math.inf else 2 * r * math.asin(min(1.0, chord / (2 * r)))
        assert float(row[length]) == pytest.approx(by_hand, abs=2e-4)
    total = rows[-1]
    assert float(total[length]) == pytest.approx(sheet[length.removeprefix("length")], rel=5e-5)
    assert float(total[length]) == pytest.approx(sum(float(row[length]) for row in rows[:-1]), abs=1e-4)
    for name, value in total.items():
        if name.startswith("part of"):
            assert float(value) == pytest.approx(sheet[name.removeprefix("part of")], rel=1e-4)
        if name.startswith("center"):
            n = name[-1]
            away = sheet[f"e_{n}"] if f"e_{n}" in sheet else sheet[f"x_{n}"]
            assert float(value) == pytest.approx(-away, abs=1e-4)
    for n in (1, 2):
        _straight_pieces(rows, length, n)


def _straight_pieces(rows: list[dict[str, str]], length: str, n: int) -> None:
    """Hold what straight pieces add to W and I along an axis to their ends and the center of all."""
    if f"center, along {n}" not in rows[-1]:
        return
    center = float(rows[-1][f"center, along {n}"])
    for row in (row for row in rows[:-1] if not row.get("radius")):
        a, b = (float(row[f"{word}, along {n}"]) - center for word in ("from", "to"))
        along, weighted = float(row[length]), (a * a + b * b) / (2 * (abs(a) + abs(b))) if a * b < 0 else abs(a + b) / 2
        if f"part ofW_{n}" in row:
            assert float(row[f"part ofW_{n}"]) == pytest.approx(along * weighted, rel=1e-3, abs=1e-4)
        if f"part ofI_{n}" in row:
            assert float(row[f"part ofI_{n}"]) == pytest.approx(along * (a * a + a * b + b * b) / 3, rel=1e-3, abs=1e-4)
            assert float(row[f"part ofl_{n}"]) == pytest.approx((b - a) ** 2 / along, rel=1e-3, abs=1e-4)


def test_links_are_told_where_they_are_needed() -> None:
    """What is missing of the resistance, by 6.52."""
    columns, changes = CASES["thin, with links"]
    found = of(sheets(*columns, **changes), "punching")
    assert found["eta"] > 1
    by_hand = (found["v_Ed"] - 0.75 * found["v_Rd"]) * found["u"] * 0.75 * found["d"] / (1.5 * found["f_ywd,ef"])
    assert found["A_sw"] == pytest.approx(1e4 * by_hand)


def test_links_reach_to_the_outer_perimeter() -> None:
    """By EN 1992-1-1 6.54 u_out = beta V_Ed / (v_Rd,c d) beyond 2 d, round a column (u_out - pi c) / (2 pi) off it.

    Links reach to 1.5 d inside it, from d / 2 on, every 0.75 d.
    """
    columns, changes = CASES["thin, with links"]
    found = of(sheets(*columns, **changes), "punching")
    d = found["d"]
    assert found["a_l"] == pytest.approx(2 * d)
    assert found["u_out"] == pytest.approx(found["v_l"] * found["u_l"] / found["v_Rd,c"])
    assert found["a_out"] == pytest.approx((found["u_out"] - np.pi * 0.4) / (2 * np.pi), rel=2e-3)
    assert (found["a_L"], found["a_F"]) == pytest.approx((found["a_out"] - 1.5 * d, d / 2))
    assert found["n_L"] == max(2, np.ceil((found["a_L"] - d / 2) / (0.75 * d)) + 1)


def test_links_that_only_inner_perimeters_need() -> None:
    """Where the outermost perimeter followed needs none, a perimeter of these is the outer one, if not 6.54."""
    control = {"u": 3.0, "V_Ed": 1e6, "beta": 1.0, "supported": False, "pressure": 0.0, "edge": 0.0, "others": 0.0}
    around = tuple(
        Stress(distance=a, v_Ed=v, error=lambda: None, **control) for a, v in ((0.2, 2.2e6), (0.3, 1.4e6), (0.4, 0.9e6))
    )
    demand = Demand("C", "ULS", "ultimate", 1e6, 0.2, 1e6, None, around)  # v_Rd is 2, 1.33 and 1 MPa
    assert outer(demand) == (3.0, 0.4, None, None, 0.0)
    beyond = outer(replace(demand, v_Rd_c=0.8e6))
    assert (beyond.u, beyond.last) == (pytest.approx(0.9 * 3.0 / 0.8), around[-1])


def test_least_beta_by_the_german_annex() -> None:
    """A centered column has beta 1.0, but 1.10 by NA.6.39.1 and NA.6.51.1, so that v_Ed is 1.10 V_Ed / (u d)."""
    for annex, least in (("recommended", 1.0), ("Germany", 1.1)):
        table = sheets(MIDDLE, steel={"annex": annex})
        assert follow(table) >= 6
        found = of(table, "punching")
        assert found["beta"] == pytest.approx(least, abs=1e-6)
        assert found["v_Ed"] == pytest.approx(least * found["V_Ed"] / (found["u"] * found["d"]), rel=1e-6)
        assert found.get("beta_min", 1.0) == least


def test_links_alone_by_the_german_annex() -> None:
    """The two inner rows carry all of beta V_Ed with f_ywd,ef, and there is no u_out but by 1.4 v_Rd.

    Rows of foundations are 0.3 d from the face and 0.5 d apart, as `link_rows` of the annex says.
    """
    columns, changes = CASES["thin, with links"]
    found = of(sheets(*columns, **changes | {"steel": {"annex": "Germany"}, "P": 600e3}), "punching")
    force = found["beta"] * found["V_Ed"]
    assert found["A_sw"] == pytest.approx(1e4 * force / found["f_ywd,ef"])
    assert found["v_Rd,m"] == pytest.approx(1.4 * found["v_Rd"])
    d = found["d"]
    assert (found["a_F"], found["s_r"]) == pytest.approx((0.3 * d, 0.5 * d))
    assert found["n_L"] == max(2, np.ceil((found["a_L"] - 0.3 * d) / (0.5 * d)) + 1)


def test_stirrups_by_aci_318() -> None:
    """They bear phi 0.498 f'c^(1/2) at most, beside 0.166 lambda_s f'c^(1/2) of concrete, d / 2 apart."""
    columns, changes = CASES["ACI, with stirrups"]
    found = of(sheets(*columns, **changes), "punching")
    assert (found["v_max"], found["s"]) == pytest.approx((0.498 * found["r"], found["d"] / 2))
    assert found["eta_m"] == pytest.approx(found["v_u"] / (0.75 * found["v_max"]))
    A_vs = (found["v_u"] / 0.75 - 0.166 * found["lambda_s"] * found["r"]) * found["b_o"] / found["f_yt"]
    assert (found["A_vs"], found["A_v"]) == pytest.approx((1e4 * A_vs, 1e4 * A_vs * found["s"]))


def test_which_sheets_are_wanted() -> None:
    """One of the column that uses most, of all, or none."""
    columns, changes = CASES["edge and corner"]
    every, one = (sheets(*columns, **changes, wanted=wanted) for wanted in ("all", "governing"))
    first, only = ([of for of, check in zip(table["of"], table["check"], strict=True) if check == "punching"]
                   for table in (every, one))  # fmt: skip
    assert set(only) == {first[0]}
    rows = zip(every["check"], every["symbol"], every["value"], strict=True)
    shares = [value for check, symbol, value in rows if (check, symbol) == ("punching", "eta")]
    assert len(shares) == len(columns)
    assert shares == sorted(shares, reverse=True)
    with pytest.raises(KeyError, match="calculations"):
        sheets(MIDDLE, wanted="none")


@pytest.mark.parametrize("steel", [{}, ACI, ACI | {"size_effect": False}, SECOND])
def test_one_way_shear_is_followed(steel: dict[str, Any]) -> None:
    """In a thin slab, with links; the share is that of the check."""
    table = sheets(ROUND, steel=steel, thickness=0.25, P=450e3)
    found = of(table, "one-way shear")
    checks = sheets(ROUND, steel=steel, thickness=0.25, P=450e3, name="checks")
    used = checks["utilization"][checks["check"].index("one-way shear")]
    assert found["eta"] == pytest.approx(used, rel=1e-9)


@pytest.mark.parametrize("steel", [{}, ACI, SECOND])
def test_the_ratio_of_bars_along_the_force_by_hand(steel: dict[str, Any]) -> None:
    """Of 10 and 20 cm2/m over d at the face in tension: rho_x cos^4 + rho_y sin^4 (EN 1992-2 LL.123)."""
    area = np.pi * 0.016**2 / 4
    bars = {key: {"diameter": 0.016, "spacing": area / 1e-3 / (1 if key.endswith("x") else 2)}
            for key in ("bottom_x", "bottom_y", "top_x", "top_y")}  # fmt: skip
    table = sheets(ROUND, steel=steel | bars, thickness=0.25, P=450e3)
    found = of(table, "one-way shear")
    force, rho = ("v_u", "rho_w") if "v_u" in found else ("v_Ed", "rho_l")
    angle = np.arctan2(found["q_y"], found["q_x"])
    assert found[force] == pytest.approx(np.hypot(found["q_x"], found["q_y"]))
    assert (found["rho_x"], found["rho_y"]) == pytest.approx((1e-3 / found["d"], 2e-3 / found["d"]))
    assert found[rho] == pytest.approx((1e-3 * np.cos(angle) ** 4 + 2e-3 * np.sin(angle) ** 4) / found["d"])
    direction = np.array([np.cos(angle), np.sin(angle)])
    tensor = np.array([[found["m_x"], found["m_xy"]], [found["m_xy"], found["m_y"]]])
    assert found["m_n"] == pytest.approx(direction @ tensor @ direction, rel=1e-6)


@pytest.mark.parametrize("laid", [True, False])
def test_means_over_a_cut_are_followed(laid: bool) -> None:
    """By ACI 318, beside a column: with the same bars all along the cut from their ratio, else the mean is given."""
    bars = {key: {"diameter": 0.016, "spacing": 0.2} for key in ("bottom_x", "bottom_y", "top_x", "top_y")}
    table = sheets(EDGE, CORNER, steel=ACI | (bars if laid else {}), P=600e3)
    rows = [row for row in table.rows() if row[0] == "one-way shear"]
    words = {str(row[4]): (str(row[3]), str(row[5])) for row in rows}
    assert words["v_u"][0] == "shear force, mean over the cut"
    assert words["d"] == ("effective depth", "h - (a_x + a_y) / 2")
    assert ("rho_w" in words, bool(words["v_c"][1])) == (laid, laid)
    assert follow(table) > 10


@pytest.mark.parametrize("steel", [{}, {"annex": "Germany"}, ACI, SECOND])
def test_bars_of_every_layer_are_followed(steel: dict[str, Any]) -> None:
    """Of each layer that a moment or the minimum governs; areas are those of the table of reinforcement."""
    table = sheets(MIDDLE, steel=steel)
    found = {
        str(of).partition(",")[0]: value
        for of, symbol, value in zip(table["of"], table["symbol"], table["value"], strict=True)
        if symbol == "A_req"
    }
    assert set(found) == {"bottom x", "bottom y", "top x", "top y"}
    needed = sheets(MIDDLE, steel=steel, name="reinforcement")
    assert found == pytest.approx(dict(zip(needed["layer"], needed["required area"], strict=True)), rel=1e-9)


@pytest.mark.parametrize(("steel", "P"), [({}, 1.7e6), ({}, 5e6), (ACI, 2e6), (SECOND, 2e6)])
def test_bars_in_compression_are_not_followed(steel: dict[str, Any], P: float) -> None:
    """In a slab so thin that they count, or that is too weak, the other calculations are left."""
    table = sheets(MIDDLE, steel=steel, thickness=0.25, P=P)
    assert "bending" not in table["check"]
    assert follow(table) > 10


@pytest.mark.parametrize("steel", [{}, {"annex": "Germany"}, {"far": True}, SECOND, SECOND | {"far": True}])
def test_widths_of_cracks_are_followed(steel: dict[str, Any]) -> None:
    """Of all layers, bars near each other and far apart, by 7.11 and 7.14; the width is that of the check."""
    steel = dict(steel)
    bars = {"diameter": 0.016, "spacing": 0.35 if steel.pop("far", False) else 0.15}
    laid = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), bars)
    table = sheets(MIDDLE, steel=steel | laid | {"w_max": 3e-4}, P=300e3)
    assert follow(table) > 40
    widths = [
        value for symbol, value in zip(table["symbol"], table["value"], strict=True) if symbol in ("w_k", "w_k,cal")
    ]
    assert len(widths) == 4
    checks = sheets(MIDDLE, steel=steel | laid | {"w_max": 3e-4}, P=300e3, name="checks")
    rows = zip(checks["check"], checks["demand"], strict=True)
    assert widths == pytest.approx([demand for check, demand in rows if str(check).startswith("crack width")], rel=1e-9)


def test_a_formula_with_its_numbers() -> None:
    """Symbols that begin alike, negative numbers and functions."""
    step = Step("", "x", 0.0, formula="max(v_Rd,c * 2, v_Rd - abs(v)^(1/2), d_1)")
    known = {"v_Rd,c": 0.5, "v_Rd": -1.25, "v": 4.0, "d_1": 1e-3}
    assert with_numbers(step, known) == "max(0.5 * 2, (-1.25) - abs(4)^(1/2), 0.001)"
    assert {*FUNCTIONS, *CONSTANTS} == NAMES.keys()


@pytest.mark.parametrize(
    ("formula", "numbers"),
    [
        ("a + b", "2 - 0.0157"),
        ("a - b * a", "2 + 0.0157 * 2"),
        ("b + a", "(-0.0157) + 2"),
        ("a + b^2", "2 + (-0.0157)^2"),
        ("a * b", "2 * (-0.0157)"),
        ("a * (a + c)", "2 * (2 - 1.5e-07)"),
    ],
)
def test_a_sum_with_what_is_negative_is_written_as_a_difference(formula: str, numbers: str) -> None:
    """And gives the same, powers too."""
    values = {"a": 2.0, "b": -0.0157, "c": -1.5e-7}
    written = with_numbers(Step("", "x", 0.0, formula=formula), values)
    assert written == numbers
    assert evaluate(written) == pytest.approx(eval(formula.replace("^", "**"), {}, values), rel=1e-9)


@pytest.mark.parametrize(
    ("steel", "find"),
    [
        ({}, lambda of: demands(of).found),
        (ACI, lambda of: two_way(of).found),
        (SECOND, lambda of: column_demands(of).found),
    ],
    ids=["EN 1992-1-1", "ACI 318", "EN 1992-1-1:2023"],
)
def test_demands_are_found_once_of_the_same_results(
    steel: dict[str, Any], find: Callable[[gs.Results], dict[tuple[str, str], Any]]
) -> None:
    """Checks, tables and calculations share them; with bars that lie elsewhere they are others."""
    results = solved(MIDDLE, steel=steel, thickness=0.4, wanted="all", openings=(), M_y=0.0, P=900e3)
    check_design(results)
    found = find(results)
    tables_of(results)
    assert find(results) is found
    deeper = results.model.model_copy(
        update={"reinforcement": results.model.reinforcement.model_copy(update={"bottom": (0.06, 0.07)})}
    )
    other = find(replace(results, model=deeper))
    assert found["high", "M"].d == pytest.approx(0.355)
    assert other["high", "M"].d == pytest.approx(0.335)


@pytest.mark.parametrize("steel", [{}, ACI, SECOND], ids=["2004", "ACI", "2023"])
def test_shares_in_thinner_slab_are_followed(steel: dict[str, Any]) -> None:
    """A column on a zone 0.1 m thicker than the slab from 0.1 m beside it on: what counts of the length there, by hand.

    By 6.4.4(2) that is max(1, 2 d_t / (a - 0.1)) a d_t / (2 d^2), at most 1; by depth alone d_t / d.
    """
    model = gs.Model(
        plate={"length_x": 6.0, "length_y": 4.0, "thickness": 0.3, "E": 30e9, "nu": 0.2,
               "zones": [{"thickness": 0.4, "shape": {"kind": "rectangle", "x": (-2.0, 0.3), "y": (-1.5, 1.5)}}]},
        ground={"kind": "winkler", "k": 20e6},
        columns=[MIDDLE],
        cases=[{"name": "G"}],
        loads=[{"kind": "point", "column": "M", "P": 900e3, "case": "G"}],
        combinations=[{"name": "high", "limit_state": "ultimate", "factors": {"G": 1.35}}],
        reinforcement=STEEL | steel,
        mesh={"size": 0.5},
    )  # fmt: skip
    results = solve_once(model)
    table = table_makers(results)["calculations"]()
    assert follow(table) > 10
    found = of(table, "punching")
    ((_, sketch),) = ((key, each) for key, each in perimeters(results).items() if key[0] == "punching")
    d = 0.4 - 0.045
    d_t, a = d - 0.1, found["a"]
    by_hand = d_t / d if steel else min(1.0, max(1.0, 2 * d_t / (a - 0.1)) * a * d_t / (2 * d**2))
    assert (found["t_1"], found["k_t,1"]) == pytest.approx((0.1, by_hand))
    assert {round(piece.share, 9) for piece in sketch.pieces} == {1.0, round(by_hand, 9)}
    length = next(found[name] for name in ("u", "b_o", "b_05") if name in found)
    assert sum(piece.length for piece in sketch.pieces) == pytest.approx(length)
