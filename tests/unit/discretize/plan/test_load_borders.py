"""Borders of loads that adaptive meshes follow: which of them, and how."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab.discretize.discretize import discretize
from groundslab.discretize.plan_layout import plan_of
from groundslab.discretize.symmetry import symmetries
from groundslab.fem.hanging import find_hanging
from groundslab.fem.mesh import sides_along
from groundslab.geometry.plan import Plan, Segment
from groundslab.model.loads.acting import rings_of
from groundslab.model.model import Model
from groundslab.model.remarks.singular_places import singular_places

COLUMN = {"kind": "point", "P": 1e5, "x": 1.0, "y": 0.5, "width_x": 0.4, "width_y": 0.4}
WALL = {"kind": "line", "q": 1e4, "points": [(-4.0, -1.0), (0.0, -1.0)]}


def slab(*loads: dict[str, Any], openings: Any = (), **mesh: Any) -> Model:
    """Return a slab of 10 m x 6 m."""
    plate = {"length_x": 10.0, "length_y": 6.0, "thickness": 0.2, "E": 30e9, "nu": 0.2, "openings": openings}
    given = {"plate": plate, "ground": {"kind": "winkler", "k": 5e7}, "loads": loads, "mesh": mesh}
    return Model.model_validate(given)


def plan(*loads: dict[str, Any], **parts: Any) -> Plan:
    """Return the plan of a slab's mesh."""
    model = slab(*loads, **parts)
    return plan_of(model, symmetries(model), 0.0)


def test_footprints_areas_and_lines_are_followed() -> None:
    """By an adaptive mesh alone; the borders of an area with a hole are two."""
    hole = [{"kind": "circle", "centre": (3.0, -1.5), "radius": 0.3}]
    area = {"kind": "area", "q": 1e4, "shape": {"kind": "rectangle", "x": (2.0, 4.0), "y": (-2.5, -0.5)}, "holes": hole}
    found = plan(COLUMN, WALL, area, {"kind": "uniform", "q": 1e3})
    model = slab(COLUMN, area)
    assert found.borders == tuple(ring for _, shape in model.acting for ring in rings_of(shape))
    assert found.lines == (((-4.0, -1.0), (0.0, -1.0)),)
    given = plan(COLUMN, WALL, area, size=0.5)
    assert not given.borders
    assert not given.lines


@pytest.mark.parametrize(("gap", "count"), [(0.09, 1), (0.11, 2), (0.0, 2)])
def test_what_passes_closely_is_not_followed(gap: float, count: int) -> None:
    """A footprint of 0.4 m that leaves a strip of less than 0.1 m to another one; it may touch it."""
    assert len(plan(COLUMN, COLUMN | {"x": 1.4 + gap}).borders) == count


@pytest.mark.parametrize(("y", "count"), [(0.2, 1), (0.8, 1), (0.95, 0), (1.03, 0), (1.1, 1)])
def test_a_line_across_a_circle(y: float, count: int) -> None:
    """It is followed where it crosses the circle, y up to 0.87 m by more than 30 degrees, or passes it clearly.

    The points of the circle beside a crossing are no corners; a line that grazes it would leave slivers.
    """
    circle = {"kind": "area", "q": 3e4, "shape": {"kind": "circle", "centre": (0.0, 0.0), "radius": 1.0}}
    found = plan(circle, {**WALL, "points": [(-4.0, y), (4.0, y)]})
    assert len(found.borders) == 1
    assert len(found.lines) == count


def test_a_wall_beside_a_column() -> None:
    """A line that runs through a footprint is followed, one closer to its edge than a quarter of the thickness not."""
    through, beside = ({**WALL, "points": [(-4.0, y), (4.0, y)]} for y in (0.5, 0.68))
    assert len(plan(COLUMN, through).lines) == 1
    assert len(plan(COLUMN, beside).lines) == 0


