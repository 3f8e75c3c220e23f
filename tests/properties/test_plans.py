"""Plates of any shape: what is drawn where, and how it is cut into parts, does not change the answer."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab.model.ground import Pasternak
from groundslab.model.loads.lines import LineLoad
from groundslab.model.loads.load_types import AreaLoad, PatchLoad, PointLoad, SelfWeight, UniformLoad
from groundslab.model.model import Model
from groundslab.model.plate import Zone
from groundslab.model.settings import Beyond, Mesh
from groundslab.model.shapes import Polygon, Rectangle
from groundslab.results.results import CombinationResult
from helpers.solve_once import solve_once

pytestmark = pytest.mark.slow

CORNERS = [(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (3.0, 2.0), (3.0, 5.0), (0.0, 5.0)]
GROUND = Pasternak(k0=20e6, k1=8e6)


def moved(points: list[tuple[float, float]], turns: int, x: float, y: float) -> list[tuple[float, float]]:
    """Return points turned by quarter turns about the origin, then moved."""
    for _ in range(turns):
        points = [(-b, a) for a, b in points]
    return [(a + x, b + y) for a, b in points]


def raft(turns: int = 0, x: float = 0.0, y: float = 0.0, **changes: Any) -> CombinationResult:
    """Return the results of an L-shaped raft with an opening, somewhere, turned."""

    def polygon(points: list[tuple[float, float]]) -> Polygon:
        return Polygon(points=moved(points, turns, x, y))

    opening = polygon([(1, 3), (2, 3), (2, 4), (1, 4)])
    zone = polygon([(0, 0), (3, 0), (3, 2), (0, 2)])
    plate = {"outline": polygon(CORNERS), "openings": [opening], "thickness": 0.25, "E": 30e9, "nu": 0.2}
    plate |= {"zones": [Zone(shape=zone, thickness=0.5)]} | changes.pop("plate", {})
    (px, py), *line = moved([(5.5, 0.5), (0.5, 0.5), (0.5, 4.5)], turns, x, y)
    loads = [
        UniformLoad(q=5e3),
        PointLoad(P=300e3, x=px, y=py),
        LineLoad(q=40e3, points=line),
        SelfWeight(unit_weight=25e3),
    ]
    return solve_once(
        Model(**{"plate": plate, "ground": GROUND, "loads": loads, "mesh": Mesh(size=0.5), **changes})
    ).only


def at_places(results: CombinationResult, places: list[tuple[float, float]], field: str = "settlement") -> np.ndarray:
    """Return a field of the plate at places."""
    return np.array([results.plate.value_at(field, *place) for place in places])


PLACES = [(0.3, 0.2), (2.7, 1.9), (5.9, 1.1), (0.4, 4.8), (2.9, 4.9), (2.6, 3.3)]


@pytest.mark.parametrize(("turns", "infinite"), [(0, True), (1, False), (2, True), (3, False)])
def test_a_moved_and_turned_plan_settles_alike(turns: int, infinite: bool) -> None:
    """Anywhere in the plane and in any of four directions the raft has the same settlements and certificate."""
    beyond = Beyond(kind="infinite", width=1.0) if infinite else Beyond()
    here, there = raft(beyond=beyond), raft(turns, 13.7, -205.3, beyond=beyond)
    np.testing.assert_allclose(
        at_places(there, moved(PLACES, turns, 13.7, -205.3)), at_places(here, PLACES), rtol=1e-7, atol=1e-10
    )
    assert there.certificate.load == pytest.approx(here.certificate.load, rel=1e-12)


def test_sums_by_hand() -> None:
    """Area, weight and sum of the loads are those of the drawing, to the last digit."""
    results = raft()
    area, thick = 6 * 2 + 3 * 3 - 1, 3 * 2
    assert results.plate.area.sum() == pytest.approx(area, rel=1e-13)
    weight = 25e3 * (0.5 * thick + 0.25 * (area - thick))
    assert results.certificate.load == pytest.approx(weight + 5e3 * area + 300e3 + 40e3 * 4, rel=1e-12)


def test_a_drawn_rectangle_is_the_plain_one() -> None:
    """A rectangle given by its outline, on the same elements, settles as the one given by its sides."""
    common = {"thickness": 0.3, "E": 30e9, "nu": 0.2}
    loads = [PatchLoad(q=200e3, x=(0.2, 1.4), y=(-0.7, 0.9)), UniformLoad(q=1e3)]
    plain = Model(plate={"length_x": 6, "length_y": 4, **common}, ground=GROUND, loads=loads, mesh=Mesh(size=0.5))
    outline = Rectangle(x=(-3, 3), y=(-2, 2))
    drawn = Model(plate={"outline": outline, **common}, ground=GROUND, loads=loads, mesh=Mesh(size=0.5))
    a, b = solve_once(plain), solve_once(drawn)
    np.testing.assert_allclose(a.plate.nodes, b.plate.nodes, atol=1e-12)
    np.testing.assert_allclose(a.plate.settlement, b.plate.settlement, rtol=1e-7, atol=1e-10)


def test_zones_that_are_no_different_change_nothing() -> None:
    """Cut into zones with the plate's own thickness, along lines of the mesh, the raft stays the same."""
    cut = [
        Zone(shape=Rectangle(x=(0, 3), y=(0, 2)), thickness=0.25),
        Zone(shape=Rectangle(x=(1, 5), y=(-1, 1)), E=30e9),
    ]
    whole, pieces = raft(plate={"zones": []}), raft(plate={"zones": cut})
    np.testing.assert_allclose(at_places(pieces, PLACES), at_places(whole, PLACES), rtol=1e-9, atol=1e-12)


