"""Walls along the edges of plates: where they stand, that they are walls like others, and what is refused."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.case import casefile
from groundslab.cli import main
from groundslab.errors import InputError
from groundslab.geometry.plan import rectangle
from groundslab.model.loads.acting import LineForce
from groundslab.model.loads.spreading import spread_line
from groundslab.model.model import Model
from groundslab.model.structure.walls import Wall
from groundslab.views.scene.plan import plan_of
from groundslab.views.tables.structure.walls import wall_table

PLATE = {"length_x": 6.0, "length_y": 4.0, "thickness": 0.4, "E": 33e9, "nu": 0.2}
LOAD = {"kind": "line", "q": 120e3, "wall": "W"}
QUARTER = math.tan(math.pi / 8)
L_SHAPE = {"kind": "polygon", "points": [(0, 0), (6, 0), (6, 2), (2, 2), (2, 5), (0, 5)]}


def outlined(points: list[tuple[float, float]], bulges: tuple[float, ...] = ()) -> dict[str, Any]:
    """Return a plate of any outline."""
    outline = {"kind": "polygon", "points": points, "bulges": bulges}
    return {"outline": outline, **{key: PLATE[key] for key in ("thickness", "E", "nu")}}


def model(plate: dict[str, Any], wall: dict[str, Any], *loads: dict[str, Any], **more: Any) -> Model:
    """Return a slab with one wall W, 0.3 m thick."""
    ground = {"kind": "pasternak", "k0": 20e6, "k1": 5e6}
    return Model(
        plate=plate, ground=ground, walls=[{"name": "W", "thickness": 0.3} | wall], loads=loads or [LOAD], **more
    )


def placed(plate: dict[str, Any], edge: int | str, **more: Any) -> Wall:
    """Return the wall along an edge with its axis."""
    (wall,) = model(plate, {"edge": edge}, **more).placed_walls
    return wall


@pytest.mark.parametrize(
    ("edge", "points"),
    [
        ("bottom", ((-3.0, -1.85), (3.0, -1.85))),
        ("right", ((2.85, -2.0), (2.85, 2.0))),
        ("top", ((3.0, 1.85), (-3.0, 1.85))),
        ("left", ((-2.85, 2.0), (-2.85, -2.0))),
        (3, ((3.0, 1.85), (-3.0, 1.85))),
    ],
)  # fmt: skip
def test_along_a_side_of_a_rectangle(edge: int | str, points: tuple[tuple[float, float], ...]) -> None:
    """From corner to corner, half its thickness inside, counterclockwise; the whole of it stands on the plate."""
    wall = placed(PLATE, edge)
    assert wall.points == points
    assert not wall.closed
    assert rectangle(-3, 3, -2, 2).polygon(0.0).covers(wall.area(0.01))
    assert wall.area(0.01).area == pytest.approx(0.3 * wall.length)


def test_along_the_whole_outline() -> None:
    """A closed wall of which the outer face is the outline, and the inner one a thickness inside."""
    wall = placed(PLATE, "all")
    area = wall.area(0.01)
    assert wall.closed
    assert wall.length == pytest.approx(2 * (5.7 + 3.7))
    assert (
        area.symmetric_difference(
            rectangle(-3, 3, -2, 2).polygon(0.0) - rectangle(-2.7, 2.7, -1.7, 1.7).polygon(0.0)
        ).area
        < 1e-12
    )


def test_around_a_disc() -> None:
    """A ring of the outer radius."""
    wall = placed(outlined([]) | {"outline": {"kind": "circle", "radius": 4.0, "centre": (1.0, 2.0)}}, "all")
    assert wall.length == pytest.approx(2 * math.pi * 3.85)
    for edge in wall.edges:
        np.testing.assert_allclose(np.linalg.norm(edge.at(np.linspace(0, 1, 5)) - [1, 2], axis=1), 3.85, rtol=1e-12)


def test_along_an_arc() -> None:
    """Concentric with the outline's rounded corner, from the normal at its start to that at its end."""
    plate = outlined([(0, 0), (6, 0), (6, 3), (4, 5), (0, 5)], (0, 0, QUARTER))
    (edge,) = placed(plate, 3).edges
    assert edge.radius == pytest.approx(1.85)
    np.testing.assert_allclose(edge.centre, (4, 3), atol=1e-12)
    np.testing.assert_allclose([edge.start, edge.end], [(5.85, 3), (4, 4.85)], atol=1e-12)