@pytest.mark.parametrize("mesh", [{}, {"size": 0.5}])
def test_forces_on_walls_are_followed(mesh: dict[str, Any]) -> None:
    """And ends of line loads, on any mesh; not beside the wall, nor closer to its end than a quarter of a thickness.

    A line load that goes on as the one before it ends there has no kink; of two that end at a place one goes on.
    """
    wall = {"name": "W", "thickness": 0.2, "height": 2.0, "points": [(-4.0, -1.0), (2.0, -1.0)]}
    loads = [
        *(
            {"kind": "point", "P": 1e5, "x": x, "y": y}
            for x, y in ((0.3, -1.0), (0.3, -1.0), (1.0, -0.9), (1.96, -1.0))
        ),
        {"kind": "line", "q": 1e4, "points": [(-4.0, -1.0), (-3.0, -1.0)]},
        {"kind": "line", "q": 1e4, "q_end": 2e4, "points": [(-3.0, -1.0), (-2.0, -1.0)]},
        {"kind": "line", "q": 2e4, "points": [(-2.0, -1.0), (-1.0, -1.0)]},
    ]
    plate = {"length_x": 10.0, "length_y": 6.0, "thickness": 0.2, "E": 30e9, "nu": 0.2}
    given = {"plate": plate, "ground": {"kind": "winkler", "k": 5e7}, "walls": [wall], "loads": loads, "mesh": mesh}
    model = Model.model_validate(given)
    assert plan_of(model, symmetries(model), 0.0).points == ((0.3, -1.0), (-1.0, -1.0))
    assert singular_places(model)["ends and bends of lines"] == [(-4.0, -1.0), (-1.0, -1.0)]
    twice = Model.model_validate(given | {"loads": [*loads, loads[4]]})
    assert plan_of(twice, symmetries(twice), 0.0).points == ((0.3, -1.0), (-3.0, -1.0), (-1.0, -1.0))


def test_lines_are_cut_off_where_there_is_no_plate() -> None:
    """By its edge and by openings."""
    openings = [{"kind": "rectangle", "x": (-3.0, -2.0), "y": (-2.0, 0.0)}]
    found = plan({**WALL, "points": [(-6.0, -1.0), (0.0, -1.0)]}, openings=openings)
    assert np.array(found.lines)[:, :, 0].tolist() == [[-5.0, -3.0], [-2.0, 0.0]]


def test_elements_end_at_the_borders_of_loads() -> None:
    """All along them there are sides of elements."""
    model = slab(COLUMN, WALL)
    mesh = discretize(model).mesh
    (ring,) = rings_of(model.acting[0][1])
    for line in (*((edge.start, edge.end) for edge in ring.segments()), ((-4.0, -1.0), (0.0, -1.0))):
        sides = sides_along(mesh, mesh.elements, [Segment(*line)])
        sides = sides[~np.isin(sides[:, 2], find_hanging(mesh.elements)[:, 2])]  # those that halves make again
        covered = np.ptp(mesh.nodes[sides[:, :2]], axis=1).sum()
        assert covered == pytest.approx(np.abs(np.subtract(*line)).sum())


def test_a_ring_near_the_edge_is_followed() -> None:
    """A tank's wall at half a meter from the edge of a round slab, without an area load inside; its sides are arcs."""
    outline = {"kind": "circle", "radius": 4.0}
    wall = {"kind": "line", "q": 6e4, "shape": {"kind": "circle", "centre": (0.0, 0.0), "radius": 3.5}}
    model = Model.model_validate(
        {
            "plate": {"outline": outline, "thickness": 0.3, "E": 30e9, "nu": 0.2},
            "ground": {"kind": "winkler", "k": 5e7},
            "loads": [wall],
        }
    )
    mesh = discretize(model).mesh
    sides = sides_along(mesh, mesh.elements, model.acting[0][1].edges)  # type: ignore[union-attr]
    np.testing.assert_allclose(np.hypot(*mesh.nodes[sides].reshape(-1, 2).T), 3.5, rtol=1e-9)
    chords = np.linalg.norm(mesh.nodes[sides[:, 1]] - mesh.nodes[sides[:, 0]], axis=1)
    assert 7 * np.arcsin(chords / 7).sum() == pytest.approx(2 * np.pi * 3.5)
