"""Every kind of load against everything that reads what acts."""

from __future__ import annotations

from typing import Any, get_args

import numpy as np
import pytest
import shapely
from matplotlib import pyplot

import groundslab
from groundslab.design.demands.loads.column_loads import sum_of_others
from groundslab.discretize.plan.local_sizes import local_sizes
from groundslab.discretize.symmetry import symmetries
from groundslab.geometry.plan import segment
from groundslab.model.loads.acting import LineForce, borders_of
from groundslab.model.loads.clipping import find_clipped_loads
from groundslab.model.loads.load_types import AnyLoad, Spread, is_zero
from groundslab.model.model import Model
from groundslab.model.remarks.singular_places import singular_places
from groundslab.views.plots import symbols
from groundslab.views.report.drawings.case_plan import draw_case_plan
from groundslab.views.report.drawings.load_plan import load_text
from groundslab.views.scene.plan import plan_of

LINE = {"points": [(-1.0, 0.5), (1.5, 0.5)]}
#: Each kind, the force [N] and the moments about y and x [N m] that it brings, and its text on plans.
LOADS: dict[str, tuple[dict[str, Any], float, tuple[float, float], str]] = {
    "uniform": ({"q": 1e3}, 24e3, (0, 0), "1 kPa"),
    "patch": ({"q": 1e3, "x": (0, 2), "y": (0, 1)}, 2e3, (2e3, 1e3), "1 kPa"),
    "area": ({"q": 1e3, "shape": {"kind": "rectangle", "x": (0, 2), "y": (0, 1)}}, 2e3, (2e3, 1e3), "1 kPa"),
    "line": ({"q": 2e3, **LINE}, 5e3, (1.25e3, 2.5e3), "2 kN/m"),
    "line moment": ({"m": 2e3, **LINE}, 0.0, (0, 5e3), "2 kNm/m"),
    "point": ({"P": 5e3, "M_x": 1e3, "x": 1, "y": 0.5}, 5e3, (6e3, 2.5e3), "5 kN, Mx 1 kNm"),
    "self weight": ({"unit_weight": 25e3}, 24 * 0.25 * 25e3, (0, 0), "25 kN/m³"),
    "temperature": ({"difference": 10.0}, 0.0, (0, 0), "10 K"),
    "shrinkage": ({"top": 3e-4}, 0.0, (0, 0), "0.0003"),
    "settlement": ({"support": "S", "w": 5e-3}, 0.0, (0, 0), "5 mm"),
    "core": ({"core": "K", "P": 5e3, "M_x": 1e3}, 5e3, (2.25e3, 2.5e3), "5 kN, Mx 1 kNm"),
}


