"""The table of walls against rigid slabs, and against a settlement that is known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from groundslab.analysis.driver import solve
from groundslab.design.demands.loads.wall_loads import loads_on_wall, settlement_along
from groundslab.model.model import Model
from groundslab.model.structure.walls import Wall
from groundslab.views.report.table_layout import keys_of, layout_table, split_columns
from groundslab.views.tables.structure.walls import wall_table

A, B, K, Q = 6.0, 4.0, 20e6, 100e3
LINE = {"name": "W1", "thickness": 0.2, "points": [(-2.0, 0.0), (2.0, 0.0)]}
RING = {"name": "R", "thickness": 0.2, "shape": {"kind": "circle", "radius": 1.0}}


def model(**changes: object) -> Model:
    """Return a rigid slab under two cases of loads on two walls."""
    parts: dict[str, object] = {
        "plate": {"length_x": A, "length_y": B, "thickness": 1.0, "E": 3e15, "nu": 0.2},
        "ground": {"kind": "winkler", "k": K},
        "walls": [LINE, RING],
        "cases": [{"name": "G"}, {"name": "W", "action": "variable"}],
        "loads": [
            {"kind": "line", "q": Q, "q_end": 2 * Q, "wall": "W1", "case": "G"},
            {"kind": "line", "q": -Q / 4, "wall": "W1", "case": "W"},
            {"kind": "line moment", "m": 3e3, "wall": "W1", "case": "W"},
            {"kind": "line", "q": Q / 10, "wall": "R", "case": "G"},
            {"kind": "uniform", "q": 10e3, "case": "G"},
        ],
        "combinations": [{"name": "ULS", "factors": {"G": 1.5, "W": 2.0}}],
        "mesh": {"size": 0.5},
    }
    return Model(**parts | changes)


def test_parts_of_the_table_on_paper_say_which_wall(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where it is cut, each part begins with combination and wall."""
    monkeypatch.setattr("groundslab.views.report.table_layout.MOST_COLUMNS", 8)
    table = wall_table(solve(model()))
    parts = split_columns(layout_table(table), keys_of(table))
    assert len(parts) > 1
    for part in parts:
        assert [head.text for head in part.heads[:2]] == ["combination", "wall"]
        assert [row[1].text for row in part.rows] == ["W1", "R"]


def test_the_row_of_a_rigid_slab_follows_from_statics() -> None:
    """Q from 1.5 Q - 0.5 Q to 3 Q - 0.5 Q; w by the sum of all forces and their moments about both axes."""
    table = wall_table(solve(model()))
    rows = [dict(zip([column.name for column in table.columns], row, strict=True)) for row in table.rows()]
    line, ring = rows
    assert (line["wall"], ring["wall"], line["combination"]) == ("W1", "R", "ULS")
    assert (line["least load per length"], line["greatest load per length"]) == pytest.approx((Q / 1e3, 2.5 * Q / 1e3))
    assert line["load"] == pytest.approx(4 * 1.75 * Q / 1e3)
    assert line["moment per length"] == pytest.approx(6.0)
    assert ring["load"] == pytest.approx(2 * np.pi * 0.15 * Q / 1e3)
    total = 1e3 * (line["load"] + ring["load"]) + 1.5 * 10e3 * A * B
    mean = total / (K * A * B)
    # int q x ds over 4 m of a q that grows by 1.5 Q
    tilt = (1.5 * Q * 4**2 / 12) / (K * B * A**3 / 12)
    assert line["settlement at the start"] == pytest.approx(1e3 * (mean - 2 * tilt), rel=1e-6)
    assert line["settlement at the end"] == pytest.approx(1e3 * (mean + 2 * tilt), rel=1e-6)
    assert line["greatest settlement"] == line["settlement at the end"]
    assert abs(line["deflection"]) < 1e-6
    assert ring["deflection"] is None
    assert ring["settlement at the start"] is None
    across = 6e3 * 4 / (K * A * B**3 / 12)
    farthest = float(np.hypot(tilt, across))
    assert ring["greatest settlement"] == pytest.approx(1e3 * (mean + farthest), rel=1e-3)


def test_a_wall_that_sags_is_told_from_one_that_hogs() -> None:
    """W = c x^2 (hogging with c > 0, as the ends settle more): off the chord by -4 c in the middle of 4 m."""
    results = next(iter(solve(model()).values()))
    plate, c = results.plate, 1e-3
    along = settlement_along(results.model, Wall(**LINE))
    for sign in (1, -1):
        bent = replace(plate, settlement=sign * c * plate.nodes[:, 0] ** 2)
        assert along(replace(results, plate=bent)).deflection == pytest.approx(-sign * 4 * c, rel=1e-6)


def test_only_loads_that_name_the_wall_count() -> None:
    """By load case, at both ends."""
    m = model()
    loads = loads_on_wall(m, m.walls[0])
    assert {case: tuple(*ends) for case, ends in loads.force.items()} == {"G": (Q, 2 * Q), "W": (-Q / 4, -Q / 4)}
    assert tuple(*loads.couple["W"]) == (3e3, 3e3)
