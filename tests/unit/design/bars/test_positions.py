"""Bars as they are cut, lapped and bent, counted by hand."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from groundslab.design.bars.positions import U_SHAPE, cut, positions
from groundslab.model.model import Model
from groundslab.views.tables.bar_quantities import bars

BASE = {"diameter": 0.012, "spacing": 0.2}


def model(length_x: float, length_y: float, **steel: Any) -> Model:
    """Return a slab, 0.3 m thick, C25/30, with 12/200 in all layers, 40 and 52 mm from the faces, and detailing."""
    laid = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), BASE)
    return Model(
        plate={"thickness": 0.3, "E": 30e9, "nu": 0.2, "length_x": length_x, "length_y": length_y},
        ground={"kind": "winkler", "k": 20e6},
        cases=[{"name": "G"}],
        loads=[{"kind": "uniform", "q": 1e4, "case": "G"}],
        combinations=[{"name": "ULS", "factors": {"G": 1.35}}],
        reinforcement={
            "f_ck": 25e6, "f_yk": 500e6, "bottom": (0.04, 0.052), "top": (0.04, 0.052), "detailing": {}, **laid, **steel
        },
    )  # fmt: skip


def test_cut_by_hand() -> None:
    """20 m of 12 m with laps of 0.5 m: two pieces of (20 + 0.5) / 2; 24 m need three of (24 + 1) / 3."""
    assert cut(12.0, 12.0, 0.5) == (1, 12.0)
    assert cut(20.0, 12.0, 0.5) == (2, pytest.approx(10.25))
    assert cut(23.5, 12.0, 0.5) == (2, pytest.approx(12.0))
    assert cut(24.0, 12.0, 0.5) == (3, pytest.approx(25 / 3))


def test_pieces_are_short_enough_and_make_up_the_bar() -> None:
    """N pieces less n - 1 laps are the bar; none is longer than delivered; one fewer would be."""
    for length in np.linspace(0.5, 100, 37):
        count, each = cut(length, 12.0, 0.8)
        assert each <= 12.0 + 1e-9
        assert count * each - (count - 1) * 0.8 == pytest.approx(length)
        assert count == 1 or (length + (count - 2) * 0.8) / (count - 1) > 12.0


def test_laps_by_hand() -> None:
    """Bars along x of a slab of 20 m x 4 m, bottom.

    4 m / 0.2 m = 20 bars; each is 20 - 2 x 0.034 = 19.932 m long, with a cover of 40 - 12 / 2 = 34 mm. l_b,rqd = 12 / 4
    x 434.78 / 2.693 = 484.3 mm, f_bd = 2.25 x 0.7 x 0.3 x 25^(2/3) / 1.5 = 2.693 MPa (8.2, 8.3); c_d = min(34, (200 -
    12) / 2) = 34 mm, alpha_2 = 1 - 0.15 (34 - 12) / 12 = 0.725; l_0 = 0.725 x 1.5 x 484.3 = 526.7 mm (8.10). So two
    pieces of (19.932 + 0.527) / 2 = 10.229 m, 40 in all.
    """
    (one,) = [p for p in positions(model(20, 4)) if p.layer == "bottom_x"]
    assert one.lap == pytest.approx(0.5267, abs=1e-4)
    assert len(one.lengths) == 40
    assert one.lengths == pytest.approx(10.2293, abs=1e-4)
    # at the top l_0 is longer: 0.26 m of concrete lie below, so that bond is poor (Figure 8.2)
    (top,) = [p for p in positions(model(20, 4)) if p.layer == "top_x"]
    assert top.lap == pytest.approx(0.5267 / 0.7, abs=1e-4)


def test_bars_at_edges_by_hand() -> None:
    """U bars of a slab of 6 m x 4 m.

    Along x 20 bars end at two edges: 40. Their legs are 2 h = 0.6 m or the lap of the top bars, 0.7524 m if that is
    more; their backs 0.3 - 2 x 0.034 = 0.232 m.
    """
    found = {p.layer: p for p in positions(model(6, 4)) if p.shape == U_SHAPE}
    assert set(found) == {"edges_x", "edges_y"}
    along_x = found["edges_x"]
    assert len(along_x.lengths) == 40
    assert along_x.lap == pytest.approx(0.7524, abs=1e-4)
    assert along_x.lengths == pytest.approx(2 * 0.7524 + 0.232, abs=2e-4)
    assert len(found["edges_y"].lengths) == 2 * 30
    assert not [p for p in positions(model(6, 4, detailing={"edge_bars": False})) if p.shape == U_SHAPE]


def test_a_zone_by_hand() -> None:
    """A zone of 16/200, x = 1 m to 3 m (the edge), y = -1 m to 1 m, at the bottom along x of a slab of 6 m x 4 m.

    2 m / 0.2 m = 10 bars from 1 m to 3 m less the cover of 40 - 16 / 2 = 32 mm: 1.968 m. They weigh 10 x 1.968 m x
    1.578 kg/m = 31.06 kg. Each has a U bar at the edge.
    """
    shape = {"kind": "rectangle", "x": (1, 3), "y": (-1, 1)}
    zone = {"name": "Z", "shape": shape, "layers": ["bottom_x"], "diameter": 0.016, "spacing": 0.2}
    straight, edge = [p for p in positions(model(6, 4, zones=[zone])) if p.zone == "Z"]
    assert len(straight.lengths) == 10
    assert straight.lengths == pytest.approx(1.968)
    assert 7850 * math.pi / 4 * 0.016**2 == pytest.approx(1.578, abs=1e-3)
    assert straight.mass == pytest.approx(31.06, abs=0.01)
    assert edge.shape == U_SHAPE
    assert len(edge.lengths) == 10


def test_marks_and_the_sum_of_the_table() -> None:
    """Marks count from 1 without gaps, and the last row has the sums of the others."""
    table = bars(model(20, 4))
    assert table["mark"] == (*range(1, len(table)), None)
    mass = [float(value or 0) for value in table["mass"]]
    assert mass[-1] == pytest.approx(sum(mass[:-1]))
    assert table["mass"][-1] == pytest.approx(sum(position.mass for position in positions(model(20, 4))))


def test_meshes_are_not_cut() -> None:
    """A welded mesh has neither laps nor bars of U shape in the list."""
    meshes = {"bottom_mesh": "A393", "top_mesh": "A393"} | dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"))
    of_mesh = positions(model(20, 4, **meshes))
    assert {position.shape for position in of_mesh} == {"straight"}
    assert {position.lap for position in of_mesh} == {None}
    assert max(position.lengths.max() for position in of_mesh) == pytest.approx(20)
