"""The building above: frames against closed forms and another program, and what their stiffness adds to loads."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.arrays import Array
from groundslab.design.demands.perimeter_loads import punching_columns
from groundslab.discretize.building import stiffness_of

E = 30e9
#: A member so stiff along its axis that it only bends.
INEXTENSIBLE: dict[str, Any] = {"kind": "properties", "area": 1e3}
I_COLUMN, I_BEAM = 0.4**4 / 12, 0.3 * 0.6**3 / 12


def member(second_moment: float, **others: Any) -> dict[str, Any]:
    """Return the section of a member that only bends."""
    return INEXTENSIBLE | {"second_moment": second_moment} | others


def column(name: str, x: float, y: float) -> dict[str, Any]:
    """Return a column of 0.4 m by 0.4 m."""
    return {"name": name, "x": x, "y": y, "width_x": 0.4, "width_y": 0.4}


def load(name: str, P: float, M_x: float = 0.0, M_y: float = 0.0) -> dict[str, Any]:
    """Return a load on a column."""
    return {"kind": "point", "column": name, "P": P, "M_x": M_x, "M_y": M_y}


def portal(height: float) -> dict[str, Any]:
    """Return a portal on columns A and B, which only bends."""
    return {
        "storeys": [height],
        "E": E,
        "columns": [{"names": ["A", "B"], "section": member(I_COLUMN)}],
        "beams": [{"through": ["A", "B"], "section": member(I_BEAM)}],
    }


def raft(columns: list[dict[str, Any]], loads: list[dict[str, Any]], **others: Any) -> gs.Model:
    """Return a raft on springs that pull, with columns and loads."""
    parts: dict[str, Any] = {
        "plate": {"length_x": 12.0, "length_y": 8.0, "thickness": 0.5, "E": E, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 20e6},
        "contact": {"tensionless": False},
        "columns": columns,
        "loads": loads,
        "mesh": {"size": 1.0},
    }
    return gs.Model(**parts | others)


def test_a_portal_whose_bases_settle_apart() -> None:
    """A portal's bases that settle apart are held back by its beam, whose columns turn."""
    # antisymmetric: the columns' moments are constant, the beam has none in its middle
    L, h, apart = 6.0, 4.0, 0.01
    model = raft([column("A", -L / 2, 0.0), column("B", L / 2, 0.0)], [load("A", 1.0)], building=portal(h))
    K = stiffness_of(model)
    turned = (6 * E * I_BEAM / L) / (E * I_COLUMN / h + 6 * E * I_BEAM / L) * apart / L
    V = 12 * E * I_BEAM / L**2 * (apart / L - turned)
    M = E * I_COLUMN / h * turned
    motion = np.array([0.0, 0.0, 0.0, apart, 0.0, 0.0])
    # the base that settles is held up, and both are turned by their columns
    assert K @ motion == pytest.approx([-V, -M, 0.0, V, -M, 0.0], rel=1e-5, abs=1e-3)
    assert pytest.approx(V * L - 2 * (V * L / 2 - M)) == 2 * M


def test_a_frame_that_is_turned_with_its_columns() -> None:
    """Turned by 30 degrees it is as stiff in its own directions; columns at 90 degrees have their sides exchanged."""

    def stiffness(turn: float, sides: tuple[float, float] = (0.3, 0.6), angle: float = 0.0) -> Array:
        c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
        places = {
            name: (c * x - s * y, s * x + c * y) for name, x, y in (("A", -3.0, 1.0), ("B", 2.0, 1.0), ("C", 2.0, -2.0))
        }
        widths = dict(zip(("width_x", "width_y"), sides, strict=True))
        columns = [{"name": name, "x": x, "y": y, "angle": turn + angle} | widths for name, (x, y) in places.items()]
        bar = {"kind": "rectangle", "width": 0.3, "height": 0.6}
        frame = {"storeys": [3.5, 3.0], "E": E, "beams": [{"through": ["A", "B", "C"], "section": bar}]}
        return stiffness_of(raft(columns, [load("A", 1.0)], building=frame))

    c, s = math.cos(math.radians(30)), math.sin(math.radians(30))
    T = np.kron(np.eye(3), [[1, 0, 0], [0, c, -s], [0, s, c]])
    K = stiffness(0.0)
    near = 1e-8 * np.abs(K).max()
    assert stiffness(30.0) == pytest.approx(T @ K @ T.T, rel=1e-6, abs=near)
    assert stiffness(0.0, (0.6, 0.3), 90.0) == pytest.approx(K, rel=1e-12, abs=near)
    assert np.abs(stiffness(0.0, (0.6, 0.3)) - K).max() > 0.1 * np.abs(K).max()


