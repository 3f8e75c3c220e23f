"""Beams and ribs in plates against closed forms, and under uplift against a small program of its own."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.accuracy.values import estimate_error
from groundslab.arrays import Array
from groundslab.design.demands.perimeter_loads import loads_near, punching_columns, punching_shear
from groundslab.design.demands.perimeters import perimeter
from groundslab.results.records import BeamResult
from groundslab.verification.analytic_beams import beam_on_springs

#: A beam of 0.3 m by 0.6 m of concrete [N m2], and one that does not shear.
E = 30e9
EI = E * 0.3 * 0.6**3 / 12
STIFF: dict[str, Any] = {"kind": "properties", "second_moment": 0.3 * 0.6**3 / 12, "shear_area": 10.0}
#: A strip so narrow that it bends along the beam alone: its width and thickness [m], and its springs [Pa/m].
B, T = 0.1, 0.2
K = 5e6
#: Its Young's modulus [Pa], and the stiffness of strip and beam together, of which the beam has its share [N m2].
SOFT = E / 10
WHOLE = EI + SOFT * B * T**3 / 12


def strip(length: float, beams: list[dict[str, Any]], loads: list[dict[str, Any]], **others: Any) -> gs.Model:
    """Return a strip on springs that pull, with beams and loads."""
    parts: dict[str, Any] = {
        "plate": {"length_x": length, "length_y": B, "thickness": T, "E": SOFT, "nu": 0.0},
        "ground": {"kind": "winkler", "k": K},
        "contact": {"tensionless": False},
        "beams": beams,
        "loads": loads,
        "mesh": {"size": 0.1},
    }
    return gs.Model(**parts | others)


def along(length: float, section: dict[str, Any] = STIFF) -> dict[str, Any]:
    """Return a beam from one end of a strip to the other, of concrete."""
    return {"name": "beam", "points": [(-length / 2, 0.0), (length / 2, 0.0)], "section": section, "E": E}


def force(x: float, P: float) -> dict[str, Any]:
    """Return a force on the beam."""
    return {"kind": "point", "x": x, "y": 0.0, "P": P}


def only_beam(results: gs.Results) -> BeamResult:
    """Return the only beam of the only combination."""
    assert results.only.certificate.holds
    (beam,) = results.only.beams
    return beam


@pytest.mark.parametrize(("length", "at"), [(6.0, 3.0), (6.0, 1.5), (40.0, 20.0)])
def test_a_beam_on_springs_is_that_of_hetenyi(length: float, at: float) -> None:
    """Free beams, short and long: settlement to 1e-4 all along, moment to 1e-4 of the largest."""
    P = 100e3
    beam = only_beam(gs.solve(strip(length, [along(length)], [force(at - length / 2, P)])))
    exact = [beam_on_springs(float(x), length, P, at, WHOLE, K * B) for x in beam.way]
    w, M = (np.array([each[name] for each in exact]) for name in ("settlement", "moment"))
    assert np.abs(beam.settlement - w).max() < 1e-4 * w.max()
    assert np.abs(beam.moment - EI / WHOLE * M).max() < 1e-4 * np.abs(M).max()


def test_the_shear_force_is_the_slope_of_the_moment() -> None:
    """Half of a force in the middle goes either way; V is dM/ds, from moments by differences."""
    length, P = 6.0, 100e3
    beam = only_beam(gs.solve(strip(length, [along(length)], [force(0.0, P)])))
    at_force = np.flatnonzero(np.isclose(beam.way, length / 2))
    assert beam.shear[at_force] == pytest.approx([P / 2, -P / 2], rel=2e-3)
    right = beam.way > length / 2 + 0.2
    slope = np.gradient(beam.moment[right], beam.way[right])
    assert beam.shear[right][2:-2] == pytest.approx(slope[2:-2], abs=2e-3 * P)


@pytest.mark.parametrize(
    ("section", "whole"),
    [
        # the concentric rib: 0.2^3 / 12 + 0.3 0.6^3 / 12 = 0.006067 m4
        ({"kind": "rectangle", "width": 0.3, "height": 0.6}, 0.0060666667),
        # the T: its axis lies 0.09 m from the middle of rib and flange together weighed by area, 0.021225 m4
        ({"kind": "rib", "width": 0.3, "height": 0.6, "effective_width": 1.0}, 0.0212254386),
    ],
)
def test_a_ribbed_strip_spans_as_its_section_does(section: dict[str, Any], whole: float) -> None:
    """A meter of a plate of 0.2 m with a rib of 0.3 m by 0.6 m that shears, simply supported over 40 m."""
    length, q = 40.0, 10e3
    shear = E / 2 * 5 / 6 * 0.3 * 0.6
    ends = [{"kind": "line", "points": [(x, -0.5), (x, 0.5)], "acts": "both ways"} for x in (-length / 2, length / 2)]
    model = gs.Model(
        plate={"length_x": length, "length_y": 1.0, "thickness": 0.2, "E": E, "nu": 0.0},
        ground={"kind": "winkler", "k": 1.0},
        contact={"tensionless": False},
        supports=ends,
        beams=[along(length, section)],
        loads=[{"kind": "uniform", "q": q}],
        mesh={"size": 0.25},
    )
    results = gs.solve(model)
    exact = 5 * q * length**4 / (384 * E * whole) + q * length**2 / (8 * shear)
    assert results.plate.value_at("settlement", 0.0, 0.0) == pytest.approx(exact, rel=1e-3)
    moment = q * length**2 / 8 * (1 - 0.2**3 / 12 / whole)
    assert only_beam(results).moment.max() == pytest.approx(moment, rel=2e-3)


def test_the_ratio_of_both_ribs_is_three_and_a_half() -> None:
    """The stiffness of the T over that of the concentric rib, 0.021225 / 0.006067 m4."""
    rib = gs.Model(
        plate={"length_x": 4.0, "length_y": 1.0, "thickness": 0.2, "E": E, "nu": 0.0},
        ground={"kind": "winkler", "k": K},
        beams=[along(4.0, {"kind": "rib", "width": 0.3, "height": 0.6, "effective_width": 1.0})],
        loads=[{"kind": "uniform", "q": 1e3}],
    ).beams[0]
    own, plate = rib.rigidities(E, 0.0, 0.2)[0] / E, 0.2**3 / 12
    assert own + plate == pytest.approx(0.021225, rel=1e-4)
    assert (own + plate) / (0.3 * 0.6**3 / 12 + plate) == pytest.approx(3.50, abs=5e-3)


def test_two_crossing_beams_share_a_force() -> None:
    """A grillage of beams over 8 m and 4 m in a plate as soft as nothing: as 1 / (L^3 / 48 EI + L / 4 G A_v)."""
    P, long, short = 100e3, 8.0, 4.0
    ends = [(-long / 2, 0.0), (long / 2, 0.0), (0.0, -short / 2), (0.0, short / 2)]
    model = gs.Model(
        plate={"length_x": long, "length_y": short, "thickness": 0.1, "E": 1e4, "nu": 0.0},
        ground={"kind": "winkler", "k": 1e-3},
        contact={"tensionless": False},
        supports=[{"kind": "point", "x": x, "y": y, "acts": "both ways"} for x, y in ends],
        beams=[
            {"name": "long", "points": ends[:2], "section": STIFF, "E": E},
            {"name": "short", "points": ends[2:], "section": STIFF, "E": E},
        ],
        loads=[{"kind": "point", "x": 0.0, "y": 0.0, "P": P}],
        mesh={"size": 0.5},
    )
    results = gs.solve(model).only
    assert results.certificate.holds
    stiffness = [1 / (L**3 / (48 * EI) + L / (4 * E / 2 * STIFF["shear_area"])) for L in (long, short)]
    w = P / sum(stiffness)
    assert results.plate.value_at("settlement", 0.0, 0.0) == pytest.approx(w, rel=1e-4)
    for beam, k, L in zip(results.beams, stiffness, (long, short), strict=True):
        assert beam.moment.max() == pytest.approx(k * w * L / 4, rel=1e-4)
        assert np.abs(beam.shear) == pytest.approx(k * w / 2, rel=1e-3)
    assert sum(abs(each.total) for each in results.supports) == pytest.approx(P, rel=1e-6)


def test_a_ring_beam_clamps_a_circular_plate() -> None:
    """A simply supported circle with a ring along its edge, which turns by m a^2 / EI under a moment m per length.

    Timoshenko and Woinowsky-Krieger 1959, section 16: under a pressure the edge turns by q a^3 / 8 D (1 + nu), under a
    moment at the edge by M a / D (1 + nu), and the middle settles by (5 + nu) q a^4 / 64 D (1 + nu) or
    M a^2 / 2 D (1 + nu).
    """
    a, q, nu, t = 5.0, 10e3, 0.2, 0.2
    D = E * t**3 / 12 / (1 - nu**2)
    shear = 5 / 6 * E / (2 * (1 + nu)) * t
    circle = {"kind": "circle", "centre": (0.0, 0.0), "radius": a}
    model = gs.Model(
        plate={"outline": circle, "thickness": t, "E": E, "nu": nu, "support": "soft"},
        ground={"kind": "winkler", "k": 1.0},
        contact={"tensionless": False},
        beams=[{"name": "ring", "shape": circle, "section": STIFF}],
        loads=[{"kind": "uniform", "q": q}],
        mesh={"size": 0.5},
    )
    results = gs.solve(model).only
    m = q * a**3 / 8 / (D * (1 + nu)) / (a**2 / EI + a / (D * (1 + nu)))
    w = (5 + nu) / (1 + nu) * q * a**4 / (64 * D) - m * a**2 / (2 * D * (1 + nu)) + q * a**2 / (4 * shear)
    assert results.plate.value_at("settlement", 0.0, 0.0) == pytest.approx(w, rel=1e-3)
    (ring,) = results.beams
    assert ring.way[-1] == pytest.approx(2 * math.pi * a, rel=1e-6)
    # the plate's edge turns outwards upwards, so that the ring is bent as if it sagged: -EI dbeta/ds . t = m a
    assert ring.moment == pytest.approx(m * a, rel=5e-3)
    assert np.abs(ring.torsion).max() == 0.0


def lifting_beam(length: float, n: int, stiffness: float, k: float, forces: dict[float, float]) -> tuple[Array, Array]:
    """Return settlement and moment at n + 1 nodes of a Bernoulli beam on springs [N/m2] that only push.

    Cubic elements; springs by Simpson's rule at nodes and middles, which those that pull leave one after the other.
    """
    h = length / n
    element = stiffness / h**3 * np.array([
        [12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h],
        [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h * h, -6 * h, 4 * h * h],
    ])  # fmt: skip
    size = 2 * (n + 1)
    bent, f = np.zeros((size, size)), np.zeros(size)
    for i in range(n):
        bent[2 * i : 2 * i + 4, 2 * i : 2 * i + 4] += element
    for x, P in forces.items():
        f[2 * round(x / h)] += P
    rows = np.zeros((2 * n + 1, size))
    rows[::2, ::2] = np.eye(n + 1)
    for i in range(n):
        rows[2 * i + 1, 2 * i : 2 * i + 4] = 0.5, h / 8, 0.5, -h / 8
    share = k * h / 6 * np.tile([2.0, 4.0], n + 1)[:-1]
    share[[0, -1]] /= 2
    pushes = np.ones(len(share), dtype=bool)
    for _ in range(100):
        u = np.linalg.solve(bent + rows.T @ (np.where(pushes, share, 0.0)[:, None] * rows), f)
        before, pushes = pushes, rows @ u > 0
        if (before == pushes).all():
            break
    ends = np.array([element @ u[2 * i : 2 * i + 4] for i in range(n)])
    M: Array = np.append(ends[:, 1], -ends[-1, 3])
    return u[::2], M


def test_a_beam_that_lifts_off_is_that_of_a_small_program() -> None:
    """Forces in the middle and near one end of a long stiff beam: both ends lift, differently; an active set agrees."""
    length, forces = 24.0, {12.0: 300e3, 16.0: 100e3}
    loads = [force(x - length / 2, P) for x, P in forces.items()]
    results = gs.solve(strip(length, [along(length)], loads, contact={"tensionless": True}, mesh={"size": 0.05}))
    beam = only_beam(results)
    w, M = lifting_beam(length, 480, WHOLE, K * B, forces)
    assert results.plate.contact_share < 0.85
    places = np.linspace(0.0, length, 481)
    assert beam.settlement == pytest.approx(np.interp(beam.way, places, w), abs=1e-3 * w.max())
    assert beam.moment == pytest.approx(EI / WHOLE * np.interp(beam.way, places, M), abs=1e-3 * np.abs(M).max())


def ribbed_raft(beams: list[dict[str, Any]], turned: bool = False) -> gs.Results:
    """Return the results of a small raft with ribs and two forces, or of the same turned by a quarter."""

    def place(x: float, y: float) -> tuple[float, float]:
        return (-y, x) if turned else (x, y)

    sides = dict(zip(("length_x", "length_y"), (4.0, 6.0) if turned else (6.0, 4.0), strict=True))
    loads = [((-1.0, 0.5), 300e3), ((2.0, -1.0), 200e3)]
    return gs.solve(
        gs.Model(
            plate={**sides, "thickness": 0.25, "E": E, "nu": 0.2},
            ground={"kind": "pasternak", "k0": 20e6, "k1": 10e6},
            beams=[each | {"points": [place(*point) for point in each["points"]]} for each in beams],
            loads=[
                {"kind": "point", "x": place(*at)[0], "y": place(*at)[1], "P": P, "width_x": 0.4, "width_y": 0.4}
                for at, P in loads
            ],
            mesh={"size": 0.25},
        )
    )


RIB = {"kind": "rib", "width": 0.3, "height": 0.4, "effective_width": 1.0}
LONG = {"name": "long", "points": [(-3.0, 0.5), (3.0, 0.5)], "section": RIB}
SHORT = {"name": "short", "points": [(2.0, -2.0), (2.0, 2.0)], "section": RIB}


def test_a_beam_in_two_parts_is_the_same_beam() -> None:
    """Parts that follow each other bend as the whole one; so does one that runs the other way, its torsion too."""
    whole = ribbed_raft([LONG, SHORT]).only
    parts = ribbed_raft(
        [
            LONG | {"name": "left", "points": [(-3.0, 0.5), (-1.0, 0.5)]},
            LONG | {"name": "right", "points": [(3.0, 0.5), (-1.0, 0.5)]},
            SHORT,
        ]
    ).only
    assert parts.plate.settlement == pytest.approx(whole.plate.settlement, rel=1e-9)
    beam, (left, right, _) = whole.beams[0], parts.beams
    for name, sign in (("settlement", 1), ("moment", 1), ("shear", -1), ("torsion", 1)):
        along_whole = getattr(beam, name)
        scale = np.abs(along_whole).max()
        for part, way, turned in ((left, left.way, 1), (right, 6.0 - right.way, sign)):
            # where the parts meet, each takes its values from its own side alone; at the other rib they jump
            away = (part.way < part.way[-1] - 0.3) & (np.abs(part.nodes[:, 0] - 2.0) > 0.1)
            expected = np.interp(way[away], beam.way, along_whole)
            assert turned * getattr(part, name)[away] == pytest.approx(expected, abs=1e-6 * scale)


def test_a_beam_that_crosses_itself_is_its_parts() -> None:
    """Its section forces jump where it crosses itself, as those of beams that cross each other."""
    way = [(-2.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0), (0.0, -1.0)]
    (whole,) = ribbed_raft([LONG | {"points": way}]).only.beams
    parts = ribbed_raft([LONG | {"name": str(n), "points": way[n : n + 2]} for n in range(4)]).only.beams
    assert whole.way[-1] == pytest.approx(sum(part.way[-1] for part in parts))
    for name in ("settlement", "moment", "shear", "torsion"):
        joined = np.concatenate([getattr(part, name) for part in parts])
        assert getattr(whole, name) == pytest.approx(joined, abs=1e-6 * np.abs(joined).max())


def test_a_turned_raft_with_ribs_is_the_same() -> None:
    """By a quarter turn: section forces of ribs, and settlements."""
    one, other = ribbed_raft([LONG, SHORT]).only, ribbed_raft([LONG, SHORT], turned=True).only
    assert other.plate.settlement.max() == pytest.approx(one.plate.settlement.max(), rel=1e-3)
    for a, b in zip(one.beams, other.beams, strict=True):
        assert b.moment.max() == pytest.approx(a.moment.max(), rel=5e-3)
        assert b.moment.min() == pytest.approx(a.moment.min(), rel=2e-2)


def test_equilibrium_holds_in_a_cut_through_slab_and_rib() -> None:
    """Moments of the slab in a cut, and of the rib that crosses it, balance loads and pressures on one side."""
    length, k = 12.0, 10e6
    model = gs.Model(
        plate={"length_x": length, "length_y": 1.0, "thickness": 0.2, "E": E, "nu": 0.0},
        ground={"kind": "winkler", "k": k},
        contact={"tensionless": False},
        beams=[along(length, {"kind": "rectangle", "width": 0.3, "height": 0.6})],
        loads=[{"kind": "line", "points": [(0.0, -0.5), (0.0, 0.5)], "q": 100e3}],
        mesh={"size": 0.125},
    )
    results = gs.solve(model).only
    plate, (beam,) = results.plate, results.beams
    cut = 1.0
    g, weight = np.polynomial.legendre.leggauss(40)
    x, weight = cut + (length / 2 - cut) * (g + 1) / 2, weight * (length / 2 - cut) / 2
    y = np.linspace(-0.5, 0.5, 201)
    y[100] = 1e-9
    X, Y = np.meshgrid(x, y)
    pressed = np.trapezoid(k * plate.value_at("settlement", X, Y), y, axis=0)
    for name, of_beam, exact in (
        ("moment_x", beam.moment, weight @ (pressed * (x - cut))),
        ("shear_x", beam.own_shear, -weight @ pressed),
    ):
        in_slab = np.trapezoid(plate.value_at(name, np.full(len(y), cut), y), y)
        in_rib = np.interp(cut + length / 2, beam.way, of_beam)
        assert in_slab + in_rib == pytest.approx(exact, rel=1e-3)


@pytest.mark.parametrize("element", ["mitc9", "q9", "heterosis"])
def test_told_errors_of_beams_cover_true_ones(element: str) -> None:
    """On a coarse mesh the told error of a rib's moments is of the size of the true one, which a fine mesh tells."""

    def rib(size: float) -> gs.CombinationResult:
        return gs.solve(
            gs.Model(
                plate={
                    "length_x": 6.0,
                    "length_y": 4.0,
                    "thickness": 0.25,
                    "E": E,
                    "nu": 0.2,
                    "element": element,
                },
                ground={"kind": "winkler", "k": 50e6},
                beams=[LONG | {"points": [(-3.0, 0.0), (3.0, 0.0)]}],
                loads=[{"kind": "patch", "x": (-1.5, -0.5), "y": (-0.5, 0.5), "q": 300e3}],
                mesh={"size": size},
            )
        ).only

    coarse, fine = rib(0.5), rib(0.125)
    assert coarse.coarser is not None
    assert coarse.comparison is not None
    for figure in (np.max, np.min):
        value, other, exact = (float(figure(each.beams[0].moment)) for each in (coarse, coarse.coarser, fine))
        told = estimate_error(value, other, coarse.comparison)
        assert abs(value - exact) < max(1.5 * told, 2e-3 * abs(exact))


