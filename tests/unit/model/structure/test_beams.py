"""Beams: sections, where they may run, and what is wrong with them otherwise."""

from __future__ import annotations

from typing import Any

import pytest

import groundslab as gs
from groundslab.errors import InputError
from groundslab.model.loads.acting import LineForce
from groundslab.model.structure.beams import torsion_constant

SECTION = {"kind": "rectangle", "width": 0.3, "height": 0.6}
GIVEN = {"kind": "properties", "second_moment": 1e-3, "shear_area": 0.1}
CIRCLE = {"kind": "circle", "centre": (0.0, 0.0), "radius": 1.0}
ACROSS = {"name": "A", "points": [(-3.0, 0.0), (3.0, 0.0)], "section": SECTION}


def model(*beams: dict[str, Any], **others: Any) -> gs.Model:
    """Return a plate of 6 m by 4 m with beams."""
    parts: dict[str, Any] = {
        "plate": {"length_x": 6.0, "length_y": 4.0, "thickness": 0.2, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 20e6},
        "beams": beams,
        "loads": [{"kind": "uniform", "q": 10e3}],
    }
    return gs.Model(**parts | others)


def issues(*beams: dict[str, Any], **others: Any) -> list[str]:
    """Return what is wrong with beams."""
    with pytest.raises(InputError) as caught:
        model(*beams, **others)
    return [f"{issue.location}: {issue.found}" for issue in caught.value.issues]


def test_a_square_has_the_torsion_constant_of_the_tables() -> None:
    """0.1406 a^4 for a square, 0.229 a b^3 for sides of 2 to 1, a b^3 / 3 for a thin strip (Timoshenko 1951)."""
    assert torsion_constant(1.0, 1.0) == pytest.approx(0.1406, rel=2e-3)
    assert torsion_constant(2.0, 1.0) == torsion_constant(1.0, 2.0) == pytest.approx(0.229 * 2, rel=2e-3)
    assert torsion_constant(0.01, 1.0) == pytest.approx(0.01**3 / 3, rel=1e-2)


def test_rigidities_are_those_of_the_plate_unless_the_beam_has_its_own() -> None:
    """E I, G J and G A_v with E and nu of the plate, or of the beam."""
    own = ACROSS | {"E": 200e9, "nu": 0.3}
    of_plate, of_beam = (model(beam).beams[0].rigidities(30e9, 0.2, 0.2) for beam in (ACROSS, own))
    second_moment, A = 0.3 * 0.6**3 / 12, 0.3 * 0.6 * 5 / 6
    assert of_plate[::2] == pytest.approx((30e9 * second_moment, 30e9 / 2.4 * A))
    assert of_beam[::2] == pytest.approx((200e9 * second_moment, 200e9 / 2.6 * A))
    assert of_plate[1] / of_beam[1] == pytest.approx(30 / 2.4 / (200 / 2.6))


def test_a_flange_of_another_material_counts_by_its_stiffness() -> None:
    """Two equal parts, one twice as stiff: the common axis lies a third of the distance from the stiffer one."""
    rib = ACROSS | {"section": {"kind": "rib", "width": 0.5, "height": 0.2, "effective_width": 0.5}, "E": 60e9}
    bending = model(rib).beams[0].rigidities(30e9, 0.2, 0.2)[0]
    second_moment, A, e = 0.5 * 0.2**3 / 12, 0.5 * 0.2, 0.2
    about_common = 60e9 * (second_moment + A * (e / 3) ** 2) + 30e9 * A * (2 * e / 3) ** 2
    assert bending == pytest.approx(about_common)


def test_an_eccentric_rib_has_its_own_section_off_the_middle_plane() -> None:
    """E I about its own axis, E A, and the distance of both middles; below is positive."""
    rib = {"kind": "rib", "width": 0.3, "height": 0.6, "eccentric": True}
    below, above = (model(ACROSS | {"section": rib | {"side": side}}).beams[0] for side in ("below", "above"))
    assert below.rigidities(30e9, 0.2, 0.2)[::3] == pytest.approx((30e9 * 0.3 * 0.6**3 / 12, 30e9 * 0.18))
    assert (below.eccentricity(0.2), above.eccentricity(0.2)) == pytest.approx((0.4, -0.4))
    assert below.added_bending(30e9, 0.2) > below.rigidities(30e9, 0.2, 0.2)[0]
    given = model(ACROSS | {"section": GIVEN | {"area": 0.1, "eccentricity": -0.25}}).beams[0]
    assert given.rigidities(30e9, 0.2, 0.2)[::3] == pytest.approx((30e6, 3e9))
    assert given.eccentricity(0.2) == -0.25


