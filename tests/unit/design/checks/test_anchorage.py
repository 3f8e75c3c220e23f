"""Bars of zones are to go on beyond where they are needed: by their anchorage and the shift of moments."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.design.bars.required_bars import largest_areas, required_areas
from groundslab.design.checks import DesignCheck, check_design
from groundslab.design.checks.anchorage import NAME
from groundslab.design.rules.combinations import ultimate_results
from groundslab.model.model import Model
from helpers.calculations import follow_steps
from helpers.solve_once import solve_once

#: Areas of the base and of a zone of 16 mm between it, all 0.15 m apart [m2/m].
BASE, MORE = (np.pi * phi**2 / 4 / 0.15 for phi in (0.012, 0.016))
GRID = {key: {"diameter": 0.012, "spacing": 0.15} for key in ("bottom_x", "bottom_y", "top_x", "top_y")}
EN: dict[str, Any] = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.05, 0.066), "top": (0.05, 0.066), **GRID}
#: Along y the base is thick enough.
EN["bottom_y"] = {"diameter": 0.025, "spacing": 0.10}
D = 0.45
#: l_b,rqd = phi / 4 f_yd / f_bd, f_bd = 2.25 * 0.7 * 0.3 * 30^(2/3) / 1.5.
L_RQD = 0.016 / 4 * (500 / 1.15) / (2.25 * 0.7 * 0.3 * 30 ** (2 / 3) / 1.5)


def raft(half: float, **steel: Any) -> Model:
    """Return a strip of 8 m by 3 m by 0.5 m under a column, with additional bars up to a length from its middle."""
    zone = {
        "name": "more", "layers": ["bottom_x"], "diameter": 0.016, "spacing": 0.15,
        "shape": {"kind": "rectangle", "x": (-half, half), "y": (-1.5, 1.5)},
    }  # fmt: skip
    return Model(
        plate={"length_x": 8.0, "length_y": 3.0, "thickness": 0.5, "E": 33e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 30e6},
        columns=[{"name": "A", "x": 0, "y": 0, "width_x": 0.4, "width_y": 0.4}],
        cases=[{"name": "G"}],
        loads=[{"kind": "point", "case": "G", "column": "A", "P": 900e3}],
        combinations=[{"name": "U", "factors": {"G": 1.35}}],
        reinforcement=EN | {"zones": [zone]} | steel,
        mesh={"size": 0.2},
    )


def anchored(model: Model) -> DesignCheck | None:
    """Return the check, if there is one."""
    return next((check for check in check_design(solve_once(model)).checks if check.name == NAME), None)


def required(model: Model) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]:
    """Return nodes and what bars along x at the bottom need there [m2/m]."""
    results = ultimate_results(solve_once(model))
    steel = model.reinforcement
    assert steel is not None
    return results[0].plate.nodes, largest_areas(required_areas(steel, results), "bottom_x")[0]


def test_bars_that_end_too_early_fail() -> None:
    """By hand: needed is no more than the base and (x_e - x - a_l) / l_bd of the zone's bars, at every node."""
    # c_d = min(0.05 - 0.008, half of 0.075 - 0.016) = 29.5 mm
    alpha_2 = max(0.7, 1 - 0.15 * (0.0295 - 0.016) / 0.016)
    l_bd = alpha_2 * L_RQD
    nodes, needed = required(raft(2.0))
    worst = {}
    for half in (1.0, 1.5, 2.0, 2.5):
        share = np.clip((half - abs(nodes[:, 0]) - D) / l_bd, 0, 1)
        counts = (needed <= BASE + MORE) & (abs(nodes[:, 0]) <= half)
        worst[half] = float((needed / (BASE + MORE * share))[counts].max())
        check = anchored(raft(half))
        assert check is not None
        outside = float((needed[abs(nodes[:, 0]) > half] / BASE).max())
        assert check.utilization == pytest.approx(max(worst[half], outside if outside <= 1 else 0.0), rel=1e-3)
        assert check.status == ("fails" if worst[half] > 1 else "no failure found")
        known = follow_steps(check.steps)
        assert known["A_d"] == pytest.approx(check.resistance)
        assert known.get("l_b,2", l_bd) == pytest.approx(l_bd)
    assert worst[1.0] > 1 > worst[2.5]


def test_edges_hold_bars() -> None:
    """A zone all along the slab ends at its edges, where U bars hold it; without them it does not."""
    whole = anchored(raft(4.0))
    assert whole is not None
    assert whole.status == "no failure found"
    bare = anchored(raft(4.0, detailing={"edge_bars": False}))
    assert bare is not None
    assert bare.status == "fails"
    assert abs(bare.place[0]) > 3.0  # type: ignore[index]


def test_what_has_no_zones_has_no_such_check() -> None:
    """Then the headline says that anchorage is not checked; with the check it does not."""
    assert anchored(raft(2.0, zones=[])) is None
    assert (
        "anchorage is not checked"
        in check_design(solve_once(raft(2.0, zones=[], bottom_x={"diameter": 0.025, "spacing": 0.1}))).headline
    )
    assert anchored(raft(2.0, code="EN 1992-1-1:2023")) is None
    assert "anchorage" not in check_design(solve_once(raft(2.5))).headline


@pytest.mark.parametrize("steel", [{}, {"code": "ACI 318", "f_yk": 420e6}], ids=["EN 1992", "ACI 318"])
def test_bars_that_are_proposed_are_anchored(steel: dict[str, Any]) -> None:
    """Zones of a proposal go on as far as is needed."""
    model = raft(2.0, **steel)
    proposal = gs.propose_bars(solve_once(model))
    assert proposal.reinforcement.zones
    check = anchored(proposal.model)
    assert check is not None
    assert check.status == "no failure found", check.words
