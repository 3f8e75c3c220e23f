"""Beams and walls over openings of the slab, against hand calculations and an independent beam on springs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.model.remarks.remarks import find_remarks
from groundslab.results.records import BeamResult
from groundslab.results.results import CombinationResult
from groundslab.views.tables.result_tables import tables_of

E, INERTIA, TORSION, SHEAR_AREA = 30e9, 2e-3, 1e-3, 0.005
G = E / 2.4
SECTION = {"kind": "properties", "second_moment": INERTIA, "torsion_constant": TORSION, "shear_area": SHEAR_AREA}
POINTS = ((-4.0, 0.0), (4.0, 0.0))
SPAN = 4.0
BEAM = {"name": "B", "section": SECTION, "points": POINTS, "E": E, "nu": 0.2}
WALL = {"name": "W", "thickness": 0.3, "height": 2.0, "points": POINTS, "E": E, "nu": 0.2}
OPENING = {"kind": "rectangle", "x": (-SPAN / 2, SPAN / 2), "y": (-1.0, 1.0)}


def slab(thickness: float = 0.3, beam: dict[str, Any] | None = None, **more: Any) -> gs.Model:
    """Return a slab of 12 m by 8 m with an opening of 4 m by 2 m in the middle, which a beam or a wall spans."""
    members = {"beams": [beam or BEAM]} if "walls" not in more else {}
    return gs.Model(
        **{
            "plate": {"length_x": 12.0, "length_y": 8.0, "thickness": thickness, "E": E, "nu": 0.2,
                      "openings": [OPENING]},
            "ground": {"kind": "winkler", "k": 20e6},
            "contact": {"tensionless": False},
            "mesh": {"size": 0.5},
            "loads": [{"kind": "line", "points": POINTS, "q": 100e3, "q_end": 200e3}],
        } | members | more
    )  # fmt: skip


def only(model: gs.Model) -> CombinationResult:
    """Return the only combination, certified."""
    results = gs.solve(model).only
    assert results.certificate.holds
    return results


def over_opening(beam: BeamResult) -> dict[str, np.ndarray]:
    """Return what is told of a beam between the edges of the opening, from its start on."""
    inside = np.flatnonzero(np.abs(beam.nodes[:, 0]) < SPAN / 2 + 1e-9)[1:-1]
    assert len(inside) == 9
    return {name: getattr(beam, name)[inside] for name in ("way", "settlement", "moment", "shear", "torsion", "axial")}


def test_a_beam_between_thick_slabs_is_fixed() -> None:
    """A slab 10 m thick holds both ends: fixed-end moments of a trapezoidal load, by hand, shear deformation included.

    For q_0 + a (2 s / L - 1), phi = 12 E I / (G A_v L^2): M(0) = -q_0 L^2 / 12 + a L^2 (1/60 + phi/12 / 6) / (1 + phi).
    """
    found = over_opening(only(slab(10.0)).beams[0])
    q_0, a = 150e3, 25e3
    phi = 12 * E * INERTIA / (G * SHEAR_AREA * SPAN**2)
    assert phi > 0.5, "shear counts"
    # of the antisymmetric part the half beam: fixed at one end, simply supported in the middle
    V_a = -a * SPAN * (1 / 5 + phi / 6) / (1 + phi)
    ends = [-q_0 * SPAN**2 / 12 - sign * (V_a * SPAN / 2 + a * SPAN**2 / 12) for sign in (1.0, -1.0)]
    # the slabs turn a little
    assert found["moment"][[0, -1]] == pytest.approx(ends, rel=2e-2)
    s = found["way"] - found["way"][0]
    M, V = found["moment"], found["shear"]
    growth = 2 * a / SPAN
    q = q_0 - a
    assert found["shear"] == pytest.approx(V[0] - q * s - growth * s**2 / 2, rel=1e-9, abs=1e-3)
    assert found["moment"] == pytest.approx(M[0] + V[0] * s - q * s**2 / 2 - growth * s**3 / 6, rel=1e-9, abs=1e-3)
    rest = found["settlement"] - np.interp(s, s[[0, -1]], found["settlement"][[0, -1]])
    middle = q_0 * SPAN**4 / (384 * E * INERTIA) + q_0 * SPAN**2 / (8 * G * SHEAR_AREA)
    assert rest[4] == pytest.approx(middle, rel=2e-2)


def test_a_load_on_half_of_a_span_between_thick_slabs() -> None:
    """Fixed-end moments of q on the first half: 11 q L^2 / 192 and 5 q L^2 / 192, with hardly any shear deformation."""
    stiff = BEAM | {"section": SECTION | {"shear_area": 5.0}}
    load = {"kind": "line", "points": ((-4.0, 0.0), (0.0, 0.0)), "q": 100e3}
    found = over_opening(only(slab(10.0, beam=stiff, loads=[load])).beams[0])
    ends = [-11 / 192 * 100e3 * SPAN**2, -5 / 192 * 100e3 * SPAN**2]
    assert found["moment"][[0, -1]] == pytest.approx(ends, rel=3e-2)
    assert found["shear"][[0, -1]] == pytest.approx([13 / 32 * 100e3 * SPAN, -3 / 32 * 100e3 * SPAN], rel=1e-2)


@pytest.mark.parametrize("parts", [
    [((-4.0, 0.0), (0.7, 0.0)), ((0.7, 0.0), (4.0, 0.0))],
    [((4.0, 0.0), (-0.3, 0.0), (-4.0, 0.0))],
    [((-4.0, 1e-6), (4.0, 1e-6))],
])  # fmt: skip
def test_loads_on_a_span_may_come_in_parts(parts: list[tuple[tuple[float, float], ...]]) -> None:
    """In two lines, in one of two pieces, from the other end, and off the axis by rounding: the same as one line."""
    whole, divided = (
        only(slab(loads=[{"kind": "line", "points": points, "q": 100e3} for points in lines]))
        for lines in ([POINTS], parts)
    )
    assert divided.certificate.load == pytest.approx(800e3, rel=1e-6)
    for name in ("settlement", "moment", "shear"):
        expected = getattr(whole.beams[0], name)
        assert getattr(divided.beams[0], name) == pytest.approx(expected, abs=1e-4 * np.abs(expected).max())


def test_couples_along_a_span_twist_it() -> None:
    """Line moments of 50 kNm/m between thick slabs: T = m (s - L / 2), nothing else."""
    load = {"kind": "line moment", "points": POINTS, "m": 50e3}
    found = over_opening(only(slab(10.0, loads=[load])).beams[0])
    s = found["way"] - found["way"][0]
    assert found["torsion"] == pytest.approx(50e3 * (s - SPAN / 2), abs=1e-3 * 50e3 * SPAN)
    assert found["moment"] == pytest.approx(0.0, abs=1.0)


MEMBERS = {
    "beam": {"beams": [BEAM]},
    "eccentric": {"beams": [BEAM | {"section": SECTION | {"area": 0.3, "eccentricity": 0.4}}]},
    "wall": {"walls": [WALL]},
}


@pytest.mark.parametrize("kind", list(MEMBERS))
def test_a_span_is_as_a_beam_on_a_slab_of_nothing(kind: str) -> None:
    """Where the opening is filled by a slab of a millionth of the stiffness over a void, the mesh follows the beam.

    Then its pieces, not the span, give settlements, moments and shear forces over the opening; the slab lifts off.
    """
    loads = [
        {"kind": "line", "points": POINTS, "q": 100e3, "q_end": 200e3},
        {"kind": "point", "P": 300e3, "x": -3.0, "y": 1.0},
        {"kind": "uniform", "q": 5e3},
    ]
    given: dict[str, Any] = {"loads": loads, "contact": {"tensionless": True}, "mesh": {"size": 0.5}}
    span = only(slab(**given, **MEMBERS[kind])).beams[0]
    filled = {"length_x": 12.0, "length_y": 8.0, "thickness": 0.3, "E": E, "nu": 0.2,
              "zones": [{"shape": OPENING, "E": 1e-6 * E}]}  # fmt: skip
    loads[-1] = {"kind": "area", "shape": OPENING, "q": -5e3}
    loads.append({"kind": "uniform", "q": 5e3})
    given["contact"] = {"tensionless": True, "voids": [{"shape": OPENING, "depth": 10.0}]}
    pieces = only(slab(**given, plate=filled, **MEMBERS[kind])).beams[0]
    found = over_opening(span)
    for name in ("settlement", "moment", "shear", "axial"):
        values = getattr(pieces, name)
        expected = np.interp(found["way"][1:-1], pieces.way, values)
        assert found[name][1:-1] == pytest.approx(expected, abs=5e-3 * max(np.abs(values).max(), 1e-9)), name


def test_loads_on_a_wall_reach_the_slab_over_an_opening() -> None:
    """All that acts on the wall is in the balance of the slab, in the case's force, and nothing is clipped."""
    loads = [{"kind": "line", "wall": "W", "q": 100e3}]
    model = slab(walls=[WALL], loads=loads, contact={"tensionless": True})
    results = gs.solve(model)
    assert results.only.certificate.load == pytest.approx(800e3, rel=1e-9)
    assert not [remark for remark in find_remarks(model) if "off the plate" in remark.words]
    (table,) = [each for each in tables_of(results) if each.name == "walls"]
    beam = results.only.beams[0]
    assert table["greatest settlement"][0] == pytest.approx(1e3 * beam.settlement.max(), rel=1e-3)