@pytest.mark.parametrize("clockwise", [False, True])
def test_numbers_count_as_points_do(clockwise: bool) -> None:
    """Whichever way the outline is drawn, the wall runs counterclockwise: the plate lies to its left."""
    points = list(L_SHAPE["points"])
    number = 4  # from (2, 2) to (2, 5)
    if clockwise:
        points, number = points[::-1], 2
    wall = placed(outlined(points), number)
    assert wall.points == ((1.85, 2.0), (1.85, 5.0))
    assert placed(outlined(points), "left").points == ((0.15, 5.0), (0.15, 0.0))


def test_ends_at_acute_corners_stay_on_the_plate() -> None:
    """At 45 degrees the square end keeps a thickness away, so that its inner corner stands on the other edge."""
    wall = placed(outlined([(0, 0), (6, 0), (6, 6)]), 1)
    np.testing.assert_allclose(wall.points, [(0.3, 0.15), (6.0, 0.15)], atol=1e-12)


def test_along_an_edge_of_another_plate() -> None:
    """The one that is named."""
    further = {
        "name": "B",
        "outline": {"kind": "rectangle", "x": (4.0, 7.0), "y": (0.0, 2.0)},
        "thickness": 0.3,
        "E": 3e10,
        "nu": 0.2,
    }
    (wall,) = model(PLATE, {"edge": "left", "plate": "B"}, plates=[further]).placed_walls
    assert wall.points == ((4.15, 2.0), (4.15, 0.0))


@pytest.mark.parametrize(
    ("edge", "given"),
    [
        ("all", {"shape": {"kind": "rectangle", "x": (-2.85, 2.85), "y": (-1.85, 1.85)}}),
        ("top", {"points": [(3.0, 1.85), (-3.0, 1.85)]}),
    ],
)
def test_it_answers_as_the_same_wall_by_points(edge: str, given: dict[str, Any]) -> None:
    """Settlements, moments, tables and what acts are those of the wall drawn with its coordinates."""
    loads = [LOAD, {"kind": "line moment", "m": 8e3, "wall": "W"}]
    mesh = {"size": 0.25}
    along, drawn = (model(PLATE, wall, *loads, mesh=mesh) for wall in ({"edge": edge}, given))
    one, other = gs.solve(along), gs.solve(drawn)
    np.testing.assert_allclose(one.only.plate.settlement, other.only.plate.settlement, rtol=1e-9)
    np.testing.assert_allclose(one.only.plate.moment_x, other.only.plate.moment_x, rtol=1e-8, atol=1e-6)
    rows = [[*wall_table(each).rows()] for each in (one, other)]
    for a, b in zip(*rows, strict=True):
        for value, expected in zip(a, b, strict=True):
            assert value == (pytest.approx(expected, rel=1e-8) if isinstance(expected, float) else expected)
    chord = 0.01
    assert plan_of(along)["walls"][0]["points"] == plan_of(drawn)["walls"][0]["points"]
    assert along.placed_walls[0].area(chord).equals_exact(drawn.placed_walls[0].area(chord), 1e-12)


def test_all_of_it_is_spread_over_its_thickness() -> None:
    """Nothing acts along its axis only: its faces lie on the plate, around a disc and at arcs, too."""
    disc = {"kind": "circle", "radius": 4.0}
    for plate in (
        PLATE,
        outlined([(0, 0), (6, 0), (6, 3), (4, 5), (0, 5)], (0, 0, QUARTER)),
        outlined([]) | {"outline": disc},
    ):
        m = model(plate, {"edge": "all"})
        (shape,) = (shape for _, shape in m.acting)
        assert isinstance(shape, LineForce)
        along, areas = spread_line(m.plate, shape)
        assert not along
        assert len(areas) == len(shape.edges)


def test_it_is_written_read_and_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """As it was given, by its edge; `check` says its length."""
    path = tmp_path / "case.toml"
    for edge, line in (("all", 'edge = "all"'), (2, "edge = 2")):
        written = model(PLATE, {"edge": edge})
        path.write_text(casefile.to_toml(written), encoding="utf-8")
        assert line in path.read_text(encoding="utf-8")
        assert casefile.load(path) == written
    assert main.main(["check", str(path)]) == 0
    assert "  wall W: 0.3 m thick, 4 m long" in capsys.readouterr().out


NARROW = [(0, 0), (6, 0), (6, 0.5), (0, 0.5)]
U_SHAPE = [(0, 0), (6, 0), (6, 5), (4, 5), (4, 2), (2, 2), (2, 5), (0, 5)]


