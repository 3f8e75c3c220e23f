"""Plans cut into pieces for Netgen, what Netgen makes of hard ones, and who is chosen to make cells."""

from __future__ import annotations

import builtins
import math
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from groundslab.errors import InputError
from groundslab.geometry.plan import Plan, Ring, circle, rectangle
from groundslab.meshing import mesh, netgen, unstructured
from groundslab.meshing.arrangement import pieces
from groundslab.meshing.backends import Maker, choose, with_gmsh, with_netgen
from groundslab.meshing.cells import Cells, FixedSides
from helpers.plans import FREE, GRIDS, L_SHAPE, MAKERS, OBLIQUE, SIDES, areas, holds, needs_gmsh, needs_netgen, size_of

SQUARE = rectangle(0, 10, 0, 8)
#: Edges that lie on each other, cross, touch, end on others: what a mesher that cannot cut is never shown.
HARD = {
    "zone on the edge": Plan(OBLIQUE, zones=((Ring(((0, 0), (10, 1), (6, 4))), 1),)),
    "zones side by side": Plan(circle((0, 0), 5), zones=((rectangle(-6, 0, -6, 6), 1), (rectangle(0, 6, -6, 1), 2))),
    "zone round an opening": Plan(
        SQUARE, (circle((4, 4), 1),), ((Ring(((4, 4), (9, 4), (9, 7), (4, 7))), 1), (circle((4, 4), 1), 2))[:1]
    ),
    "half circle in a circle": Plan(circle((0, 0), 5), zones=((Ring(((5, 0), (-5, 0)), (1, 0)), 1),)),
    "lines that cross": Plan(circle((0, 0), 5), lines=(((-3, -3), (3, 3)), ((-3, 3), (3, -3)), ((-5, 0), (2, 0)))),
    "line on a border": Plan(OBLIQUE, zones=((rectangle(0, 6, 0, 2.5), 1),), lines=(((1, 2.5), (8, 2.5)),)),
    "line along the edge": Plan(OBLIQUE, lines=(((0, 0), (5, 0.5)), ((12, 6), (7, 9), (4, 8)))),
    "points on edges": Plan(
        circle((0, 0), 5), zones=((circle((0, 0), 2), 1),), points=((5.0, 0.0), (0.0, 2.0), (3.0, -4.0), (1.0, 1.0))
    ),
    "points close together": Plan(OBLIQUE, points=((3.0, 3.0), (3.1, 3.0), (3.0, 3.1), (6.0, 8.2))),
    "filleted": Plan(
        Ring(((1, 0), (9, 0), (10, 1), (10, 7), (9, 8), (0, 8), (0, 1)), (0, math.tan(math.pi / 8)) * 2 + (0, 0, 0.2)),
        zones=((rectangle(-1, 2, -1, 9), 1),),
    ),
    "ground in a corner": Plan(rectangle(0, 6, 0, 4), beyond=Ring(((0, 0), (20, 0), (0, 20)), (0, 0.4, 0))),
}


@pytest.mark.parametrize("plan", [pytest.param(plan, id=name) for name, plan in {**FREE, **GRIDS, **HARD}.items()])
def test_pieces_share_nothing_but_their_ends(plan: Plan) -> None:
    """No two pieces meet but at common ends, and the edges of all that is meshed are among them, each once."""
    import shapely

    found, points = pieces(plan)
    ends = [{piece.edge.start, piece.edge.end} for piece in found]
    flat = [shapely.LineString(piece.edge.at(np.linspace(0, 1, piece.edge.chords(1e-6) + 1))) for piece in found]
    for i, one in enumerate(flat):
        for j in range(i):
            common = set(ends[i] & ends[j])
            met = [part for part in shapely.get_parts(one.intersection(flat[j])) if not part.is_empty]
            away = [min((shapely.Point(place).distance(part) for place in common), default=1.0) for part in met]
            assert max(away, default=0.0) < 1e-3 * plan.extent
            assert max((part.length for part in met), default=0.0) < 1e-2 * plan.extent
    rim = [ring for name, ring in plan.rings().items() if plan.beyond is None and "openings" in name]
    rim.append(plan.outline if plan.beyond is None else plan.beyond)
    one_sided = sum(piece.edge.length for piece in found if piece.left != piece.right)
    assert one_sided == pytest.approx(sum(edge.length for ring in rim for edge in ring.segments()), rel=1e-9)
    lines = shapely.union_all(flat)
    assert all(lines.distance(shapely.Point(point)) > 1e-4 * plan.extent for point in points)


