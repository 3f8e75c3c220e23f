"""Columns at an angle: what a rotation leaves as it is, and what a quarter turn makes of the sides."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import groundslab as gs
from groundslab.design.checks import check_design
from groundslab.design.codes.aci318.checks.two_way_demand import TwoWay, two_way
from groundslab.design.codes.en1992_2004.checks.governing_perimeters import column_demands as demands
from groundslab.design.codes.en1992_2023.checks.punching_demand import column_demands
from groundslab.design.demands.perimeters import RectangularColumn
from groundslab.design.rules.wide_beam import cuts
from helpers.solve_once import solve_once

#: Perimeters have chords for arcs, shorter by 3e-5 at most, whose corners do not turn with the column.
CHORDS = 1e-4
BARS = {"diameter": 0.016, "spacing": 0.15}
STEEL: dict[str, Any] = {"bottom": (0.05, 0.05), "top": (0.05, 0.05)} | dict.fromkeys(
    ("bottom_x", "bottom_y", "top_x", "top_y"), BARS
)
CODES: dict[str, dict[str, Any]] = {
    "EN 1992-1-1:2004": {"f_ck": 30e6, "f_yk": 500e6},
    "EN 1992-1-1:2004, German annex": {"f_ck": 30e6, "f_yk": 500e6, "annex": "Germany"},
    "EN 1992-1-1:2023": {"code": "EN 1992-1-1:2023", "f_ck": 30e6, "f_yk": 500e6, "d_lower": 0.016},
    "ACI 318": {"code": "ACI 318", "f_ck": 30e6, "f_yk": 420e6},
}
#: Columns inside, at an edge and at a corner: place and sides [m], angle [degrees].
COLUMNS = {
    "inside": (0.3, -0.2, 0.3, 0.7, 20.0),
    "edge": (2.6, 0.5, 0.3, 0.5, 0.0),
    "corner": (-2.6, -1.7, 0.4, 0.4, 0.0),
    "askew": (0.2, 1.5, 0.3, 0.5, 35.0),
}
#: Their forces [N] and moments along x and y [N m].
FORCES = {
    "inside": (900e3, 200e3, -120e3),
    "edge": (400e3, -20e3, 10e3),
    "corner": (250e3, 0.0, 0.0),
    "askew": (400e3, 80e3, 30e3),
}


def turned(x: float, y: float, angle: float) -> tuple[float, float]:
    """Return a vector turned by an angle [degrees]."""
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    return c * x - s * y, s * x + c * y


def model(code: str, turn: float = 0.0, columns: dict[str, Any] = COLUMNS, **changes: Any) -> gs.Model:
    """Return a slab of 6 m x 4 m with its columns and their loads, all turned by an angle [degrees]."""
    outline = [turned(x, y, turn) for x, y in ((-3, -2), (3, -2), (3, 2), (-3, 2))]
    stand, loads = [], []
    for name, (x, y, width_x, width_y, angle) in columns.items():
        place = dict(zip("xy", turned(x, y, turn), strict=True))
        stand.append({"name": name, **place, "width_x": width_x, "width_y": width_y, "angle": angle + turn})
        P, *M = FORCES[name]
        loads.append({"kind": "point", "column": name, "P": P, "case": "G"}
                     | dict(zip(("M_x", "M_y"), turned(*M, turn), strict=True)))  # fmt: skip
    parts: dict[str, Any] = {
        "plate": {"outline": {"kind": "polygon", "points": outline}, "thickness": 0.5, "E": 33e9, "nu": 0.2},
        "ground": {"kind": "winkler", "k": 25e6},
        "contact": {"tensionless": False},
        "beyond": {"kind": "none"},
        "columns": stand,
        "cases": [{"name": "G"}],
        "loads": loads,
        "combinations": [{"name": "ULS", "factors": {"G": 1.35}}],
        "reinforcement": STEEL | CODES[code],
    }
    return gs.Model(**parts | changes)


def numbers(code: str, results: gs.Results) -> dict[str, dict[str, float]]:
    """Return demand and share used of punching at each column, and what they are made of."""
    if code == "ACI 318":
        return {name: _of_aci(one) for (_, name), one in two_way(results).found.items()}
    if code == "EN 1992-1-1:2023":
        # where another column is near, tau_Ed is that of the analysis on its mesh
        return {
            name: {"V": one.V_Ed, "b_05": one.b_05, "b_0": one.b_0, "beta_e": one.beta_e, "k_pb": one.k_pb}
            for (_, name), one in column_demands(results).found.items()
        }
    found = {}
    for (_, name), one in demands(results).found.items():
        stress, face = one.governing, one.face
        assert stress is not None
        assert face is not None
        assert stress.control is not None
        found[name] = {"V": stress.V_Ed, "u": stress.u, "beta": stress.beta, "v": stress.v_Ed, "used": one.used(stress),
                       "u_0": face.u, "beta at the face": face.beta, "v at the face": face.v_Ed,
                       "W_1": float(stress.control.moduli[0]), "W_2": float(stress.control.moduli[1])}  # fmt: skip
    return found


def _of_aci(one: TwoWay) -> dict[str, float]:
    assert one.transfer is not None
    (gamma_1, gamma_2), (J_1, J_2) = one.transfer.shares, one.transfer.J
    return {
        "V": one.V_u,
        "b_o": one.b_o,
        "beta": one.beta,
        "v": one.v_u,
        "gamma_1": gamma_1,
        "gamma_2": gamma_2,
        "J_1": J_1,
        "J_2": J_2,
    }


@pytest.mark.slow
@pytest.mark.parametrize("code", CODES)
def test_a_slab_turned_with_its_columns(code: str) -> None:
    """All turned by 30 degrees punches as before: forces, perimeters, moduli, eccentricities and stresses.

    Both are solved on adaptive meshes, whose errors in these demands are a tenth of what chords make, by their own
    estimate; settlements of the columns agree as well.
    """
    solved = [solve_once(model(code, turn, mesh={"accuracy": 0.01})) for turn in (0.0, 30.0)]
    before, after = (numbers(code, results) for results in solved)
    assert set(before) == set(after) == set(COLUMNS)
    for name, known in before.items():
        assert after[name] == pytest.approx(known, rel=CHORDS), name
    one, other = (
        [results["ULS"].plate.value_at("settlement", each.x, each.y) for each in results.model.columns]
        for results in solved
    )
    assert one == pytest.approx(other, rel=CHORDS)


@pytest.mark.parametrize("code", CODES)
def test_a_quarter_turn_exchanges_the_sides(code: str) -> None:
    """A column of b x h at 90, -90 or 270 degrees is one of h x b, and a square one itself, to the last digit."""
    plain = {name: (x, y, b, h, 0.0) for name, (x, y, b, h, _) in COLUMNS.items()}
    want = check_design(solve_once(model(code, columns=plain, mesh={"size": 0.5}))).checks
    for quarter in (90.0, -90.0, 270.0):
        columns = {name: (x, y, h, b, quarter) for name, (x, y, b, h, _) in plain.items()}
        found = check_design(solve_once(model(code, columns=columns, mesh={"size": 0.5}))).checks
        assert [(each.name, each.of, each.demand, each.utilization, each.error) for each in found] == [
            (each.name, each.of, each.demand, each.utilization, each.error) for each in want
        ]


@pytest.mark.parametrize("code", [code for code in CODES if code != "EN 1992-1-1:2023"])
def test_an_angle_matters(code: str) -> None:
    """The same columns along x and y have other stresses: a test that turns nothing would be none.

    By the second generation of EN 1992-1-1 the direction of an eccentricity inside a slab does not matter.
    """
    plain = {name: (x, y, b, h, 0.0) for name, (x, y, b, h, _) in COLUMNS.items()}
    before, after = (
        numbers(code, solve_once(model(code, columns=each, mesh={"size": 0.5}))) for each in (plain, COLUMNS)
    )
    for name in ("inside", "askew"):
        assert after[name] != pytest.approx(before[name], rel=1e-2), name


def test_one_way_shear_at_d_from_a_column_at_an_angle() -> None:
    """Cuts of ACI 318 are d away from the lines across the bars that touch the column: those through its corners."""
    columns = {"inside": (0.0, 0.0, 0.4, 0.4, 45.0)}
    results = solve_once(model("ACI 318", columns=columns, mesh={"size": 0.5}))
    steel = results.model.reinforcement
    assert steel is not None
    d = 0.5 - 0.05
    at = math.sqrt(0.08) + d
    places = sorted(cut.place for cut in cuts(results["ULS"], steel))
    np.testing.assert_allclose(places, [(-at, 0), (0, -at), (0, at), (at, 0)], atol=1e-12)


def test_a_load_on_a_column_at_an_angle() -> None:
    """Its force and its moments, along x and y as they are given, are those of the pressure on the turned footprint."""
    standing = model("ACI 318")
    load = standing.loads[0]
    assert isinstance(load, gs.PointLoad)
    on = load.on(standing.columns)
    assert (on.width_x, on.width_y, on.angle) == (0.3, 0.7, 20.0)
    (force,) = on.acts
    footprint = force.to_shapely(1e-6)
    assert footprint.equals_exact(RectangularColumn(0.3, -0.2, 0.3, 0.7, 20.0).footprint(), 1e-12)
    pressure = force.pressure(footprint)
    # by quadrature along the column's own axes
    t, w = np.polynomial.legendre.leggauss(4)
    s, v = np.meshgrid(0.15 * t, 0.35 * t)
    weights = np.outer(w, w) * 0.3 * 0.7 / 4
    x, y = turned(1.0, 0.0, 20.0)
    places = np.stack([0.3 + x * s - y * v, -0.2 + y * s + x * v], axis=-1)
    q = pressure(places)
    assert (q * weights).sum() == pytest.approx(900e3)
    assert (q * weights * (places[..., 0] - 0.3)).sum() == pytest.approx(200e3)
    assert (q * weights * (places[..., 1] + 0.2)).sum() == pytest.approx(-120e3)
