"""Borders of soil zones and voids in the plan of a mesh, and shares of elements inside them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab import Model, meshing
from groundslab.discretize.discretize import discretize
from groundslab.discretize.plan.borders import add_borders
from groundslab.fem.mesh import grid
from groundslab.fem.parts.mesh_plan import MeshPlan
from groundslab.fem.problem import Problem
from groundslab.fem.shape_functions import areas
from groundslab.geometry.area_shares import shares
from groundslab.geometry.plan import Plan, Ring, circle, rectangle

PLATE = rectangle(-3.0, 3.0, -2.0, 2.0)
BEYOND = rectangle(-5.0, 5.0, -4.0, 4.0)


def model(mesh: dict[str, Any], **parts: Any) -> Model:
    """Return a plate of 6 x 4 m on ground with shear."""
    parts.setdefault("ground", {"kind": "pasternak", "k0": 2e7, "k1": 1e7})
    parts.setdefault("plate", {"length_x": 6.0, "length_y": 4.0, "thickness": 0.3, "E": 3e10, "nu": 0.2})
    return Model(loads=[{"kind": "uniform", "q": 1e4}], mesh=mesh, **parts)


def stiffer(shape: dict[str, Any]) -> dict[str, Any]:
    """Return a zone of other soil."""
    return {"shape": shape, "ground": {"kind": "pasternak", "k0": 8e7, "k1": 1e7}}


def sides_at(problem: Problem, axis: int, value: float) -> bool:
    """Return whether a line of nodes lies at a coordinate, and no element across it."""
    xy = problem.mesh.xy[..., axis]
    across = (xy.min(axis=1) < value - 1e-9) & (xy.max(axis=1) > value + 1e-9)
    return bool(np.isclose(problem.mesh.nodes[:, axis], value, atol=1e-9).any() and not across.any())


@pytest.mark.slow
def test_borders_are_lines_of_grids_and_zones_are_met_exactly() -> None:
    """The default mesh, a size, nested coarser meshes, ground beyond the plate: a line at each border within it."""
    zone = stiffer({"kind": "rectangle", "x": (1.07, 50.0), "y": (-50.0, 3.13)})
    for mesh in ({}, {"size": 0.5}):
        for coarsening in (0, 1, 2):
            found = discretize(model(mesh, soil_zones=[zone], beyond={"kind": "margin", "width": 2.0}), coarsening)
            assert sides_at(found, 0, 1.07)
            assert sides_at(found, 1, 3.13)
            x, y = found.mesh.nodes[found.mesh.elements[:, 8]].T
            np.testing.assert_allclose(found.ground.A0[:, 0, 0], np.where((x > 1.07) & (y < 3.13), 8e7, 2e7))  # type: ignore[union-attr]


def test_borders_on_the_lines_of_a_grid_change_nothing() -> None:
    """A void whose edges are grid lines already leaves the equal elements and the symmetry of the plate."""
    void = {"x": (-1.0, 1.0), "y": (-0.5, 0.5)}
    with_void = discretize(model({"size": 0.5}, contact={"voids": [void]}))
    without = discretize(model({"size": 0.5}))
    assert with_void.symmetry == without.symmetry == (True, True)
    np.testing.assert_array_equal(with_void.mesh.nodes, without.mesh.nodes)


def test_the_plan_of_a_mesh_says_which_borders_it_follows() -> None:
    """A mesh for a size follows borders as drawn but those that are cut off; a grid of counts follows none."""
    voids = [{"x": (-1.1, 1.1), "y": (-0.3, 0.3)}]
    zones = [stiffer({"kind": "rectangle", "x": (x, x + 0.7), "y": (-1.3, 1.3)}) for x in (2.9, -2.9)]
    followed = discretize(model({"size": 0.5}, soil_zones=zones, contact={"voids": voids})).mesh_plan
    assert followed == MeshPlan((False, False), followed_zones=(1,), followed_voids=(0,), has_coarser=True)
    given = discretize(model({"counts": (12, 8)}, soil_zones=zones, contact={"voids": voids})).mesh_plan
    assert (given.followed_zones, given.followed_voids) == ((), ())
    assert not discretize(model({"counts": (1, 1)})).mesh_plan.has_coarser


def test_symmetric_voids_off_the_lines_keep_the_symmetry() -> None:
    """A quarter is meshed with lines at the edges of the void, and the whole has a void of the area drawn."""
    void = {"x": (-1.1, 1.1), "y": (-0.3, 0.3)}
    found = discretize(model({"size": 0.5}, contact={"voids": [void]}))
    assert found.symmetry == (True, True)
    assert found.mesh.nodes.min() == 0.0
    assert sides_at(found, 0, 1.1)
    assert sides_at(found, 1, 0.3)
    assert found.contact.depths.area.sum(axis=0) == pytest.approx([6.0 - 0.33, 0.33])


@pytest.mark.parametrize("mesh", ["gmsh", "netgen"])
def test_arcs_and_oblique_borders_are_followed(mesh: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Both mesh makers put sides on a circle, and on an oblique zone as far as it lies on the plate."""
    if mesh == "netgen":
        pytest.importorskip("netgen")
        monkeypatch.setattr(meshing, "choose", lambda: meshing.with_netgen)
    else:
        pytest.importorskip("gmsh")
    oblique = {"kind": "polygon", "points": [(1.0, -3.0), (2.0, 9.0), (9.0, 9.0), (9.0, -3.0)]}
    void = {"shape": {"kind": "circle", "centre": (-1.5, 0.0), "radius": 0.7}}
    found = discretize(model({"size": 0.5}, soil_zones=[stiffer(oblique)], contact={"voids": [void]}))
    assert found.contact.depths.area.sum(axis=0) == pytest.approx([24 - np.pi * 0.49, np.pi * 0.49], rel=1e-4)
    k = found.ground.A0[:, 0, 0]  # type: ignore[union-attr]
    assert set(np.round(np.unique(k), -2)) == {2e7, 8e7}
    # right of the line from (1, -3) to (2, 9), of which y = 0 is at x = 1.25
    assert areas(found.mesh.xy)[k > 5e7].sum() == pytest.approx((3 - 1.25) * 4, rel=1e-6)


