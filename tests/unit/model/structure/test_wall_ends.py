"""Ends and corners of walls: which there are where walls end, bend, meet and cross."""

from __future__ import annotations

import math
from typing import Any

import pytest

from groundslab.model.structure.wall_ends import WallEnd, wall_ends
from groundslab.model.structure.walls import Wall

T = 0.25


def wall(name: str, *points: tuple[float, float], thickness: float = T, **more: Any) -> Wall:
    """Return a wall through points."""
    return Wall(name=name, thickness=thickness, points=points, **more)


def named(*walls: Wall) -> list[str]:
    """Return the names of the ends and corners."""
    return [end.name for end in wall_ends(walls)]


def only_corner(*walls: Wall) -> WallEnd:
    """Return the only corner."""
    (corner,) = (end for end in wall_ends(walls) if end.kind == "corner")
    return corner


A = wall("A", (0, 0), (5, 0))


def test_a_wall_has_two_ends() -> None:
    """Each runs away into the wall, which is as long from both."""
    start, end = wall_ends([A])
    assert (start.name, end.name) == ("start of A", "end of A")
    assert (start.place, end.place) == ((0, 0), (5, 0))
    assert math.cos(start.legs[0].angle) == pytest.approx(1)
    assert math.cos(end.legs[0].angle) == pytest.approx(-1)
    assert start.legs[0].length == end.legs[0].length == 5
    assert (start.legs[0].share, end.legs[0].share) == (0, 1)


@pytest.mark.parametrize(
    "other",
    [
        wall("B", (0, 0), (0, 5)),
        wall("B", (0, 5), (0, 0)),
        wall("B", (0, T / 2), (0, 5)),
        wall("B", (-T / 2, T / 2), (-T / 2, 5)),
    ],
    ids=["from it", "to it", "from its face", "from its face, past its end"],
)
def test_ends_that_meet_at_an_angle_are_one_corner(other: Wall) -> None:
    """An L of two walls, drawn axis to axis or face to face: 270 degrees on the outer side."""
    assert named(A, other) == ["corner of A and B", "end of A", f"{'end' if other.points[-1][1] else 'start'} of B"]
    assert math.degrees(only_corner(A, other).outer_angle) == pytest.approx(270)


@pytest.mark.parametrize("turn", [1, -1])
def test_the_outer_side_lies_to_the_left_of_the_first_leg(turn: int) -> None:
    """However the wall bends, it is from the first leg counterclockwise to the last one."""
    bent = wall("A", (-5, 0), (0, 0), (0, turn * 5.0))
    corner = only_corner(bent)
    outside = math.atan2(-turn, 1)
    assert 0 < (outside - corner.legs[0].angle) % (2 * math.pi) < corner.outer_angle


def test_a_wall_that_ends_on_another_has_no_end_there() -> None:
    """A T, drawn to the axis or to the face, or as three walls that end at one place."""
    for stem in (wall("B", (2, 0), (2, 5)), wall("B", (2, T / 2), (2, 5))):
        assert named(A, stem) == ["start of A", "end of A", "end of B"]
    assert named(A, wall("B", (5, 0), (9, 0)), wall("C", (5, 0), (5, 3))) == ["start of A", "end of B", "end of C"]


def test_a_wall_that_ends_before_another_has_an_end() -> None:
    """A gap of a thickness between its end and the other's face."""
    assert "start of B" in named(A, wall("B", (2, 1.5 * T), (2, 5)))


def test_walls_that_cross_have_no_more_than_their_ends() -> None:
    """A cross of two walls, or of four that end at one place."""
    assert named(A, wall("B", (2, -2), (2, 2))) == ["start of A", "end of A", "start of B", "end of B"]
    four = [wall(name, (0, 0), place) for name, place in zip("ABCD", [(3, 0), (0, 3), (-3, 0), (0, -3)], strict=True)]
    assert named(*four) == [f"end of {name}" for name in "ABCD"]


