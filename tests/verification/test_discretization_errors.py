"""Estimated discretization errors against true ones: those to the same slab on elements a third as large."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import groundslab
from groundslab.accuracy.energy import energy_errors
from groundslab.accuracy.values import estimate_error
from groundslab.analysis import nested
from groundslab.analysis.mesh_hierarchy import MeshHierarchy
from groundslab.arrays import Array
from groundslab.fem import plate
from groundslab.fem.mesh import locate
from groundslab.fem.problem import plate_unknowns
from groundslab.fem.shape_functions import determinants, gauss, q9
from groundslab.model.combinations import case_factors, list_combinations
from groundslab.model.model import Model
from groundslab.results.mirroring import make_result_mesh
from groundslab.results.recovery import own_forces, recover_fields
from groundslab.results.results import CombinationResult
from groundslab.solvers import factorization
from groundslab.solvers.solution import Solution

SIDES = (12.0, 8.0)
PATCH = {"kind": "patch", "x": (-1.0, 2.0), "y": (-1.0, 1.0), "q": 1e5}
VLASOV = {"kind": "vlasov", "layers": [{"E": 20e6, "nu": 0.3, "thickness": 5.0}]}
#: Thin and thick, glued and tensionless, on each kind of ground.
CASES: dict[str, dict[str, Any]] = {
    "winkler": {},
    "thin": {"t": 0.05},
    "thick": {"t": 1.2},
    "tensionless": {"tensionless": True},
    "pasternak": {"ground": {"kind": "pasternak", "k0": 20e6, "k1": 20e6}},
    "vlasov, tensionless": {"ground": VLASOV, "tensionless": True},
}
#: A slab with a cut corner, which no grid can mesh.
CUT = {"kind": "polygon", "points": [(-6.0, -4.0), (6.0, -4.0), (6.0, 1.0), (3.0, 4.0), (-6.0, 4.0)]}
UNSTRUCTURED = {f"{name}, unstructured": {**CASES[name], "outline": CUT} for name in ("winkler", "vlasov, tensionless")}


def slab(
    counts: int,
    t: float = 0.3,
    tensionless: bool = False,
    ground: dict[str, Any] | None = None,
    outline: dict[str, Any] | None = None,
) -> Model:
    """Return a slab under a patch, with so many elements to four meters."""
    sides = {"length_x": SIDES[0], "length_y": SIDES[1]} if outline is None else {"outline": outline}
    return Model(
        plate={**sides, "thickness": t, "E": 30e9, "nu": 0.2},
        ground=ground or {"kind": "winkler", "k": 20e6},
        contact={"tensionless": tensionless},
        loads=[PATCH],
        mesh={"symmetry": "off"} | ({"counts": (3 * counts, 2 * counts)} if outline is None else {"size": 4 / counts}),
    )


def solution_of(model: Model) -> Solution:
    """Return the solution on the finest mesh."""
    hierarchy = MeshHierarchy(model, factorization.choose("auto")[1], 0, 1.0, False)
    (combination,) = list_combinations(model)
    found = nested.solve_nested(hierarchy, combination.name, case_factors(model, combination), lambda _: None)
    return found[0][-1]


def true_energy_error(coarse: Solution, fine: Solution, forces: Array) -> float:
    """Return the energy norm of the plate's error, from forces (m, 4, 5) at the Gauss points of a much finer mesh."""
    p, f = coarse.system.problem, fine.system.problem
    points, weights = gauss(2)
    xy = f.mesh.nodes[f.mesh.elements[f.plate.elements]]
    N, dN = q9(points)
    at = (N @ xy).reshape(-1, 2)
    dA = (determinants(dN, xy) * weights).ravel()
    element, place = locate(p.mesh, at)
    D, S = p.plate.bending[0], p.plate.shear[0]
    u = plate_unknowns(p, coarse.U)
    error = np.empty((len(at), 5))
    for number in np.unique(element):
        own = np.flatnonzero(element == number)
        nodes = p.mesh.xy[[number]]
        raw = plate.section_forces(p.plate.element, place[own], nodes, D[None], np.array([S]), u[[number]])[0]
        error[own] = forces.reshape(-1, 5)[own] - raw
    squares = np.einsum("pi,ij,pj->p", error[:, :3], np.linalg.inv(D), error[:, :3])
    return float(np.sqrt((dA * (squares + (error[:, 3:] ** 2).sum(axis=1) / S)).sum()))


@pytest.mark.slow
@pytest.mark.parametrize("case", [*CASES, *UNSTRUCTURED])
def test_energy(case: str) -> None:
    """The estimated error in the energy norm is 0.7 to 1.5 times the true one, on grids and on meshes that are none."""
    given = (CASES | UNSTRUCTURED)[case]
    model, reference = slab(4, **given), slab(12, **given)
    coarse, fine = solution_of(model), solution_of(reference)
    frame = make_result_mesh(model, coarse.system.problem)
    estimate = np.sqrt(energy_errors(model, coarse, recover_fields(coarse, frame)).sum())
    true = true_energy_error(coarse, fine, own_forces(fine.system.problem, fine.U, gauss(2)[0]))
    assert 0.7 < estimate / true < 1.5


def values(results: CombinationResult) -> dict[str, float]:
    """Return figures of a result."""
    p = results.plate
    return {
        "largest settlement": float(p.settlement.max()),
        "settlement of a corner": float(p.value_at("settlement", *(side / 2 for side in SIDES))),
        "largest moment": float(p.moment_x.max()),
        "smallest moment": float(p.moment_y.min()),
        "largest shear force": float(p.shear_x.max()),
        "largest pressure": float(p.pressure.max()),
        "area in contact": p.contact_share,
    }


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_values(case: str) -> None:
    """Where a value is off by more than 3 %, its estimate is not below half of that."""
    results = groundslab.solve(slab(8, **CASES[case])).only
    reference = values(groundslab.solve(slab(24, **CASES[case])).only)
    assert results.comparison is not None
    assert results.coarser is not None
    coarser = values(results.coarser)
    for name, value in values(results).items():
        true = abs(value - reference[name])
        if true > 0.03 * abs(value):
            assert estimate_error(value, coarser[name], results.comparison) > true / 2, name


@pytest.mark.parametrize("t", [pytest.param(0.3, marks=pytest.mark.slow), 0.8])
def test_means_where_moments_are_singular(t: float) -> None:
    """A force without a footprint gives the moment and shear forces of one that has spread over a thickness' width."""
    force = {"kind": "point", "P": 1e6, "x": 0.5, "y": 0.3}
    found = list[Array]()
    for footprint in ({}, {"diameter": t}):
        model = Model(
            plate={"length_x": 4.0, "length_y": 4.0, "thickness": t, "E": 30e9, "nu": 0.2},
            ground={"kind": "winkler", "k": 3e7},
            loads=[force | footprint],
            mesh={"size": t / 4},
        )
        plate = groundslab.solve(model).only.plate
        beside = plate.value_at("moment_xy", 0.5 + t / 2, 0.3 + t / 2), plate.value_at("shear_x", 0.5 + t / 2, 0.3)
        found.append(np.array([plate.moment_x.max(), plate.moment_y.max(), *beside]))
    # the shear force has a kink there, which elements of a quarter of the thickness round off
    np.testing.assert_array_less(np.abs(found[0] / found[1] - 1), [0.01, 0.01, 0.02, 0.06])
