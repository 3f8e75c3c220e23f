"""How many products with the operator the contact on an elastic continuum takes, from the coarsest grid upwards."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab import Model, solve
from groundslab.solvers import bounded_forces
from groundslab.solvers.bounded_forces import BoundedForces, BoundedSolution

LAYER = {"kind": "continuum", "layers": [{"E": 20e6, "nu": 0.3, "thickness": 5.0}]}
HALF_SPACE = {"kind": "continuum", "half_space": {"E": 20e6, "nu": 0.3}}
#: The coarsest grid starts from nothing; grids of many cells start well.
COLD, FROM_COARSER, MANY = 60, 25, 3000


def floor(q: float, loads: list[dict[str, Any]]) -> dict[str, Any]:
    """Return a floor of 24 m x 24 m under its own load and others."""
    plate = {"length_x": 24.0, "length_y": 24.0, "thickness": 0.2, "E": 30e9, "nu": 0.2}
    return {"plate": plate, "ground": LAYER, "loads": [patch(0, 0, 24, q), *loads], "mesh": {"counts": (60, 60)}}


def patch(x: float, y: float, side: float, q: float) -> dict[str, Any]:
    """Return a pressure on a square about x and y."""
    h = side / 2
    return {"kind": "patch", "q": q, "x": (x - h, x + h), "y": (y - h, y + h)}


RACKS = [patch(x, y, 0.3, 8e5) for x in np.arange(-9, 10, 3.0) for y in np.arange(-9, 10, 2.7)]
L_RAFT = [(0, 0), (20, 0), (20, 8), (8, 8), (8, 16), (0, 16)]
COLUMNS = [patch(x, y, 0.6, 1e6) for x, y in ((1, 1), (19, 1), (19, 7), (1, 15), (7, 15))]
SLABS: dict[str, dict[str, Any]] = {
    "wheel on a light floor": floor(500.0, [patch(11.15, 11.15, 0.3, 1e6)]),
    "racks": floor(1e3, RACKS),
    "L-shaped raft": {
        "plate": {"outline": {"kind": "polygon", "points": L_RAFT}, "thickness": 0.4, "E": 30e9, "nu": 0.2},
        "ground": HALF_SPACE,
        "loads": [{"kind": "uniform", "q": 2e3}, *COLUMNS],
        "mesh": {"size": 0.25},
    },
    "eccentric raft": {
        "plate": {"length_x": 12.0, "length_y": 8.0, "thickness": 0.3, "E": 30e9, "nu": 0.2},
        "ground": HALF_SPACE,
        "loads": [{"kind": "uniform", "q": 1e3}, patch(4, 2, 1, 2e6)],
        "mesh": {"counts": (90, 60)},
    },
}


@pytest.mark.slow
@pytest.mark.parametrize("name", SLABS)
def test_products(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """At most 60 on the coarsest grid, which starts from nothing, and 25 on grids of 3,000 cells and more."""
    taken: list[tuple[int, int]] = []
    iterate = bounded_forces.solve

    def counted(p: BoundedForces, *arguments: Any) -> BoundedSolution:
        found = iterate(p, *arguments)
        taken.append((len(p.lower), found.products))
        return found

    monkeypatch.setattr(bounded_forces, "solve", counted)
    solve(Model.model_validate(SLABS[name]))
    many = [products for forces, products in taken if forces >= MANY]
    assert len(many) >= 2
    assert max(many) <= FROM_COARSER, taken
    assert taken[0][1] <= COLD, taken
