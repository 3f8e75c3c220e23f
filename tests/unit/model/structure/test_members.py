"""Walls with a height as deep beams: their parts, what is wrong with them, and that they are such beams."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.errors import InputError

WALL = {"name": "W", "thickness": 0.25, "height": 3.0, "points": [(-2.0, 0.0), (2.0, 0.0)]}


def model(*walls: dict[str, Any], **others: Any) -> gs.Model:
    """Return a plate of 6 m by 4 m under walls, the first one of which is loaded."""
    parts: dict[str, Any] = {
        "plate": {"length_x": 6.0, "length_y": 4.0, "thickness": 0.3, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 20e6},
        "walls": walls,
        "loads": [{"kind": "line", "wall": walls[0]["name"], "q": 200e3}],
    }
    return gs.Model(**parts | others)


def issues(*walls: dict[str, Any], **others: Any) -> list[str]:
    """Return what is wrong with walls."""
    with pytest.raises(InputError) as caught:
        model(*walls, **others)
    return [f"{issue.location}: {issue.found}" for issue in caught.value.issues]


def test_a_low_wall_is_a_beam() -> None:
    """Where it hardly shears: settlements and section forces as of a beam by the same properties, but for that."""
    t, h, E = 0.25, 0.4, 15e9
    given = {
        "kind": "properties",
        "second_moment": t * h**3 / 12,
        "shear_area": 5 / 6 * t * h,
        "torsion_constant": model(WALL | {"height": h}).members[0].section.torsion_constant,
    }
    beam = {"name": "B", "points": WALL["points"], "section": given, "E": E}
    plain = {key: value for key, value in WALL.items() if key != "height"}
    stiff = gs.solve(model(WALL | {"height": h, "stiffness": 0.5}, mesh={"size": 0.3})).only
    other = gs.solve(model(plain, beams=[beam], mesh={"size": 0.3})).only
    assert stiff.plate.settlement == pytest.approx(other.plate.settlement, rel=2e-3)
    assert stiff.beams[0].moment.max() == pytest.approx(other.beams[0].moment.max(), rel=1e-2)


def test_a_high_wall_keeps_the_slab_straight() -> None:
    """What sags without a height does not with one."""
    soft = gs.solve(model({key: value for key, value in WALL.items() if key != "height"}, mesh={"size": 0.3})).only
    stiff = gs.solve(model(WALL, mesh={"size": 0.3})).only
    assert not soft.beams
    stays, sags = (
        np.subtract(*(each.plate.value_at("settlement", x, 0.0) for x in (0.0, 2.0))) for each in (stiff, soft)
    )
    assert abs(stays) < 0.2 * abs(sags)


def test_a_wall_has_parts_at_its_openings() -> None:
    """As high as they are, along the axis, also around corners; the parts' lengths add up."""
    openings = [{"start": 1.0, "end": 2.0, "height": 2.0}, {"start": 5.0, "end": 8.0, "height": 1.0}]
    around = {"name": "A", "thickness": 0.2, "height": 2.5, "edge": "all", "openings": openings}
    parts = model(around).members
    assert [part.name for part in parts] == [
        "A, 0 m to 1 m", "A, 1 m to 2 m", "A, 2 m to 5 m", "A, 5 m to 8 m", f"A, 8 m to {2 * (5.8 + 3.8):g} m",
    ]  # fmt: skip
    assert [part.section.height for part in parts] == [2.5, 0.5, 2.5, 1.5, 2.5]
    assert sum(part.length for part in parts) == pytest.approx(2 * (5.8 + 3.8))
    for before, after in itertools.pairwise(parts):
        assert math.dist(before.points[-1], after.points[0]) < 1e-12
    found = gs.solve(model(around)).only
    assert found.certificate.holds
    assert [beam.way[-1] for beam in found.beams] == pytest.approx([part.length for part in parts])