def slope_deflection(L: float, h: float) -> Array:
    """Return the stiffness (4, 4) of a portal for w_A, slope_A, w_B, slope_B of its bases, by slope deflection.

    Further unknowns are the sway u, positive along x, and the slopes of both corners; z points down, so that a slope s
    moves what lies above by s times its height along x.
    """
    c, b = E * I_COLUMN / h, E * I_BEAM / L
    K = np.zeros((7, 7))

    def bend(stiffness: float, rows: list[tuple[int, float]], chord: list[tuple[int, float]]) -> None:
        """Add a member by the slopes of its ends relative to its chord."""
        ends = []
        for unknown, sign in rows:
            end = np.zeros(7)
            end[unknown] = sign
            for other, share in chord:
                end[other] -= share
            ends.append(end)
        one, two = ends
        K.__iadd__(
            stiffness
            * (4 * np.outer(one, one) + 4 * np.outer(two, two) + 2 * np.outer(one, two) + 2 * np.outer(two, one))
        )

    # unknowns: w_A, s_A, w_B, s_B, u, corner slopes
    bend(c, [(1, 1.0), (5, 1.0)], [(4, 1 / h)])
    bend(c, [(3, 1.0), (6, 1.0)], [(4, 1 / h)])
    bend(b, [(5, 1.0), (6, 1.0)], [(2, 1 / L), (0, -1 / L)])
    inner = K[4:, 4:]
    condensed: Array = K[:4, :4] - K[:4, 4:] @ np.linalg.solve(inner, K[4:, :4])
    return condensed


def test_a_portal_by_slope_deflection() -> None:
    """A portal is as stiff as slope deflection has it, with sway."""
    L, h = 6.0, 4.0
    model = raft([column("A", -L / 2, 0.0), column("B", L / 2, 0.0)], [load("A", 1.0)], building=portal(h))
    in_plane = [0, 1, 3, 4]
    K = stiffness_of(model)[np.ix_(in_plane, in_plane)]
    assert pytest.approx(slope_deflection(L, h), rel=1e-5, abs=1e-5 * K.max()) == K


def test_a_portal_on_two_footings() -> None:
    """A portal moves load from one footing to the other as four equations by hand say."""
    # footings that do not bend, on springs: eight digits by hand with the portal's stiffness
    L, h, a, k = 6.0, 4.0, 2.0, 40e6
    x = [-L / 2, L / 2]
    outline = [{"kind": "rectangle", "x": [at - a / 2, at + a / 2], "y": [-a / 2, a / 2]} for at in x]
    sheet = {"thickness": 2.0, "E": 3e13, "nu": 0.2}
    model = raft(
        [column("A", x[0], 0.0), column("B", x[1], 0.0)],
        [load("A", 800e3), load("B", 300e3, M_x=20e3)],
        plate=sheet | {"name": "left", "outline": outline[0]},
        plates=[sheet | {"name": "right", "outline": outline[1]}],
        ground={"kind": "winkler", "k": k},
        building=portal(h),
        mesh={"size": 0.5},
    )
    springs = np.diag([k * a**2, k * a**4 / 12] * 2)
    by_hand = np.linalg.solve(springs + slope_deflection(L, h), [800e3, 0.0, 300e3, 20e3])
    results = gs.solve(model)
    assert results.certificate.holds
    for number, base in enumerate(results.only.bases):
        w, slope = by_hand[2 * number : 2 * number + 2]
        assert base.settlement[0] == pytest.approx(w, rel=1e-4)
        assert base.slope_x[0] == pytest.approx(slope, rel=1e-3)
        change = springs[0, 0] * w - [800e3, 300e3][number]
        assert base.force[0] == pytest.approx(change, rel=1e-3)