def test_a_slab_sees_a_stiff_span() -> None:
    """Far from the opening it makes little difference; at its edges the slab is pressed where it was free."""
    plain = only(slab(loads=[{"kind": "uniform", "q": 10e3}, {"kind": "point", "P": 300e3, "x": -2.5, "y": 0.0}]))
    wall = only(slab(walls=[WALL], loads=[{"kind": "uniform", "q": 10e3},
                                          {"kind": "point", "P": 300e3, "x": -2.5, "y": 0.0}]))  # fmt: skip
    at = [float(each.plate.value_at("settlement", 2.0, 0.0)) for each in (plain, wall)]
    assert at[1] > 1.05 * at[0]


def test_spans_turned_about_and_mirrored_answer_alike() -> None:
    """A wall drawn from its other end, and a beam with an eccentric section, mirrored."""
    load = {"kind": "line", "points": POINTS, "q": 100e3, "q_end": 200e3}
    there, back = (only(slab(walls=[WALL | {"points": points}], loads=[load])).beams[0]
                   for points in (POINTS, POINTS[::-1]))  # fmt: skip
    assert back.moment[::-1] == pytest.approx(there.moment, abs=1e-6 * there.moment.max())
    eccentric = BEAM | {"section": SECTION | {"area": 0.3, "eccentricity": 0.4}}
    one = only(slab(beam=eccentric)).beams[0]
    other = only(slab(beam=eccentric, loads=[load | {"q": 200e3, "q_end": 100e3}])).beams[0]
    assert other.axial[::-1] == pytest.approx(one.axial, abs=1e-5 * np.abs(one.axial).max())
    assert other.settlement[::-1] == pytest.approx(one.settlement, rel=1e-6)
    axial = over_opening(one)["axial"]
    assert axial == pytest.approx(axial[0], rel=1e-9)
    assert abs(axial[0]) > 1e3