def test_a_wall_along_an_arc_has_parts_along_it() -> None:
    """A quarter of a circle and a straight piece; the opening begins on the arc and ends on the piece."""
    arc = math.pi / 2
    wall = {
        "name": "A", "thickness": 0.2, "height": 2.5, "points": [(1.0, 0.0), (0.0, 1.0), (-2.0, 1.0)],
        "bulges": [math.tan(math.pi / 8)], "openings": [{"start": arc / 2, "end": arc + 0.5, "height": 2.0}],
    }  # fmt: skip
    first, middle, last = model(wall).members
    assert [each.length for each in (first, middle, last)] == pytest.approx([arc / 2, arc / 2 + 0.5, 1.5])
    corner = math.sqrt(0.5), math.sqrt(0.5)
    assert first.points[-1] == pytest.approx(corner)
    assert middle.points == (pytest.approx(corner), (0.0, 1.0), pytest.approx((-0.5, 1.0)))
    assert middle.edges[0].centre == pytest.approx((0.0, 0.0), abs=1e-12)
    results = gs.solve(model(wall)).only
    assert results.certificate.holds
    assert sum(beam.way[-1] for beam in results.beams) == pytest.approx(wall_length := arc + 2.0, rel=1e-6)
    assert wall_length == pytest.approx(model(wall).placed_walls[0].length)
    ring = {key: wall[key] for key in ("name", "thickness", "height")}
    around = model(ring | {"shape": {"kind": "circle", "centre": (0.0, 0.0), "radius": 1.5}})
    assert [part.closed for part in around.members] == [True]
    assert gs.solve(around).only.certificate.holds


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"openings": [{"start": 1.0, "end": 0.5, "height": 1.0}]}, "walls[1].openings[1].end: 0.5 m"),
        ({"openings": [{"start": 0.0, "end": 0.5, "height": 3.0}]}, "walls[1].openings[1].height: 3.0 m"),
        ({"openings": [{"start": 3.0, "end": 4.5, "height": 1.0}]}, "walls[1].openings[1].end: 4.5 m"),
        ({"height": None, "stiffness": 0.5}, "walls[1].stiffness: stiffness without a height"),
        (
            {"openings": [{"start": 1.0, "end": 1.001, "height": 1.0}]},
            "walls[1].openings: openings that leave a part of 0.001 m",
        ),
        ({"stiffness": 1.5}, "walls[1].stiffness: 1.5"),
    ],
)
def test_what_cannot_be_is_told(changes: dict[str, Any], said: str) -> None:
    """Where it is, and what was found there."""
    wall = {key: value for key, value in (WALL | changes).items() if value is not None}
    assert any(each.startswith(said) for each in issues(wall)), issues(wall)


def test_members_lie_beside_each_other() -> None:
    """A stiff wall along a beam, or along another wall, is told at the later one; soft walls may lie anywhere."""
    section = {"kind": "rectangle", "width": 0.3, "height": 0.6}
    beam = {"name": "B", "points": [(-1.0, 0.0), (1.0, 0.0)], "section": section}
    assert issues(WALL, beams=[beam]) == ['walls[1]: a beam along 2 m of "B"']
    assert issues(WALL, WALL | {"name": "V"}) == ['walls[2]: a beam along 4 m of "W"']
    assert len(model(WALL, {"name": "V", "thickness": 0.2, "points": WALL["points"]}).members) == 1