def test_a_portal_holds_a_footing_that_would_topple() -> None:
    """A moment that no footing by itself can bear, on ground that only pushes, goes into the frame."""
    L, h, a = 6.0, 4.0, 2.0
    x = [-L / 2, L / 2]
    outline = [{"kind": "rectangle", "x": [at - a / 2, at + a / 2], "y": [-a / 2, a / 2]} for at in x]
    sheet = {"thickness": 0.5, "E": E, "nu": 0.2}
    toppling = {
        "columns": [column("A", x[0], 0.0), column("B", x[1], 0.0)],
        "loads": [load("A", 100e3, M_x=110e3), load("B", 300e3)],
        "plate": sheet | {"name": "left", "outline": outline[0]},
        "plates": [sheet | {"name": "right", "outline": outline[1]}],
        "contact": {"tensionless": True},
        "mesh": {"size": 0.25},
    }
    with pytest.raises(gs.NoEquilibrium):
        gs.solve(raft(**toppling))
    results = gs.solve(raft(**toppling, building=portal(h)))
    assert results.certificate.holds
    assert results.only.bases[0].moment_x[0] < -20e3


#: Loads on rigid bases, and on a raft on elements of 0.25 m: P [kN], M_x and M_y [kN m], by PyNite 3.2.0
#: (tools/other_programs/pynite_frame.py).
PYNITE = {
    "A1": ((640.7099, -4.1812, -1.2249), (692.3120, -29.2767, 2.5444)),
    "A2": ((1724.1479, -1.0157, -0.3476), (1635.5542, -5.1811, 9.1468)),
    "A3": ((784.6043, 2.4590, -0.0414), (821.1767, 21.4655, 9.4172)),
    "B1": ((631.8598, -2.4504, -1.2249), (667.1565, -21.5477, -12.1526)),
    "B2": ((1430.5955, 0.8238, -0.3476), (1345.3144, 5.0457, -10.3664)),
    "B3": ((338.0827, 3.7778, -0.0414), (388.4862, 28.5224, -4.3318)),
}


def pynite_model(**others: Any) -> gs.Model:
    """Return the frame of three storeys on a raft."""
    places = {"A1": (2, 2), "A2": (7, 2), "A3": (12, 2), "B1": (2, 8), "B2": (7, 8), "B3": (12, 8)}
    building = {
        "storeys": [4.0, 3.0, 3.0],
        "E": E,
        "rigid_floors": False,
        "columns": [{"names": [*places], "section": {
            "kind": "properties", "area": 0.16, "second_moment": I_COLUMN, "torsion_constant": 0.0036}}],
        "beams": [{"through": line, "section": {
            "kind": "properties", "area": 0.18, "second_moment": I_BEAM, "second_moment_across": 0.6 * 0.3**3 / 12,
            "torsion_constant": 0.0037}} for line in (["A1", "A2", "A3"], ["B1", "B2", "B3"], ["A1", "B1"],
                                                      ["A2", "B2"], ["A3", "B3"])],
    }  # fmt: skip
    parts: dict[str, Any] = {
        "plate": {"outline": {"kind": "rectangle", "x": [0, 14], "y": [0, 10]}, "thickness": 0.6, "E": E, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 15e6},
        "building": building,
        "mesh": {"size": 0.5},
    }
    columns = [column(name, *place) for name, place in places.items()]
    loads = [load(name, *(1e3 * value for value in given)) for name, (given, _) in PYNITE.items()]
    return raft(columns, loads, **parts | others)


def test_a_frame_on_a_raft_by_another_program() -> None:
    """Columns of a frame on a raft carry what PyNite finds, within half a percent."""
    results = gs.solve(pynite_model())
    assert results.certificate.holds
    largest = max(abs(M) for _, own in PYNITE.values() for M in own[1:])
    for base in results.only.bases:
        given, on_raft = PYNITE[base.name]
        changes = np.array([base.force[0], base.moment_x[0], base.moment_y[0]]) / 1e3
        P, *moments = given + changes
        assert pytest.approx(on_raft[0], rel=5e-3) == P
        # columns of PyNite stand on points, which turn more than footprints
        assert moments == pytest.approx(on_raft[1:], abs=0.04 * largest)


