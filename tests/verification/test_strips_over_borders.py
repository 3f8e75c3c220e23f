"""Borders of soil zones and voids: strips with exact solutions, figures of another program, and how errors shrink.

A plate of nu = 0 loaded alike along y bends like a Timoshenko beam. Its equations with the ground's, all with constant
coefficients between the borders, are solved by matrix exponentials: nothing of groundslab takes part.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm

from groundslab import CombinationResult, Model, solve

E, T, FACTOR = 30e9, 0.25, 5 / 6
D, S = E * T**3 / 12, FACTOR * E / 2 * T


def beam(pieces: list[tuple[float, float, float, float, bool]]) -> list[Any]:
    """Return the exact settlement of a free beam of the plate's stiffness at the ends of its pieces, (m,).

    A piece is its length, k0, k1, load q and whether it lies over a cavity. The state is w, psi, M, the total shear
    force of beam and ground, and 1; over a cavity w, psi, M, Q of the beam, then w0 and k1 w0' of the ground.
    w' = psi + Q / S, psi' = -M / D, M' = Q, Q' = -q + pressure.
    """
    state = np.zeros((5, 2 + sum(piece[-1] for piece in pieces) + 1))  # affine in the unknowns
    state[0, 0] = state[1, 1] = state[4, -1] = 1.0
    equations, ends, number = [], [state[0]], 2
    for length, k0, k1, q, cavity in pieces:
        if not cavity:
            A = np.zeros((5, 5))
            a = 1 / (1 + k1 / S)  # w' a^-1 = psi + total / S
            A[0, 1], A[0, 3] = a, a / S
            A[1, 2] = -1 / D
            A[2] = S * (A[0] - np.eye(5)[1])
            A[3, 0], A[3, 4] = k0, -q
            state = expm(A * length) @ state
        else:
            A = np.zeros((7, 7))
            A[0, 1], A[0, 3], A[1, 2], A[2, 3], A[3, 6] = 1, 1 / S, -1 / D, 1, -q
            A[4, 5], A[5, 4] = (1 / k1 if k1 else 0.0), k0 * (k1 > 0)
            pull = np.zeros(state.shape[1])
            pull[number] = 1.0
            number += 1
            inner = expm(A * length) @ np.vstack([state[:3], state[3] - pull, state[0], pull, state[4]])
            # without shear the ground has no line force; with it the surface comes back to the beam
            equations.append(inner[4] - inner[0] if k1 else pull)
            state = np.vstack([inner[:3], inner[3] + inner[5], inner[6]])
        ends.append(state[0])
    rows = np.array([state[2], state[3], *equations])
    unknown = np.linalg.solve(rows[:, :-1], -rows[:, -1])
    return [float(end[:-1] @ unknown + end[-1]) for end in ends]


def strip(mesh: dict[str, Any], ground: dict[str, Any], **parts: Any) -> CombinationResult:
    """Return the results of the plate 6 x 4 m as a strip: nu = 0, loads alike along y."""
    plate = {"length_x": 6.0, "length_y": 4.0, "thickness": T, "E": E, "nu": 0.0, "shear_factor": FACTOR}
    loads = parts.pop("loads", [{"kind": "uniform", "q": 20e3}])
    return solve(Model(plate=plate, ground=ground, loads=loads, mesh=mesh, **parts))


def at(results: CombinationResult, x: float) -> float:
    """Return the settlement at (x, 0)."""
    return results.plate.value_at("settlement", float(x), 0.0)


def plate(mesh: dict[str, Any], **parts: Any) -> Model:
    """Return the plate 6 x 4 m x 0.25 m on springs of 20 MPa/m."""
    sheet = {"length_x": 6.0, "length_y": 4.0, "thickness": T, "E": E, "nu": 0.2}
    parts.setdefault("loads", [{"kind": "uniform", "q": 20e3}])
    return Model(plate=sheet, ground={"kind": "winkler", "k": 20e6}, mesh=mesh, **parts)


def zone(x: tuple[float, float], y: tuple[float, float], k: float) -> dict[str, Any]:
    """Return a rectangle of other springs."""
    return {"shape": {"kind": "rectangle", "x": x, "y": y}, "ground": {"kind": "winkler", "k": k}}


VOID_LOADS = [{"kind": "uniform", "q": 20e3}, {"kind": "patch", "q": 100e3, "x": (0.0, 1.0), "y": (-0.5, 0.5)}]


@pytest.mark.slow
@pytest.mark.parametrize("size", [0.5, 0.25, 0.125])
def test_a_zone_between_grid_lines_has_the_settlement_of_another_program(size: float) -> None:
    """3.68753 mm, by hp finite elements: the border at x = 1.07 m is a line of the mesh at every size."""
    results = solve(plate({"size": size}, soil_zones=[zone((1.07, 3.0), (-2.0, 2.0), 5e6)]))
    assert results.plate.settlement.max() == pytest.approx(3.68753e-3, rel=3e-5)
    assert np.isclose(results.plate.nodes[:, 0], 1.07).any()


@pytest.mark.slow
def test_a_void_has_the_settlement_of_another_program() -> None:
    """1.7449 mm, by hp finite elements: a void is no wider than it is drawn."""
    void = {"x": (1.0, 2.0), "y": (-1.0, 1.0)}
    for size, near in ((0.5, 2e-3), (0.25, 1e-4), (0.125, 5e-5)):
        results = solve(plate({"size": size}, contact={"voids": [void]}, loads=VOID_LOADS))
        assert results.plate.settlement.max() == pytest.approx(1.7449e-3, rel=near)


@pytest.mark.slow
@pytest.mark.parametrize("border", [1.07, 1.0])
def test_settlements_beside_a_zone_converge_as_those_of_the_plate(border: float) -> None:
    """Halving the elements of a strip over two zones takes off at least as much error as of one over one."""
    exact = beam([(3 + border, 20e6, 0.0, 20e3, False), (3 - border, 5e6, 0.0, 20e3, False)])
    errors = []
    for size in (1.0, 0.5, 0.25):
        found = strip(
            {"size": size}, {"kind": "winkler", "k": 20e6}, soil_zones=[zone((border, 3.0), (-2.0, 2.0), 5e6)]
        )
        errors.append(np.abs([at(found, x) - w for x, w in zip((-3.0, border, 3.0), exact, strict=True)]).max())
    assert errors[0] < 1e-3 * exact[2]
    assert errors[1] < errors[0] / 6
    assert errors[2] < errors[1] / 6


@pytest.mark.slow
@pytest.mark.parametrize("k1", [0.0, 10e6])
@pytest.mark.parametrize("edges", [(-0.93, 0.57), (-1.0, 0.5)])
def test_settlements_over_a_cavity_converge_as_those_of_the_plate(edges: tuple[float, float], k1: float) -> None:
    """A strip over a cavity, with and without shear in the ground: the cavity is as wide as drawn on every mesh."""
    low, high = edges
    ground = (20e6, k1, 60e3)
    exact = beam([(3 + low, *ground, False), (high - low, *ground, True), (3 - high, *ground, False)])
    described = {"kind": "pasternak", "k0": 20e6, "k1": k1}
    errors = []
    for size in (1.0, 0.5, 0.25):
        void = {"x": edges, "y": (-2.0, 2.0)}
        found = strip({"size": size}, described, contact={"voids": [void]}, loads=[{"kind": "uniform", "q": 60e3}])
        errors.append(np.abs([at(found, x) - w for x, w in zip((-3, low, high, 3), exact, strict=True)]).max())
        assert found.plate.in_contact[(found.plate.nodes[:, 0] < low - 1e-6)].all()
    assert errors[0] < 5e-3 * max(exact)
    assert errors[1] < errors[0] / 5
    # the plate pulls at ground with shear along its free ends: below a millionth this decides
    assert errors[2] < max(errors[1] / 5, 1e-6 * max(exact))


@pytest.mark.slow
def test_a_stiff_pier_under_a_column_is_seen_by_large_elements() -> None:
    """A pier of 0.4 x 0.4 m off the lines of elements of 0.5 m: as on a grid of 0.1 m on whose lines it lies."""
    parts: dict[str, Any] = {
        "soil_zones": [zone((0.1, 0.5), (0.1, 0.5), 2e9)],
        "loads": [
            {"kind": "uniform", "q": 5e3},
            {"kind": "point", "P": 400e3, "x": 0.3, "y": 0.3, "width_x": 0.4, "width_y": 0.4},
        ],
    }
    fine = solve(plate({"counts": (60, 40)}, **parts)).plate.value_at("settlement", 0.3, 0.3)
    coarse = solve(plate({"size": 0.5}, **parts)).plate.value_at("settlement", 0.3, 0.3)
    without = solve(plate({"size": 0.5}, loads=parts["loads"])).plate.value_at("settlement", 0.3, 0.3)
    assert coarse == pytest.approx(fine, rel=0.01)
    assert without > 1.3 * fine


@pytest.mark.parametrize("mesh", [{"size": 0.5}, {"counts": (12, 8)}, {"counts": (11, 7)}])
def test_a_rigid_plate_rests_on_the_bottom_of_a_void(mesh: dict[str, Any]) -> None:
    """A void of depth d under half a rigid plate, pressed to its bottom: w = q / k + d / 2 + 1.5 d x / L.

    Force and moment of k w on one half and k (w - d) on the other balance the load; a grid may cross the border.
    """
    q, k, d, L = 1e3, 1e5, 2e-3, 6.0
    stiff = {"length_x": L, "length_y": 4.0, "thickness": 2.0, "E": 1e12, "nu": 0.2}
    void = {"x": (0.0, 3.0), "y": (-2.0, 2.0), "depth": d}
    loads = [{"kind": "uniform", "q": q}]
    results = solve(
        Model(plate=stiff, ground={"kind": "winkler", "k": k}, contact={"voids": [void]}, loads=loads, mesh=mesh)
    )
    x = results.plate.nodes[:, 0]
    met = mesh != {"counts": (11, 7)}
    np.testing.assert_allclose(results.plate.settlement, q / k + d / 2 + 1.5 * d * x / L, rtol=1e-5 if met else 3e-3)
    assert results.plate.in_contact.all()
    pressure = k * (results.plate.settlement - np.where(x > 1e-9, d, 0.0))
    off = np.abs(x) > 0.6
    np.testing.assert_allclose(results.plate.pressure[off], pressure[off], rtol=1e-3)
    assert results.plate.pressure @ results.plate.area == pytest.approx(24 * q, rel=1e-7)
    assert results.plate.contact_area.sum() == pytest.approx(24.0, rel=1e-12)


def test_the_pressure_of_springs_is_k_w_on_both_sides_of_a_border() -> None:
    """Beside a column, where the mesh is refined along a border of springs of 20 and 60 MPa/m, p / w is one of both.

    Nodes on the border stand for one side each, and all together carry the load.
    """
    model = Model(
        plate={"length_x": 10.0, "length_y": 8.0, "thickness": 0.5, "E": 33e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 20e6},
        soil_zones=[{"shape": {"kind": "rectangle", "x": (0.05, 40.0), "y": (-40.0, 40.0)},
                     "ground": {"kind": "winkler", "k": 60e6}}],
        loads=[{"kind": "self weight", "unit_weight": 25e3},
               {"kind": "point", "P": 1.5e6, "x": 0.0, "y": 0.0, "width_x": 0.4, "width_y": 0.4}],
        mesh={"accuracy": 0.05},
    )  # fmt: skip
    results = solve(model).only
    plate = results.plate
    x, touches = plate.nodes[:, 0], plate.pressure > 0
    k = plate.pressure[touches] / plate.settlement[touches]
    border = np.abs(x[touches] - 0.05) < 1e-6
    assert border.sum() > 50
    expected = np.where(border, np.where(k > 40e6, 60e6, 20e6), np.where(x[touches] > 0.05, 60e6, 20e6))
    assert k == pytest.approx(expected, rel=1e-3)
    assert plate.pressure @ plate.area == pytest.approx(80 * 0.5 * 25e3 + 1.5e6, rel=1e-9)
