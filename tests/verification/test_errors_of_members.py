"""Told errors of the checks of ribs, beams and walls against what they are on a much finer mesh."""

from __future__ import annotations

from typing import Any

import pytest

import groundslab as gs

BARS: dict[str, Any] = {"concrete": "C30/37", "steel": "B500B", "bottom": (0.04, 0.05), "top": (0.04, 0.05)}
RIB = {"kind": "rib", "width": 0.4, "height": 0.4, "effective_width": 1.0}
STRIP: dict[str, Any] = {
    "plate": {"length_x": 12.0, "length_y": 1.0, "thickness": 0.4, "E": 30e9, "nu": 0.0},
    "ground": {"kind": "winkler", "k": 1.0},
    "contact": {"tensionless": False},
    "supports": [{"kind": "line", "points": [(x, -0.5), (x, 0.5)], "acts": "both ways"} for x in (-6.0, 0.0, 6.0)],
    "loads": [{"kind": "uniform", "case": "G", "q": 150e3}],
}
RAFT: dict[str, Any] = {
    "plate": {"length_x": 8.0, "length_y": 6.0, "thickness": 0.3, "E": 30e9, "nu": 0.2},
    "ground": {"kind": "winkler", "k": 20e6},
}
WALL = {"thickness": 0.25, "E": 30e9, "nu": 0.2}
COLUMN = {"name": "C", "x": 1.0, "y": 0.5, "width_x": 0.4, "width_y": 0.4}
MODELS: dict[str, dict[str, Any]] = {
    "continuous rib": STRIP | {"beams": [{"name": "R", "points": [(-6.0, 0.0), (6.0, 0.0)], "section": RIB}]},
    "crossing beams under a column": RAFT
    | {
        "columns": [COLUMN],
        "beams": [
            {"name": "X", "points": [(-4.0, 0.5), (4.0, 0.5)], "section": RIB | {"effective_width": 1.5}},
            {
                "name": "Y",
                "points": [(1.0, -3.0), (1.0, 3.0)],
                "section": {"kind": "rectangle", "width": 0.4, "height": 0.8},
            },
        ],
        "loads": [{"kind": "point", "case": "G", "column": "C", "P": 2e6}],
    },
    "walls": RAFT
    | {
        "walls": [
            {"name": "W", "points": [(-2.0, 0.5), (3.0, 0.5)], **WALL, "height": 2.5},
            {
                "name": "V",
                "points": [(-2.0, -2.0), (-2.0, 2.0)],
                "thickness": 0.25,
                "height": 1.5,
                "E": 30e9,
                "nu": 0.2,
            },
        ],
        "loads": [
            {"kind": "line", "case": "G", "wall": "W", "q": 270e3},
            {"kind": "point", "case": "G", "x": 3.0, "y": 0.5, "P": 540e3},
        ],
    },
}


def checks(model: dict[str, Any], size: float) -> dict[str, Any]:
    """Return the checks of members on elements of a size [m]."""
    parts = {
        "cases": [{"name": "G"}],
        "combinations": [{"name": "U", "factors": {"G": 1.0}, "limit_state": "ultimate"}],
        "reinforcement": BARS,
        "mesh": {"size": size},
    }
    made = gs.check_design(gs.solve(gs.Model(**model | parts))).checks
    return {check.name: check for check in made if check.name in ("webs of beams", "flanges", "walls")}


@pytest.mark.slow
@pytest.mark.parametrize("name", MODELS)
def test_the_told_error_covers_what_a_much_finer_mesh_changes(name: str) -> None:
    """On elements of 0.4 m each demand is within its error of that on 0.16 m; errors are below demands, not 0."""
    coarse, fine = checks(MODELS[name], 0.4), checks(MODELS[name], 0.16)
    assert coarse.keys() == fine.keys()
    assert coarse
    for check, found in coarse.items():
        assert abs(found.demand - fine[check].demand) <= found.error, check
        assert 1e-3 * found.demand < found.error < found.demand, check