def test_ends_in_one_line_are_none() -> None:
    """Two walls one after the other, and two that meet at less than 15 degrees."""
    assert named(A, wall("B", (5, 0), (9, 0))) == ["start of A", "end of B"]
    assert named(A, wall("B", (5, 0), (9, 4 * math.tan(math.radians(14))))) == ["start of A", "end of B"]
    assert len(named(A, wall("B", (5, 0), (9, 4 * math.tan(math.radians(16)))))) == 3


def test_walls_on_one_side_of_a_place_have_a_corner_around_all_of_them() -> None:
    """Three walls within 90 degrees: one corner between the outer two; three at 120 degrees none."""
    fan = [wall(name, (0, 0), (3 * math.cos(a), 3 * math.sin(a))) for name, a in zip("ABC", (0, 0.7, 1.5), strict=True)]
    corner = only_corner(*fan)
    assert corner.name == "corner of A and C"
    assert corner.outer_angle == pytest.approx(2 * math.pi - 1.5)
    star = [
        wall(name, (0, 0), (math.cos(a), math.sin(a)))
        for name, a in zip("ABC", (0, 2 * math.pi / 3, 4 * math.pi / 3), strict=True)
    ]
    assert named(*star) == ["end of A", "end of B", "end of C"]


def test_closed_walls_have_corners_only() -> None:
    """None of a circle; four of a rectangle, given as a shape or by points, numbered along it."""
    circle = Wall(name="R", thickness=T, shape={"kind": "circle", "radius": 2.0})
    assert named(circle) == []
    box = Wall(name="R", thickness=T, shape={"kind": "rectangle", "x": (0, 2), "y": (0, 3)})
    by_points = wall("R", (0, 0), (2, 0), (2, 3), (0, 3), (0, 0))
    for each in (box, by_points):
        assert named(each) == [f"corner {number} of R" for number in (1, 2, 3, 4)]
        assert sorted(leg.length for end in wall_ends([each]) for leg in end.legs) == [2] * 4 + [3] * 4


def test_arcs_have_ends_and_no_corners() -> None:
    """A half circle runs away from its end along the tangent; goes on straight without a corner, or aside with one."""
    start, end = wall_ends([wall("A", (0, 0), (4, 0), (4, -3), bulges=(-1.0,))])
    assert math.degrees(start.legs[0].angle) == pytest.approx(90)
    assert start.legs[0].length == end.legs[0].length == pytest.approx(2 * math.pi + 3)
    assert end.place == (4, -3)
    assert named(wall("A", (0, 0), (4, 0), (7, 0), bulges=(-1.0,))) == ["start of A", "corner of A", "end of A"]


def test_a_chamfer_shorter_than_the_wall_is_thick_is_part_of_the_corner() -> None:
    """Two kinks of 45 degrees 0.14 m apart make one corner of 90 degrees."""
    corner = only_corner(wall("A", (0, 0), (5, 0), (5.1, 0.1), (5.1, 4)))
    assert math.degrees(corner.outer_angle) == pytest.approx(270)


def test_corners_of_the_same_walls_are_numbered() -> None:
    """Two walls that meet at both ends."""
    roof = wall("B", (0, 0), (2.5, 3), (5, 0))
    assert named(A, roof) == ["corner 1 of A and B", "corner 2 of A and B", "corner of B"]


def test_a_wall_ends_at_the_edges_of_openings_that_it_spans() -> None:
    """At both edges, with the wall between them and its next end or corner as its leg; the corner stays."""
    walls = [wall("A", (-4, 0), (4, 0), (4, 4))]
    found = {end.name: end for end in wall_ends(walls, {"A": ((2.0, 6.0),)})}
    assert list(found) == ["start of A", "edge at 2 m of A", "edge at 6 m of A", "corner of A", "end of A"]
    assert found["edge at 2 m of A"].place == (-2.0, 0.0)
    assert found["edge at 6 m of A"].place == (2.0, 0.0)
    assert [leg.length for end in found.values() for leg in end.legs] == pytest.approx([2.0, 2.0, 2.0, 2.0, 4.0, 4.0])
    assert [end.legs[0].angle % (2 * math.pi) for end in found.values() if "edge" in end.name] == pytest.approx(
        [math.pi, 0.0], abs=1e-12
    )
