"""Beams and walls that go on across joints of slabs, against hand calculations and the slab without a joint."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.results.records import BeamResult
from groundslab.results.results import CombinationResult

E, INERTIA, SHEAR_AREA = 30e9, 2e-3, 0.25
SECTION = {"kind": "properties", "second_moment": INERTIA, "torsion_constant": 1e-3, "shear_area": SHEAR_AREA}
ECCENTRIC = SECTION | {"area": 0.3, "eccentricity": 0.4}
WALL_HEIGHT, WALL_THICKNESS = 2.0, 0.3
JOINTS = {
    "hinge": {"kind": "hinge"},
    "dowels": {"kind": "elastic", "stiffness": 10e6},
    "play": {"kind": "elastic", "stiffness": 10e6, "gap": 1e-3},
    "nothing": {"kind": "elastic", "stiffness": 0.0},
}
POINTS = [(-4.0, 0.0), (4.0, 0.0)]
BEAM = {"beams": [{"name": "B", "section": SECTION, "points": POINTS, "E": E, "nu": 0.0}]}
ECCENTRIC_BEAM = {"beams": [{"name": "B", "section": ECCENTRIC, "points": POINTS, "E": E, "nu": 0.0}]}
WALL: dict[str, Any] = {"name": "W", "thickness": WALL_THICKNESS, "height": WALL_HEIGHT, "points": POINTS,
                        "E": E, "nu": 0.0}  # fmt: skip
MEMBERS = {"beam": BEAM, "eccentric": ECCENTRIC_BEAM, "wall": {"walls": [WALL]}}


def slabs(joint: str | None, width: float, slab: float = E, **more: Any) -> gs.Model:
    """Return two slabs side by side, from x = -5 m to a joint at x = 0 and on to 5 m, or one slab without the joint."""
    plate = {"thickness": 0.2, "E": slab, "nu": 0.0}

    def outline(start: float, end: float) -> dict[str, Any]:
        return {"kind": "rectangle", "x": (start, end), "y": (-width / 2, width / 2)}

    parts: dict[str, Any] = {"plate": plate | {"outline": outline(-5.0, 5.0)}}
    if joint is not None:
        parts = {
            "plate": plate | {"name": "a", "outline": outline(-5.0, 0.0)},
            "plates": [plate | {"name": "b", "outline": outline(0.0, 5.0)}],
            "joints": [JOINTS[joint] | {"between": ("a", "b")}],
        }
    given = {
        "ground": {"kind": "winkler", "k": 20e6},
        "contact": {"tensionless": False},
        "loads": [{"kind": "point", "P": 100e3, "x": -1.0, "y": 0.0}],
    }
    return gs.Model(**(parts | given | more))


def only(model: gs.Model) -> CombinationResult:
    """Return the only combination, certified."""
    results = gs.solve(model).only
    assert results.certificate.holds
    return results


def member(model: gs.Model) -> BeamResult:
    """Return the results of the only member."""
    (found,) = only(model).beams
    return found


@pytest.mark.parametrize("joint", list(JOINTS))
@pytest.mark.parametrize("kind", list(MEMBERS))
def test_a_member_spans_over_a_joint_at_midspan(kind: str, joint: str) -> None:
    """Of 8 m on two line supports, on slabs as soft as nothing: q L^2 / 8 at the joint, and the deflection by hand."""
    length, q = 8.0, 20e3
    ends = [{"kind": "line", "points": [(x, -0.5), (x, 0.5)], "acts": "both ways"} for x in (-length / 2, length / 2)]
    load = {"kind": "line", "points": POINTS, "q": q}
    ground = {"kind": "winkler", "k": 1.0}
    found = member(slabs(joint, 1.0, 1e6, ground=ground, supports=ends, loads=[load], mesh={"size": 0.25},
                         **MEMBERS[kind]))  # fmt: skip
    area, inertia = (
        (5 / 6 * WALL_THICKNESS * WALL_HEIGHT, WALL_THICKNESS * WALL_HEIGHT**3 / 12)
        if kind == "wall"
        else (SHEAR_AREA, INERTIA)
    )
    deflection = 5 * q * length**4 / (384 * E * inertia) + q * length**2 / 8 / (E / 2 * area)
    middle = np.flatnonzero(np.abs(found.nodes[:, 0]) < 1e-9)
    assert len(middle) == 2, "both sides of the joint are told"
    assert found.settlement[middle] == pytest.approx(deflection, rel=2e-3)
    assert found.moment[middle] == pytest.approx(q * length**2 / 8, rel=2e-3)
    # of the slab's side, whatever its joint carries
    assert found.shear[middle] == pytest.approx(0.0, abs=0.02 * q * length / 2)


@pytest.mark.parametrize("kind", ["beam", "wall"])
def test_a_member_closes_the_joint_of_a_narrow_strip(kind: str) -> None:
    """A strip 0.2 m wide settles as without a joint, at which the member carries the slab's share of moment, too."""
    one, two = (member(slabs(joint, 0.2, mesh={"size": 0.1}, **MEMBERS[kind])) for joint in (None, "hinge"))
    assert two.settlement.max() == pytest.approx(one.settlement.max(), rel=5e-4)
    assert two.settlement.min() == pytest.approx(one.settlement.min(), abs=5e-4 * one.settlement.max())
    assert two.moment.max() == pytest.approx(one.moment.max(), rel=1e-3)
    own = INERTIA if kind == "beam" else WALL_THICKNESS * WALL_HEIGHT**3 / 12
    slab = 0.2 * 0.2**3 / 12
    at_joint = one.moment[np.abs(one.nodes[:, 0]) < 1e-9][0]
    # the slab has its share again some way off the joint
    assert two.moment[np.abs(two.nodes[:, 0]) < 1e-9] == pytest.approx(at_joint * (1 + slab / own), rel=1e-2)