def test_fewer_storeys_as_if_there_were_no_more() -> None:
    """What fewer storeys would change is what a building of that height does."""
    model = pynite_model(mesh={"size": 1.0})
    of_all = gs.solve(model).only
    assert model.building is not None
    for storeys in (1, 2, 3):
        lower = model.building.replace(storeys=model.building.storeys[:storeys])
        fewer = gs.solve(model.replace(building=lower)).only
        for one, other in zip(of_all.bases, fewer.bases, strict=True):
            assert one.by_storeys[0, storeys - 1] == pytest.approx(other.force[0], rel=1e-6)


GROUNDS: dict[str, dict[str, Any]] = {
    "springs that push alone": {"ground": {"kind": "winkler", "k": 20e6}, "contact": {"tensionless": True}},
    "Pasternak": {"ground": {"kind": "pasternak", "k0": 20e6, "k1": 20e6}, "contact": {"tensionless": True}},
    "Vlasov": {
        "ground": {"kind": "vlasov", "layers": [{"thickness": 8.0, "E": 40e6, "nu": 0.3}]},
        "contact": {"tensionless": True},
    },
    "continuum": {
        "ground": {"kind": "continuum", "layers": [{"thickness": 8.0, "E": 40e6, "nu": 0.3}]},
        "contact": {"tensionless": True},
    },
}


@pytest.mark.parametrize("ground", GROUNDS)
def test_loads_with_what_it_adds_do_the_same_without_it(ground: str) -> None:
    """A slab under the changed loads is the same without the building, where it lifts off, too."""
    # three bases could only tilt; the slab lifts off at one of its corners
    places = {"A": (-5.0, 2.5), "B": (5.0, 2.5), "C": (5.0, -2.5), "D": (-5.0, -2.5)}
    columns = [column(name, *place) for name, place in places.items()]
    loads = [load("A", 100e3, 30e3), load("B", 900e3), load("C", 300e3, 0.0, 50e3), load("D", 1500e3)]
    building = {
        "storeys": [4.0, 3.0],
        "E": E,
        "beams": [
            {"through": ["A", "B", "C", "D", "A"], "section": {"kind": "rectangle", "width": 0.3, "height": 0.8}}
        ],
    }
    with_it = gs.solve(raft(columns, loads, building=building, **GROUNDS[ground]))
    changes = {base.name: (base.force[0], base.moment_x[0], base.moment_y[0]) for base in with_it.only.bases}
    assert with_it.certificate.holds
    assert sum(P for P, _, _ in changes.values()) == pytest.approx(0.0, abs=1e-6 * 2500e3)
    added = [load(each["column"], each["P"] + P, each["M_x"] + M_x, each["M_y"] + M_y)
             for each, (P, M_x, M_y) in ((each, changes[each["column"]]) for each in loads)]  # fmt: skip
    without = gs.solve(raft(columns, added, **GROUNDS[ground]))
    # punching takes the same loads
    for one, other in zip(punching_columns(with_it.model), punching_columns(without.model), strict=True):
        assert one.pushing(with_it.only) == pytest.approx(other.pushing(without.only), rel=1e-9)
    largest = np.abs(without.plate.settlement).max()
    rounding = 1e-4 if ground in ("Vlasov", "continuum") else 1e-7
    assert np.abs(with_it.plate.settlement - without.plate.settlement).max() <= rounding * largest
    assert max(abs(P) for P, _, _ in changes.values()) > 0.02 * 900e3
    assert with_it.plate.contact_share < 1


def test_a_matrix_does_what_its_frame_does() -> None:
    """A frame's matrix, given as such, does the same."""
    model = pynite_model(mesh={"size": 1.0})
    frame = gs.solve(model).only
    K = stiffness_of(model) / 1e3
    assert model.building is not None
    given = {"nodes": [*model.building.names], "matrix": K.tolist(), "unit": "kN"}
    matrix = gs.solve(model.replace(building=given)).only
    for one, other in zip(frame.bases, matrix.bases, strict=True):
        assert other.force[0] == pytest.approx(one.force[0], rel=1e-9)
        assert other.moment_x[0] == pytest.approx(one.moment_x[0], rel=1e-9)


