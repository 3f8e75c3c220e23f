"""Hanging nodes: what they take from the sides on which they hang, and equations that know nothing of them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab.analysis.driver import solve
from groundslab.arrays import Array, Integers
from groundslab.discretize.discretize import discretize
from groundslab.discretize.plan.local_sizes import local_sizes
from groundslab.discretize.plan_layout import Meshes
from groundslab.fem.hanging import carry, collect, connect, find_halves, find_hanging
from groundslab.fem.mesh import Mesh, grid, sides_on_boundary
from groundslab.fem.plate import ELEMENTS
from groundslab.fem.problem import BETA_X, BETA_Y, TOP, Problem, W
from groundslab.fem.shape_functions import gauss
from groundslab.fem.system import build_system, nodal_table, stiffness, surface_fields
from groundslab.meshing.refinement import close, halve, split
from groundslab.model.model import Model
from groundslab.results.balance.forces import ground_forces, plate_forces

NOWHERE = np.zeros(0, dtype=np.int64)
#: Elements of 0.25 m in the middle and at a corner of a plate whose others have 1 m.
REFINED = [
    {"shape": {"kind": "rectangle", "x": (-0.5, 0.5), "y": (-0.4, 0.4)}, "size": 0.25},
    {"shape": {"kind": "rectangle", "x": (3.0, 4.0), "y": (2.0, 3.0)}, "size": 0.25},
]
PLATE = {"length_x": 8.0, "length_y": 6.0, "thickness": 0.3, "E": 30e9, "nu": 0.2}
SPRINGS = {"kind": "winkler", "k": 20e6}
LAYERS = [{"E": 20e6, "nu": 0.3, "thickness": 4.0}]
LOADS = [
    {"kind": "uniform", "q": 5e3},
    {"kind": "point", "P": 4e5, "x": 0.0, "y": 0.0, "width_x": 0.5, "width_y": 0.5},
    {"kind": "point", "P": 2e5, "x": 3.5, "y": 2.5, "width_x": 0.5, "width_y": 0.5},
]


def model_of(**changes: Any) -> Model:
    """Return a plate with small elements in two places."""
    data = {"plate": PLATE, "ground": SPRINGS, "loads": LOADS, "mesh": {"size": 1.0, "refine": REFINED}}
    return Model.model_validate(data | changes)


def discretize_finely(model: Model) -> Problem:
    """Return the problem on a mesh that is smaller where the model wants it."""
    problem = discretize(model, meshes=Meshes(local=local_sizes(model)))
    assert len(find_hanging(problem.mesh.elements))
    return problem


def cut_around(*places: tuple[float, float]) -> Mesh:
    """Return a grid whose elements were cut around places, one after the other."""
    mesh = grid(np.linspace(0, 4, 5), np.linspace(0, 3, 4))
    for place in places:
        marked = np.zeros(len(mesh.elements), dtype=bool)
        marked[np.argmin(np.linalg.norm(mesh.xy[:, 8] - place, axis=1))] = True
        mesh, _ = split(mesh, close(mesh, marked, NOWHERE))
    return mesh


def quadratic(xy: Array) -> Array:
    """Return a quadratic function of places (n, 2)."""
    x, y = xy.T
    return 1 + 2 * x - y + x**2 + 3 * x * y - 2 * y**2


def test_one_element_is_cut() -> None:
    """Its middles of sides become corners; eight nodes hang around it, and the plate's edge stays what it was."""
    mesh = cut_around((1.5, 1.5))
    assert len(mesh.elements) == 15
    assert len(mesh.nodes) == 63 + 16
    hanging = find_hanging(mesh.elements)
    assert len(hanging) == 8
    assert len(sides_on_boundary(mesh.elements)) == 14
    np.testing.assert_allclose(mesh.nodes[hanging[:, 1:3]].mean(axis=1), mesh.nodes[hanging[:, 0]])
    np.testing.assert_allclose(mesh.nodes[hanging[:, [1, 3]]].mean(axis=1), mesh.nodes[hanging[:, 2]])