@pytest.mark.parametrize(
    ("plate", "wall", "place", "found"),
    [
        (PLATE, {"edge": "all", "plate": "B"}, "walls[1].plate", '"B"'),
        ({**PLATE, "name": "A"}, {"edge": "all", "plate": "B"}, "walls[1].plate", '"B"'),
        (PLATE, {"edge": "lefd"}, "walls[1].edge", '"lefd"'),
        (PLATE, {"edge": 0}, "walls[1].edge", "0"),
        (PLATE, {"edge": 1.5}, "walls[1].edge", "1.5"),
        (PLATE, {"edge": 5}, "walls[1].edge", "edge 5 of an outline with 4"),
        (outlined(U_SHAPE), {"edge": "top"}, "walls[1].edge", '"top" of an outline with 2 edges on that side'),
        (outlined([]) | {"outline": {"kind": "circle", "radius": 4.0}}, {"edge": "left"}, "walls[1].edge",
         '"left" of an outline with no straight edge on that side'),
        (PLATE, {"edge": "all", "points": [(0, 0), (1, 0)]}, "walls[1].points", "points together with an edge"),
        (PLATE, {"edge": "all", "bulges": [0.2]}, "walls[1].bulges", "bulges together with an edge"),
        (PLATE, {"edge": 1, "shape": {"kind": "circle", "radius": 1}}, "walls[1].shape", "shape together with an edge"),
        (PLATE, {"points": [(0, 0), (1, 0)], "plate": "A"}, "walls[1].plate", "plate without an edge"),
        (PLATE, {}, "walls[1].points", "nothing"),
        (PLATE, {"edge": "all", "thickness": 2.0}, "walls[1].thickness", "2 m, for which a plate of 6 m x 4 m has no"),
        (outlined([(0, 0), (6, 0), (6, 0.2), (5, 0.2), (5, 4), (0, 4)]), {"edge": "all"}, "walls[1].thickness",
         "0.3 m, for which edge 2 of the outline has no room"),
        (outlined([(0, 0), (6, 0), (6, 3), (5.8, 3.2), (0, 3.2)], (0, 0, QUARTER)), {"edge": 3},
         "walls[1].thickness", "0.3 m, for which edge 3 of the outline has no room"),
        (outlined(NARROW), {"edge": "bottom", "thickness": 0.6}, "walls[1]", "a part off the plate, at "),
        (PLATE | {"openings": [{"kind": "rectangle", "x": (0, 1), "y": (1.75, 1.9)}]}, {"edge": "top"}, "walls[1]",
         "a part off the plate, at "),
    ],
)  # fmt: skip
def test_what_is_refused(plate: dict[str, Any], wall: dict[str, Any], place: str, found: str) -> None:
    """Each says where it is and what was found; what stands on the wall is not reported, too."""
    with pytest.raises(InputError) as refused:
        model(plate, wall)
    issues = [issue for issue in refused.value.issues if issue.location.startswith("walls")]
    assert any(issue.location == place and issue.found.startswith(found) for issue in issues), refused.value.issues
    assert len(refused.value.issues) == len(issues)


def test_loads_that_vary_need_a_wall_with_ends() -> None:
    """One along the whole outline has none."""
    with pytest.raises(InputError, match="a closed curve"):
        model(PLATE, {"edge": "all"}, {**LOAD, "q_end": 1e3})


def test_the_direction_is_that_of_its_loads() -> None:
    """A load that grows along the right side is largest at its upper end; a moment presses the inside down."""
    m = model(PLATE, {"edge": "right"}, {**LOAD, "q": 0.0, "q_end": 100e3}, mesh={"size": 0.5})
    w = gs.solve(m).only.plate
    assert w.value_at("settlement", 2.9, 1.9) > w.value_at("settlement", 2.9, -1.9)
    weight = {"kind": "uniform", "q": 5e3}
    moment = {"kind": "line moment", "m": 20e3, "wall": "W"}
    turned = gs.solve(model(PLATE, {"edge": "right"}, weight, moment, mesh={"size": 0.5})).only.plate
    assert turned.value_at("settlement", 0.0, 0.0) > turned.value_at("settlement", 2.9, 0.0)


def test_around_corners_between_arcs() -> None:
    """Where arcs meet at corners the whole outline has room, too, though mitered ends would reach over it."""
    lens = outlined([(-4, 0), (4, 0), (0, 3)], (0.6, 0.3, -0.2))
    wall = placed(lens, "all")
    assert wall.closed
    assert len(wall.edges) == 3