def test_turned_by_a_right_angle() -> None:
    """Plan and building turned by a right angle change nothing."""
    columns = {"A": (-5.0, 1.0), "B": (0.0, 3.0), "C": (4.5, -2.0)}
    building = {
        "storeys": [4.0],
        "E": E,
        "columns": [{"names": ["A", "B", "C"], "section": {"kind": "circle", "diameter": 0.5}}],
        "beams": [{"through": ["A", "B", "C"], "section": {"kind": "rectangle", "width": 0.3, "height": 0.8}}],
    }
    loads = [load("A", 500e3), load("B", 900e3), load("C", 1500e3)]
    one = gs.solve(raft([column(name, x, y) for name, (x, y) in columns.items()], loads, building=building)).only
    plate = {"length_x": 8.0, "length_y": 12.0, "thickness": 0.5, "E": E, "nu": 0.2}
    turned = [column(name, -y, x) for name, (x, y) in columns.items()]
    other = gs.solve(raft(turned, loads, building=building, plate=plate)).only
    for before, after in zip(one.bases, other.bases, strict=True):
        assert after.force[0] == pytest.approx(before.force[0], rel=1e-7)
        assert after.moment_y[0] == pytest.approx(before.moment_x[0], rel=1e-6, abs=1.0)
        assert after.moment_x[0] == pytest.approx(-before.moment_y[0], rel=1e-6, abs=1.0)


def test_a_beam_that_starts_at_the_end_of_a_wall() -> None:
    """A beam along a wall starts at its end, which is nearest, not in its middle."""
    # a wall so stiff that it does not bend turns with its base: its end goes down by the slope times half its length
    t, half, h, L = 10.0, 1.5, 3.0, 5.0
    wall = {"name": "W", "thickness": t, "points": [(-4.0, 0.0), (-1.0, 0.0)]}
    building = {
        "storeys": [h],
        "E": E,
        "columns": [{"names": ["C"], "section": member(1e-9)}],
        "beams": [{"through": ["W", "C"], "section": member(I_BEAM)}],
    }
    loads = [{"kind": "line", "wall": "W", "q": 200e3}, load("C", 500e3)]
    model = raft([column("C", 4.0, 0.0)], loads, walls=[wall | {"thickness": 0.3}], building=building)
    results = gs.solve(model)
    assert results.certificate.holds
    base_w, base_c = results.only.bases
    assert base_w.force[0] == pytest.approx(-base_c.force[0], rel=1e-9)
    # the column does not resist turning: a beam fixed to the wall, hinged at the column
    stiff = stiffness_of(raft([column("C", 4.0, 0.0)], loads, walls=[wall], building=building))
    k = 3 * E * I_BEAM / L**3
    motion = np.array([0.0, 0.0, 0.0, 0.01, 0.0, 0.0])
    # at the wall's middle the moment has the lever of the beam and of half the wall
    V = k * 0.01
    assert stiff @ motion == pytest.approx([-V, -V * (L + half), 0.0, V, 0.0, 0.0], rel=1e-3, abs=1.0)


@pytest.mark.parametrize("place", [(4.0, 5.0), (4.0, 1.0), (-3.0, -5.0), (5.0, 0.0)])
def test_an_oblique_beam_to_a_wall_by_rigid_members(place: tuple[float, float]) -> None:
    """A wall is a column in its middle, with a rigid beam to its place that is nearest to the beam's other end."""
    nearest = min(max(place[1], -3.0), 3.0)
    bar = {"kind": "rectangle", "width": 0.3, "height": 0.6}
    frame = {"storeys": [3.5, 3.0], "E": E, "rigid_floors": False}
    plate = {"length_x": 14.0, "length_y": 14.0, "thickness": 0.5, "E": E, "nu": 0.2}
    wall = {"name": "W", "thickness": 0.3, "points": [(0.0, -3.0), (0.0, 3.0)]}
    far = column("C", *place)
    as_wall = frame | {"beams": [{"through": ["W", "C"], "section": bar}]}
    K = stiffness_of(raft([far], [load("C", 1.0)], plate=plate, walls=[wall], building=as_wall))
    rigid = {"kind": "properties", "area": 1e4, "second_moment": 1e4, "torsion_constant": 1e4}
    nothing = {"kind": "properties", "area": 1e-8, "second_moment": 1e-13}
    as_column = frame | {
        "columns": [
            {"names": ["W"], "section": {"kind": "rectangle", "width": 0.3, "height": 6.0}},
            {"names": ["end"], "section": nothing},
        ],
        "beams": [{"through": ["W", "end"], "section": rigid}, {"through": ["end", "C"], "section": bar}],
    }
    columns = [column("W", 0.0, 0.0), column("end", 0.0, nearest), far]
    if nearest == 0.0:
        # the beam starts in the middle
        as_column |= {"columns": as_column["columns"][:1], "beams": as_wall["beams"]}
        columns.pop(1)
    other = stiffness_of(raft(columns, [load("C", 1.0)], plate=plate, building=as_column))
    both = np.r_[0:3, len(other) - 3 : len(other)]
    assert pytest.approx(other[np.ix_(both, both)], rel=1e-4, abs=1e-5 * np.abs(K).max()) == K


