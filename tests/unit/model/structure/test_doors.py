"""Doors of walls without a height: where they may be, and that force and moments of what the walls carry are kept."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from groundslab.analysis.driver import solve
from groundslab.case import casefile
from groundslab.cli import main
from groundslab.errors import InputError
from groundslab.model.loads.acting import LineForce
from groundslab.model.model import Model
from groundslab.model.remarks.resultants import case_resultants
from groundslab.model.structure.wall_ends import wall_ends
from groundslab.views.drawing.shapes import plan_shapes
from groundslab.views.scene.plan import plan_of
from groundslab.views.tables.result_tables import table_makers

PLATE = {"length_x": 12.0, "length_y": 10.0, "thickness": 0.4, "E": 33e9, "nu": 0.2}
#: How far a load spreads below 2.1 m at 60 degrees to the horizontal [m].
SPREAD = 2.1 * math.tan(math.pi / 6)
Q = 100e3
STRAIGHT = {"name": "W", "thickness": 0.25, "points": [(-3, 0), (3, 0)]}
BENT = {"name": "W", "thickness": 0.25, "points": [(-4, -3), (2, -3), (5, 1), (5, 4)]}
CLOSED = {"name": "W", "thickness": 0.25, "shape": {"kind": "rectangle", "x": (-3, 3), "y": (-2, 2)}}
ON = {"kind": "line", "q": Q, "wall": "W"}


def door(start: float, end: float, height: float = 2.1) -> dict[str, float]:
    """Return a door."""
    return {"start": start, "end": end, "height": height}


def model(wall: dict[str, Any], doors: list[dict[str, float]], *loads: dict[str, Any], **changes: Any) -> Model:
    """Return a slab with a wall and what stands on it."""
    walls = [{**wall, "openings": doors}]
    parts: dict[str, Any] = {"plate": PLATE, "ground": {"kind": "winkler", "k": 20e6}, "walls": walls, "loads": loads}
    return Model(**parts | changes)


def forces(m: Model) -> list[LineForce]:
    """Return what acts."""
    return [shape for _, shape in m.acting if isinstance(shape, LineForce)]


def test_each_side_of_a_door_takes_half_of_the_load_over_it() -> None:
    """Over 1 m 100 kN, 50 kN to each side over 2.1 m tan 30 degrees; further off the load is what it was."""
    more = Q + 50e3 / SPREAD
    lines = forces(model(STRAIGHT, [door(2.5, 3.5)], ON))
    assert [line.q for line in lines] == [pytest.approx(q) for q in ((Q, Q), (more, more), (more, more), (Q, Q))]
    x = [(line.edges[0].start[0], line.edges[-1].end[0]) for line in lines]
    bounds = [(-3, -0.5 - SPREAD), (-0.5 - SPREAD, -0.5), (0.5, 0.5 + SPREAD), (0.5 + SPREAD, 3)]
    assert np.array(x) == pytest.approx(np.array(bounds))
    assert {(line.wall, line.width) for line in lines} == {("W", 0.25)}


def test_short_wall_beside_a_door_takes_its_share_all_along() -> None:
    """0.4 m before a door of 1 m, 1 m after it: a beam of 1.7 m between the middles of both, by hand.

    Its load of 100 kN is 0.5 + 0.5 m from the middle of the second length: 58.8 kN before the door, 41.2 kN after it.
    """
    short = {**STRAIGHT, "points": [(0, 0), (2.4, 0)]}
    before, after = forces(model(short, [door(0.4, 1.4)], ON))
    assert before.q == pytest.approx((Q + 100e3 * 1.0 / 1.7 / 0.4,) * 2)
    assert after.q == pytest.approx((Q + 100e3 * 0.7 / 1.7 / 1.0,) * 2)


@pytest.mark.parametrize(
    ("wall", "doors"),
    [
        (STRAIGHT, [door(0.3, 1.4)]),
        (STRAIGHT, [door(1.0, 2.0), door(2.3, 3.8, 3.0), door(4.0, 4.2)]),
        ({**STRAIGHT, "points": [(-3, 0), (0, 0), (3, 0)]}, [door(2.2, 3.6)]),
        (BENT, [door(4.0, 5.9), door(7.0, 8.0), door(11.5, 13.0)]),
        (CLOSED, [door(0.2, 1.2), door(7.0, 8.0)]),
    ],
    ids=["one", "three", "over a point of the line", "bent", "closed"],
)
@pytest.mark.parametrize("load", [ON, {**ON, "q_end": 30e3}, {"kind": "line moment", "m": 7e3, "wall": "W"}])
def test_force_and_moments_are_kept(wall: dict[str, Any], doors: list[Any], load: dict[str, Any]) -> None:
    """What acts has the resultant that it would have without doors, and nothing acts in them."""
    if "shape" in wall:
        load = {key: value for key, value in load.items() if key != "q_end"}
    m = model(wall, doors, load)
    (kept,), (given,) = case_resultants(m).values(), case_resultants(model(wall, [], load)).values()
    scale = max(abs(given.F) * 5, 10e3)
    found = [kept.F - given.F, kept.M_x - given.M_x, kept.M_y - given.M_y]
    assert np.array(found) == pytest.approx(np.zeros(3), abs=1e-9 * scale)
    loaded = sum(line.length for line in forces(m))
    assert loaded == pytest.approx(m.walls[0].length - sum(each["end"] - each["start"] for each in doors))


@pytest.mark.parametrize(
    ("wall", "openings", "place", "found"),
    [
        (STRAIGHT, [door(0, 1)], "walls[1].openings[1]", "an opening at the end of the wall"),
        (STRAIGHT, [door(5, 6)], "walls[1].openings[1]", "an opening at the end of the wall"),
        (STRAIGHT, [door(5, 7)], "walls[1].openings[1].end", "7.0 m"),
        (STRAIGHT, [door(1, 2), door(2, 3)], "walls[1].openings[2]", "0 m of wall between"),
        (STRAIGHT, [door(1, 2), door(0.5, 3)], "walls[1].openings[1]", "-2 m of wall between"),
        (BENT, [door(5, 7)], "walls[1].openings[1]", "an opening in an arc or at a corner"),
        (BENT, [door(5, 6)], "walls[1].openings[1]", "an opening in an arc or at a corner"),
        (CLOSED, [door(0, 1)], "walls[1].openings[1]", "an opening in an arc or at a corner"),
        ({**STRAIGHT, "bulges": [0.2]}, [door(2, 3)], "walls[1].openings[1]", "an opening in an arc or at a corner"),
    ],
)
def test_doors_without_wall_on_both_sides_are_refused(
    wall: dict[str, Any], openings: list[Any], place: str, found: str
) -> None:
    """What bears the lintel must be there, and lie in its line; nothing else is reported beside it."""
    with pytest.raises(InputError) as refused:
        model(wall, openings, ON)
    (issue,) = refused.value.issues
    assert issue.location == place
    assert issue.found.startswith(found)


def test_walls_end_at_jambs() -> None:
    """A wall of 6 m with a door has four ends; the jambs are called by how far along the wall they are."""
    ends = wall_ends(model(STRAIGHT, [door(2.5, 3.5)], ON).placed_walls)
    assert [end.name for end in ends] == ["start of W", "jamb at 2.5 m of W", "jamb at 3.5 m of W", "end of W"]
    assert [end.place for end in ends] == [(-3, 0), (-0.5, 0), (0.5, 0), (3, 0)]
    assert [end.legs[0].length for end in ends] == pytest.approx([2.5] * 4)
    assert [math.cos(end.legs[0].angle) for end in ends] == pytest.approx([1, -1, 1, -1])


def test_a_closed_wall_goes_on_past_its_start() -> None:
    """A door at 0.2 m leaves a corner at the start, with 0.2 m of wall on one side."""
    ends = wall_ends(model(CLOSED, [door(0.2, 1.2)], ON).placed_walls)
    names = [end.name for end in ends]
    corners = [f"corner {number} of W" for number in (1, 2, 3, 4)]
    assert names == ["jamb at 1.2 m of W", *corners, "jamb at 0.2 m of W"]


def test_results_are_those_of_two_walls_with_the_loads_by_hand() -> None:
    """A symmetric wall: settlements as under four line loads; the table knows the sum, and the largest load."""
    mesh = {"size": 1.0}
    with_door = solve(model(STRAIGHT, [door(2.5, 3.5)], ON, mesh=mesh)).only
    more = Q + 50e3 / SPREAD
    x = (-3, -0.5 - SPREAD, -0.5, 0.5, 0.5 + SPREAD, 3)
    lines = [
        {"kind": "line", "q": q, "points": [(x[a], 0), (x[a + 1], 0)], "width": 0.25}
        for a, q in ((0, Q), (1, more), (3, more), (4, Q))
    ]
    by_hand = solve(model(STRAIGHT, [], *lines, mesh=mesh)).only
    w, expected = (one.plate.value_at("settlement", np.array([-3, -1, 0, 1, 3]), 0.0) for one in (with_door, by_hand))
    assert w == pytest.approx(expected, rel=1e-9)
    assert w[::-1] == pytest.approx(w, rel=1e-9)


def test_tables_and_drawings_show_the_door(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """From the file: the sum of the load, its largest value beside the door, both pieces in plan, and the check."""
    m = model(STRAIGHT, [door(2.5, 3.5)], ON, mesh={"size": 1.0})
    path = tmp_path / "case.toml"
    path.write_text(casefile.to_toml(m), encoding="utf-8")
    read = casefile.load(path)
    assert read == m
    table = table_makers(solve(read))["walls"]()
    row = dict(zip([column.name for column in table.columns], table.rows()[0], strict=True))
    assert row["load"] == pytest.approx(600)
    assert row["least load per length"] == pytest.approx(100)
    assert row["greatest load per length"] == pytest.approx(100 + 50 / SPREAD)
    outlines = [shape for shape in plan_shapes(read) if shape.layer == "WALLS"]
    assert len(outlines) == 2
    (wall,), (load,) = plan_of(read)["walls"], plan_of(read)["loads"]
    assert wall["pieces"] == [[[-3, 0], [-0.5, 0]], [[0.5, 0], [3, 0]]]
    assert len(load["pieces"]) == 4
    assert main.main(["check", str(path)]) == 0
    assert "an opening 2.1 m high from 2.5 m to 3.5 m" in capsys.readouterr().out


def test_a_building_stands_on_walls_without_doors() -> None:
    """What a frame brings acts along all of a wall."""
    frame = {"storeys": [3.0], "E": 30e9, "beams": [{"through": ["W", "C"], "section": SECTION}]}
    column = {"name": "C", "x": 0.0, "y": 3.0, "width_x": 0.4, "width_y": 0.4}
    with pytest.raises(InputError) as refused:
        model(STRAIGHT, [door(2.5, 3.5)], ON, building=frame, columns=[column])
    assert [issue.found for issue in refused.value.issues] == ['wall "W", which has openings']


SECTION = {"kind": "rectangle", "width": 0.3, "height": 0.6}