def test_stiff_walls_span_openings_of_the_slab() -> None:
    """A wall with a height does, openings in it beside those; one without has nothing to carry its load."""
    holed = {"length_x": 6.0, "length_y": 4.0, "thickness": 0.3, "E": 30e9, "nu": 0.2,
             "openings": [{"kind": "rectangle", "x": (-0.5, 0.5), "y": (-0.5, 0.5)}]}  # fmt: skip
    assert [span.length for span in model(WALL, plate=holed).spans] == pytest.approx([1.0])
    soft = {"name": "V", "thickness": 0.2, "points": WALL["points"]}
    assert issues(soft, plate=holed) == ["walls[1]: a part off the plate, at (-0.5, 0) m"]
    beside = WALL | {"openings": [{"start": 0.2, "end": 1.0, "height": 1.0}]}
    assert gs.solve(model(beside, plate=holed, mesh={"size": 0.5})).only.certificate.holds
    above = WALL | {"openings": [{"start": 0.2, "end": 2.0, "height": 1.0}]}
    told = "walls[1].openings[1]: an opening that begins or ends over an opening of the plate"
    assert issues(above, plate=holed) == [told]
    assert issues(WALL | {"openings": [{"start": 1.5, "end": 2.5, "height": 1.0}]}, plate=holed) == [told]


@pytest.mark.parametrize(("code", "least", "borne"), [("EN 1992-1-1", 5.0, 2376.0), ("ACI 318", 6.25, 2301.4)])
def test_struts_and_least_bars_of_stiff_walls(code: str, least: float, borne: float) -> None:
    """Both faces together 0.002 0.25 m = 5 cm2/m, or 0.0025 0.25 m = 6.25 cm2/m, of 3 m by 4 m.

    C30/37: 0.25 m 0.6 3 m 10.56 MPa / 2 = 2376 kN, 0.75 0.83 30^(1/2) MPa 0.25 m 0.9 3 m = 2301 kN. The headline says
    that nothing else of them is designed.
    """
    steel = {"f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)}
    case = {
        "cases": [{"name": "G"}],
        "combinations": [{"name": "U", "limit_state": "ultimate", "factors": {"G": 1.35}}],
    }
    loads = [{"kind": "line", "wall": "W", "q": 50e3, "case": "G"}, {"kind": "uniform", "q": 5e3, "case": "G"}]
    solved = gs.solve(model(WALL, reinforcement=steel | {"code": code}, loads=loads, mesh={"size": 0.5}, **case))
    table = {each.name: each for each in gs.tables_of(solved)}["wall_reinforcement"]
    assert table["required bars upright"] == table["required bars level"] == pytest.approx([least])
    assert table["shear force that struts bear"] == pytest.approx([borne], rel=1e-4)
    found = gs.check_design(solved)
    (check,) = (each for each in found.checks if each.name == "walls")
    assert check.status == "no failure found"
    assert check.utilization == pytest.approx(table["share used"][0])
    assert "ties, forces along and across" in found.headline


def test_struts_of_stiff_walls_by_the_second_generation() -> None:
    """C30/37, k_tc = 0.85: 0.25 m 0.6 3 m 0.5 17 MPa / 2 = 1912.5 kN; least bars are told as not read."""
    steel = {"code": "EN 1992-1-1:2023", "f_ck": 30e6, "f_yk": 500e6, "bottom": (0.04, 0.05), "top": (0.04, 0.05)}
    case: dict[str, Any] = {"cases": [{"name": "G"}], "mesh": {"size": 0.5}}
    loads = [{"kind": "line", "wall": "W", "q": 50e3, "case": "G"}]
    ultimate = [{"name": "U", "limit_state": "ultimate", "factors": {"G": 1.35}}]
    solved = gs.solve(model(WALL, reinforcement=steel, loads=loads, combinations=ultimate, **case))
    found = gs.check_design(solved)
    (check,) = (each for each in found.checks if each.name == "walls")
    assert check.resistance == pytest.approx(1912.5)
    assert check.status == "no failure found"
    assert "least bars of walls were not read" in check.words
    table = {each.name: each for each in gs.tables_of(solved)}["wall_reinforcement"]
    assert list(table["required bars upright"]) == [None]


def test_a_wall_too_stiff_for_sixteen_digits_is_told() -> None:
    """It is the wall of which the message speaks."""
    with pytest.raises(gs.IllConditioned, match=r"a wall is .* times as stiff as the ground.* a walls\.E a thousand"):
        gs.solve(model(WALL | {"E": 1e18}, mesh={"size": 0.5}))
