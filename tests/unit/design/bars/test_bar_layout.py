"""Bars one by one, counted by hand on simple slabs, and the table of what they weigh."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from shapely import box

from groundslab.design.bars.bar_layout import bar_sets, straight_bars
from groundslab.design.bars.positions import MOST_LENGTHS
from groundslab.model.model import Model
from groundslab.views.tables.bar_quantities import bars


def model(plate: dict[str, Any], **steel: Any) -> Model:
    """Return a slab with 10/200 in all layers."""
    base = {"diameter": 0.010, "spacing": 0.2}
    laid = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), base)
    return Model(
        plate={"thickness": 0.3, "E": 30e9, "nu": 0.2, **plate},
        ground={"kind": "winkler", "k": 20e6},
        cases=[{"name": "G"}],
        loads=[{"kind": "uniform", "q": 1e4, "case": "G"}],
        combinations=[{"name": "ULS", "factors": {"G": 1.35}}],
        reinforcement={"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05), **laid, **steel},
    )


RECTANGLE = {"length_x": 6, "length_y": 4, "openings": [{"kind": "rectangle", "x": (-1, 0), "y": (0, 1)}]}
L_SHAPE = {"outline": {"kind": "polygon", "points": [(0, 0), (6, 0), (6, 2), (2, 2), (2, 5), (0, 5)]}}


def rows(of: Model, layer: str) -> list[tuple[Any, ...]]:
    """Return number, length and total length of the rows of a layer, and their mass."""
    names = ("layer", "number", "least length", "greatest length", "total length", "mass")
    table = bars(of)
    found = zip(*(table[name] for name in names), strict=True)
    return [row[1:] for row in found if row[0] == layer]


def test_rectangle_with_an_opening_by_hand() -> None:
    """4 m hold 20 bars along x, the outer ones 0.1 m from the edges; an opening 1 m high cuts 5 of them into 2 + 3 m.

    6 m hold 30 along y, of which the opening, 1 m wide, cuts 5 into 2 + 1 m.
    """
    plate = model(RECTANGLE)
    kg = 7850 * np.pi / 4 * 0.01**2
    assert kg == pytest.approx(0.617, abs=5e-4)  # the mass of a bar of 10 mm in every table
    wanted = [(15, 6, 6, 90, 90 * kg), (5, 3, 3, 15, 15 * kg), (5, 2, 2, 10, 10 * kg)]
    assert rows(plate, "bottom x") == [pytest.approx(row) for row in wanted]
    wanted = [(25, 4, 4, 100, 100 * kg), (5, 2, 2, 10, 10 * kg), (5, 1, 1, 5, 5 * kg)]
    assert rows(plate, "top y") == [pytest.approx(row) for row in wanted]
    # all of it, over 24 - 1 m2
    (total,) = rows(plate, "all layers")
    assert total[0] == 2 * (25 + 35)
    assert total[3:] == pytest.approx((460, 460 * kg))
    assert bars(plate)["mass per area"][-1] == pytest.approx(460 * kg / 23)
    first = bar_sets(plate)[0].ends
    assert first[0] == pytest.approx(np.array([[-3, -1.9], [3, -1.9]]))


def test_l_shape_by_hand() -> None:
    """Along x 10 bars of 6 m below y = 2 m, 15 of 2 m above; along y 10 of 5 m up to x = 2 m, then 20 of 2 m."""
    plate = model(L_SHAPE)
    assert [row[:4] for row in rows(plate, "top x")] == [pytest.approx(row) for row in ((10, 6, 6, 60), (15, 2, 2, 30))]
    assert [row[:4] for row in rows(plate, "top y")] == [pytest.approx(row) for row in ((10, 5, 5, 50), (20, 2, 2, 40))]


def test_zones_are_clipped_and_have_rows_of_their_own() -> None:
    """A zone 2 m x 1 m that reaches 1 m over the edge has 5 bars of 1 m along x and 5 of 1 m along y, at 200 mm."""
    shape = {"kind": "rectangle", "x": (2, 4), "y": (-1.5, -0.5)}
    zone = {"name": "Z", "shape": shape, "layers": ["bottom_x", "bottom_y"], "mesh": "A393"}
    plate = model({"length_x": 6, "length_y": 4}, zones=[zone])
    found = {each.layer: each for each in bar_sets(plate) if each.zone == "Z"}
    assert set(found) == {"bottom_x", "bottom_y"}
    for each in found.values():
        assert each.lengths == pytest.approx(np.ones(5))
        assert (each.mesh, each.bars.diameter) == ("A393", 0.010)


def test_bars_over_a_width_that_is_no_multiple() -> None:
    """3.05 m / 150 mm = 20.3: 21 bars, the outer ones (3.05 - 20 x 0.15) / 2 = 25 mm from the edges; 0.1 m: one bar."""
    found = straight_bars(box(0, 0, 2, 3.05), 0, 0.15)
    assert found[:, 0, 1] == pytest.approx(0.025 + 0.15 * np.arange(21))
    assert straight_bars(box(0, 0, 2, 0.1), 0, 0.15).tolist() == [[[0, 0.05], [2, 0.05]]]


def test_area_of_all_bars_is_that_of_the_slab() -> None:
    """Length times spacing is the slab's area but for what one bar at each border is off, on a circle with a hole."""
    round_slab = model({"outline": {"kind": "circle", "radius": 5}, "openings": [{"kind": "circle", "radius": 1}]})
    for each in bar_sets(round_slab):
        assert each.lengths.sum() * each.bars.spacing == pytest.approx(np.pi * 24, rel=0.01)
    (row,) = rows(round_slab, "bottom x")  # more lengths than MOST_LENGTHS
    assert row[1] < row[2] <= 10
    assert MOST_LENGTHS < 25


def test_bars_along_the_edge_of_an_opening_are_whole() -> None:
    """A bar that runs along the edge of an opening is one bar, not one for each of the edge's corners."""
    found = straight_bars(box(0, 0, 6, 3).difference(box(2, 0.5, 3, 1.5)), 0, 1.0)
    assert found[:, 0, 1] == pytest.approx([0.5, 1.5, 2.5])
    assert np.ptp(found[:, :, 0], axis=1) == pytest.approx(np.full(3, 6))
