"""Plates of any shape as a file describes them: what is read, what is refused and where."""

from __future__ import annotations

import math
from typing import Any

import pytest

from groundslab.case.casefile import loads, to_toml
from groundslab.errors import InputError
from groundslab.model.ground import Winkler
from groundslab.model.loads.lines import LineLoad
from groundslab.model.loads.load_types import AreaLoad, PointLoad, SelfWeight, UniformLoad
from groundslab.model.model import Model
from groundslab.model.plate import Plate, Zone
from groundslab.model.settings import Mesh
from groundslab.model.shapes import Circle, Polygon, Rectangle

L = Polygon(points=[(0, 0), (30, 0), (30, 10), (12, 10), (12, 20), (0, 20)])
HOLE = Rectangle(x=(4, 6), y=(12, 15))


def model(**changes: Any) -> Model:
    """Return an L-shaped plate with an opening, changed."""
    plate = {"outline": L, "openings": [HOLE], "thickness": 0.4, "E": 30e9, "nu": 0.2, **changes.pop("plate", {})}
    return Model(**{"plate": plate, "ground": Winkler(k=2e7), "loads": [UniformLoad(q=1e4)], **changes})


def test_bounds_follow_arcs_exactly() -> None:
    """The rectangle around a shape reaches to the outermost point of its arcs."""
    assert Plate(outline=Circle(centre=(1, 2), radius=3), thickness=1, E=1, nu=0).bounds == pytest.approx(
        (-2, 4, -1, 5)
    )
    half_round = Polygon(points=[(0, 0), (2, 0)], bulges=[0.0, 1.0])
    assert half_round.ring().bounds == pytest.approx((0, 2, 0, 1))
    flat = Polygon(points=[(0, 0), (2, 0), (2, 1), (0, 1)], bulges=[0, math.tan(math.pi / 8)])
    assert flat.ring().bounds[1] == pytest.approx(2 + math.sqrt(0.5) - 0.5)


@pytest.mark.parametrize(
    ("changes", "where"),
    [
        ({"plate": {"length_x": 6}}, "plate.length_x"),
        ({"plate": {"outline": None}}, "plate.length_x"),
        ({"plate": {"support": "soft", "edges": {"left": "soft"}}}, "plate.support"),
        ({"mesh": Mesh(counts=(4, 4))}, "mesh.counts"),
        ({"plate": {"openings": [HOLE, Rectangle(x=(25, 40), y=(2, 4))]}}, "plate.openings[2]"),
        ({"plate": {"openings": [HOLE, Rectangle(x=(5, 7), y=(13, 16))]}}, "plate.openings[2]"),
        ({"plate": {"zones": [Zone(shape=Circle(centre=(50, 50), radius=1), thickness=1)]}}, "plate.zones[1]"),
        ({"loads": [PointLoad(P=1, x=5, y=13)]}, "loads[1]"),
        ({"loads": [PointLoad(P=1, x=20, y=15)]}, "loads[1]"),
        ({"loads": [PointLoad(P=1, x=31, y=5)]}, "loads[1].x"),
        ({"loads": [LineLoad(q=1, points=[(31, 1), (31, 12)])]}, "loads[1]"),
        ({"loads": [AreaLoad(q=1, shape=Circle(centre=(5, 13), radius=0.5))]}, "loads[1]"),
    ],
)
def test_what_does_not_fit_is_refused_by_its_place(changes: dict[str, Any], where: str) -> None:
    """Lengths beside an outline, counts on a drawn plan, loads in openings or beside the plate: each by name."""
    with pytest.raises(InputError) as error:
        model(**changes)
    assert where in [issue.location for issue in error.value.issues]


def test_shapes_are_refused_where_they_make_no_sense() -> None:
    """Too few points, more bulges than edges, a line of one point, a zone that is no different."""
    for make, word in (
        (lambda: Polygon(points=[(0, 0), (1, 1)]), "points"),
        (lambda: Polygon(points=[(0, 0), (1, 0), (0, 1)], bulges=[0, 0, 0, 1]), "bulges"),
        (lambda: Polygon(points=[(0, 0), (1, 1), (1, 0), (0, 1)]), r"self-intersection at \(0.5 0.5\) m"),
        (lambda: Polygon(points=[(1, 1), (1, 1), (1, 1)]), "one place"),
        (lambda: LineLoad(q=1, points=[(0, 0)]), "points"),
        (lambda: LineLoad(q=1, points=[(0, 0), (0, 0)]), "points"),
        (lambda: LineLoad(q=1), "points: found nothing, expected the line's points, a shape"),
        (lambda: LineLoad(q=1, points=[(0, 0), (1, 0)], bulges=[1, 1]), "bulges: found 2 bulges, expected at most 1"),
        (lambda: LineLoad(q=1, points=[(0, 0), (1, 0)], bulges=[1e4]), "bulges"),
        (lambda: LineLoad(q=1, q_end=2, shape=Circle(radius=1)), "q_end together with a shape"),
        (lambda: LineLoad(q=1, points=[(0, 0), (1, 0)], shape=Circle(radius=1)), "points together with a shape"),
        (lambda: AreaLoad(q=1, shape=Circle(radius=1), holes=[Circle(centre=(5, 0), radius=1)]), r"holes\[1\]"),
        (lambda: AreaLoad(q=1, shape=Circle(radius=1), holes=[Circle(radius=2)]), "leave nothing"),
        (lambda: Zone(shape=HOLE), "Zone"),
        (lambda: Circle(radius=0), "radius"),
    ):
        with pytest.raises(InputError, match=word):
            make()


def test_a_drawn_plate_is_written_and_read_back() -> None:
    """A plate with openings, zones and every kind of load survives the way through a file."""
    described = model(
        plate={"zones": [Zone(shape=Rectangle(x=(0, 12), y=(0, 10)), thickness=0.8)]},
        loads=[
            UniformLoad(q=1e3),
            AreaLoad(q=2e3, shape=Circle(centre=(20, 5), radius=2)),
            LineLoad(q=5e3, points=[(1, 1), (11, 1), (11, 9)]),
            LineLoad(q=5e3, q_end=1e3, points=[(1, 1), (11, 1), (11, 9)], bulges=[0.0, 0.25]),
            LineLoad(q=5e3, shape=Circle(centre=(20, 5), radius=2)),
            AreaLoad(q=2e3, shape=Circle(centre=(20, 5), radius=2), holes=[Circle(centre=(20, 5), radius=1)]),
            PointLoad(P=1e5, x=29, y=1),
            SelfWeight(unit_weight=25e3),
        ],
        mesh=Mesh(size=1.0),
    )
    assert loads(to_toml(described)) == described