def test_a_closed_wall_settles_and_turns_as_its_ring_does() -> None:
    """A rigid slab settles as a plane, which the means over a ring of walls find, and a matrix of slopes turns."""
    walls = [{"name": "core", "thickness": 0.3, "shape": {"kind": "rectangle", "x": [-3, -1], "y": [-2, 1]}}]
    columns = [column("A", 4.0, 3.0), column("B", 4.0, -3.0)]
    # the core resists turning against A, and nothing else
    turning = np.array([0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0])
    building = {"nodes": ["core", "A", "B"], "matrix": (1e4 * np.outer(turning, turning)).tolist(), "unit": "kN"}
    sheet = {"length_x": 12.0, "length_y": 8.0, "thickness": 2.0, "E": 3e13, "nu": 0.2}
    loads = [load("A", 500e3), load("B", 100e3), {"kind": "line", "wall": "core", "q": 80e3}]
    results = gs.solve(raft(columns, loads, plate=sheet, walls=walls, building=building))
    assert results.certificate.holds
    plate = results.plate
    places = np.column_stack([np.ones(len(plate.nodes)), plate.nodes])
    plane = np.linalg.lstsq(places, plate.settlement, rcond=None)[0]
    for base in results.only.bases:
        at = base.nodes[0]
        assert base.settlement[0] == pytest.approx(plane @ [1.0, *at], rel=1e-3)
        assert [base.slope_x[0], base.slope_y[0]] == pytest.approx(plane[1:], rel=1e-2)
    assert results.only.bases[0].nodes[0] == pytest.approx([-2.0, -0.5])


@pytest.mark.parametrize("turn", [0.0, 30.0, 90.0])
def test_columns_in_a_row_take_what_the_matrix_says(turn: float) -> None:
    """Settlements alone, of columns in a row, across which nothing tilts: the change of each load is -K w."""
    along = np.array([-3.0, -1.5, 0.5, 3.0])
    # what a beam over two of three columns resists: w_1 l_2 - w_2 (l_1 + l_2) + w_3 l_1
    bends = np.zeros((2, 4))
    for row in (0, 1):
        l_1, l_2 = np.diff(along[row : row + 3])
        bends[row, row : row + 3] = l_2, -l_1 - l_2, l_1
    K = 5e6 * bends.T @ bends
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    columns = [
        {"name": f"C{n}", "x": float(c * way), "y": float(s * way), "width_x": 0.4, "width_y": 0.4}
        for n, way in enumerate(along)
    ]
    results = gs.solve(
        gs.Model(
            plate={"length_x": 9.0, "length_y": 9.0, "thickness": 0.4, "E": 30e9, "nu": 0.2},
            ground={"kind": "winkler", "k": 10e6},
            columns=columns,
            building={"nodes": [each["name"] for each in columns], "matrix": K.tolist(), "unit": "N"},
            loads=[{"kind": "point", "column": f"C{n}", "P": P} for n, P in enumerate((1e6, 2e5, 8e5, 3e5))],
            mesh={"size": 0.5},
        )
    ).only
    assert results.certificate.holds
    w, change = (np.array([getattr(base, name)[0] for base in results.bases]) for name in ("settlement", "force"))
    assert change == pytest.approx(-K @ w, rel=1e-6, abs=1e-6 * np.abs(change).max())
    assert np.abs(change).max() > 10e3
