"""Walls of a model: where they stand, what stands on them, and what is refused."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely
from shapely import Polygon

from groundslab.case import casefile
from groundslab.cli import main
from groundslab.errors import InputError
from groundslab.geometry.offsets import parallel
from groundslab.geometry.plan import Segment, make_segments
from groundslab.model.loads.acting import LineForce
from groundslab.model.loads.clipping import find_clipped_loads, integral
from groundslab.model.loads.lines import LineLoad, LineMoment
from groundslab.model.loads.spreading import spread_line
from groundslab.model.model import Model
from groundslab.model.plate import Plate
from groundslab.model.structure.walls import Wall

PLATE = {"length_x": 6.0, "length_y": 4.0, "thickness": 0.4, "E": 33e9, "nu": 0.2}
CORNER = [(-2.0, -1.0), (2.0, -1.0), (2.0, 1.0)]
W1 = {"name": "W1", "thickness": 0.25, "points": CORNER}
RING = {"name": "R", "thickness": 0.2, "shape": {"kind": "circle", "radius": 1.5}}
ON_W1 = {"kind": "line", "q": 120e3, "q_end": 60e3, "wall": "W1"}


def model(walls: list[dict[str, Any]], *loads: dict[str, Any], **changes: Any) -> Model:
    """Return a slab with walls and what stands on them."""
    parts: dict[str, Any] = {"plate": PLATE, "ground": {"kind": "winkler", "k": 20e6}, "walls": walls, "loads": loads}
    return Model(**parts | changes)


def test_loads_on_a_wall_have_its_line_and_its_thickness() -> None:
    """A load along two pieces, linear over both, and a moment, at the wall; another one has its own place."""
    moment = {"kind": "line moment", "m": 5e3, "wall": "W1"}
    free = {"kind": "line", "q": 1e3, "points": [(0, 0), (1, 0)]}
    (_, force), (_, couple), (_, line) = model([W1], ON_W1, moment, free).acting
    edges = make_segments(tuple(CORNER), ())
    assert force == LineForce(edges, q=(120e3, 60e3), width=0.25)
    assert couple == LineForce(edges, m=(5e3, 5e3), width=0.25)
    assert line == LineForce((Segment((0.0, 0.0), (1.0, 0.0)),), q=(1e3, 1e3))


def test_it_is_written_and_read(tmp_path: Path) -> None:
    """A case with walls comes back from its file."""
    written = model([W1, RING], ON_W1, {"kind": "line", "q": 1e3, "wall": "R"})
    path = tmp_path / "case.toml"
    path.write_text(casefile.to_toml(written), encoding="utf-8")
    assert casefile.load(path) == written


def test_check_says_how_long_walls_are(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """4 m and 2 m of the first wall, 2 pi 1.5 m of the second."""
    path = tmp_path / "case.toml"
    path.write_text(casefile.to_toml(model([W1, RING], ON_W1)), encoding="utf-8")
    assert main.main(["check", str(path)]) == 0
    out = capsys.readouterr().out
    assert "  wall W1: 0.25 m thick, 6 m long" in out
    assert "  wall R: 0.2 m thick, 9.42478 m long" in out


@pytest.mark.parametrize(
    ("walls", "loads", "place", "found"),
    [
        ([W1], [{"kind": "line", "q": 1e3, "wall": "W2"}], "loads[1].wall", '"W2"'),
        ([], [{"kind": "line moment", "m": 1e3, "wall": "W2"}], "loads[1].wall", '"W2"'),
        ([W1], [{**ON_W1, "points": CORNER}], "loads[1].points", "points together with a wall"),
        ([W1], [{**ON_W1, "width": 0.3}], "loads[1].width", "width together with a wall"),
        ([W1], [{**ON_W1, "bulges": [0.1]}], "loads[1].bulges", "bulges together with a wall"),
        ([W1], [{"kind": "line", "q": 1e3}], "loads[1].points", "nothing"),
        ([RING], [{**ON_W1, "wall": "R"}], "loads[1].q_end", 'q_end on wall "R", a closed curve'),
        ([W1, W1], [ON_W1], "walls[2].name", '"W1" again'),
        ([{**W1, "name": ""}], [{"kind": "uniform", "q": 1e3}], "walls[1].name", "no name"),
        ([{**W1, "points": [(0, 0), (4, 0)]}], [ON_W1], "walls[1]", "a part off the plate, at "),
        ([{**W1, "points": [(0, 0), (0, 0)]}], [ON_W1], "walls[1].points[2]", "(0.0, 0.0) m twice"),
        ([{**W1, "points": [(0, 0)]}], [ON_W1], "walls[1].points", "1 point"),
        ([{**W1, "thickness": 0.0}], [ON_W1], "walls[1].thickness", "0.0"),
        ([{**W1, **RING, "name": "W1", "points": CORNER}], [ON_W1], "walls[1].points", "points together with a shape"),
        ([{"name": "W1", "thickness": 0.2}], [ON_W1], "walls[1].points", "nothing"),
    ],
)  # fmt: skip
def test_what_is_refused(walls: list[dict[str, Any]], loads: list[dict[str, Any]], place: str, found: str) -> None:
    """Each says where it is and what was found."""
    with pytest.raises(InputError) as refused:
        model(walls, *loads)
    assert any(issue.location == place and issue.found.startswith(found) for issue in refused.value.issues), (
        refused.value.issues
    )


def test_a_wall_over_an_opening_is_refused() -> None:
    """What stands on it there would act on nothing."""
    hole = {"kind": "rectangle", "x": (-0.5, 0.5), "y": (-1.5, -0.5)}
    with pytest.raises(InputError, match=r"walls\[1\]"):
        model([W1], ON_W1, plate={**PLATE, "openings": [hole]})


AXES = {
    "straight": ((-2.0, -1.0), (1.0, 1.0), 0.0),
    "quarter of a circle": ((1.0, 0.0), (0.0, 1.0), math.tan(math.pi / 8)),
    "clockwise": ((1.0, 0.0), (0.0, 1.0), -math.tan(math.pi / 8)),
}


@pytest.mark.parametrize("m", [(0.0, 0.0), (7e3, -3e3)], ids=["force", "force and couple"])
@pytest.mark.parametrize("q", [(100e3, 100e3), (100e3, 40e3)], ids=["uniform", "growing"])
@pytest.mark.parametrize("axis", AXES.values(), ids=AXES)
def test_areas_about_an_axis_have_its_force_and_its_couple(
    axis: tuple[Any, Any, float], q: tuple[float, float], m: tuple[float, float]
) -> None:
    """Force and first moments are those of the axis with its couple, whose arm is across it.

    Those of an arc to a thousandth: it is made of chords, and a uniform pressure about it lies outwards of the axis.
    """
    start, end, bulge = axis
    (edge,) = make_segments((start, end), (bulge,))
    width = 0.1
    along, areas = spread_line(Plate(**PLATE), LineForce((edge,), q, m, width))
    assert not along
    x, weights = np.polynomial.legendre.leggauss(20)
    s, ds = (x + 1) / 2, weights / 2 * edge.length
    force, couple = ((ends[0] + (ends[1] - ends[0]) * s) * ds for ends in (q, m))
    expected = np.array([force.sum(), *(force @ edge.at(s) + couple @ edge.left(s))])
    total = np.zeros(3)
    for area, pressure in areas:
        points = polygon_rule(area)
        p = pressure(points[:, :2]) * points[:, 2]
        total += np.array([p.sum(), *(p @ points[:, :2])])
    error = 1e-9 if edge.straight else 1e-3
    np.testing.assert_allclose(total, expected, rtol=error, atol=error * force.sum())


def polygon_rule(area: Polygon) -> Any:
    """Return places and weights (p, 3) with which polynomials of third degree are exact on a polygon."""
    places = []
    for triangle in shapely.get_parts(shapely.constrained_delaunay_triangles(area)):
        a, b, c = shapely.get_coordinates(triangle)[:3]
        size = abs((b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]) / 2
        for shares, weight in (((1, 1, 1), -27), ((3, 1, 1), 25), ((1, 3, 1), 25), ((1, 1, 3), 25)):
            place = np.array(shares) @ np.array([a, b, c]) / sum(shares)
            places.append([*place, size * weight / 48])
    return np.array(places)


def test_a_width_that_leaves_the_plate_acts_on_the_axis() -> None:
    """Nothing of a wall along the plate's edge is cut off; inside, its width acts."""
    plate = Plate(**PLATE)
    for y, spread in ((2.0, False), (1.9, False), (1.85, True)):
        line = LineForce(make_segments(((-2.0, y), (2.0, y)), ()), q=(1e3, 1e3), width=0.3)
        along, areas = spread_line(plate, line)
        assert bool(areas) == spread
        total = sum(piece.force for piece in along) + sum(integral(area, pressure) for area, pressure in areas)
        assert total == pytest.approx(4e3)


def test_what_of_a_wall_load_lies_off_the_plate_is_told() -> None:
    """A load with a width over the edge is cut off there as any line load; one on a wall is on the plate."""
    loads = (LineLoad(q=1e3, points=[(0, 0), (6, 0)], width=0.2), LineMoment(m=1.0, wall="W1"))
    (clipped,) = find_clipped_loads(Plate(**PLATE), loads, (), (Wall(**W1),))
    assert (clipped.number, clipped.share) == (1, pytest.approx(0.5))


def test_a_parallel_edge_keeps_its_distance() -> None:
    """To the left of a line, towards the middle of an arc that turns left, away from one that turns right."""
    for start, end, bulge in AXES.values():
        (edge,) = make_segments((start, end), (bulge,))
        for distance in (0.2, -0.2):
            s = np.linspace(0, 1, 7)
            beside = parallel(edge, distance)
            np.testing.assert_allclose(beside.at(s), edge.at(s) + distance * edge.left(s), atol=1e-12)