def test_what_beams_carry_across_a_perimeter_does_not_punch() -> None:
    """The force that punches around a column on two ribs is the slab's shear force across the perimeter, to 1 %.

    By equilibrium, with the ribs' shear forces at the perimeter; and from the slab's shear forces, integrated along it.
    """
    P = 800e3
    model = gs.Model(
        plate={"length_x": 6.0, "length_y": 5.0, "thickness": 0.25, "E": E, "nu": 0.2},
        ground={"kind": "winkler", "k": 40e6},
        contact={"tensionless": False},
        columns=[{"name": "C", "x": 0.3, "y": 0.2, "width_x": 0.4, "width_y": 0.4}],
        beams=[
            {"name": "x", "points": [(-3.0, 0.2), (3.0, 0.2)], "section": RIB},
            {"name": "y", "points": [(0.3, -2.5), (0.3, 2.5)], "section": RIB},
        ],
        loads=[{"kind": "point", "column": "C", "P": P}],
        mesh={"size": 0.1},
    )
    results = gs.solve(model).only
    (column,) = punching_columns(model)
    for distance in (0.4, 0.6):
        around = perimeter(results.plate, column.footprint, distance)
        inside = loads_near(results, column, distance).inside(results, around.inside)
        assert len(inside.crossings) == 4
        shear = punching_shear(results, inside, column, np.array(column.place), edge_relieves=False)
        assert shear.others < -0.3 * P
        out = 0.0
        for start, end in around.whole:
            step = (end - start) / 20
            places = start + (np.arange(20)[:, None] + 0.5) * step
            q = [results.plate.value_at(name, *places.T) for name in ("shear_x", "shear_y")]
            out += float((q[0] * step[1] - q[1] * step[0]).sum())
        assert -out == pytest.approx(shear.V, rel=1e-2)
        # on an axis of symmetry of column and ribs the moments come from the plate's edges alone
        assert np.abs(shear.moments).max() < 0.05 * P * distance