def test_a_beam_weighs_all_of_its_section_over_an_opening() -> None:
    """40 cm by 80 cm in a slab of 30 cm: 0.4 * 0.5 m2 beside the slab, 0.4 * 0.8 m2 over 4 m of opening."""
    beam = BEAM | {"section": {"kind": "rectangle", "width": 0.4, "height": 0.8}}
    weight = {"kind": "self weight", "unit_weight": 25e3, "beams": True}
    results = only(slab(beam=beam, loads=[weight]))
    concrete = 0.3 * (12.0 * 8.0 - 4.0 * 2.0) + 0.4 * 0.5 * 4.0 + 0.4 * 0.8 * 4.0
    assert results.certificate.load == pytest.approx(25e3 * concrete, rel=1e-9)


def test_a_wall_without_a_height_may_touch_a_span() -> None:
    """At the edge of the opening, where another member spans it: what it settles there is the slab's."""
    soft = {"name": "soft", "thickness": 0.2, "points": ((2.0, -3.0), (2.0, 3.0))}
    results = gs.solve(slab(walls=[WALL, soft]))
    (table,) = [each for each in tables_of(results) if each.name == "walls"]
    along = [float(results.only.plate.value_at("settlement", 2.0, y)) for y in np.linspace(-3.0, 3.0, 101)]
    assert table["greatest settlement"][1] == pytest.approx(1e3 * max(along), rel=1e-9)


def test_limits_of_a_wall_with_openings_over_an_opening() -> None:
    """Both are certified, also where spans bend with hardly any of their stiffness."""
    wall = WALL | {"openings": [{"start": 0.5, "end": 1.5, "height": 1.0}]}
    ground = {"kind": "vlasov", "layers": [{"thickness": 5.0, "E": 20e6, "nu": 0.3}]}
    results = only(slab(walls=[wall], ground=ground, contact={"tensionless": True}, output={"wall_limits": True}))
    assert [share for share, _ in results.wall_limits] == [0.0, 1.0]
