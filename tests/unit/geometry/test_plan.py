"""Plans: arcs, areas, what lies where, and every issue that keeps a plan from being meshed."""

from __future__ import annotations

import math

import numpy as np
import pytest

from groundslab.geometry.plan import Plan, Ring, circle, rectangle, segment
from groundslab.geometry.regions import GROUND, NOTHING, sections
from groundslab.geometry.validity import find_issues

SQUARE = rectangle(0, 10, 0, 8)


def test_semicircle_from_a_bulge() -> None:
    """A bulge of 1 is a semicircle that runs counter-clockwise: to the right of the chord."""
    edge = segment((0.0, 0.0), (2.0, 0.0), 1.0)
    assert edge.centre == pytest.approx((1.0, 0.0))
    assert edge.radius == pytest.approx(1.0)
    np.testing.assert_allclose(edge.at(np.array([0.0, 0.5, 1.0])), [[0, 0], [1, -1], [2, 0]], atol=1e-15)


@pytest.mark.parametrize("bulge", [-2.5, -1.0, -0.2, 0.1, 0.7, 3.0])
def test_arcs_start_and_end_where_they_should(bulge: float) -> None:
    """Centre, angle and sweep lead from the start to the end, over the angle that the bulge says."""
    edge = segment((1.0, 2.0), (4.0, 1.0), bulge)
    angle = edge.angle + np.array([0.0, edge.sweep])
    ends = np.array(edge.centre) + edge.radius * np.column_stack([np.cos(angle), np.sin(angle)])
    np.testing.assert_allclose(ends, [edge.start, edge.end], atol=1e-14)
    assert math.tan(edge.sweep / 4) == pytest.approx(bulge)
    places = edge.at(np.linspace(0, 1, 7))
    np.testing.assert_allclose(edge.distance(places), 0, atol=1e-14)
    assert edge.distance(np.array([[1.0, 52.0]]))[0] > 40
    assert edge.part((float(places[2, 0]), float(places[2, 1]))) == pytest.approx(1 / 3)


def test_areas_are_exact() -> None:
    """A circle, a stadium and a polygon run clockwise have their areas; flattening comes near from inside."""
    assert circle((3.0, -2.0), 2.0).area == pytest.approx(4 * math.pi, rel=1e-14)
    stadium = Ring(((0, 0), (4, 0), (4, 2), (0, 2)), (0, 1, 0, 1))
    assert stadium.area == pytest.approx(8 + math.pi, rel=1e-14)
    assert Ring(SQUARE.points[::-1]).area == 80
    assert stadium.polygon(1e-6).area == pytest.approx(8 + math.pi, rel=1e-5)


def test_flags() -> None:
    """Rings and plans know whether they are straight and whether a grid fits them."""
    assert SQUARE.rectilinear
    assert not circle((0, 0), 1).straight
    assert not Ring(((0, 0), (1, 0), (0, 1))).rectilinear
    assert Plan(SQUARE, points=((1.0, 2.0),), lines=(((1, 1), (1, 5), (3, 5)),)).rectilinear
    assert not Plan(SQUARE, lines=(((1, 1), (2, 5)),)).rectilinear
    assert not Plan(SQUARE, beyond=circle((5, 4), 20)).rectilinear


def test_sections() -> None:
    """The last zone counts, zones end at openings and edges, and ground lies where the plate does not."""
    zones = ((rectangle(0, 5, 0, 8), 1), (rectangle(4, 12, 0, 4), 2))
    plan = Plan(SQUARE, (rectangle(4, 6, 1, 2),), zones)
    places = np.array([[1, 1], [4.5, 3], [9, 3], [9, 7], [11, 2], [5, 1.5]])
    assert sections(plan, places).tolist() == [1, 2, 2, 0, NOTHING, NOTHING]
    ground = Plan(SQUARE, plan.openings, zones, beyond=rectangle(-5, 15, -5, 15))
    assert sections(ground, places).tolist() == [1, 2, 2, 0, GROUND, GROUND]


GOOD = [
    Plan(SQUARE),
    Plan(SQUARE, (circle((4, 4), 1), circle((7, 4), 1))),
    Plan(SQUARE, zones=((rectangle(-3, 5, 0, 8), 1), (SQUARE, 2))),
    Plan(SQUARE, beyond=rectangle(0, 20, 0, 20), points=((0, 0), (10, 3)), lines=(((0, 0), (10, 8)),)),
    Plan(Ring(((0, 0), (2, 0)), (1, 1)), points=((1.0, -1.0),)),
]


@pytest.mark.parametrize("plan", GOOD)
def test_good_plans_have_no_faults(plan: Plan) -> None:
    """Shared edges, zones over the edge and points on arcs are nothing to complain about."""
    assert find_issues(plan) == []