@pytest.mark.parametrize(
    ("beams", "said"),
    [
        ([ACROSS | {"points": [(-3.0, 0.0), (4.0, 0.0)]}], "beams[1].points: 1 m of 7 m that do not lie on the plate"),
        ([ACROSS | {"points": [(0.0, 0.0), (0.0, 0.0)]}], "beams[1].points[2]: (0.0, 0.0) m twice"),
        ([ACROSS | {"points": [(0.0, 0.0)]}], "beams[1].points: 1 point"),
        ([ACROSS, ACROSS], "beams[2].name: \"A\" again"),
        ([ACROSS, ACROSS | {"name": "B", "points": [(1.0, 0.0), (5.0, 0.0)]}], "beams[2].points: 2 m of 4 m that"),
        ([ACROSS, ACROSS | {"name": "B", "points": [(1.0, 0.0), (2.0, 0.0)]}], "beams[2]: a beam along 1 m of \"A\""),
        ([ACROSS | {"points": [(-3.0, 1.9999), (3.0, 1.9999)]}], "beams[1].points: 0.0001 m between it and plate"),
        ([ACROSS | {"section": SECTION | {"width": 0.0}}], "beams[1].section.width: 0"),
        ([ACROSS | {"section": {"kind": "tee"}}], "beams[1].section.kind: \"tee\""),
        ([{"name": "A", "section": SECTION}], "beams[1].points: nothing"),
        ([ACROSS | {"section": SECTION | {"kind": "rib"}}], "beams[1].section.effective_width: nothing"),
        ([ACROSS | {"section": GIVEN | {"area": 0.1}}], "beams[1].section.eccentricity: nothing, with an area"),
        ([ACROSS | {"section": GIVEN | {"eccentricity": 0.1}}], "beams[1].section.area: nothing, with an eccentricity"),
        ([{"name": "A", "section": SECTION, "shape": CIRCLE, "joined": ["hinged", "fixed"]}],
         "beams[1].joined: hinged ends of a closed beam"),
        ([ACROSS | {"points": [(-3.0, 0.0), (1.0, 0.0)], "joined": ["hinged", "hinged"]}],
         "beams[1].joined: a hinged end inside the plate"),
        ([ACROSS | {"points": [(-3.0, 0.0), (1.0, 0.0), (-1.0, 0.0)]}], "beams[1]: a beam that runs back along 2 m"),
        ([{"name": "A", "section": SECTION, "shape": CIRCLE | {"centre": (2.0, 0.0)}}],
         "beams[1].shape: a curve with arcs that touches an edge of the plate"),
        ([ACROSS, ACROSS | {"name": "B", "points": [(-3.0, 1e-5), (0.0, 1.0)]}],
         "beams[2].points: 1e-05 m between it and beams[1]"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_told(beams: list[dict[str, Any]], said: str) -> None:
    """Where it is, and what was found there."""
    assert any(each.startswith(said) for each in issues(*beams)), issues(*beams)


def test_a_beam_spans_openings_straight_from_edge_to_edge() -> None:
    """One that ends over an opening is told, one with a corner there, a rib, two that meet; one along its edge runs."""
    holed = {"length_x": 6.0, "length_y": 4.0, "thickness": 0.2, "E": 30e9, "nu": 0.2,
             "openings": [{"kind": "rectangle", "x": (-1.0, 1.0), "y": (-1.0, 1.0)}]}  # fmt: skip
    assert gs.solve(model(ACROSS, plate=holed)).only.beams[0].way[-1] == pytest.approx(6.0)
    ends = ACROSS | {"points": [(-3.0, 0.0), (0.5, 0.0)]}
    assert issues(ends, plate=holed) == ["beams[1].points: 1.5 m of 3.5 m that do not lie on the plate"]
    bent = ACROSS | {"points": [(-3.0, 0.0), (0.0, 0.0), (3.0, 0.5)]}
    assert issues(bent, plate=holed) == ["beams[1].points: 2.01 m over an opening with a corner or an arc"]
    arc = ACROSS | {"bulges": [0.1]}
    assert issues(arc, plate=holed) == ["beams[1].points: 2 m over an opening with a corner or an arc"]
    straight = ACROSS | {"points": [(-3.0, 0.0), (0.0, 0.0), (3.0, 0.0)]}
    assert gs.solve(model(straight, plate=holed)).only.beams[0].way[-1] == pytest.approx(6.0)
    landing = {"name": "other", "points": [(1.0, -2.0), (1.0, 2.0)], "section": SECTION}
    assert gs.solve(model(ACROSS, landing, plate=holed)).only.certificate.holds
    rib = ACROSS | {"section": {"kind": "rib", "width": 0.3, "height": 0.5, "effective_width": 1.0}}
    assert issues(rib, plate=holed) == ["beams[1].points: a rib of which 2 m over an opening have no flange"]
    other = {"name": "other", "points": [(0.0, -2.0), (0.0, 2.0)], "section": SECTION}
    assert issues(ACROSS, other, plate=holed) == [
        "beams[1].points: 2 m over an opening where it meets another beam",
        "beams[2].points: 2 m over an opening where it meets another beam",
    ]
    beside = model(ACROSS | {"points": [(-3.0, 1.0), (3.0, 1.0)]}, plate=holed)
    assert gs.solve(beside).only.beams[0].way[-1] == pytest.approx(6.0)


def test_a_beam_lies_on_plates() -> None:
    """One along a joint is told, and one over a strip between plates; one across runs, and beams of either side."""
    plates = [{"name": "other", "outline": {"kind": "rectangle", "x": (3.0, 9.0), "y": (-2.0, 2.0)},
               "thickness": 0.2, "E": 30e9, "nu": 0.2}]  # fmt: skip
    plate = {"name": "one", "length_x": 6.0, "length_y": 4.0, "thickness": 0.2, "E": 30e9, "nu": 0.2}
    joined: dict[str, Any] = {
        "plate": plate, "plates": plates, "joints": [{"kind": "hinge", "between": ["one", "other"]}],
    }  # fmt: skip
    upon = ACROSS | {"points": [(3.0, -2.0), (3.0, 2.0)]}
    assert issues(upon, **joined) == ['beams[1]: a beam along the joint "one - other"']
    beside = ACROSS | {"name": "B", "points": [(3.0, 0.0), (9.0, 0.0)]}
    found = gs.solve(model(ACROSS, beside, **joined)).only
    assert found.certificate.holds
    assert [beam.way[-1] for beam in found.beams] == pytest.approx([6.0, 6.0])
    over = ACROSS | {"points": [(-3.0, 0.0), (6.0, 0.0)]}
    assert gs.solve(model(over, **joined)).only.beams[0].way[-1] == pytest.approx(9.0)
    apart = [plates[0] | {"outline": {"kind": "rectangle", "x": (4.0, 9.0), "y": (-2.0, 2.0)}}]
    assert issues(over, plate=plate, plates=apart) == ["beams[1].points: 1 m off the plates, from one to another"]


def test_a_beam_too_stiff_for_sixteen_digits_is_told() -> None:
    """A beam as stiff as nothing else."""
    with pytest.raises(gs.IllConditioned, match=r"a beam is .* times as stiff as the ground"):
        gs.solve(model(ACROSS | {"E": 1e18}))


def test_a_beam_follows_a_closed_shape() -> None:
    """Around a rectangle and around a circle, as far as their circumferences."""
    for shape, length in (
        ({"kind": "rectangle", "x": (-2.0, 2.0), "y": (-1.0, 1.0)}, 12.0),
        ({"kind": "circle", "centre": (0.0, 0.0), "radius": 1.0}, 6.283185),
    ):
        found = gs.solve(model({"name": "ring", "shape": shape, "section": SECTION}, mesh={"size": 0.5})).only
        assert found.certificate.holds
        assert found.beams[0].way[-1] == pytest.approx(length, rel=1e-4)


def test_a_self_weight_weighs_beams_of_concrete_if_it_says_so() -> None:
    """A rib by its section, a rectangle by what is higher than the plate, one by its properties not at all."""
    weight = {"kind": "self weight", "unit_weight": 25e3}
    rib = {"kind": "rib", "width": 0.4, "height": 0.5, "effective_width": 1.0}
    ribs = [
        ACROSS,
        {"name": "B", "points": [(0.0, -2.0), (0.0, 2.0)], "section": rib},
        {"name": "C", "points": [(1.0, -2.0), (1.0, 2.0)], "section": GIVEN},
        {
            "name": "D",
            "points": [(2.0, -2.0), (2.0, 2.0)],
            "section": {"kind": "rectangle", "width": 1.0, "height": 0.15},
        },
    ]
    plain, weighed = (model(*ribs, loads=[weight | {"beams": beams}]) for beams in (False, True))
    assert [type(shape).__name__ for _, shape in plain.acting] == ["PlateAction"]
    lines = [shape for _, shape in weighed.acting if isinstance(shape, LineForce)]
    assert [(line.length, line.q[0]) for line in lines] == [
        (6.0, pytest.approx(25e3 * 0.3 * 0.4)), (4.0, pytest.approx(25e3 * 0.4 * 0.5)),
    ]  # fmt: skip
    solved = gs.solve(weighed.replace(mesh={"size": 1.0})).only
    assert solved.certificate.load == pytest.approx(25e3 * (24 * 0.2 + 6 * 0.12 + 4 * 0.2), rel=1e-9)


def test_rectangles_weigh_what_is_higher_than_the_plate_there() -> None:
    """0.3 m by 0.6 m over 6 m: 0.4 m beside 0.2 m of plate, 0.2 m over 2 m of a zone of 0.4 m, none in one of 0.7 m."""
    weight = {"kind": "self weight", "unit_weight": 25e3, "beams": True}
    zones = [{"shape": {"kind": "rectangle", "x": x, "y": (-1.0, 1.0)}, "thickness": t}
             for x, t in (((-1.0, 1.0), 0.4), ((2.0, 2.5), 0.7))]  # fmt: skip
    plate = {"length_x": 6.0, "length_y": 4.0, "thickness": 0.2, "E": 30e9, "nu": 0.2, "zones": zones}
    found = model(ACROSS, plate=plate, loads=[weight])
    lines = [shape for _, shape in found.acting if isinstance(shape, LineForce)]
    assert [(round(line.length, 6), round(line.q[0] / 25e3, 6)) for line in lines] == [
        (2.0, 0.12), (2.0, 0.06), (1.0, 0.12), (0.5, 0.12)]  # fmt: skip