def model(*loads: dict[str, Any]) -> Model:
    """Return a slab on springs, with a support in its middle, as soft as a spring of its own, and a core of a wall."""
    return Model(
        plate={"length_x": 6.0, "length_y": 4.0, "thickness": 0.25, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        contact={"tensionless": False},
        supports=[{"kind": "point", "name": "S", "x": 0.0, "y": 0.0, "stiffness": 1e6}],
        walls=[{"name": "W", "thickness": 0.2, **LINE}],
        cores=[{"name": "K", "walls": ["W"]}],
        loads=loads,
        mesh={"size": 0.5},
    )


def test_every_kind_of_load_is_tried_here() -> None:
    """A new class among the loads fails here until it has its row."""
    assert list(LOADS) == [kind.model_fields["kind"].default for kind in get_args(AnyLoad)]


@pytest.mark.parametrize("kind", LOADS)
def test_ground_and_supports_carry_all_that_acts(kind: str) -> None:
    """Force and moments of ground and support are those of the load; a part of the slab bears its part of the force."""
    load, force, moments, _ = LOADS[kind]
    results = groundslab.solve(model({"kind": kind, **load})).only
    (support,) = results.supports
    carried = results.plate.contact_force
    scale = max(force, *moments, 1e3)
    assert carried.sum() + support.total == pytest.approx(force, abs=1e-6 * scale)
    np.testing.assert_allclose(carried @ results.plate.nodes, moments, atol=1e-6 * scale)
    (whole,) = sum_of_others(results, shapely.box(-3, -2, 3, 2), ()).values()
    assert whole == pytest.approx(force, rel=1e-9)


@pytest.mark.parametrize("kind", LOADS)
def test_plans_show_every_load_with_its_value(kind: str) -> None:
    """What has a place is drawn and has data for the browser; what has none is named."""
    load, _, _, text = LOADS[kind]
    slab = model({"kind": kind, **load})
    assert load_text(slab.loads[0]) == text
    (about,) = plan_of(slab)["loads"]
    assert about["kind"] == kind
    assert {"points", "ring", "everywhere"} & about.keys()
    figure, axes = pyplot.subplots()
    drawn = symbols.draw_loads(axes, slab)
    pyplot.close(figure)
    shown = kind in {"uniform", "patch", "area", "line", "line moment", "point"}
    assert bool(drawn) == shown
    pyplot.close(draw_case_plan(slab, slab))


@pytest.mark.parametrize("kind", LOADS)
def test_meshes_see_every_load(kind: str) -> None:
    """Borders, singular places, sizes and symmetry of a mesh follow from what acts."""
    load, *_ = LOADS[kind]
    slab = model({"kind": kind, **load})
    edges = [edge for _, shape in slab.acting for edge in borders_of(shape)]
    places = singular_places(slab)
    has_line = kind in {"line", "line moment", "core"}
    assert len(edges) == {"patch": 4, "area": 4}.get(kind, int(has_line))
    assert places.get("ends and bends of lines", []) == (LINE["points"] if has_line else [])
    assert places.get("forces without a footprint", []) == ([(1.0, 0.5)] if kind == "point" else [])
    adaptive = slab.model_copy(update={"mesh": groundslab.Mesh()})
    assert local_sizes(adaptive) is not None
    if kind != "settlement":
        everywhere = kind in {"uniform", "self weight", "temperature", "shrinkage"}
        assert symmetries(slab.model_copy(update={"supports": ()})) == (everywhere, everywhere)


@pytest.mark.parametrize("kind", LOADS)
def test_a_load_of_nothing_is_known(kind: str) -> None:
    """With all of its values zero nothing acts."""
    load, *_ = LOADS[kind]
    zero = {key: 0.0 if isinstance(value, float) else value for key, value in load.items()}
    given = next(part for part in get_args(AnyLoad) if part.model_fields["kind"].default == kind)
    assert not is_zero(given(**load))
    if kind != "self weight":
        assert is_zero(given(**zero))


@pytest.mark.parametrize("kind", LOADS)
def test_what_reaches_over_the_edge_is_cut_off_and_named(kind: str) -> None:
    """Moved by a length half of its extent off the plate, half of it acts."""
    load = LOADS[kind][0]
    if kind == "area":
        load = load | {"shape": {"kind": "rectangle", "x": (2, 4), "y": (0, 1)}}
    elif kind == "patch":
        load = load | {"x": (2, 4)}
    elif kind in {"line", "line moment"}:
        load = load | {"points": [(2.0, 0.5), (4.0, 0.5)]}
    slab = model({"kind": kind, **load})
    clipped = find_clipped_loads(slab.plate, slab.loads)
    assert len(clipped) == int(isinstance(slab.loads[0], Spread))
    for part in clipped:
        assert part.share == pytest.approx(0.5)
        assert part.force == pytest.approx(part.drawn / 2)


def test_corners_of_lines_are_their_ends_and_bends() -> None:
    """A closed line has no ends; where it runs on straight or by a tangent it has no corner."""
    square = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]
    closed = LineForce(tuple(segment(a, b) for a, b in zip(square, square[1:] + square[:1], strict=True)))
    assert sorted(closed.corners) == sorted(square)
    straight = LineForce((segment((0.0, 0.0), (1.0, 0.0)), segment((1.0, 0.0), (3.0, 0.0))))
    assert straight.corners == ((0.0, 0.0), (3.0, 0.0))
    smooth = LineForce((segment((0.0, 0.0), (1.0, 0.0)), segment((1.0, 0.0), (2.0, 1.0), np.tan(np.pi / 8))))
    assert smooth.corners == ((0.0, 0.0), (2.0, 1.0))
    assert LineForce(groundslab.Circle(radius=1.0).ring().segments()).corners == ()


def test_elements_at_a_footprint_at_an_angle_are_as_small_as_along_x_and_y() -> None:
    """Its least width, not that of the rectangle around it, has so many elements across, all over the footprint."""
    found = []
    for angle in (0.0, 45.0):
        load = {"kind": "point", "P": 1e3, "x": 1.0, "y": 0.5, "width_x": 0.8, "width_y": 0.2, "angle": angle}
        slab = model(load).model_copy(update={"mesh": groundslab.Mesh()})
        sizes = local_sizes(slab)
        assert sizes is not None
        found.append((np.min(sizes[1]), sizes[0][sizes[1] == np.min(sizes[1])] - (1.0, 0.5)))
    (size, places), (size_askew, askew) = found
    assert size_askew == pytest.approx(size)
    c = np.sqrt(0.5)
    assert sorted(map(tuple, np.round(askew, 9))) == sorted(map(tuple, np.round(places @ [[c, c], [-c, c]], 9)))