def test_larger_neighbors_are_cut_with_an_element() -> None:
    """No side has more than one hanging node to a half, and no corner hangs."""
    mesh = cut_around((1.5, 1.5), (1.4, 1.4), (1.1, 1.1), (2.6, 1.4))
    hanging = find_hanging(mesh.elements)
    assert not np.isin(hanging[:, 0], mesh.elements[:, :4]).any()
    assert not np.isin(hanging[:, 1:], hanging[:, 0]).any()
    assert len(np.unique(mesh.nodes.round(9), axis=0)) == len(mesh.nodes)
    sides = np.linalg.norm(mesh.xy[:, 1] - mesh.xy[:, 0], axis=1)
    assert sides.min() == pytest.approx(1 / 8)
    halved = halve(mesh)
    assert len(find_hanging(halved.elements)) == 2 * len(hanging)
    assert len(np.unique(halved.nodes.round(9), axis=0)) == len(halved.nodes)


def test_sides_that_must_stay_whole() -> None:
    """Across them the neighbor is cut, too."""
    mesh = grid(np.linspace(0, 4, 5), np.linspace(0, 3, 4))
    marked = np.zeros(len(mesh.elements), dtype=bool)
    marked[5] = True
    assert close(mesh, marked, NOWHERE).sum() == 1
    found = close(mesh, marked, mesh.elements[[5], 5])
    assert np.flatnonzero(found).tolist() == [5, 6]


def test_quadratic_functions_are_carried_and_their_work_is_kept() -> None:
    """What nodes of an element are moved by is the function itself; forces have the same resultant and moments."""
    mesh = cut_around((1.5, 1.5), (1.4, 1.4), (2.6, 1.4))
    hanging = find_hanging(mesh.elements)[:, 0]
    exact = quadratic(mesh.nodes)
    lost = exact.copy()
    lost[hanging] = np.nan
    np.testing.assert_allclose(carry(mesh.elements, lost), exact, rtol=1e-12)
    moving, kind, P, _ = connect(mesh.elements)
    np.testing.assert_allclose(np.einsum("eab,eb->ea", P[kind], lost[moving]), exact[mesh.elements], rtol=1e-12)
    forces = np.random.default_rng(2).normal(size=(len(mesh.nodes), 3))
    collected = collect(mesh.elements, forces)
    assert not collected[hanging].any()
    np.testing.assert_allclose(exact @ collected, exact @ forces, rtol=1e-12)


@pytest.mark.parametrize("t", [2.0, 0.3, 8e-4])
@pytest.mark.parametrize("element", ["mitc9", "heterosis", "q9"])
def test_constant_curvature_across_hanging_sides(element: str, t: float) -> None:
    """With w = x^2 + 3 x y - 2 y^2 and rotations that are its slopes no force is left at nodes inside the plate."""
    s = build_system(discretize_finely(model_of(plate=PLATE | {"element": element, "thickness": t})))
    mesh = s.problem.mesh
    x, y = mesh.nodes.T
    U = np.zeros((len(mesh.nodes), TOP + 1))
    U[:, W], U[:, BETA_X], U[:, BETA_Y] = x**2 + 3 * x * y - 2 * y**2, 2 * x + 3 * y, 3 * x - 4 * y
    sizes = s.problem.nodal_sizes(plate_forces(s, U))
    inside = np.ones(len(mesh.nodes), dtype=bool)
    inside[sides_on_boundary(mesh.elements)] = False
    # shear rigidity times what cancels is rounding
    assert sizes[inside].max() < (1e-9 if t > 0.1 else 1e-5) * sizes.max()


def test_a_cubic_deflection_across_hanging_sides_has_no_shear_strain() -> None:
    """With w a cubic along the sides and its slopes as rotations MITC9 ties no shear, not on halves of sides either.

    A side's own w is a parabola through its three nodes: only with its rotations it tells the cubic.
    """
    mesh = cut_around((1.5, 1.5), (1.4, 1.4), (2.6, 1.4))
    x, y = mesh.nodes.T
    w, beta_x, beta_y = x**3 - 2 * y**3 + x * y, 3 * x**2 + y, -6 * y**2 + x
    u = np.concatenate([carry(mesh.elements, each)[mesh.elements] for each in (w, beta_x, beta_y)], axis=1)
    halves = find_halves(mesh.elements)
    assert set(halves.ravel()) == {-1, 0, 1}

    def strain(halves: Integers | None) -> Array:
        element, (points, _) = ELEMENTS["mitc9"], gauss(3)
        of_matrices = element.covariant_shear(points, mesh.xy, element.w_functions(mesh.xy), halves)
        found = element.covariant_strain(points, mesh.xy, u, halves)
        np.testing.assert_allclose(np.einsum("eipu,eu->epi", of_matrices, u), found, atol=1e-12)
        return np.abs(found)

    assert strain(halves).max() < 1e-12
    assert strain(None).max() > 0.1