def test_a_beam_with_hinged_ends_is_simply_supported() -> None:
    """From edge to edge of a plate as soft as nothing, a hinged beam takes no moment at its ends, q L^2 / 8 between.

    Both edges are held against turning. Clamped there it has -q L^2 / 12 and q L^2 / 24; with one hinge -q L^2 / 8 at
    the other end.
    """
    q, span = 10e3, 6.0

    def moments(joined: tuple[str, str]) -> BeamResult:
        model = gs.Model(
            plate={"length_x": span, "length_y": 2.0, "thickness": 0.05, "E": 1e3, "nu": 0.0},
            ground={"kind": "winkler", "k": 1e-3},
            contact={"tensionless": False},
            supports=[
                {"kind": "line", "points": [(x, -1.0), (x, 1.0)], "rotation": "fixed", "acts": "both ways"}
                for x in (-span / 2, span / 2)
            ],
            beams=[
                {
                    "name": "B",
                    "points": [(-span / 2, 0.0), (span / 2, 0.0)],
                    "section": STIFF,
                    "E": E,
                    "joined": joined,
                }
            ],
            loads=[{"kind": "line", "points": [(-span / 2, 0.0), (span / 2, 0.0)], "q": q}],
            mesh={"size": 0.25},
        )
        return only_beam(gs.solve(model))

    whole = q * span**2
    hinged, clamped, half = (moments(ends) for ends in (("hinged", "hinged"), ("fixed", "fixed"), ("hinged", "fixed")))
    assert hinged.moment.max() == pytest.approx(whole / 8, rel=2e-3)
    assert hinged.moment[[0, -1]] == pytest.approx(0.0, abs=1e-3 * whole)
    assert clamped.moment[[0, -1]] == pytest.approx(-whole / 12, rel=5e-3)
    assert clamped.moment.max() == pytest.approx(whole / 24, rel=5e-3)
    assert half.moment[[0, -1]] == pytest.approx([0.0, -whole / 8], abs=1e-3 * whole)
    assert half.moment.max() == pytest.approx(9 / 128 * whole, rel=5e-3)