def test_an_area_load_is_the_patch_of_its_shape() -> None:
    """A pressure on a drawn rectangle and on a patch are one; in two halves too."""
    shape = Rectangle(x=(0.3, 2.1), y=(0.4, 1.7))
    halves = [
        Polygon(points=[(0.3, 0.4), (2.1, 0.4), (2.1, 1.7)]),
        Polygon(points=[(0.3, 0.4), (2.1, 1.7), (0.3, 1.7)]),
    ]
    ways = [
        [PatchLoad(q=1e5, x=(0.3, 2.1), y=(0.4, 1.7))],
        [AreaLoad(q=1e5, shape=shape)],
        [AreaLoad(q=1e5, shape=half) for half in halves],
    ]
    first, *others = [raft(loads=[*loads, UniformLoad(q=5e3)]) for loads in ways]
    for other in others:
        np.testing.assert_allclose(other.plate.settlement, first.plate.settlement, rtol=1e-8, atol=1e-12)


def test_a_thicker_zone_stiffens() -> None:
    """A zone does change something: the thicker it is, the less the raft bends within it."""
    bends = []
    for thickness in (0.25, 0.5, 1.0):
        zone = Zone(shape=Rectangle(x=(0, 3), y=(0, 2)), thickness=thickness)
        results = raft(plate={"zones": [zone]}, loads=[PointLoad(P=300e3, x=1.5, y=1), UniformLoad(q=20e3)])
        middle, *corners = at_places(results, [(1.5, 1), (0.1, 0.1), (2.9, 0.1), (0.1, 1.9), (2.9, 1.9)])
        bends.append(middle - np.mean(corners))
    assert bends[0] > bends[1] > bends[2] > 0


def test_nothing_is_averaged_across_a_change_of_thickness() -> None:
    """On a border of zones nodes stand twice: the moment across it is one, that along it jumps with the stiffness."""
    zone = Zone(shape=Rectangle(x=(0, 2), y=(-1.5, 1.5)), thickness=0.6)
    plate = {"outline": Rectangle(x=(-2, 2), y=(-1.5, 1.5)), "zones": [zone], "thickness": 0.3, "E": 30e9, "nu": 0.0}
    loads = [UniformLoad(q=1e3), PatchLoad(q=100e3, x=(-2, 2), y=(-0.5, 0.5))]
    results = solve_once(Model(plate=plate, ground=GROUND, loads=loads, mesh=Mesh(size=0.1))).plate
    here = np.flatnonzero((np.abs(results.nodes[:, 0]) < 1e-9) & (np.abs(results.nodes[:, 1]) < 1e-9))
    assert len(here) == 2
    assert len(np.unique(results.settlement[here])) == 1
    thin, thick = sorted(results.moment_y[here], key=abs)
    assert thick / thin == pytest.approx(8.0, rel=0.02)
    assert results.moment_x[here[0]] == pytest.approx(results.moment_x[here[1]], rel=0.02)
    assert results.area.sum() == pytest.approx(12.0, rel=1e-12)
