"""Columns and supports on beams, and the shear forces that count at them, by hand."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.arrays import Array
from groundslab.design.demands.beam_supports import Faces, faces_on, shear_forces
from groundslab.results.records import BeamResult

L = 8.0


def faces(section: dict[str, Any], **others: Any) -> list[tuple[float, float, bool]]:
    """Return what a beam along y = 0 of a plate of 8 m by 4 m meets."""
    model = gs.Model(
        plate={"length_x": L, "length_y": 4.0, "thickness": 0.3, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        beams=[{"name": "B", "points": [(-4.0, 0.0), (4.0, 0.0)], "section": section}, *others.pop("beams", [])],
        cases=[{"name": "G"}],
        loads=[{"kind": "uniform", "q": 10e3, "case": "G"}],
        **others,
    )
    return [(round(each.low, 6), round(each.high, 6), each.direct) for each in faces_on(model, model.beams[0], L)]


def test_what_a_beam_meets() -> None:
    """Columns and piles from face to face, lines at a place; direct where the rib lies between them and the slab."""
    below: dict[str, Any] = {"kind": "rib", "width": 0.4, "height": 0.5, "effective_width": 1.0}
    on_it = {
        "columns": [{"name": "C", "x": 1.0, "y": 0.1, "width_x": 0.6, "width_y": 0.4},
                    {"name": "beside", "x": 2.0, "y": 1.0, "width_x": 0.6, "width_y": 0.4}],
        "supports": [{"kind": "point", "x": -2.0, "y": 0.0, "diameter": 0.4},
                     {"kind": "line", "points": [(-4.0, -1.0), (-4.0, 1.0)]}],
        "walls": [{"name": "across", "points": [(3.0, -1.0), (3.0, 1.0)], "thickness": 0.2}],
        "beams": [{"name": "along y", "points": [(0.0, -2.0), (0.0, 2.0)], "section": below}],
    }  # fmt: skip
    wall, crossing, end = (7.0, 7.0, False), (4.0, 4.0, False), (8.0, 8.0, False)
    assert faces(below, **on_it) == [
        (0.0, 0.0, True), (1.8, 2.2, True), crossing, (4.7, 5.3, False), wall, end]  # fmt: skip
    assert faces(below | {"side": "above"}, **on_it) == [
        (0.0, 0.0, False), (1.8, 2.2, False), crossing, (4.7, 5.3, True), wall, end]  # fmt: skip
    middle = {"kind": "rectangle", "width": 0.4, "height": 0.8}
    assert not any(direct for *_, direct in faces(middle, **on_it))


def test_a_beam_through_a_door_meets_no_wall() -> None:
    """The wall across it has a door from 0.5 to 1.5 m of its 2 m, and the beam runs through the middle."""
    wall = {"name": "across", "points": [(3.0, -1.0), (3.0, 1.0)], "thickness": 0.2}
    section = {"kind": "rectangle", "width": 0.4, "height": 0.8}
    ends = [(0.0, 0.0, False), (8.0, 8.0, False)]
    assert faces(section, walls=[wall]) == [ends[0], (7.0, 7.0, False), ends[1]]
    assert faces(section, walls=[{**wall, "openings": [{"start": 0.5, "end": 1.5, "height": 2.1}]}]) == ends


def test_a_column_at_an_end_has_its_face_inside() -> None:
    """A column of 0.5 m at the end of a rib above the slab: d counts from its face 0.25 m from the end."""
    above = {"kind": "rib", "width": 0.4, "height": 0.5, "effective_width": 1.0, "side": "above"}
    column = {"name": "C", "x": -3.75, "y": 0.0, "width_x": 0.5, "width_y": 0.5}
    assert faces(above, columns=[column])[0] == (0.0, 0.5, True)


def line(V: Array, way: Array) -> BeamResult:
    """Return a beam along x with shear forces (k,) at ways (k,)."""
    nothing = 0 * way
    return BeamResult("B", np.column_stack([way, nothing]), way, nothing, nothing, V, *(nothing,) * 4)


def counted(V: Array, way: Array, where: list[Faces], d: float = 0.5) -> tuple[float, float]:
    """Return the largest shear forces of links and of struts."""
    own = line(V, way)
    links, struts = shear_forces(own, own.between_ends(d), where, d)
    return float(links.max()), float(struts.max())


def test_shear_forces_at_faces_of_direct_supports() -> None:
    """100 kN/m on 8 m over a column of 0.4 m in the middle: 380 kN at its face, 330 kN at d = 0.5 m.

    What dips beside it does not matter; indirectly supported, all 380 kN count for links, too. Ends are free.
    """
    way = np.repeat(np.linspace(0.0, L, 81), 2)[1:-1]
    V = -100e3 * way + 800e3 * (way > 4.0)
    V[81] = 400e3  # the place of the jump stands twice
    dip = np.where(np.abs(way - 4.0) < 0.35, 0.8 * V, V)
    free = [Faces(0.0, 0.0, direct=False), Faces(L, L, direct=False)]
    for direct, at in ((True, 330e3), (False, 380e3)):
        where = [free[0], Faces(3.8, 4.2, direct=direct), free[1]]
        assert counted(dip, way, where) == pytest.approx((at, 380e3), rel=1e-6)


def test_a_force_between_face_and_d_counts() -> None:
    """100 kN at 0.2 m from the face: nothing is taken off, up to 380 + 100 kN raw."""
    way = np.repeat(np.linspace(0.0, L, 81), 2)[1:-1]
    V = -100e3 * way + 800e3 * (way > 4.0)
    V[81] = 400e3
    with_force = np.where((way > 4.0) & (way < 4.4 + 1e-9), V + 100e3, V)
    with_force[np.flatnonzero(np.isclose(way, 4.4))[1]] -= 100e3
    where = [Faces(0.0, 0.0, direct=False), Faces(3.8, 4.2, direct=True), Faces(L, L, direct=False)]
    links, struts = counted(with_force, way, where)
    assert links >= 480e3 - 1.0
    assert struts >= 480e3 - 1.0


def test_supports_closer_than_d_leave_shear_forces_as_they_are() -> None:
    """Between faces 0.4 m apart no place is d from a face."""
    way = np.linspace(0.0, L, 81)
    V = 100e3 + 0 * way
    where = [Faces(0.0, 0.0, direct=False), Faces(3.8, 4.2, direct=True), Faces(4.6, 5.0, direct=True),
             Faces(L, L, direct=False)]  # fmt: skip
    assert counted(V, way, where) == pytest.approx((100e3, 100e3))


def test_few_places_lose_nothing() -> None:
    """On places a meter apart, none between face and d, links have what is at d and struts what is at the face."""
    way = np.repeat(np.linspace(0.0, L, 9), 2)[1:-1]
    V = -100e3 * way + 800e3 * (way > 4.0)
    V[8] = 400e3
    own = line(V, way)
    part = own.at(np.array([0.5, 2.0, 3.0, 5.0, 6.0, 7.5]))
    links, struts = shear_forces(own, part, [Faces(3.8, 4.2, direct=True)], 0.5)
    assert links.max() == pytest.approx(330e3)
    assert struts.max() == pytest.approx(380e3)
