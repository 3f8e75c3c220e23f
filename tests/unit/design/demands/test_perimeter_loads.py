"""What acts inside a perimeter: shares of the plate's edge, and what the edge's line force does."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from shapely import box

import groundslab as gs
from groundslab.design.codes.en1992_2004.perimeter_demand import RectangularColumn, demand
from groundslab.design.demands.loads.column_loads import acting_inside, shapes_around
from groundslab.design.demands.loads.edge_lengths import edge_inside
from groundslab.fem.mesh import Mesh
from groundslab.meshing.refinement import split
from helpers.plates import parted, plate_of, straight

SLAB = plate_of(straight(16, 12, 8.0, 6.0))


def length_inside(*bounds: float) -> float:
    """Return the length of the slab's edge in a box."""
    return float(edge_inside(SLAB, box(*bounds))[1].sum())


def test_lengths_of_the_edge_by_hand() -> None:
    """Along a side, around a corner, inside: what lies in the box, whether it ends on the edge or beyond it."""
    assert length_inside(1.1, 0.0, 2.3, 1.0) == pytest.approx(1.2)
    assert length_inside(1.1, -1.0, 2.3, 1.0) == pytest.approx(1.2)
    assert length_inside(0.0, 0.0, 0.7, 0.4) == pytest.approx(1.1)
    assert length_inside(1.0, 1.0, 2.0, 2.0) == 0.0
    assert length_inside(-1.0, -1.0, 9.0, 9.0) == pytest.approx(28.0)


def test_a_field_along_the_edge_is_integrated() -> None:
    """A line force quadratic in y along x = 0 has its exact integral between two places."""
    nodes, length = edge_inside(SLAB, box(-1.0, 1.3, 1.0, 2.9))
    y = SLAB.nodes[nodes, 1]
    assert length @ (2 + y - 3 * y**2) == pytest.approx(2 * 1.6 + (2.9**2 - 1.3**2) / 2 - (2.9**3 - 1.3**3))


def test_the_border_of_two_sections_is_no_edge() -> None:
    """Along a change of thickness nodes stand twice, and no edge is between them."""
    plate = plate_of(parted(straight(16, 12, 8.0, 6.0), 4.0)[0])
    assert edge_inside(plate, box(3.0, 1.0, 5.0, 2.0))[1].sum() == 0.0
    assert edge_inside(plate, box(3.0, -1.0, 5.0, 2.0))[1].sum() == pytest.approx(2.0)


def test_sides_on_which_nodes_hang_are_no_edge() -> None:
    """A larger element's side inside the plate belongs to it alone, and so do its neighbors' halves of it."""
    mesh = straight(16, 12, 8.0, 6.0)
    plate = plate_of(split(mesh, mesh.nodes[mesh.elements[:, 8], 0] > 4.0)[0])
    assert edge_inside(plate, box(3.0, 1.0, 5.0, 2.0))[1].sum() == 0.0
    nodes, length = edge_inside(plate, box(3.0, -1.0, 5.0, 2.0))
    assert length.sum() == pytest.approx(2.0)
    assert not plate.nodes[nodes, 1].any()


def test_a_curved_edge() -> None:
    """On an element with sides that are parabolas, the edge's length is that of the parabolas."""
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    middles = np.array([[0, -1.4], [1.4, 0], [0, 1.4], [-1.4, 0]])
    plate = plate_of(Mesh(np.vstack([corners, middles, [[0, 0]]]), np.arange(9)[None]))
    t = (np.arange(100_000) + 0.5) / 50_000 - 1
    assert edge_inside(plate, box(-3, -3, 3, 3))[1].sum() == pytest.approx(
        4 * np.hypot(1, 0.8 * t).sum() / 50_000, rel=1e-4
    )


def test_shares_are_those_of_results() -> None:
    """Of a plate that was solved, the shares of the whole edge are those by which its line force is told."""
    model = gs.Model(
        plate={"length_x": 6, "length_y": 4, "thickness": 0.3, "E": 30e9, "nu": 0.2},
        ground={"kind": "pasternak", "k0": 10e6, "k1": 5e6},
        loads=[{"kind": "uniform", "q": 20e3}],
        mesh={"size": 0.5},
    )
    plate = gs.solve(model).only.plate
    nodes, length = edge_inside(plate, box(-9, -9, 9, 9))
    assert length == pytest.approx(plate.edge_length[nodes])
    assert length.sum() == pytest.approx(20.0)


@pytest.mark.parametrize(("line_force", "taken_off"), [(30e3, 0.0), (-30e3, -30e3)])
def test_the_edge_force_relieves_only_if_it_is_said_to(line_force: float, taken_off: float) -> None:
    """What pushes up along the edge is not taken off unless it is said to be; what pulls there is added."""
    column = RectangularColumn(0.2, 3.0, 0.4, 0.4)
    plate = replace(SLAB, line_force=np.full(len(SLAB.nodes), line_force))
    reach = 0.4 + 4 * 0.2
    free, relieved = (demand(plate, column, 0.2, 1e6, line_force_relieves=says) for says in (False, True))
    assert free.edge_inside == pytest.approx(line_force * reach)
    assert free.V_Ed == pytest.approx(1e6 - taken_off * reach)
    assert relieved.V_Ed == pytest.approx(1e6 - line_force * reach)


def test_loads_beside_a_part_are_left_out() -> None:
    """Of what acts on a part by hand nothing is lost; loads that do not reach it are not looked at."""
    model = gs.Model(
        plate={"length_x": 8, "length_y": 6, "thickness": 0.4, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        cases=[{"name": name} for name in ("G", "Q", "far")],
        loads=[
            {"kind": "uniform", "case": "G", "q": 2e3},
            {"kind": "line", "case": "G", "points": [[-2, 0.4], [3, 0.4]], "q": 30e3, "width": 0.6},
            {"kind": "point", "case": "Q", "x": 0.5, "y": -0.5, "P": 7e3},
            {"kind": "patch", "case": "Q", "x": [0.8, 2], "y": [-1, 1], "q": 1e3},
            {"kind": "line", "case": "far", "points": [[-3, 2], [3, 2]], "q": 40e3, "width": 0.6},
            {"kind": "patch", "case": "far", "x": [2, 3], "y": [-1, 1], "q": 1e3},
            {"kind": "point", "case": "far", "x": -2, "y": 0, "P": 9e3},
        ],
        combinations=[{"name": "all", "limit_state": "ultimate", "factors": {"G": 1, "Q": 1, "far": 1}}],
    )
    results, part = gs.solve(model)["all"], box(-1, -1, 1, 0.2)
    shapes = shapes_around(model, part, ())
    assert [case for case, _ in shapes] == ["G", "G", "Q", "Q"]
    inside = acting_inside(results, part, (), shapes)
    # of the line's width 0.1 m is in the part
    assert inside["G"] == pytest.approx([2e3 * 2.4 + 30e3 * 2 * 0.1 / 0.6, 0, 2e3 * 2.4 * -0.4 + 30e3 * 2 / 6 * 0.15])
    assert inside["Q"] == pytest.approx([7e3 + 240, 3.5e3 + 240 * 0.9, -3.5e3 + 240 * -0.4])