def test_an_eccentric_rib_has_no_axial_force_at_a_joint() -> None:
    """Nothing else crosses the joint, so that the rib's normal force there vanishes as the mesh becomes finer."""
    forces = []
    for size in (0.2, 0.1, 0.05):
        found = member(slabs("hinge", 0.2, mesh={"size": size}, **ECCENTRIC_BEAM))
        forces.append(np.abs(found.axial[np.abs(found.nodes[:, 0]) < 1e-9]).max() / np.abs(found.axial).max())
    assert forces == sorted(forces, reverse=True)
    assert forces[-1] < 0.75 * forces[-2] < 0.75**2 * forces[-3]


GROUNDS: dict[str, dict[str, Any]] = {
    "winkler": {"ground": {"kind": "winkler", "k": 20e6}},
    "vlasov": {"ground": {"kind": "vlasov", "layers": [{"thickness": 5.0, "E": 20e6, "nu": 0.3}]}},
    "continuum": {"ground": {"kind": "continuum", "layers": [{"thickness": 5.0, "E": 20e6, "nu": 0.3}]}},
}
WEIGHT = {"kind": "uniform", "q": 5e3}
FORCE = {"kind": "point", "P": 100e3, "x": -1.0, "y": 0.5}


@pytest.mark.parametrize("ground", list(GROUNDS))
@pytest.mark.parametrize("kind", list(MEMBERS))
def test_slabs_turned_and_exchanged_answer_alike(kind: str, ground: str) -> None:
    """Mirrored at the joint, slabs, member and load give the mirrored answer, lifting off, on any ground."""
    given: dict[str, Any] = {"contact": {"tensionless": True}, "mesh": {"size": 1.0}, **GROUNDS[ground]}
    back = {key: [each | {"points": POINTS[::-1]} for each in members] for key, members in MEMBERS[kind].items()}
    here = member(slabs("play", 3.0, loads=[WEIGHT, FORCE], **given, **MEMBERS[kind]))
    there = member(slabs("play", 3.0, loads=[WEIGHT, FORCE | {"x": 1.0}], **given, **back))
    assert there.settlement == pytest.approx(here.settlement, abs=1e-6 * here.settlement.max())
    assert there.moment == pytest.approx(here.moment, abs=1e-6 * here.moment.max())
    assert there.axial == pytest.approx(here.axial, abs=1e-6 * max(here.axial.max(), 1.0))


def test_a_slab_without_loads_hangs_on_a_beam() -> None:
    """The second slab weighs nothing and lifts off whole; nothing of it is taken for an error."""
    found = only(slabs("hinge", 3.0, contact={"tensionless": True}, loads=[FORCE | {"x": -4.0}], mesh={"size": 0.5},
                       **BEAM))  # fmt: skip
    assert found.beams[0].settlement[-1] < 0.0


def three(**more: Any) -> gs.Model:
    """Return three slabs of 6 m in a row, with hinges between, under a force on the first one."""
    plate = {"thickness": 0.2, "E": E, "nu": 0.2}

    def outline(start: float) -> dict[str, Any]:
        return {"kind": "rectangle", "x": (start, start + 6.0), "y": (-3.0, 3.0)}

    return gs.Model(
        **{
            "plate": plate | {"name": "a", "outline": outline(-9.0)},
            "plates": [plate | {"name": name, "outline": outline(x)} for name, x in (("b", -3.0), ("c", 3.0))],
            "joints": [{"kind": "hinge", "between": pair} for pair in (("a", "b"), ("b", "c"))],
            "ground": {"kind": "winkler", "k": 20e6},
            "loads": [{"kind": "point", "P": 200e3, "x": -4.0, "y": 0.5}, WEIGHT],
            "mesh": {"size": 0.5},
        }
        | more
    )


