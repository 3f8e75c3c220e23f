"""Columns that pull up and piles that pull down punch the slab the other way: by hand, from three codes' clauses."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from groundslab.design.checks import DesignCheck, check_design
from groundslab.model.model import Model
from groundslab.results.records import SupportResult
from groundslab.results.results import Results
from groundslab.views.tables.result_tables import tables_of
from helpers import synthetic
from helpers.calculations import follow
from helpers.synthetic import LENGTH_X, LENGTH_Y

C, H = 0.3, 0.4
#: Effective depths of the bars at the top, which a column that pulls has in tension, and at the bottom.
D_TOP, D_BOTTOM = H - 0.07, H - 0.045
PRESSURE, LOAD = 50e3, 1.35 * 20e3
STEEL: dict[str, Any] = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.06, 0.08)}
COLUMN = {"name": "C1", "x": 0, "y": 0, "width_x": C, "width_y": C}
PILE = {"kind": "point", "name": "P1", "x": 0, "y": 0, "stiffness": 1e8, "diameter": C}
NAMES = {"EN 1992-1-1": "within 2 d", "EN 1992-1-1:2023": "punching", "ACI 318": "two-way shear"}


def solved(code: str, P: float = 0.0, pile: float | None = None, M_x: float = 0.0) -> Results:
    """Return made-up results: an even pressure and load, with a column that pushes by P, or a pile [N]."""
    own = {"kind": "point", "P": P, "M_x": M_x, "column": "C1", "case": "G"}
    model = Model(
        plate={"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": H, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        columns=[COLUMN] if pile is None else [],
        supports=[] if pile is None else [PILE],
        cases=[{"name": "G"}],
        loads=[{"kind": "uniform", "q": 20e3, "case": "G"}, *([own] if pile is None else [])],
        combinations=[{"name": "ULS", "factors": {"G": 1.35}}],
        reinforcement=STEEL | {"code": code},
    )
    one = synthetic.results(24, model=model, combination="ULS", limit_state="ultimate", factors={"G": 1.35})
    flat = np.zeros(len(one.plate.nodes))
    fields = {"moment_x": flat, "moment_y": flat, "moment_xy": flat, "pressure": flat + PRESSURE}
    zero = np.zeros(1)
    supports = () if pile is None else (SupportResult("P1", np.zeros((1, 2)), zero, zero, zero + pile, zero, zero),)
    one = replace(one, plate=replace(one.plate, **fields), supports=supports)
    return Results(model, model.combinations, {"ULS": one}, {})


def check(code: str, of: Results) -> DesignCheck:
    """Return the check of punching around the column or pile."""
    about = NAMES[code]
    found = [each for each in check_design(of).checks if about in each.name]
    assert len(found) == 1
    return found[0]


def around(a: float, *, circle: bool = False) -> tuple[float, float]:
    """Return the length of the perimeter at a distance from a square or a circle [m] and what it surrounds [m2]."""
    u, A = (math.pi * C, math.pi * C**2 / 4) if circle else (4 * C, C**2)
    return u + 2 * math.pi * a, A + u * a + math.pi * a**2


def by_first_generation(force: float, other: float, d: float, *, circle: bool = False) -> tuple[float, float]:
    """Return v_Ed and v_Rd [MPa] where their ratio is largest within 2 d (6.4.4), with 2 % of bars."""
    v_Rd_c = 0.18 / 1.5 * (1 + math.sqrt(0.2 / d)) * (2 * 30) ** (1 / 3)
    pairs = []
    for a in np.linspace(0.25, 2, 701) * d:
        u, A = around(a, circle=circle)
        pairs.append(((force + other * A) / (u * d) / 1e6, v_Rd_c * 2 * d / a))
    return max(pairs, key=lambda pair: pair[0] / pair[1])


def by_second_generation(force: float, other: float, d: float, *, circle: bool = False) -> tuple[float, float]:
    """Return tau_Ed and tau_Rd,c [MPa] at d / 2 (8.4.2, 8.4.3), with what acts up to 0.67 d and 2 % of bars."""
    b_0, b_05 = around(0, circle=circle)[0], around(d / 2, circle=circle)[0]
    k_pb = min(2.5, 3.6 * math.sqrt(1 - b_0 / b_05))
    tau_Rd_c = min(0.6 / 1.4 * k_pb * (2 * 30 * 32 / (1e3 * d)) ** (1 / 3), 0.5 / 1.4 * math.sqrt(30))
    return 1.05 * (force + other * around(0.67 * d, circle=circle)[1]) / (b_05 * d) / 1e6, tau_Rd_c


def by_aci(force: float, other: float, d: float, *, circle: bool = False) -> tuple[float, float]:
    """Return v_u and phi v_c [MPa] at d / 2 (22.6.5.2), the corners square around a square."""
    b_o, A = around(d / 2, circle=True) if circle else (4 * (C + d), (C + d) ** 2)
    lambda_s = min(1.0, math.sqrt(2 / (1 + 0.004 * 1e3 * d)))
    return (force + other * A) / (b_o * d) / 1e6, 0.75 * 0.33 * lambda_s * math.sqrt(30)


HAND = {"EN 1992-1-1": by_first_generation, "EN 1992-1-1:2023": by_second_generation, "ACI 318": by_aci}


@pytest.mark.parametrize("code", HAND)
def test_a_column_that_pulls(code: str) -> None:
    """1.35 x 200 kN up and the pressure inside, less the loads there, on perimeters of the depth of the top bars."""
    v_Ed, v_Rd = HAND[code](1.35 * 200e3, PRESSURE - LOAD, D_TOP)
    found = check(code, solved(code, -200e3))
    assert found.utilization == pytest.approx(v_Ed / v_Rd, rel=5e-4)
    assert found.demand == pytest.approx(v_Ed, rel=5e-3)
    assert (found.of, found.place) == ("C1", (0.0, 0.0))
    assert "it pulls and is taken as tied to the far face" in found.words


@pytest.mark.parametrize("code", HAND)
def test_a_pile_that_pulls(code: str) -> None:
    """270 kN down and the loads inside, less the pressure there, on perimeters of the depth of the bottom bars."""
    v_Ed, v_Rd = HAND[code](270e3, LOAD - PRESSURE, D_BOTTOM, circle=True)
    found = check(code, solved(code, pile=-270e3))
    assert found.utilization == pytest.approx(v_Ed / v_Rd, rel=5e-4)
    assert found.demand == pytest.approx(v_Ed, rel=5e-3)
    assert "it pulls" in found.words


@pytest.mark.parametrize("code", HAND)
def test_what_pulls_needs_links_and_fails(code: str) -> None:
    """A pull of 1.2 times what resists needs links around it, a very large one fails; table and steps tell it."""
    v_Ed, v_Rd = HAND[code](1e6, 0.0, D_TOP)
    P = 1.2e6 * v_Rd / v_Ed / 1.35
    of = solved(code, -P)
    failing = check(code, of)
    assert failing.status == "fails"
    assert "are needed" in failing.words or "is needed" in failing.words
    tables = {table.name: table for table in tables_of(of)}
    assert any("it punches the other way" in note for note in tables["columns"].notes)
    assert follow(tables["calculations"])
    steps = [row for row in tables["calculations"].rows() if "punching" in row or "two-way shear" in row]
    assert next(row for row in steps if "pull of the column" in row)[7] == pytest.approx(1.35 * P / 1e6)
    assert [row[5] for row in steps if row[4] in ("V_Ed", "V_u")] == [
        f"N_{'u' if code == 'ACI 318' else 'Ed'} - N_o + N_p"
    ]
    assert set(tables["shear_reinforcement"]["name"]) >= {"C1"}
    large = [each for each in check_design(solved(code, -10 * P)).checks if each.status == "fails" and each.of == "C1"]
    assert large


def turning(code: str, M: float, other: float, d: float) -> float:
    """Return demand over resistance for a moment without a force [N m] and what else acts [Pa]: V_Ed + k M u / W.

    W is (6.41) with a for 2 d, beta_e V_Ed of Table 8.3 with e V_Ed = M, J_c that of R8.4.4.2.3.
    """
    if code == "EN 1992-1-1":
        shares = []
        for a in np.linspace(0.25, 2, 701) * d:
            u, A = around(a)
            W = 1.5 * C**2 + 2 * C * a + 4 * a**2 + math.pi * a * C
            v_Rd = 0.12 * (1 + math.sqrt(0.2 / d)) * 60 ** (1 / 3) * 2 * d / a
            shares.append((other * A + 0.6 * M * u / W) / (u * d) / 1e6 / v_Rd)
        return max(shares)
    v, resistance = HAND[code](0, other, d)
    if code == "ACI 318":
        b = C + d
        J = d * b**3 / 6 + b * d**3 / 6 + d * b**3 / 2
        return (v + 0.4 * M * b / 2 / J / 1e6) / resistance
    return (v / 1.05 + 1.1 * M / (C + d) / (around(d / 2)[0] * d) / 1e6) / resistance


@pytest.mark.parametrize("code", HAND)
def test_a_moment_without_a_force(code: str) -> None:
    """1.35 x 100 kNm press one side down and the other up: the worse way counts, here that of the pressure's excess."""
    M = 1.35 * 100e3
    used = max(turning(code, M, PRESSURE - LOAD, D_TOP), turning(code, M, LOAD - PRESSURE, D_BOTTOM))
    of = solved(code, M_x=100e3)
    found = check(code, of)
    assert found.utilization == pytest.approx(used, rel=1e-3)
    assert found.words.endswith("it turns the slab without a force")
    (steps,) = (table for table in tables_of(of) if table.name == "calculations")
    assert follow(steps)
    assert any("moment of all forces by their places along axis" in str(words) for words in steps["quantity"])
    assert not {"beta", "beta_e"} & (set(steps["symbol"]) - {"beta" if code == "ACI 318" else ""})
    large = [each for each in check_design(solved(code, M_x=2000e3)).checks if each.status == "fails"]
    assert any(each.of == "C1" for each in large)


def test_what_is_tied_is_said_where_nothing_fails() -> None:
    """A pull of 135 kN fails nothing; that the tie to the far face is not checked stands in the first line."""
    design = check_design(solved("EN 1992-1-1", -100e3))
    assert design.status == "no failure found"
    assert (
        'columns that pull ("C1") are taken as tied to the far face of the slab, which is not checked'
        in design.headline
    )
    assert "tied" not in check_design(solved("EN 1992-1-1", 100e3)).headline
