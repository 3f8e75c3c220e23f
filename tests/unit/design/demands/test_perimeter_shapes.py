"""How control perimeters run: around, at an edge, at a corner, across the slab; and beta of each."""

from __future__ import annotations

import numpy as np
import pytest
from shapely import get_coordinates

import groundslab as gs
from groundslab.design.checks import check_design
from groundslab.design.codes.en1992_2004 import punching as en1992
from groundslab.design.codes.en1992_2004.checks.governing_perimeters import reduced_share
from groundslab.design.demands.line_properties import course, cuts_strips
from groundslab.design.demands.perimeters import RectangularColumn
from groundslab.views.tables.result_tables import tables_of


def legs(*points: tuple[float, float]) -> np.ndarray:
    """Return the straight pieces through points."""
    return np.array([(points[i], points[i + 1]) for i in range(len(points) - 1)], dtype=float)


@pytest.mark.parametrize(
    ("line", "shape"),
    [
        (legs((1, 0), (1, 1), (0, 1), (0, 0), (1, 0)), "closed"),
        (legs((0, -1), (1, -1), (1, 1), (0, 1)), "edge"),
        (legs((1, 0), (1, 1), (0, 1)), "corner"),
        (legs((1, -1), (1.1, 0), (1, 1)), "cut"),
        (np.concatenate([legs((1, -1), (1, 1)), legs((-1, 1), (-1, -1))]), "cut"),
    ],
)
def test_a_perimeter_is_told_by_how_far_it_turns(line: np.ndarray, shape: str) -> None:
    """All around, half around, a quarter, hardly."""
    assert course(line, np.eye(2)).shape == shape


def test_what_is_between_small_openings_is_no_strip() -> None:
    """Two cuts, or four across the arms of a crossing, leave strips; four quarters around a column do not."""
    two = np.concatenate([legs((1, -1), (1, 1)), legs((-1, 1), (-1, -1))])
    assert cuts_strips(two)
    assert cuts_strips(np.concatenate([two, 0.9 * two[:, :, ::-1]]))
    assert not cuts_strips(legs((1, -1), (1, 1)))
    arc = np.radians([5, 25, 45, 65, 85])
    quarter = np.column_stack([np.cos(arc), np.sin(arc)])
    sides = [quarter, quarter @ [[0, 1], [-1, 0]], -quarter, quarter @ [[0, -1], [1, 0]]]
    assert not cuts_strips(np.concatenate([legs(*map(tuple, side)) for side in sides]))


def test_the_reduced_perimeter_at_an_edge() -> None:
    """Figure 6.20a: of the legs across the edge half of the column's side counts, from the inner face."""
    column = RectangularColumn(0.2, 0.0, 0.4, 0.6)
    u = legs((0, -1), (1.2, -1), (1.2, 1), (0, 1))
    way, footprint = course(u, column.axes), get_coordinates(column.footprint())
    assert np.abs(way.frame[0]) == pytest.approx([0, 1])
    assert way.inward == pytest.approx(np.array([[1, 0], [1, 0]]))
    # from x = 0.4 - 0.2 on: two legs of 1.0 m and one of 2 m, of 4.4 m
    assert reduced_share(u, footprint, way, 0.5) == pytest.approx(4.0 / 4.4)
    assert reduced_share(u, footprint, way, 0.1) == pytest.approx((2 * 0.95 + 2) / 4.4)


def test_beta_at_an_edge_by_hand() -> None:
    """6.44: V (u1 / u1* + k M u / (V W)) of the moment along the edge."""
    expected = 200e3 * (1.25 + 0.6 * 30 * 4 / (200 * 2))
    assert en1992.raised_at_an_edge(0.8, -30e3, 0.6, 200e3, 4.0, 2.0) == pytest.approx(expected)


def footing(x: float, length: float, width: float) -> gs.Model:
    """Return a footing with one column at x."""
    return gs.Model(
        plate=gs.Plate(length_x=length, length_y=width, thickness=0.6, E=33e9, nu=0.2),
        ground=gs.Winkler(k=50e6),
        columns=[gs.Column(name="C", x=x, y=0, width_x=0.4, width_y=0.4)],
        cases=[gs.LoadCase(name="G")],
        loads=[gs.PointLoad(P=600e3, column="C", case="G")],
        combinations=[gs.Combination(name="ULS", factors={"G": 1.35})],
        reinforcement=gs.Reinforcement(concrete="C30/37", steel="B500B", bottom=(0.06, 0.08), top=(0.06, 0.08)),
        mesh=gs.Mesh(size=0.2),
    )


def column_row(results: gs.Results) -> dict[str, object]:
    """Return the only row of the table of columns."""
    table = next(table for table in tables_of(results) if table.name == "columns")
    return {column.name: column.values[0] for column in table.columns}


@pytest.mark.parametrize(("x", "beta"), [(0.0, 1.0), (2.8, 1.1)])
def test_beta_of_a_column_inside_and_at_an_edge(x: float, beta: float) -> None:
    """In the middle no moment is left; at an edge u1 / u1* is a little above 1, whatever bends the slab across it."""
    row = column_row(gs.solve(footing(x, 6.0, 6.0)))
    assert row["beta"] == pytest.approx(beta, abs=0.05)


def test_a_narrow_footing_is_checked_for_one_way_shear_up_to_d() -> None:
    """At 2 d the perimeter of a column in a strip cuts it from side to side: no beta, but shear at d from the face."""
    narrow = gs.solve(footing(0.0, 6.0, 1.2))
    assert column_row(narrow)["beta"] is None
    found = {check.name: check for check in check_design(narrow).checks}
    assert found["punching within 2 d"].status == "no failure found"
    place = found["one-way shear"].place
    assert place is not None
    assert abs(place[0]) == pytest.approx(0.2 + 0.53, abs=0.21)