BAD = {
    "too few points": (Plan(Ring(((0, 0), (1, 0)))), "plate.outline", "2 points"),
    "one point": (Plan(Ring(((0, 0),), (1.0,))), "plate.outline", "1 points"),
    "too many bulges": (Plan(Ring(SQUARE.points, (0,) * 5)), "plate.outline", "5 bulges"),
    "not finite": (Plan(Ring(((0, 0), (1, math.nan), (1, 1)))), "plate.outline", "not finite"),
    "no section": (Plan(SQUARE, zones=((rectangle(1, 2, 1, 2), 0),)), "plate.zones[1]", "section 0"),
    "point not finite": (Plan(SQUARE, points=((math.inf, 0),)), "plate.points[1]", "not finite"),
    "line of one point": (Plan(SQUARE, lines=(((1, 1),),)), "plate.lines[1]", "no line"),
    "crossing": (Plan(Ring(((0, 0), (2, 2), (2, 0), (0, 2)))), "plate.outline", "(1, 1)"),
    "double point": (Plan(Ring(((0, 0), (2, 0), (2, 0), (0, 2)))), "plate.outline", "without length at (2, 0)"),
    "spike": (Plan(Ring(((0, 0), (10, 0), (10, 5), (0, 5), (9, 4.9)))), "plate.outline", "at (0, 5)"),
    "double line point": (Plan(SQUARE, lines=(((1, 1), (1, 1)),)), "plate.lines[1]", "without length"),
    "opening outside": (Plan(SQUARE, (rectangle(11, 12, 0, 1),)), "plate.openings[1]", "outside"),
    "opening touches": (Plan(SQUARE, (rectangle(0, 1, 1, 2),)), "plate.openings[1]", "touches or crosses"),
    "opening crosses": (Plan(SQUARE, (rectangle(-1, 1, 1, 2),)), "plate.openings[1]", "touches or crosses"),
    "opening around": (Plan(SQUARE, (rectangle(-1, 11, -1, 9),)), "plate.openings[1]", "around"),
    "opening near": (Plan(SQUARE, (rectangle(0.001, 1, 1, 2),)), "plate.openings[1]", "0.001 m between"),
    "openings meet": (Plan(SQUARE, (rectangle(1, 3, 1, 3), rectangle(2, 4, 1, 3))), "plate.openings[2]", "meets"),
    "opening in opening": (Plan(SQUARE, (rectangle(1, 4, 1, 4), rectangle(2, 3, 2, 3))), "plate.openings[2]", "inside"),
    "openings near": (Plan(SQUARE, (circle((2, 2), 1), circle((4.005, 2), 1))), "plate.openings[2]", "0.005 m"),
    "zone outside": (Plan(SQUARE, zones=((rectangle(10, 12, 0, 8), 1),)), "plate.zones[1]", "nothing of the plate"),
    "zone in opening": (
        Plan(SQUARE, (rectangle(1, 4, 1, 4),), ((rectangle(2, 3, 2, 3), 1),)),
        "plate.zones[1]",
        "nothing of the plate",
    ),
    "zone near": (Plan(SQUARE, zones=((rectangle(0.002, 5, 1, 5), 1),)), "plate.zones[1]", "0.002 m between"),
    "beyond within": (Plan(SQUARE, beyond=rectangle(-1, 9, -1, 9)), "beyond", "leaves out the plate"),
    "point off": (Plan(SQUARE, points=((11, 4),)), "plate.points[1]", "off the plate at (11, 4)"),
    "point in opening": (Plan(SQUARE, (circle((4, 4), 1),), points=((4, 4),)), "plate.points[1]", "off the plate"),
    "line off": (Plan(SQUARE, lines=(((5, 5), (12, 5)),)), "plate.lines[1]", "leaves the plate"),
    "line over opening": (Plan(SQUARE, (circle((4, 4), 1),), lines=(((1, 4), (7, 4)),)), "plate.lines[1]", "leaves"),
    "point near edge": (Plan(SQUARE, points=((0.003, 4),)), "plate.points[1]", "0.003 m between"),
    "points near": (Plan(SQUARE, points=((5, 4), (5.004, 4))), "plate.points[2]", "0.004 m between"),
    "tangent": (
        Plan(SQUARE, (circle((4, 4), 1),), ((rectangle(1, 8, 1, 3), 1),)),
        "plate.openings[1]",
        "parts from plate.zones[1] at (4, 3)",
    ),
}


@pytest.mark.parametrize("name", BAD)
def test_every_fault_is_named(name: str) -> None:
    """Each issue says which part of the plan it is, and where."""
    plan, where, found = BAD[name]
    assert [issue for issue in find_issues(plan) if issue.location == where and found in issue.found], find_issues(plan)


def test_all_faults_come_at_once() -> None:
    """Two openings with a issue each are both reported."""
    plan = Plan(SQUARE, (rectangle(11, 12, 0, 1), rectangle(0, 1, 1, 2)))
    assert {issue.location for issue in find_issues(plan)} == {"plate.openings[1]", "plate.openings[2]"}


@pytest.mark.parametrize("radius", [1e-3, 0.3, 5.0])
def test_circles_look_round_at_any_size(radius: float) -> None:
    """Beside a plate of 10 m the chords of a small circle turn by 4 degrees at most, those of a large one by less."""
    places = circle((1.0, 2.0), radius).flat(2e-4 * 10.0)
    assert len(places) >= 90
    assert radius * (1 - math.cos(math.pi / len(places))) <= 2e-4 * 10.0


def test_arcs_of_lines_are_no_straight_pieces() -> None:
    """One whose ends lie beside each other along an axis makes no grid; its bulges stand beside the points."""
    line = ((3.0, 1.0), (3.0, 5.0), (3.0, 8.0))
    assert Plan(SQUARE, lines=(line,)).rectilinear
    bent = Plan(SQUARE, lines=(line,), line_bulges=((1.0,),))
    assert not bent.rectilinear
    assert [edge.straight for edge in bent.line_segments()] == [False, True]
    assert [edge.radius for edge in bent.arcs()] == [2.0]