def test_without_a_mesh_maker_borders_that_no_grid_follows_are_left_to_areas(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where neither Gmsh nor Netgen is there a circle does not keep a plain plate from being solved."""
    monkeypatch.setattr(meshing, "available", lambda: False)
    add_borders.cache_clear()
    void = {"shape": {"kind": "circle", "centre": (-1.5, 0.0), "radius": 0.7}}
    found = discretize(model({"size": 0.5}, ground={"kind": "winkler", "k": 2e7}, contact={"voids": [void]}))
    add_borders.cache_clear()
    assert len(found.mesh.elements) == 96
    assert found.contact.depths.area.sum(axis=0) == pytest.approx([24 - np.pi * 0.49, np.pi * 0.49], rel=5e-3)


@pytest.mark.parametrize(
    ("ring", "kept"),
    [
        (rectangle(1.0, 9.0, -9.0, 9.0), rectangle(1.0, 3.0, -2.0, 2.0)),  # cut off at the edge
        (rectangle(1.0, 2.999, -1.0, 1.0), rectangle(1.0, 3.0, -1.0, 1.0)),  # moved onto the edge nearby
        (rectangle(-9.0, 9.0, -9.0, 9.0), None),  # around all that is meshed
        (rectangle(4.0, 5.0, 0.0, 1.0), None),  # beside it
        (rectangle(1.0, 1.003, -1.0, 1.0), None),  # narrower than what can be meshed
        (Ring(((-1.0, 2.0), (1.0, 2.0), (1.0, 1.95))), None),  # leaves the edge of the plate at a small angle
    ],
)
def test_what_becomes_of_a_border(ring: Ring, kept: Ring | None) -> None:
    """Borders are clipped, moved onto lines too close to them, or left out where no mesh could follow them."""
    found = add_borders(Plan(PLATE), (ring,)).borders
    assert [sorted(each.points) for each in found] == ([] if kept is None else [sorted(kept.points)])


def test_two_zones_with_a_sliver_between_them_share_a_line() -> None:
    """A slip of the drawing between two zones makes no strip in the mesh, and one that crosses keeps its place."""
    rings = (rectangle(-1.0, 1.0, -1.0, 1.0), rectangle(1.00001, 2.0, -1.0, 1.0), rectangle(0.3, 1.6, 0.2, 3.0))
    found = add_borders(Plan(PLATE), rings).borders
    assert sorted(found[1].points) == [(1.0, -1.0), (1.0, 1.0), (2.0, -1.0), (2.0, 1.0)]
    assert len(found) == 3


def test_a_border_counts_on_the_ground_beyond() -> None:
    """What lies off the plate is a border as far as ground is meshed there."""
    ring = rectangle(4.0, 9.0, 0.0, 1.0)
    assert not add_borders(Plan(PLATE), (ring,)).borders
    (found,) = add_borders(Plan(PLATE, beyond=BEYOND), (ring,)).borders
    assert sorted(found.points) == [(4.0, 0.0), (4.0, 1.0), (5.0, 0.0), (5.0, 1.0)]


def test_shares_are_areas_and_the_last_ring_counts() -> None:
    """Rectangles and circles over a grid: shares add up to one, and over all elements to the areas drawn."""
    mesh = grid(np.linspace(-3, 3, 8), np.linspace(-2, 2, 6))
    rings = (rectangle(-2.1, 1.0, -1.3, 0.4), circle((0.9, 0.2), 0.85), rectangle(0.5, 9.0, -0.1, 0.1))
    found = shares(mesh.xy, rings, (), 6.0)
    np.testing.assert_allclose(found.sum(axis=1), 1.0, rtol=1e-14)
    total = areas(mesh.xy) @ found
    last = 2.5 * 0.2
    # of the circle without the strip: integrated across it
    y = (np.arange(200000) + 0.5) / 200000 * 1.7 - 0.65
    half = np.sqrt(0.85**2 - (y - 0.2) ** 2)
    low, high = 0.9 - half, 0.9 + half
    strip = np.where(np.abs(y) < 0.1, np.maximum(0, high - np.maximum(low, 0.5)), 0.0)
    both = np.where((y > -1.3) & (y < 0.4), np.maximum(0, np.minimum(high, 1.0) - low), 0.0)
    in_strip = np.where(np.abs(y) < 0.1, np.maximum(0, np.minimum(high, 1.0) - np.maximum(low, 0.5)), 0.0)
    step = 1.7 / 200000
    disc = (2 * half - strip).sum() * step
    first = 3.1 * 1.7 - (both.sum() - in_strip.sum()) * step - 0.5 * 0.2
    np.testing.assert_allclose(total, [24 - first - disc - last, first, disc, last], rtol=2e-5)


@pytest.mark.slow
def test_a_ring_followed_along_arcs_is_judged_by_centres() -> None:
    """The chords of a mesh that follows a circle leave slivers, which are nobody's."""
    pytest.importorskip("gmsh")
    ring = circle((0.4, 0.1), 0.9)
    found = meshing.unstructured(Plan(PLATE, borders=(ring,)), 0.5)
    by_centre, by_area = (shares(found.xy, (ring,), followed, 6.0) for followed in ((0,), ()))
    assert set(np.unique(by_centre)) == {0.0, 1.0}
    assert areas(found.xy) @ by_centre[:, 1] == pytest.approx(ring.area, rel=1e-4)
    assert 0 < np.abs(by_centre - by_area).max() < 0.05


def test_a_void_that_touches_the_edge_is_taken_by_area() -> None:
    """No mesh follows the cusp between a circle and an edge that it touches; no node has a negative area."""
    radius = 0.8802123765848484
    circle = {"kind": "circle", "centre": (7.44617243103454 / 2 - radius, -2.264071685958864), "radius": radius}
    voids = [{"depth": 0.01, "shape": circle}, {"x": (2.0979032869894816, 3.3149045176986682), "y": (0.48, 4.95)}]
    places = [(-1.861543107758635, 1.375), (-2.7923146616379526, 4.125), (3.72308621551727, -1.375)]
    model = Model(
        plate={"length_x": 7.44617243103454, "length_y": 11.0, "thickness": 0.8, "E": 30e9, "nu": 0.2},
        ground={"kind": "pasternak", "k0": 20e6, "k1": 20e6},
        beyond={"kind": "margin", "width": 8.832788608614285},
        contact={"voids": voids},
        supports=[{"kind": "point", "x": x, "y": y} for x, y in places],
        loads=[{"kind": "uniform", "q": 50e3}],
        mesh={"size": 3.74025991002138},
    )
    assert discretize(model).contact.depths.area.min() >= 0