@pytest.mark.parametrize(
    "ways",
    [
        [[(0.3, 0.2), (2.3, 0.2), (2.3, 2.2), (0.3, 2.2), (0.3, 0.2)]],
        [[(0.3, 2.2), (0.3, 0.2), (2.3, 0.2), (2.3, 2.2), (0.3, 2.2)]],
        [[(2.3, 2.2), (0.3, 2.2), (0.3, 0.2)], [(2.3, 2.2), (2.3, 0.2), (0.3, 0.2)]],
    ],
)
def test_what_punches_does_not_depend_on_where_beams_start(ways: list[list[tuple[float, float]]]) -> None:
    """At a column on the corner of a closed beam: one that starts there, one that starts elsewhere, two halves."""
    around = [(2.3, 0.2), (2.3, 2.2), (0.3, 2.2), (0.3, 0.2), (2.3, 0.2)]
    V = [[_punching_at_column(beams, distance) for distance in (0.4, 0.6)] for beams in (ways, [around])]
    assert V[0] == pytest.approx(V[1], rel=1e-6)
    assert max(V[0]) < 0.8 * 800e3


def test_a_beam_that_crosses_itself_at_a_column_carries_as_two() -> None:
    """What punches at the crossing is the same."""
    way = [(-1.7, 0.2), (2.3, 0.2), (2.3, 1.2), (0.3, 1.2), (0.3, -1.8)]
    parts = [way[:2], way[1:4], way[3:]]
    for distance in (0.4, 0.6):
        assert _punching_at_column([way], distance) == pytest.approx(_punching_at_column(parts, distance), rel=1e-6)