@pytest.mark.parametrize("changes", [
    {},
    {"ground": {"kind": "vlasov", "gamma": 1.5, "layers": LAYERS}, "beyond": {"kind": "infinite"}},
    {"ground": {"kind": "pasternak", "k0": 2e7, "k1": 1e7}, "beyond": {"kind": "margin", "width": 2.0},
     "contact": {"tensionless": False}},
    {"ground": {"kind": "vlasov", "gamma": 1.5, "layers": LAYERS}, "boreholes": [
        {"name": "A", "x": -3.0, "y": 0.0, "layers": LAYERS},
        {"name": "B", "x": 3.0, "y": 1.0, "layers": [LAYERS[0] | {"E": 6e7}]}]},
], ids=["springs", "infinite", "margin", "boreholes"])  # fmt: skip
def test_matrix_and_forces_of_elements_agree(changes: dict[str, Any]) -> None:
    """The matrix of unknowns times any of them is what elements resist with, collected where nodes hang."""
    problem = discretize_finely(model_of(**changes))
    s, ground = build_system(problem), problem.ground
    column = ground.column(1.5) if hasattr(ground, "column") else ground
    u = np.random.default_rng(3).normal(size=s.pattern.size)
    U = nodal_table(problem, u)
    forces, resisting = ground_forces(s, U, column), np.zeros_like(U)
    resisting[:, :TOP] = plate_forces(s, U)
    for surface in range(column.surfaces):
        for field in surface_fields(surface):
            resisting[:, field] += forces[:, 0] if field == W else forces[:, 1 + surface]
    has = problem.unknown >= 0
    expected = np.zeros(s.pattern.size)
    np.add.at(expected, problem.unknown[has], resisting[has])
    found = stiffness(s, column) @ u
    assert np.abs(found - expected).max() < 1e-12 * np.abs(expected).max()


@pytest.mark.parametrize("changes", [
    {},
    {"loads": [LOADS[0] | {"q": 500.0}, *LOADS[1:]]},
    {"loads": LOADS[:2], "mesh": {"size": 1.0, "refine": REFINED[:1]}},
    {"ground": {"kind": "continuum", "layers": LAYERS, "cell": 0.25}},
    {"ground": {"kind": "vlasov", "layers": LAYERS}, "beyond": {"kind": "infinite"}},
    {"supports": [{"kind": "line", "points": [(-4.0, -1.0), (4.0, -1.0)]}]},
    {"contact": {"voids": [{"x": (-1.0, 0.2), "y": (-1.0, 0.3), "depth": 1e-3}]}},
], ids=["contact", "lifts", "quarter", "continuum", "infinite", "support", "void"])  # fmt: skip
def test_results_are_those_of_small_elements_everywhere(changes: dict[str, Any]) -> None:
    """Certified, the contact force is the load, nothing pulls, and values under the load differ by little."""
    found = solve(model_of(**changes)).only
    assert len(find_hanging(found.plate.elements))
    assert found.certificate.holds
    fine = solve(model_of(**changes | {"mesh": {"size": 0.25}})).only
    assert found.unknowns < 0.8 * fine.unknowns
    assert found.plate.pressure.min() >= 0.0
    force = found.plate.contact_force.sum() + sum(support.total for support in found.supports)
    assert force == pytest.approx(fine.plate.contact_force.sum() + sum(each.total for each in fine.supports), rel=1e-3)
    assert found.plate.settlement.max() == pytest.approx(fine.plate.settlement.max(), rel=2e-3)
    for name in ("moment_x", "moment_y"):
        assert getattr(found.plate, name).max() == pytest.approx(getattr(fine.plate, name).max(), rel=0.02)
