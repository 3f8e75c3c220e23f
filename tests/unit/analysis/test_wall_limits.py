"""Limits of walls: the same slab with none and with all of the stiffness of its walls."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.errors import InputError
from groundslab.views.files import npz
from groundslab.views.report.html import render_report
from groundslab.views.tables.result_tables import tables_of

WALL = {"name": "W", "thickness": 0.25, "height": 3.0, "points": [(-3.0, 0.0), (3.0, 0.0)]}


def model(**changes: Any) -> gs.Model:
    """Return a raft under a wall."""
    return gs.Model(
        plate={"length_x": 10.0, "length_y": 8.0, "thickness": 0.4, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        walls=[WALL | {"stiffness": 0.5} | changes.pop("wall", {})],
        cases=[{"name": "G"}, {"name": "Q"}],
        loads=[{"kind": "line", "wall": "W", "q": 3e5, "case": "G"}, {"kind": "uniform", "q": 1e4, "case": "Q"}],
        **{"output": {"wall_limits": True}, "mesh": {"size": 0.5}} | changes,
    )


@pytest.fixture(scope="module")
def results() -> gs.Results:
    """Return the results with limits."""
    return gs.solve(model())


def test_limits_are_those_of_the_case_without_and_with_all_stiffness(results: gs.Results) -> None:
    """By themselves: walls of next to none and of all stiffness; what is told of the case stays the same."""
    plain = gs.solve(model(output={}))
    for share, other in ((0.0, 1e-6), (1.0, 1.0)):
        alone = gs.solve(model(wall={"stiffness": other}, output={}))
        for name in ("G", "Q"):
            told = dict(results[name].wall_limits)[share]
            plate = alone[name].plate
            assert told == tuple(
                (field, pytest.approx(getattr(plate, field).min()), pytest.approx(getattr(plate, field).max()))
                for field in ("settlement", "moment_x", "moment_y", "pressure")
            )
    assert np.array_equal(results["G"].plate.settlement, plain["G"].plate.settlement)
    assert not plain["G"].wall_limits
    # without stiffness as without a height, on another mesh
    soft = gs.solve(model(output={}).replace(walls=[{key: value for key, value in WALL.items() if key != "height"}]))
    told = {field: (least, most) for field, least, most in dict(results["G"].wall_limits)[0.0]}
    assert told["settlement"][1] == pytest.approx(soft["G"].plate.settlement.max(), rel=1e-2)


def test_the_table_has_the_case_between_its_limits(results: gs.Results, tmp_path: Path) -> None:
    """Largest settlements fall as the wall gets stiffer; report and archive have the limits, too."""
    table = next(table for table in tables_of(results) if table.name == "wall_limits")
    assert len(table.rows()) == 8
    none, own, most = (table[f"greatest{which}"][0] for which in (" without stiffness", "", " uncracked"))
    assert none > own > most
    assert own == pytest.approx(results["G"].plate.settlement.max() * 1e3)
    assert "Limits of walls" in render_report(results)
    npz.write(results["G"], tmp_path / "results.npz")
    assert npz.load(tmp_path / "results.npz").wall_limits == results["G"].wall_limits


def test_limits_need_a_wall_with_a_height() -> None:
    """Else there are none."""
    with pytest.raises(InputError, match=r"output\.wall_limits: found true, without such a wall"):
        model(output={}).replace(walls=[], loads=[], output={"wall_limits": True})
