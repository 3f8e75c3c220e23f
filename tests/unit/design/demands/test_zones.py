"""Thicker zones as places of punching, and what counts of legs in thinner slab."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from shapely import box

from groundslab.design.demands.line_properties import centroid, moduli, total_length
from groundslab.design.demands.perimeter_loads import PunchingForce
from groundslab.design.demands.perimeter_pieces import what_counts
from groundslab.design.demands.zones.thicker_zones import ZoneForce, zone_forces
from groundslab.design.demands.zones.thinner_slab import ThinnerPart, depth_share, weighted
from groundslab.model.model import Model
from groundslab.model.structure.columns import Column
from groundslab.results.results import Results
from helpers import synthetic
from helpers.synthetic import LENGTH_X, LENGTH_Y

STEEL = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)}


def zones_of(
    columns: list[tuple[float, float]], *zones: tuple[float, float, float, float, float]
) -> tuple[ZoneForce, ...]:
    """Return the thicker zones of a plate of 0.5 m with zones x0, x1, y0, y1, thickness [m] and columns at places."""
    shapes = [
        {"thickness": t, "shape": {"kind": "rectangle", "x": [x0, x1], "y": [y0, y1]}} for x0, x1, y0, y1, t in zones
    ]
    model = Model(
        plate={"length_x": LENGTH_X, "length_y": LENGTH_Y, "thickness": 0.5, "E": 30e9, "nu": 0.2, "zones": shapes},
        ground={"kind": "winkler", "k": 20e6},
        columns=[{"name": f"C{n}", "x": x, "y": y, "width_x": 0.4, "width_y": 0.4} for n, (x, y) in enumerate(columns)],
        loads=[{"kind": "point", "P": 1.0, "column": "C0"}],
    )
    return zone_forces(Results(model, (), {"all": synthetic.results(24, model=model)}, {}))


def test_zones_that_touch_or_overlap_are_one() -> None:
    """Of the same thickness, with the columns of both; apart they are two."""
    (touching,) = zones_of([(-0.6, 0), (0.6, 0)], (-1.2, 0, -0.6, 0.6, 0.8), (0, 1.2, -0.6, 0.6, 0.8))
    (overlapping,) = zones_of([(-0.6, 0), (0.6, 0)], (-1.2, 0.4, -0.6, 0.6, 0.8), (0, 1.2, -0.6, 0.6, 0.8))
    for one in (touching, overlapping):
        assert (one.name, one.columns) == ("zones 1 and 2", ("C0", "C1"))
        assert one.region is not None
        assert one.region.bounds == pytest.approx((-1.2, -0.6, 1.2, 0.6))
        assert one.region.area == pytest.approx(2.4 * 1.2)
    apart = zones_of([(-1, 0), (1, 0)], (-1.6, -0.4, -0.6, 0.6, 0.8), (0.4, 1.6, -0.6, 0.6, 0.8))
    assert [(one.name, one.columns) for one in apart] == [("zone 1", ("C0",)), ("zone 2", ("C1",))]


def test_a_zone_beside_a_less_thick_one_has_its_depth_there() -> None:
    """The slab around counts where it is thickest; perimeters count less where it is thinner."""
    beside = zones_of([(-0.6, 0)], (-1.2, 0, -0.6, 0.6, 1.0), (0, 1.2, -0.6, 0.6, 0.8))
    assert [(one.name, one.around) for one in beside] == [("zones 1 and 2", 0.5), ("zone 1", 0.8)]


def test_zones_in_two_parts_are_told_apart_by_their_columns() -> None:
    """A zone that a thinner one cuts in two."""
    two = zones_of([(-1, 0), (1, 0)], (-1.6, 1.6, -0.6, 0.6, 0.8), (-0.4, 0.4, -0.6, 0.6, 0.5))
    assert sorted(one.name for one in two) == ["zone 1 at C0", "zone 1 at C1"]


def test_a_column_on_the_border_is_on_no_zone() -> None:
    """It has the thickness of the slab, which it stands on in part."""
    assert not zones_of([(1.2, 0)], (-1.2, 1.2, -0.6, 0.6, 0.8))


def test_a_pit_in_a_zone_is_none_of_its_border() -> None:
    """The zone is loaded with the pit; the slab around is what is thinner outside."""
    (one,) = zones_of([(-0.8, 0)], (-1.2, 1.2, -1.2, 1.2, 0.8), (0, 0.8, -0.6, 0.6, 0.3))
    assert one.around == 0.5
    assert one.region is not None
    assert one.region.area == pytest.approx(2.4**2)


class _Force(PunchingForce):
    """A force that pushes as it is told."""

    def pushing(self, results: Any) -> np.ndarray:
        """Return force and moments."""
        return np.array(results[self.name])


def test_piles_below_a_zone_relieve_it() -> None:
    """Forces and moments about its center: those of columns, less those of piles."""
    at = {"width_x": 0.4, "width_y": 0.4}
    forces = (
        _Force(Column(name="C", x=1.5, y=2, **at), {}),
        _Force(Column(name="P", x=0.5, y=2, **at), {}, support=3),
    )
    zone = ZoneForce(Column(name="zone 1", x=1, y=1, **at), {}, region=box(0, 0, 2, 2), around=0.5, forces=forces)
    sums = zone.pushing({"C": (5.0, 1.0, 2.0), "P": (2.0, 0.25, 0.5)})
    assert sums == pytest.approx((3.0, 1.0 + 5 * 0.5 - 0.25 + 2 * 0.5, 2.0 + 5 * 1 - 0.5 - 2 * 1))
    assert (zone.columns, zone.supports) == (("C",), (3,))


def test_legs_in_thinner_slab_count_in_part() -> None:
    """Length, center and moduli are those of legs with weights, and legs elsewhere stay as they are."""
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)], dtype=float)
    legs = np.stack([corners[:-1], corners[1:]], axis=1)
    parts = (ThinnerPart(0.2, 0.0, box(0.5, -2, 2, 2)), ThinnerPart(0.3, 0.0, box(-2, -2, -1.5, 2)))
    kept = what_counts(weighted(legs, parts, depth_share, 1.0, 0.5))
    w = 0.6
    total = 2 + 2 * 1.5 + w * (2 * 0.5 + 2)
    assert total_length(kept) == pytest.approx(total)
    first = -1 * 2 + 2 * 1.5 * -0.25 + w * (2 * 0.5 * 0.75 + 2)
    assert centroid(kept) == pytest.approx((first / total, 0.0))
    W_y = 2 * 1.5 + w * 2 * 0.5 + 2 * 0.5 + w * 1
    assert moduli(kept, np.zeros(2))[1] == pytest.approx(W_y, rel=1e-3)
    assert what_counts(weighted(legs, parts[1:], depth_share, 1.0, 0.5)) is legs
