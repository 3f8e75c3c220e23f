"""Beams across the cuts of design strips: slab and beams together are in equilibrium."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.design.demands.cuts.section_cuts import carried_across
from groundslab.views.tables.result_tables import tables_of
from groundslab.views.tables.table import Table

L, WIDTH, q = 8.0, 4.0, 10e3


def span(*beams: dict[str, Any], turn: float = 0.0, **others: Any) -> gs.Results:
    """Return a plate that spans 8 m between line supports, with beams, turned by an angle, and a strip all over it."""
    c, s = math.cos(turn), math.sin(turn)

    def at(x: float, y: float) -> tuple[float, float]:
        return (c * x - s * y, s * x + c * y)

    corners = [at(x * L / 2, y * WIDTH / 2) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    strip = {"name": "S", "start": at(-L / 2, 0.0), "end": at(L / 2, 0.0), "width": WIDTH + 1, "stations": 9}
    return gs.solve(
        gs.Model(
            plate={"outline": {"kind": "polygon", "points": corners}, "thickness": 0.2, "E": 30e9, "nu": 0.2},
            ground={"kind": "winkler", "k": 1.0},
            contact={"tensionless": False},
            supports=[
                {"kind": "line", "points": [at(x, -WIDTH / 2), at(x, WIDTH / 2)], "acts": "both ways"}
                for x in (-L / 2, L / 2)
            ],
            beams=[beam | {"points": [at(*place) for place in beam["points"]]} for beam in beams],
            loads=[{"kind": "uniform", "q": q}],
            output={"strips": [strip]},
            mesh={"size": 0.25},
            **others,
        )
    )


def strips(results: gs.Results) -> Table:
    """Return the table of design strips."""
    return next(table for table in tables_of(results) if table.name == "strips")


RIB = {"kind": "rib", "width": 0.3, "height": 0.5, "effective_width": 1.0}
BEAMS: dict[str, list[dict[str, Any]]] = {
    "along": [{"name": "A", "points": [(-L / 2, 0.5), (L / 2, 0.5)], "section": RIB}],
    "backwards": [{"name": "A", "points": [(L / 2, 0.5), (-L / 2, 0.5)], "section": RIB}],
    "oblique": [{"name": "A", "points": [(-3.5, -1.5), (3.2, 1.7)], "section": RIB}],
    "eccentric": [{"name": "A", "points": [(-L / 2, 0.5), (L / 2, 0.5)], "section": RIB | {"eccentric": True}}],
}


@pytest.mark.parametrize("turn", [0.0, 0.7])
@pytest.mark.parametrize("which", list(BEAMS))
def test_slab_and_beams_together_carry_the_span(which: str, turn: float) -> None:
    """Q b s (L - s) / 2 and q b (L / 2 - s), to 2 % of the largest; half of it or so is the beam's."""
    table = strips(span(*BEAMS[which], turn=turn))
    s, M, V, of_beams, shear = (
        np.array(table[name], dtype=float) for name in ("s", "moment", "shear", "moment of beams", "shear of beams")
    )
    inner = (s > 0.5) & (s < L - 0.5)
    exact, slope = q * WIDTH * s * (L - s) / 2e3, q * WIDTH * (L / 2 - s) / 1e3
    assert np.abs(M + of_beams - exact)[inner].max() < 0.02 * exact.max()
    assert np.abs(V + shear - slope)[inner].max() < 0.03 * slope.max()
    assert of_beams[4] > 0.2 * exact[4]
    assert np.abs(M - exact)[inner].max() > 0.2 * exact.max()


def test_beams_beside_a_cut_carry_nothing_across() -> None:
    """Of a narrow cut, one along the beam, and one where the beam ends."""
    results = span(*BEAMS["along"]).only
    starts = np.array([[0.0, -1.0], [-2.0, 0.5], [-4.0, -1.0], [0.0, 0.0]])
    ends = np.array([[0.0, 0.4], [2.0, 0.5], [-4.0, 1.0], [0.0, 1.0]])
    found = carried_across(results, starts, ends)
    assert not found[:3].any()
    assert found[3, 0] == pytest.approx(np.interp(4.0, results.beams[0].way, results.beams[0].moment))
    assert "moment of beams" not in [column.name for column in strips(span()).columns]