def test_the_joints_of_eccentric_ribs_hold_no_slab_in_its_plane() -> None:
    """One rib or three across two joints: as many holds as motions are left, and their forces vanish."""
    for places in ((0.0,), (-2.0, 0.0, 2.0)):
        ribs = [{"name": f"R{y}", "section": ECCENTRIC, "points": [(-8.0, y), (8.0, y)]} for y in places]
        results = only(three(beams=ribs))
        axial = np.array([each.axial for each in results.beams])
        assert (np.abs(axial).max(axis=1) > 1e3).all()


def test_a_ring_crosses_a_joint_twice() -> None:
    """A ring of two arcs, begun on a slab and begun at the joint, is the same ring."""
    moments = []
    for points in (((-5.0, 0.0), (-1.0, 0.0), (-5.0, 0.0)), ((-3.0, -2.0), (-3.0, 2.0), (-3.0, -2.0))):
        ring = {"name": "ring", "section": SECTION, "points": points, "bulges": (1.0, 1.0)}
        (found,) = only(three(beams=[ring])).beams
        moments.append((found.moment.max(), found.moment.min(), found.settlement.max()))
    assert moments[1] == pytest.approx(moments[0], rel=5e-3)


def test_openings_of_a_wall_may_begin_at_a_joint() -> None:
    """One wall with an opening from the joint on goes on across it; two walls that end there do not."""
    whole = WALL | {"points": [(-8.0, 0.0), (8.0, 0.0)], "openings": [{"start": 5.0, "end": 7.0, "height": 1e-6}]}
    one = only(three(walls=[whole])).beams
    parts = [WALL | {"name": "W1", "points": [(-8.0, 0.0), (-3.0, 0.0)]},
             WALL | {"name": "W2", "points": [(-3.0, 0.0), (8.0, 0.0)]}]  # fmt: skip
    two = only(three(walls=parts)).beams
    (alike,) = only(three(walls=[whole | {"openings": []}])).beams
    joint = np.abs(alike.nodes[:, 0] + 3.0) < 1e-9
    assert one[0].moment[-1] == pytest.approx(alike.moment[joint][0], rel=1e-3)
    assert one[1].moment[0] == pytest.approx(one[0].moment[-1], rel=2e-2)
    assert abs(two[0].moment[-1]) < 0.1 * abs(one[0].moment[-1])


def test_two_beams_cross_where_four_slabs_meet() -> None:
    """Both go on through the corner, each on its own two slabs, and mirror each other."""
    plate = {"thickness": 0.2, "E": E, "nu": 0.2}
    corners = {"a": (-4.0, -4.0), "b": (0.0, -4.0), "c": (0.0, 0.0), "d": (-4.0, 0.0)}
    a, *others = [
        plate | {"name": name, "outline": {"kind": "rectangle", "x": (x, x + 4.0), "y": (y, y + 4.0)}}
        for name, (x, y) in corners.items()
    ]
    lines = [[(-3.0, -3.0), (3.0, 3.0)], [(3.0, -3.0), (-3.0, 3.0)]]
    results = only(
        gs.Model(
            plate=a,
            plates=others,
            joints=[{"kind": "hinge", "between": pair} for pair in (("a", "b"), ("b", "c"), ("c", "d"), ("d", "a"))],
            beams=[{"name": str(n), "section": SECTION, "points": points} for n, points in enumerate(lines)],
            ground={"kind": "winkler", "k": 20e6},
            loads=[{"kind": "point", "P": 200e3, "x": 0.0, "y": -2.0}, WEIGHT],
            mesh={"size": 0.5},
        )
    )
    one, other = results.beams
    assert one.moment == pytest.approx(other.moment, abs=5e-3 * one.moment.max())
    assert np.abs(one.moment[np.linalg.norm(one.nodes, axis=1) < 1e-9]).min() > 0.05 * one.moment.max()


def test_a_beam_weighs_on_each_slab_what_it_is_beside_it() -> None:
    """Slabs of 20 cm and 30 cm, of which a self-weight names the second: half of the beam, 0.4 * 0.5 m2 of it."""
    outline = {"kind": "rectangle", "x": (0.0, 5.0), "y": (-1.5, 1.5)}
    beam = {"name": "B", "section": {"kind": "rectangle", "width": 0.4, "height": 0.8}, "points": POINTS}
    thicker = [{"name": "b", "outline": outline, "thickness": 0.3, "E": E, "nu": 0.0}]
    for plate, volume in (("a", 0.2 * 15.0 + 0.4 * 0.6 * 4.0), ("b", 0.3 * 15.0 + 0.4 * 0.5 * 4.0)):
        load = {"kind": "self weight", "unit_weight": 25e3, "beams": True, "plate": plate}
        results = only(slabs("hinge", 3.0, plates=thicker, loads=[load], beams=[beam], mesh={"size": 0.5}))
        assert results.certificate.load == pytest.approx(25e3 * volume, rel=1e-9)