def test_pieces_by_hand() -> None:
    """Two zones on a square: borders between different sections are kept, what is covered or outside is not."""
    zones = ((rectangle(-1, 4, 2, 5), 1), (rectangle(2, 6, 2, 5), 1))
    found, _ = pieces(Plan(SQUARE, zones=zones))
    inner = [piece.edge for piece in found if piece.left and piece.right]
    assert sum(edge.length for edge in inner) == pytest.approx(6 + 3 + 6)
    assert {place for edge in inner for place in (edge.start, edge.end)} >= {(0, 2), (6, 2), (6, 5), (0, 5)}
    # a wall on the covered border keeps it
    found, _ = pieces(Plan(SQUARE, zones=zones, lines=(((2, 2), (2, 5)),)))
    inner = [piece.edge for piece in found if piece.left and piece.right]
    assert sum(edge.length for edge in inner) == pytest.approx(6 + 3 + 6 + 3)


def test_arcs_are_cut_where_they_cross() -> None:
    """Two circles of radius 5, 6 apart, cross at (3, 4) and (3, -4); the pieces lie on them and keep their length."""
    plan = Plan(circle((0, 0), 5), zones=((circle((6, 0), 5), 1),))
    found, _ = pieces(plan)
    inner = [piece.edge for piece in found if piece.left and piece.right]
    assert sum(edge.length for edge in inner) == pytest.approx(2 * 5 * math.atan2(4, 3))
    ends = np.array([place for edge in inner for place in (edge.start, edge.end)])
    for place in ((3, 4), (3, -4)):
        assert np.linalg.norm(ends - place, axis=1).min() < 1e-14
    for edge in inner:
        assert np.abs(np.linalg.norm(edge.at(np.linspace(0, 1, 7)) - [6, 0], axis=1) - 5).max() < 1e-14


@pytest.mark.slow
@pytest.mark.parametrize("maker", MAKERS)
@pytest.mark.parametrize("parts", [5, 20])
@pytest.mark.parametrize("plan", [pytest.param(plan, id=name) for name, plan in HARD.items()])
def test_hard_plans(plan: Plan, parts: int, maker: Maker) -> None:
    """Edges that lie on each other, cross and touch are met by conforming meshes with the right areas."""
    result = mesh(plan, size_of(plan, parts), maker=maker)
    wanted = plan.area if plan.beyond is None else plan.beyond.area
    assert areas(result).sum() == pytest.approx(wanted, rel=1e-3)
    ends = np.sort(result.elements[:, SIDES].reshape(-1, 3)[:, :2], axis=1)
    corners = len(np.unique(result.elements[:, :4]))
    holes = 0 if plan.beyond is not None else len(plan.openings)
    assert corners - len(np.unique(ends, axis=0)) + len(result.elements) == 1 - holes
    assert all(holds(result, point) for point in plan.outline.points + plan.points)
    for line in plan.line_segments():
        on_it = np.flatnonzero(line.distance(result.nodes) <= 1e-9)
        along = np.unique(ends[np.isin(ends, on_it).all(axis=1)], axis=0)
        assert np.linalg.norm(np.ptp(result.nodes[along], axis=1), axis=1).sum() == pytest.approx(line.length)
    assert result.quality.worst > 0.3


@pytest.mark.slow
@needs_netgen
@pytest.mark.parametrize("parts", [3, 17])
@pytest.mark.parametrize("name", FREE)
def test_quality_at_any_size(name: str, parts: int) -> None:
    """Netgen's meshes are good from coarse to fine."""
    result = mesh(FREE[name], size_of(FREE[name], parts), maker=with_netgen)
    assert result.quality.worst > 0.35
    assert result.quality.median > 0.75


