"""What bars lie where: against loops over places and zones, and by hand at columns."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab.model.design.bars import MESHES, MeshName, bars_of_mesh
from groundslab.model.design.laid_bars import laid_bars, mean_area, punching_bars
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.model import Model
from groundslab.model.plate import Plate

BASE = {"diameter": 0.012, "spacing": 0.15}
D = 0.5


def model(zones: list[dict[str, Any]], **changes: Any) -> Model:
    """Return a slab of 12 m x 8 m with 12/150 in all layers and zones of further bars."""
    bars = dict.fromkeys(("bottom_x", "bottom_y", "top_x", "top_y"), BASE)
    parts: dict[str, Any] = {
        "plate": {"length_x": 12, "length_y": 8, "thickness": 0.55, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 20e6},
        "columns": [
            {"name": "C", "x": 0, "y": 0, "width_x": 0.4, "width_y": 0.6},
            {"name": "edge", "x": 0, "y": 3.7, "width_x": 0.4, "width_y": 0.6},
        ],
        "cases": [{"name": "G"}],
        "loads": [{"kind": "uniform", "q": 1e4, "case": "G"}],
        "combinations": [{"name": "ULS", "factors": {"G": 1.35}}],
        "reinforcement": {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.046, 0.058), "top": (0.046, 0.058), **bars,
                          "zones": zones},
    }  # fmt: skip
    return Model(**parts | changes)


def zone(x: tuple[float, float], y: tuple[float, float], diameter: float = 0.016, **changes: Any) -> dict[str, Any]:
    """Return a rectangular zone of bars 150 mm apart, at the bottom along both axes."""
    shape = {"kind": "rectangle", "x": x, "y": y}
    own = {"name": f"{x} {y}", "shape": shape, "layers": ["bottom_x", "bottom_y"], "diameter": diameter}
    return own | {"spacing": 0.15} | changes


def area(diameter: float, spacing: float = 0.15) -> float:
    """Return the area of bars [m2/m]."""
    return np.pi / 4 * diameter**2 / spacing


def test_bars_at_places_by_loops() -> None:
    """At each place the bars per meter of the base and of each zone that holds it, one by one; 7.12 of them."""
    rng = np.random.default_rng(4)
    rectangles = []
    for number in range(5):
        x, y = np.sort(rng.uniform(-5, 5, 2)), np.sort(rng.uniform(-3.5, 3.5, 2))
        given = {"diameter": float(rng.uniform(0.008, 0.025)), "spacing": float(rng.uniform(0.1, 0.3))}
        rectangles.append(zone(tuple(x), tuple(y), name=str(number), **given))
    rectangles[2]["layers"] = ["top_x"]
    circle = {"name": "round", "shape": {"kind": "circle", "centre": (1, 1), "radius": 2}, "layers": ["bottom_x"],
              "diameter": 0.02, "spacing": 0.2}  # fmt: skip
    steel = model([*rectangles, circle]).reinforcement
    assert steel is not None
    places = np.column_stack([rng.uniform(-6, 6, 300), rng.uniform(-4, 4, 300)])
    found = laid_bars(steel, "bottom_x", places)
    for i, (x, y) in enumerate(places):
        sets = [(BASE["diameter"], BASE["spacing"])]
        for each in rectangles:
            (x0, x1), (y0, y1) = each["shape"]["x"], each["shape"]["y"]
            if "bottom_x" in each["layers"] and x0 <= x <= x1 and y0 <= y <= y1:
                sets.append((each["diameter"], each["spacing"]))
        if (x - 1) ** 2 + (y - 1) ** 2 <= 4:
            sets.append((0.02, 0.2))
        assert found.area[i] == pytest.approx(sum(area(*each) for each in sets))
        # n_i bars of a width of one meter
        n, phi = np.array([1 / s for _, s in sets]), np.array([d for d, _ in sets])
        assert found.diameter[i] == pytest.approx((n @ phi**2) / (n @ phi))
        assert found.spacing[i] == min(s for _, s in sets)


def test_a_node_on_the_border_of_a_zone_has_its_bars() -> None:
    """On the border and by rounding beside it the zone counts, a millimeter beside it does not."""
    steel = model([zone((-1, 1), (-1, 1))]).reinforcement
    assert steel is not None
    places = np.array([[1, 0], [1 + 1e-12, 0], [1.001, 0], [6, 4], [-6, -4]])
    both = area(0.012) + area(0.016)
    assert laid_bars(steel, "bottom_y", places).area == pytest.approx([both, both, *[area(0.012)] * 3])
    assert laid_bars(steel, "top_y", places).area == pytest.approx(area(0.012))


def parts(of: Model) -> tuple[Plate, Reinforcement]:
    """Return the plate and the bars of a model."""
    assert of.reinforcement is not None
    return of.plate, of.reinforcement


def test_mean_over_the_width_beside_a_column() -> None:
    """Bars along x count over 0.6 + 6 x 0.5 = 3.6 m: a zone 2 m wide gives 2 / 3.6 of its bars; one 5 m wide all."""
    narrow = model([zone((-4, 4), (-1, 1))])
    column = narrow.columns[0]
    assert mean_area(*parts(narrow), "bottom_x", column, D) == pytest.approx(area(0.012) + area(0.016) * 2 / 3.6)
    wide = model([zone((-4, 4), (-2.5, 2.5))])
    assert mean_area(*parts(wide), "bottom_x", column, D) == pytest.approx(area(0.012) + area(0.016))
    # along y: over 0.4 + 3.0 = 3.4 m, which the zone covers, and up to 0.3 + 1.0 = 1.3 m from the center
    assert mean_area(*parts(wide), "bottom_y", column, D) == pytest.approx(area(0.012) + area(0.016))
    assert mean_area(*parts(model([])), "bottom_x", column, D) == pytest.approx(area(0.012))


def test_bars_that_end_within_the_perimeter_do_not_count() -> None:
    """Bars along y of a zone that ends 1 m from the center end within 0.3 + 2 d = 1.3 m: they leave the base alone."""
    narrow = model([zone((-4, 4), (-1, 1))])
    assert mean_area(*parts(narrow), "bottom_y", narrow.columns[0], D) == pytest.approx(area(0.012))
    ratio = np.sqrt((area(0.012) + area(0.016) * 2 / 3.6) * area(0.012)) / D
    assert punching_bars(*parts(narrow), narrow.columns[0], D).ratio(D) == pytest.approx(ratio)


def test_width_ends_with_the_plate() -> None:
    """At an edge 0.3 m off the center 0.3 + 0.3 + 1.5 = 2.1 m of the plate count, a zone on 1 m of it by 1 / 2.1."""
    at_edge = model([zone((-4, 4), (3, 4))])
    found = mean_area(*parts(at_edge), "bottom_x", at_edge.columns[1], D)
    assert found == pytest.approx(area(0.012) + area(0.016) / 2.1)


@pytest.mark.parametrize("name", MESHES)
def test_area_of_a_mesh_is_its_name(name: MeshName) -> None:
    """The number in the name of a mesh is its area both ways, to a square millimeter per meter (BS 4483, DIN 488-4)."""
    bars = bars_of_mesh(name)
    assert area(bars.diameter, bars.spacing) * 1e6 == pytest.approx(int(name.strip("AQ")), abs=0.75)


def test_axes_by_cover_have_no_digits_of_rounding() -> None:
    """50 mm of cover and half of a bar of 18 mm: 59 mm, which as a sum of floats is 0.059000000000000004 m."""
    bars = {"diameter": 0.018, "spacing": 0.15}
    steel = Reinforcement(
        f_ck=30e6, f_yk=500e6, cover=(0.05, 0.05), bottom_x=bars, bottom_y=bars, top_x=bars, top_y=bars
    )
    assert steel.bottom_axes == steel.top_axes == (0.059, 0.077)
