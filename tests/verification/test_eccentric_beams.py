"""Beams whose axes lie off the plate's middle plane: they stretch the plate, whose forces balance theirs."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.results.results import CombinationResult

#: A plate of 0.2 m with a rib of 0.3 m by 0.6 m below it [Pa, m].
E, T, WIDTH, HEIGHT = 30e9, 0.2, 0.3, 0.6
ECCENTRIC = {"kind": "rib", "width": WIDTH, "height": HEIGHT, "eccentric": True}


def strip(section: dict[str, Any], length: float = 40.0, **others: Any) -> gs.Model:
    """Return a strip one meter wide, simply supported at both ends, with a rib along it."""
    ends = [{"kind": "line", "points": [(x, -0.5), (x, 0.5)], "acts": "both ways"} for x in (-length / 2, length / 2)]
    parts: dict[str, Any] = {
        "plate": {"length_x": length, "length_y": 1.0, "thickness": T, "E": E, "nu": 0.0},
        "ground": {"kind": "winkler", "k": 1.0},
        "contact": {"tensionless": False},
        "supports": ends,
        "beams": [{"name": "rib", "points": [(-length / 2, 0.0), (length / 2, 0.0)], "section": section, "E": E}],
        "loads": [{"kind": "uniform", "q": 10e3}],
        "mesh": {"size": 0.25},
    }
    return gs.Model(**parts | others)


def only(model: gs.Model) -> CombinationResult:
    """Return the only combination, certified."""
    results = gs.solve(model).only
    assert results.certificate.holds
    return results


@pytest.mark.parametrize("ratio", [1.0, 0.1, 1e-3])
def test_a_strip_with_an_eccentric_rib_spans_as_a_tee(ratio: float) -> None:
    """The T of two materials: of one, I = 0.021225 m4; of a plate as soft as nothing, the rib's own 0.0054 m4.

    Deflection with the rib's shear, moment about the middle plane and axial force by hand, to 1e-3.
    """
    length, q = 40.0, 10e3
    plate = {"length_x": length, "length_y": 1.0, "thickness": T, "E": ratio * E, "nu": 0.0}
    results = only(strip(ECCENTRIC, plate=plate))
    (rib,) = results.beams
    area, flange, e = WIDTH * HEIGHT, ratio * 1.0 * T, (T + HEIGHT) / 2
    own, of_flange = WIDTH * HEIGHT**3 / 12, ratio * T**3 / 12
    whole = own + of_flange + area * flange / (area + flange) * e**2
    if ratio == 1.0:
        assert whole == pytest.approx(0.021225, rel=1e-4)
    shear = E / 2 * 5 / 6 * area
    M = q * length**2 / 8
    deflection = 5 * q * length**4 / (384 * E * whole) + M / shear
    assert results.plate.value_at("settlement", 0.0, 0.0) == pytest.approx(deflection, rel=1e-3)
    axial = M / whole * area * flange / (area + flange) * e
    assert rib.axial.max() == pytest.approx(axial, rel=1e-3)
    assert rib.moment.max() == pytest.approx(M * (1 - of_flange / whole), rel=1e-3)
    assert rib.eccentricity == pytest.approx(e)
    assert (rib.moment - rib.eccentricity * rib.axial).max() == pytest.approx(M * own / whole, rel=1e-3)
    assert results.elements.membrane_x is not None
    # all that the rib pulls the strip pushes
    middle = np.abs(results.plate.nodes[results.plate.elements[:, 8], 0]) < 0.2
    assert results.elements.membrane_x[middle].mean() == pytest.approx(-axial / 1.0, rel=2e-3)


def test_a_rib_above_is_one_below_but_for_the_axial_force() -> None:
    """Settlement and moment are the same, the axial force has the other sign."""
    below, above = (only(strip(ECCENTRIC | {"side": side}, length=8.0)) for side in ("below", "above"))
    assert above.plate.settlement == pytest.approx(below.plate.settlement, rel=1e-8)
    one, other = above.beams[0], below.beams[0]
    assert one.moment == pytest.approx(other.moment, abs=1e-8 * other.moment.max())
    assert one.axial == pytest.approx(-other.axial, abs=1e-8 * other.axial.max())


def test_without_eccentricity_nothing_is_stretched() -> None:
    """A section whose axis lies in the middle plane is as one that is not eccentric."""
    given = {"kind": "properties", "second_moment": 0.0054, "shear_area": 0.15}
    plain = only(strip(given, length=8.0))
    centric = only(strip(given | {"area": 0.18, "eccentricity": 0.0}, length=8.0))
    assert centric.unknowns > plain.unknowns
    assert centric.plate.settlement == pytest.approx(plain.plate.settlement, rel=1e-8)
    assert np.abs(centric.beams[0].axial).max() < 1e-8 * np.abs(centric.beams[0].moment).max()


def test_a_wide_flange_acts_with_the_width_of_karman() -> None:
    """A beam under q cos(pi x / L) with a flange without end: 2 lambda = 4 L / (pi (1 + nu) (3 - nu)).

    Timoshenko and Goodier, Theory of Elasticity, effective width of wide beam flanges: 0.181 of 2 L on both sides
    together for nu = 0.3. The plate bends as nothing; nine half waves, of which the middle one is read.
    """
    L, nu, t, e = 4.0, 0.3, 0.01, 0.5
    area, second_moment, q = 0.02, 0.02 * 0.5**2 / 12, 10e3
    flange = 4 * L / (math.pi * (1 + nu) * (3 - nu)) * t
    assert flange / (2 * L * t) == pytest.approx(0.181, abs=5e-4)
    whole = second_moment + area * flange / (area + flange) * e**2
    pieces = 20
    x = np.linspace(-4.5 * L, 4.5 * L, 9 * pieces + 1)
    ordinates = q * np.cos(np.pi * x / L)
    # lines between ordinates of a cosine have its first harmonic times this
    share = (math.sin(math.pi / 2 / pieces) / (math.pi / 2 / pieces)) ** 2
    model = gs.Model(
        plate={"length_x": 9 * L, "length_y": 6 * L, "thickness": t, "E": E, "nu": nu},
        ground={"kind": "winkler", "k": 1e-3},
        contact={"tensionless": False},
        supports=[
            {"kind": "line", "points": [(n * L / 2, -3 * L), (n * L / 2, 3 * L)], "acts": "both ways"}
            for n in range(-9, 10, 2)
        ],
        beams=[
            {
                "name": "beam",
                "points": [(-4.5 * L, 0.0), (4.5 * L, 0.0)],
                "section": {
                    "kind": "properties",
                    "second_moment": second_moment,
                    "shear_area": 1e3,
                    "area": area,
                    "eccentricity": e,
                },
            }
        ],
        loads=[
            {"kind": "line", "points": [(float(a), 0.0), (float(b), 0.0)], "q": float(one), "q_end": float(other)}
            for a, b, one, other in zip(x[:-1], x[1:], ordinates[:-1], ordinates[1:], strict=True)
        ],
        mesh={"size": 0.5},
    )
    results = only(model)
    M = share * q * (L / math.pi) ** 2
    (beam,) = results.beams
    middle = int(np.argmin(np.abs(beam.nodes[:, 0])))
    assert beam.axial[middle] == pytest.approx(M / whole * area * flange / (area + flange) * e, rel=2e-3)
    deflection = M * (L / math.pi) ** 2 / (E * whole)
    assert results.plate.value_at("settlement", 0.0, 0.0) == pytest.approx(deflection, rel=1e-3)


#: Settlements [mm] at places, and axial force [kN] and moment about its own axis [kNm] of each rib at x = 0, of
#: `ngsolve_shells.py`: under 10 kPa everywhere, and under 100 kPa on 2 m by 1 m.
PLACES = ((0.0, -1.2), (0.0, 1.2), (0.0, 0.0), (3.0, 1.2), (0.0, 2.4), (0.0, -2.4))
SHELLS = {
    "uniform": (
        (8.09657, 8.09657, 8.02212, 5.78858, 8.51654, 8.51654),
        (804.59734, 804.59738),
        (85.25422, 85.25422),
    ),
    "patch": (
        (2.58522, 6.31371, 4.42990, 4.28486, 8.09683, 1.06980),
        (260.53021, 746.09643),
        (29.31595, 82.36068),
    ),
}


@pytest.mark.parametrize("load", list(SHELLS))
def test_a_bridge_strip_with_two_ribs_is_near_that_of_shells(load: str) -> None:
    """12 m by 4.8 m, simply supported: settlements to 1 % of the largest, forces in ribs to 1 %, moments to 2.5 %."""
    loads = {
        "uniform": {"kind": "uniform", "q": 10e3},
        "patch": {"kind": "patch", "x": (-1.0, 1.0), "y": (0.7, 1.7), "q": 100e3},
    }
    results = only(
        gs.Model(
            plate={"length_x": 12.0, "length_y": 4.8, "thickness": T, "E": E, "nu": 0.2},
            ground={"kind": "winkler", "k": 1.0},
            contact={"tensionless": False},
            supports=[{"kind": "line", "points": [(x, -2.4), (x, 2.4)], "acts": "both ways"} for x in (-6.0, 6.0)],
            beams=[
                {"name": f"rib at {y:g} m", "points": [(-6.0, y), (6.0, y)], "section": ECCENTRIC} for y in (-1.2, 1.2)
            ],
            loads=[loads[load]],
            mesh={"size": 0.2},
        )
    )
    settlements, axial, moments = (np.array(each) for each in SHELLS[load])
    w = np.array([1e3 * results.plate.value_at("settlement", x, y) for x, y in PLACES])
    assert np.abs(w - settlements).max() < 0.01 * settlements.max()
    for rib, N, M in zip(results.beams, axial, moments, strict=True):
        middle = int(np.argmin(np.abs(rib.nodes[:, 0])))
        assert rib.axial[middle] == pytest.approx(1e3 * N, rel=0.01)
        own = rib.moment - rib.eccentricity * rib.axial
        assert own[middle] == pytest.approx(1e3 * M, rel=0.025)


def raft(*, turned: bool = False, ground: dict[str, Any] | None = None, **others: Any) -> gs.Model:
    """Return a raft with two crossing ribs, one not along its middle, that lifts off at a corner; or turned."""

    def at(x: float, y: float) -> tuple[float, float]:
        return (-y, x) if turned else (x, y)

    sides = ("length_y", "length_x") if turned else ("length_x", "length_y")
    parts: dict[str, Any] = {
        "plate": dict(zip(sides, (8.0, 6.0), strict=True)) | {"thickness": 0.25, "E": E, "nu": 0.2},
        "ground": ground or {"kind": "pasternak", "k0": 15e6, "k1": 5e6},
        "beams": [
            {"name": "long", "points": [at(-4.0, 1.0), at(4.0, 1.0)], "section": ECCENTRIC},
            {"name": "short", "points": [at(-2.0, -3.0), at(-2.0, 3.0)], "section": ECCENTRIC | {"side": "above"}},
        ],
        "loads": [
            {"kind": "point", "x": x, "y": y, "P": 400e3, "width_x": 0.5, "width_y": 0.5}
            for x, y in (at(-3.5, 1.0), at(-2.0, -1.0))
        ],
        "mesh": {"size": 0.5},
    }
    return gs.Model(**parts | others)


def across(results: CombinationResult, x: float) -> float:
    """Return what beams and plate carry together along x across a line x = const between elements [N]."""
    plate, n_x = results.plate, results.elements.membrane_x
    assert n_x is not None
    corners = plate.nodes[plate.elements[:, :4]]
    low, high = corners[..., 0].min(axis=1), corners[..., 0].max(axis=1)
    here = (low < x) & (x < high)
    total = float((n_x * np.ptp(corners[..., 1], axis=1))[here].sum())
    size = float(np.abs(n_x * np.ptp(corners[..., 1], axis=1))[here].sum())
    for beam in results.beams:
        if np.ptp(beam.nodes[:, 0]) > 0:
            total += float(np.interp(x, beam.nodes[:, 0], beam.axial))
    return total / size


def test_forces_in_the_plane_balance_across_sections() -> None:
    """Nothing acts in the plane: what ribs along x pull the plate pushes, where it lifts off too."""
    results = only(raft(mesh={"size": 0.25}))
    assert not results.plate.in_contact.all()
    sections = np.unique(results.plate.nodes[results.plate.elements[:, 8], 0])
    assert max(abs(across(results, float(x))) for x in sections[4:-4]) < 0.02


def test_a_turned_raft_has_the_same_forces() -> None:
    """Turned by a right angle, and with its ribs drawn from their other ends."""
    one, other = only(raft()), only(raft(turned=True))
    backwards = only(raft(beams=[
        {"name": "long", "points": [(4.0, 1.0), (-4.0, 1.0)], "section": ECCENTRIC},
        {"name": "short", "points": [(-2.0, 3.0), (-2.0, -3.0)], "section": ECCENTRIC | {"side": "above"}},
    ]))  # fmt: skip
    for number in (0, 1):
        scale = np.abs(one.beams[number].axial).max()
        for name in ("axial", "moment"):
            here, there, back = (getattr(each.beams[number], name) for each in (one, other, backwards))
            assert there == pytest.approx(here, abs=1e-6 * scale)
            assert np.sort(back) == pytest.approx(np.sort(here), abs=1e-6 * scale)


def test_a_rib_in_two_parts_is_one() -> None:
    """Split where nothing else meets it, to 1e-6 of the largest values."""
    whole = only(raft())
    short = {"name": "short", "points": [(-2.0, -3.0), (-2.0, 3.0)], "section": ECCENTRIC | {"side": "above"}}
    parts = [{"name": f"long {n}", "points": ends, "section": ECCENTRIC}
             for n, ends in enumerate(([(-4.0, 1.0), (1.0, 1.0)], [(1.0, 1.0), (4.0, 1.0)]))]  # fmt: skip
    split = only(raft(beams=[*parts, short]))
    assert split.plate.settlement == pytest.approx(whole.plate.settlement, abs=1e-6 * whole.plate.settlement.max())
    assert split.beams[0].axial.max() == pytest.approx(whole.beams[0].axial.max(), rel=1e-6)


@pytest.mark.parametrize(
    "others",
    [
        {"ground": {"kind": "winkler", "k": 15e6}},
        {"ground": {"kind": "continuum", "layers": [{"thickness": 8.0, "E": 20e6, "nu": 0.3}]}},
        {"ground": {"kind": "vlasov", "layers": [{"thickness": 4.0, "E": 20e6, "nu": 0.3}]}},
        {"contact": {"tensionless": True, "limit_pressure": 200e3}},
    ],
    ids=["winkler", "continuum", "vlasov", "limit pressure"],
)
def test_every_ground_is_certified(others: dict[str, Any]) -> None:
    """Forces in the plane are in the certificate, those that hold the plate in its plane too, which vanish."""
    results = only(raft(**others))
    sections = np.unique(np.round(results.plate.nodes[results.plate.elements[:, 8], 0], 6))
    inner = sections[(sections > -1.0) & (sections < 3.0)]
    assert max(abs(across(results, float(x))) for x in inner) < 0.02
    assert np.abs(results.beams[0].axial).max() > 20e3


def test_a_mesh_with_hanging_nodes_gives_the_same_force() -> None:
    """One that was refined where errors are large, against a grid, to 1 %."""
    refined, grid = only(raft(mesh={"accuracy": 0.05})), only(raft(mesh={"size": 0.25}))
    assert refined.beams[0].axial.max() == pytest.approx(grid.beams[0].axial.max(), rel=1e-2)
    assert refined.beams[1].axial.min() == pytest.approx(grid.beams[1].axial.min(), rel=3e-2)


def test_only_the_plate_of_an_eccentric_rib_is_stretched() -> None:
    """Of two joined plates that with the rib has unknowns in its plane; the joint holds nothing there."""
    plate = {"length_x": 4.0, "length_y": 4.0, "thickness": 0.25, "E": E, "nu": 0.2}

    def model(section: dict[str, Any]) -> gs.Model:
        return gs.Model(
            plate=plate | {"name": "A"},
            plates=[
                {
                    "name": "B",
                    "outline": {"kind": "rectangle", "x": (2.0, 6.0), "y": (-2.0, 2.0)},
                    "thickness": 0.25,
                    "E": E,
                    "nu": 0.2,
                }
            ],
            joints=[{"kind": "elastic", "between": ["A", "B"], "stiffness": 50e6, "gap": 1e-4}],
            ground={"kind": "winkler", "k": 20e6},
            beams=[{"name": "rib", "points": [(-2.0, 0.0), (2.0, 0.0)], "section": section}],
            loads=[
                {"kind": "uniform", "q": 10e3},
                {"kind": "point", "x": 0.0, "y": 0.0, "P": 300e3, "width_x": 0.4, "width_y": 0.4},
            ],
            mesh={"size": 0.5},
        )

    plain, stretched = only(model(ECCENTRIC | {"eccentric": False, "effective_width": 1.5})), only(model(ECCENTRIC))
    nodes = (2 * 8 + 1) ** 2
    assert stretched.unknowns - plain.unknowns == 2 * nodes - 3
    assert stretched.elements.membrane_x is not None
    beyond = stretched.plate.nodes[stretched.plate.elements[:, 8], 0] > 2.0
    assert not stretched.elements.membrane_x[beyond].any()
    assert stretched.beams[0].axial.max() > 20e3