@needs_netgen
def test_netgen_takes_the_place_of_gmsh(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where Gmsh is missing or cannot be loaded, Netgen makes the mesh, the same one as when it is asked for."""
    load = builtins.__import__

    def without(name: str, *rest: Any) -> Any:
        if name == "gmsh":
            raise OSError("libGLU.so.1")
        return load(name, *rest)

    monkeypatch.setattr(builtins, "__import__", without)
    assert choose() is with_netgen
    here, there = mesh(FREE["ring"], 0.5), mesh(FREE["ring"], 0.5, maker=with_netgen)
    np.testing.assert_array_equal(here.nodes, there.nodes)


@needs_gmsh
def test_gmsh_comes_first() -> None:
    """Where both can be loaded, Gmsh makes the mesh."""
    assert choose() is with_gmsh


@needs_netgen
def test_what_netgen_says_becomes_our_error(monkeypatch: pytest.MonkeyPatch) -> None:
    """When Netgen gives up in every way it is asked, that is an error of the input."""
    geom2d, meshing = netgen.load()

    class Stubborn(geom2d.SplineGeometry):  # type: ignore[misc,name-defined]
        def GenerateMesh(self, **_: Any) -> None:
            raise RuntimeError("meshing failed")

    class Other:
        SplineGeometry = Stubborn

    monkeypatch.setattr(netgen, "load", lambda: (Other, meshing))
    with pytest.raises(InputError, match=r"Netgen refuses \(meshing failed\)"):
        mesh(FREE["circle"], 0.5, maker=with_netgen)


def square(middle: tuple[float, float]) -> Cells:
    """Return a square of side 2 about (0, 0) as four cells that share a corner somewhere in it."""
    nodes = np.array([[-1, -1], [0, -1], [1, -1], [-1, 0], middle, [1, 0], [-1, 1], [0, 1], [1, 1]], dtype=float)
    cells = np.array([[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7]])
    rim = np.array([0, 1, 2, 5, 8, 7, 6, 3, 0])
    ends = np.column_stack([rim[:-1], rim[1:]])
    drawn = FixedSides(ends, np.zeros((8, 2)), np.zeros(8), np.array([0, 2, 4, 6, 8]))
    return Cells(nodes, np.zeros((0, 3), dtype=np.int64), cells, drawn)


@pytest.mark.slow
def test_the_next_cells_are_taken_when_the_first_are_bad() -> None:
    """Unusable cells are passed over, poor ones are bettered, and after good ones no more are asked for.

    Nor after middling ones, if they are not the first: what comes last are triangles.
    """
    plan = Plan(rectangle(-1, 1, -1, 1))
    asked: list[float] = []

    def maker(*middles: float) -> Maker:
        def make(*_: Any) -> Iterator[Cells]:
            for x in middles:
                asked.append(x)
                yield square((x, x))

        return make

    best = unstructured(plan, 1.0, maker=maker(0.9, 0.0, 0.1))
    assert asked == [0.9, 0.0]
    assert best.quality.worst == pytest.approx(1)
    asked.clear()
    best = unstructured(plan, 1.0, maker=maker(3.0, 0.95, 0.9, 0.0))
    assert asked == [3.0, 0.95, 0.9]
    assert 0.2 < best.quality.worst < 0.35
    poor = unstructured(plan, 1.0, maker=maker(0.9, 0.95, 3.0)).quality.worst
    assert 0 < poor < 0.35
    assert poor == unstructured(plan, 1.0, maker=maker(0.9)).quality.worst
    with pytest.raises(InputError, match="inside out"):
        unstructured(plan, 1.0, maker=maker(3.0))
    with pytest.raises(InputError, match="makes nothing"):
        unstructured(plan, 1.0, maker=maker())


@needs_netgen
def test_sizes_are_followed_where_nothing_is_drawn() -> None:
    """On the ground far from anything elements have about the size asked for there, seldom half of it, never twice."""
    plan = Plan(L_SHAPE, beyond=circle((4, 4), 30))
    result = unstructured(plan, 1.0, beyond_growth=5.0, maker=with_netgen)
    import shapely

    away = shapely.distance(plan.outline.polygon(1e-6), shapely.points(result.nodes[result.elements[:, 8]]))
    ratio = np.sqrt(areas(result)) / (1 + away / 5)
    low, median, high = np.quantile(ratio, [0.1, 0.5, 0.95])
    assert ratio.max() < 2
    assert 0.5 < low < 0.75 < median < 1.0 < high < 1.5
