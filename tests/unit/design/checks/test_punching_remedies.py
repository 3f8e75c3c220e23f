"""What helps where links do not suffice against punching: more bars, a thicker slab or a larger column."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from typing import Any

import pytest

import groundslab as gs
from groundslab.design.bars.proposal.links import NeedsOfLinks
from groundslab.design.checks import DesignCheck, check_design
from groundslab.model.model import Model
from groundslab.results.results import Results
from helpers.solve_once import solve_once

WITHIN = "punching within 2 d"


def checks(results: Results) -> dict[str, DesignCheck]:
    """Return the checks by their names."""
    return {check.name: check for check in check_design(results).checks}


def pad(P: float, side: float = 0.3, width: float = 3.0, spacing: float = 0.1) -> Model:
    """Return a stiff square pad of 0.5 m on springs under a square column, with bars of 20 mm."""
    bars = {"diameter": 0.02, "spacing": spacing}
    steel: dict[str, Any] = {
        "f_ck": 25e6, "f_yk": 500e6, "bottom": (0.06, 0.08), "top": (0.06, 0.08),
        **dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), bars),
    }  # fmt: skip
    return Model(
        plate={"length_x": width, "length_y": width, "thickness": 0.5, "E": 31e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 40e6},
        columns=[{"name": "C", "x": 0, "y": 0, "width_x": side, "width_y": side}],
        cases=[{"name": "G"}],
        loads=[{"kind": "point", "case": "G", "column": "C", "P": P}],
        combinations=[{"name": "U", "factors": {"G": 1.35}}],
        reinforcement=steel,
        mesh={"counts": (8, 8)},
    )


def test_struts_at_the_face_ask_for_thickness_or_a_larger_column() -> None:
    """v_Ed = V (1 - c^2 / 9) / (4 c d) against v_Rd,max = 0.4 x 0.54 x 25 / 1.5 = 3.6 MPa, V = 1.35 x 2.3 MN.

    With c = 0.3 m and d = h - 0.07 m, 0.75 m have 3.77 MPa and 0.80 m 3.51 MPa; with h = 0.5 m a column of 0.45 m has
    3.92 MPa, one of 0.5 m 3.51 MPa.
    """

    def v_Ed(c: float, h: float) -> float:
        return 1.35 * 2.3 * (1 - c**2 / 9) / (4 * c * (h - 0.07))

    assert v_Ed(0.3, 0.75) > 3.6 > v_Ed(0.3, 0.80)
    assert v_Ed(0.45, 0.5) > 3.6 > v_Ed(0.5, 0.5)
    results = solve_once(pad(2300e3))
    face = checks(results)["punching at the column's face"]
    said = "a slab of 0.80 m as far as 2 d around it would do, or a loaded area of 0.50 x 0.50 m"
    assert face.status == "fails"
    assert said in str(face.words)
    (links,) = gs.punching_links(results)
    assert said in str(links.why)


def test_bars_are_no_remedy_where_struts_fail_too() -> None:
    """Of a column of 0.6 m v_Ed = 3.85 MPa at its face is more than v_Rd,max = 3.6 MPa, whatever bars there are.

    At 2 d around it, v_Ed = 0.85 MPa by an even pressure of the ground is 1.5 times k_max v_Rd,c = 1.5 x 0.38 MPa,
    v_Rd,c = v_min with 0.24 % of bars: that alone would hold with 0.9 %.
    """
    V, d = 1.35 * 3.01, 0.43
    assert V * (1 - 0.6**2 / 16) / (4 * 0.6 * d) > 3.6
    found = checks(solve_once(pad(3010e3, side=0.6, width=4.0, spacing=0.3)))
    around, face = found[WITHIN], found["punching at the column's face"]
    assert (around.utilization or 0) > (face.utilization or 0) > 1
    for check in (around, face):
        assert check.status == "fails"
        assert "bars in tension" not in str(check.words)
        assert "would do" in str(check.words)


def test_struts_that_fail_in_another_combination_are_seen() -> None:
    """1.35 x 2.7 MN are worst around and leave 3.45 MPa at the face, which 1.35 x 3.0 MN with 2.5 MN beside break.

    The ground pushes those 2.5 MN back by an even pressure, a third of it within 2 d.
    """
    model = pad(2700e3, side=0.6, width=4.0, spacing=0.3)
    strips = [{"kind": "patch", "case": "Q", "q": 2500e3 / 4, "x": x, "y": (-2, 2)} for x in ((-2, -1.5), (1.5, 2))]
    more = {"kind": "point", "case": "Q", "column": "C", "P": 300e3}
    values = model.model_dump()
    values["cases"] = [*values["cases"], {"name": "Q"}]
    values["loads"] = [*values["loads"], *strips, more]
    values["combinations"] = [*values["combinations"], {"name": "V", "factors": {"G": 1.35, "Q": 1.35}}]
    found = checks(solve_once(Model.model_validate(values)))
    around, face = found[WITHIN], found["punching at the column's face"]
    assert around.combination == "U"
    assert face.combination == "V"
    assert around.status == face.status == "fails"
    for check in (around, face):
        assert "bars in tension" not in str(check.words)
        assert "would do" in str(check.words)


def test_no_remedy_is_told_where_links_suffice() -> None:
    """Nor where none are needed."""
    assert "would do" not in str(checks(solve_once(pad(500e3)))["punching at the column's face"].words)


def raft(P: float) -> Model:
    """Return a thick slab of strong concrete, which bends little under its column."""
    return Model(
        plate={"length_x": 6, "length_y": 6, "thickness": 0.6, "E": 34e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 60e6},
        columns=[{"name": "A", "x": 0, "y": 0, "width_x": 0.5, "width_y": 0.5}],
        cases=[{"name": "G"}],
        loads=[{"kind": "point", "P": P, "column": "A", "case": "G"}],
        combinations=[{"name": "U", "factors": {"G": 1.35}}],
        reinforcement={"concrete": "C35/45", "steel": "B500B", "bottom": (0.05, 0.07), "top": (0.05, 0.07)},
        mesh={"size": 0.5},
    )


@pytest.mark.slow
def test_bars_that_links_ask_for_are_proposed(monkeypatch: pytest.MonkeyPatch) -> None:
    """v_Rd,c grows with the third root of rho_l: with the bars that are said links suffice, which they do not else."""
    results = solve_once(raft(3850e3))
    proposal = gs.propose_bars(results)
    with monkeypatch.context() as without:
        nothing = NeedsOfLinks({}, ())
        without.setattr("groundslab.design.bars.proposal.propose.needs_of_links", lambda _: nothing)
        fewer = gs.propose_bars(results)
    before, after = (replace(results, model=each.model) for each in (fewer, proposal))
    failing = checks(before)[WITHIN]
    assert failing.status == "fails"
    (said,) = re.findall(r"bars in tension of ([0-9.]+) %", str(failing.words))
    assert failing.demand is not None
    # 1.5 v_Rd,c = 1.5 x 0.18 / 1.5 k (100 rho_l 35)^(1/3) at 2 d, d = 0.54 m
    k = 1 + math.sqrt(0.2 / 0.54)
    assert "at 2 d" in str(failing.words)
    assert float(said) == pytest.approx((failing.demand / (0.18 * k)) ** 3 / 35, rel=0.01)
    assert checks(after)[WITHIN].status == "no failure found"
    assert any("so that links suffice" in str(remark) for remark in proposal.remarks)
    assert fewer.laid["bottom_x"] < proposal.laid["bottom_x"]
    assert fewer.laid["top_x"] == proposal.laid["top_x"]