def _punching_at_column(beams: list[list[tuple[float, float]]], distance: float) -> float:
    """Return what punches at a column on ribs along lines, at a distance from its faces [N]."""
    model = gs.Model(
        plate={"length_x": 6.0, "length_y": 5.0, "thickness": 0.25, "E": E, "nu": 0.2},
        ground={"kind": "winkler", "k": 40e6},
        contact={"tensionless": False},
        columns=[{"name": "C", "x": 0.3, "y": 0.2, "width_x": 0.4, "width_y": 0.4}],
        beams=[{"name": str(number), "points": points, "section": RIB} for number, points in enumerate(beams)],
        loads=[{"kind": "point", "column": "C", "P": 800e3}],
        mesh={"size": 0.2},
    )
    results = gs.solve(model).only
    (column,) = punching_columns(model)
    inside = perimeter(results.plate, column.footprint, distance).inside
    near = loads_near(results, column, distance).inside(results, inside)
    return punching_shear(results, near, column, np.array(column.place), edge_relieves=False).V


def test_an_arc_is_a_polygon_with_many_corners() -> None:
    """Half a circle as two arcs and as thirty straight pieces, whose section forces turn a little at each corner."""
    angles = np.linspace(0.0, np.pi, 31)
    bulge = math.tan(math.pi / 8)
    axes: list[dict[str, Any]] = [
        {"points": [(3.0, 0.0), (0.0, 3.0), (-3.0, 0.0)], "bulges": [bulge, bulge]},
        {"points": [(3 * math.cos(angle), 3 * math.sin(angle)) for angle in angles.tolist()]},
    ]
    arc, polygon = (
        gs.solve(
            gs.Model(
                plate={"length_x": 12.0, "length_y": 10.0, "thickness": 0.25, "E": E, "nu": 0.2},
                ground={"kind": "pasternak", "k0": 15e6, "k1": 5e6},
                beams=[{"name": "arc", "section": {"kind": "rectangle", "width": 0.4, "height": 0.8}} | axis],
                loads=[
                    {"kind": "uniform", "q": 5e3},
                    {"kind": "point", "x": 0.0, "y": 3.0, "P": 5e5, "width_x": 0.5, "width_y": 0.5},
                ],
                mesh={"size": 0.5},
            )
        ).only
        for axis in axes
    )
    assert arc.certificate.holds
    assert arc.beams[0].way[-1] == pytest.approx(3 * math.pi, rel=1e-4)
    assert arc.plate.settlement.max() == pytest.approx(polygon.plate.settlement.max(), rel=2e-3)
    assert arc.beams[0].moment.max() == pytest.approx(polygon.beams[0].moment.max(), rel=5e-3)
    assert arc.beams[0].torsion.max() == pytest.approx(-arc.beams[0].torsion.min(), rel=1e-2)
