"""The edge line force of a ground with shear, and a limit pressure beside it, against strips solved exactly."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm

from groundslab import CombinationResult, Model, NoEquilibrium, solve
from helpers.solve_once import solve_once

K0, K1, L, WIDTH = 10e6, 40e6, 6.0, 1.0
E, T = 30e9, 0.3
EI, S = E * T**3 / 12, 5 / 6 * E * T / 2
#: A load on part of the strip beside one on all of it: nothing is symmetric, and all rests on the ground.
Q, FROM, TO = 150e3, -1.5, 1.8
OWN = 30e3


def strip(n: int, beyond: str, **contact: Any) -> CombinationResult:
    """Return a strip of a plate, with nu = 0 and ground beyond its ends alone, so that all depends on x only."""
    beside = {"kind": beyond, "sides": ["left", "right"]} if beyond != "none" else {"kind": "none"}
    return solve_once(
        Model.model_validate(
            {
                "plate": {"length_x": L, "length_y": WIDTH, "thickness": T, "E": E, "nu": 0.0, "shear_factor": 5 / 6},
                "ground": {"kind": "pasternak", "k0": K0, "k1": K1},
                "beyond": beside,
                "contact": contact,
                "loads": [
                    {"kind": "uniform", "q": OWN},
                    {"kind": "patch", "q": Q, "x": [FROM, TO], "y": [-WIDTH / 2, WIDTH / 2]},
                ],
                "mesh": {"counts": [n, 2], "symmetry": "off"},
            }
        )
    )


def exact(infinite: bool) -> dict[str, np.ndarray]:
    """Return line force [N/m], pressure [Pa] and settlement [m] at both ends, and the largest moment, of the strip.

    y = (w, beta, m, q, 1) with m' = q, beta' = -m / D, w' = beta + q / S and q' = p - load, where the pressure is
    p = k0 w - k1 w'', follows y' = A y on each piece with the same load, so that exponentials of A lead from one end to
    the other. There m vanishes, and the shear force is the line force k1 w' + sqrt(k0 k1) w, taken outwards.
    """

    def matrix(load: float) -> np.ndarray:
        shear = np.array([K0, 0, K1 / EI, 0, -load]) / (1 + K1 / S)
        return np.array([[0, 1, 0, 1 / S, 0], [0, 0, -1 / EI, 0, 0], [0, 0, 0, 1, 0], shear, [0, 0, 0, 0, 0]])

    def line(y: np.ndarray, outward: int) -> np.ndarray:
        return K1 * outward * (y[1] + y[3] / S) + infinite * np.sqrt(K0 * K1) * y[0]

    def pressure(y: np.ndarray) -> float:
        load = OWN  # at both ends
        return float(matrix(load)[3] @ y + load)

    pieces = (FROM + L / 2, OWN), (TO - FROM, OWN + Q), (L / 2 - TO, OWN)
    whole = np.eye(5)
    for length, load in pieces:
        whole = expm(length * matrix(load)) @ whole
    rows = np.array([np.eye(5)[2], np.eye(5)[3] - line(np.eye(5), -1), whole[2], whole[3] + line(whole, 1)])
    left = np.append(np.linalg.solve(rows[:, :4], -rows[:, 4]), 1.0)
    right = whole @ left
    return {
        "line_force": np.array([line(left, -1), line(right, 1)]),
        "pressure": np.array([pressure(left), pressure(right)]),
        "settlement": np.array([left[0], right[0]]),
    }


def ends(results: CombinationResult, field: str) -> np.ndarray:
    """Return a field in the middle of both ends."""
    plate = results.plate
    at = [np.argmin(np.hypot(plate.nodes[:, 0] - x, plate.nodes[:, 1])) for x in (-L / 2, L / 2)]
    values: np.ndarray = getattr(plate, field)[at]
    return values


@pytest.mark.slow
@pytest.mark.parametrize("beyond", ["infinite", "none"])
def test_a_strip_glued_to_the_ground(beyond: str) -> None:
    """At the ends line force, pressure and settlement converge to the exact ones, without ground beyond them, too."""
    wanted = exact(beyond == "infinite")
    off = {name: [] for name in wanted}
    for n in (12, 24, 48):
        results = strip(n, beyond, tensionless=False)
        for name, values in wanted.items():
            off[name].append(np.abs(ends(results, name) - values).max() / np.abs(values).max())
    assert off["settlement"][-1] < 1e-5
    assert off["line_force"][-1] < 1e-3
    assert off["pressure"][-1] < 5e-3
    assert off["pressure"][0] > 2 * off["pressure"][1] > 4 * off["pressure"][2]


@pytest.mark.slow
def test_a_limit_pressure_that_is_not_reached_changes_nothing() -> None:
    """The limit is one of the pressure: the line force may be as large as it is, and all results stay the same."""
    wanted, free = exact(True), strip(48, "infinite")
    assert free.plate.in_contact.all()
    limit = 1.05 * free.plate.pressure.max()
    # spread over the outermost nodes' share of the plate the line force would be far above it
    assert wanted["line_force"].max() > 4 * limit * (L / 48 / 6)
    limited = strip(48, "infinite", limit_pressure=limit)
    assert not limited.plate.penetration.any()
    for name, values in wanted.items():
        np.testing.assert_allclose(ends(limited, name), values, rtol=5e-3)
    for name in ("settlement", "pressure", "line_force", "moment_x"):
        one, other = (getattr(results.plate, name) for results in (limited, free))
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-9 * np.abs(other).max())


@pytest.mark.slow
def test_a_limit_pressure_that_is_reached() -> None:
    """Where the ground yields its pressure is the limit, nowhere more; the line forces carry what it no longer does."""
    free = strip(48, "infinite")
    limit = 0.9 * free.plate.pressure.max()
    results = strip(48, "infinite", limit_pressure=limit)
    plate = results.plate
    assert plate.penetration.max() > 0
    assert plate.pressure.max() <= limit * (1 + 1e-9)
    np.testing.assert_allclose(plate.pressure[plate.penetration > 0], limit, rtol=1e-9)
    assert (plate.line_force * plate.edge_length).sum() > (free.plate.line_force * free.plate.edge_length).sum()
    assert plate.contact_force.sum() == pytest.approx(OWN * L + Q * (TO - FROM), rel=1e-9)


def test_more_than_the_limit_pressure_over_all_of_the_plate_is_refused() -> None:
    """Line forces do not count as capacity: the whole carries no more than its area times the limit."""
    mean = OWN + Q * (TO - FROM) / L
    assert strip(12, "infinite", limit_pressure=1.4 * mean).certificate.holds
    with pytest.raises(NoEquilibrium, match="more than ground and supports can carry"):
        strip(12, "infinite", limit_pressure=0.98 * mean)


SHAPES = {
    "rectangle": {"length_x": 6.0, "length_y": 4.0},
    "polygon with an opening": {
        "outline": {"kind": "polygon", "points": [(0, 0), (6, 0), (6, 2), (2.5, 2.5), (2, 5), (0, 5)]},
        "openings": [{"kind": "rectangle", "x": (0.5, 1.5), "y": (1, 2)}],
    },
    "circle": {"outline": {"kind": "circle", "centre": (0, 0), "radius": 3}},
}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("shape", "tensionless", "kind"),
    [
        ("rectangle", True, "pasternak"),
        ("polygon with an opening", True, "layers"),
        ("circle", True, "pasternak"),
        ("polygon with an opening", False, "pasternak"),
        ("circle", False, "winkler"),
    ],
)
def test_pressures_and_line_forces_together_are_the_load(shape: str, tensionless: bool, kind: str) -> None:
    """Pressure times area and line force times length sum up to the load, with its moments; neither pulls."""
    soil = [{"thickness": 1.0, "E": 20e6, "nu": 0.3}, {"thickness": 2.0, "E": 40e6, "nu": 0.3}]
    grounds = {
        "pasternak": {"kind": "pasternak", "k0": K0, "k1": 20e6},
        "layers": {"kind": "layered", "coupling": "consistent", "layers": soil},
        "winkler": {"kind": "winkler", "k": K0},
    }
    loads = [{"kind": "uniform", "q": 4e3}, {"kind": "point", "P": 200e3, "x": 1.7, "y": 0.6}]
    model = Model.model_validate(
        {
            "plate": {"thickness": 0.25, "E": E, "nu": 0.2, **SHAPES[shape]},
            "ground": grounds[kind],
            "beyond": {"kind": "none" if kind == "winkler" else "infinite"},
            "contact": {"tensionless": tensionless},
            "loads": loads,
            "mesh": {"size": 0.6},
        }
    )
    results = solve(model)
    plate = results.plate
    x, y = plate.nodes.T
    area, force = plate.area, plate.contact_force
    total = 4e3 * area.sum() + 200e3
    assert force.sum() == pytest.approx(total, rel=1e-9)
    assert force @ x == pytest.approx(4e3 * area @ x + 200e3 * 1.7, rel=1e-7)
    assert force @ y == pytest.approx(4e3 * area @ y + 200e3 * 0.6, rel=1e-7)
    if kind == "winkler":
        assert not plate.line_force.any()
        return
    on_edge = plate.edge_length > 0
    assert not plate.line_force[~on_edge].any()
    assert plate.line_force[on_edge].any()
    outline = {"rectangle": 20.0, "polygon with an opening": None, "circle": np.pi * 6}[shape]
    if outline is not None:
        assert plate.edge_length.sum() == pytest.approx(outline, rel=1e-4)
    if tensionless:
        assert plate.pressure.min() >= 0
        assert plate.line_force.min() >= 0
        assert not force[~plate.in_contact].any()


@pytest.mark.slow
def test_edge_pressure_converges() -> None:
    """At the middle of an edge pressure and line force hardly change from mesh to mesh; a node's force halves."""
    found = []
    for size in (0.5, 0.25, 0.125):
        model = Model.model_validate(
            {
                "plate": {"length_x": 6.0, "length_y": 4.0, "thickness": 0.3, "E": E, "nu": 0.2},
                "ground": {"kind": "pasternak", "k0": K0, "k1": K1},
                "beyond": {"kind": "infinite"},
                "loads": [{"kind": "uniform", "q": 50e3}],
                "mesh": {"size": size},
            }
        )
        plate = solve(model).plate
        node = np.argmin(np.hypot(plate.nodes[:, 0] - 3.0, plate.nodes[:, 1]))
        found.append((plate.line_force[node], plate.pressure[node]))
    (_, p1), (f2, p2), (f3, p3) = found
    assert abs(f3 - f2) < 2e-3 * f3
    assert abs(p3 - p2) < 0.02 * p3
    assert abs(p3 - p2) < 0.5 * abs(p2 - p1)
