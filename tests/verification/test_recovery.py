"""Moments and shear forces at nodes: one order more than the elements' own at their corners, none across a border.

Three kinds of truth: smooth fields put on the nodes; one term of Navier's series, whose plate answers with one sine
wave, solved with nothing but the element matrices; and a plate on Pasternak ground through all of the package.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from groundslab.analysis.driver import solve
from groundslab.discretize.discretize import discretize
from groundslab.fem import plate
from groundslab.fem.mesh import sides_on_boundary
from groundslab.fem.problem import BETA_X, BETA_Y, W
from groundslab.fem.shape_functions import gauss, q9
from groundslab.model.ground import Pasternak, Winkler
from groundslab.model.loads.load_types import UniformLoad
from groundslab.model.model import Model
from groundslab.model.plate import Edges, Plate, Zone
from groundslab.model.settings import Contact, Mesh
from groundslab.model.shapes import Polygon
from groundslab.results import patch_recovery, recovery
from groundslab.results.mirroring import make_result_mesh
from groundslab.verification import analytic
from helpers import quads

E, NU, T, FACTOR = 1.0, 0.3, 0.2, 5 / 6
D, S = plate.bending_rigidity(E, NU, T), plate.shear_rigidity(E, NU, T, FACTOR)
CORNERS = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
LENGTHS = (2.0, 1.5)
ELEMENTS = list(plate.ELEMENTS)
MOMENTS, SHEARS = slice(0, 3), slice(3, 5)


def smooth(x: Any, y: Any) -> tuple[Any, ...]:
    """Return w, beta_x, beta_y and (m_x, m_y, m_xy, q_x, q_y) of a smooth field that solves no plate's equations."""
    w = np.sin(1.3 * x + 0.4) * np.exp(0.7 * y) + 0.3 * x * y
    w_x, w_y = 1.3 * np.cos(1.3 * x + 0.4) * np.exp(0.7 * y) + 0.3 * y, 0.7 * (w - 0.3 * x * y) + 0.3 * x
    bx, by = np.cos(1.1 * x + 0.3) * np.cos(0.9 * y - 0.2), np.sin(0.8 * x) * np.sin(1.2 * y + 0.5)
    kappa_x = -1.1 * np.sin(1.1 * x + 0.3) * np.cos(0.9 * y - 0.2)
    kappa_y = 1.2 * np.sin(0.8 * x) * np.cos(1.2 * y + 0.5)
    twist = -0.9 * np.cos(1.1 * x + 0.3) * np.sin(0.9 * y - 0.2) + 0.8 * np.cos(0.8 * x) * np.sin(1.2 * y + 0.5)
    M = -np.stack([kappa_x, kappa_y, twist], axis=-1) @ D
    return w, bx, by, np.concatenate([M, S * np.stack([w_x - bx, w_y - by], axis=-1)], axis=-1)


def sine(x: Any, y: Any) -> tuple[Any, ...]:
    """Return the same of a plate simply supported on all sides (hard) under one term of Navier's series, q = q0 s s.

    w = A s s with A = q0 (1 + D l2 / S) / D l2^2, and beta = grad w / (1 + D l2 / S): `exact.navier` has the sum of
    such terms.
    """
    a, b = np.pi / np.array(LENGTHS)
    l2, D0 = a * a + b * b, D[0, 0]
    bent = 1 + D0 * l2 / S
    A = bent / (D0 * l2**2)
    sa, ca, sb, cb = np.sin(a * x), np.cos(a * x), np.sin(b * y), np.cos(b * y)
    w, w_x, w_y = A * sa * sb, A * a * ca * sb, A * b * sa * cb
    M = D0 * A / bent * np.stack([(a * a + NU * b * b) * sa * sb, (b * b + NU * a * a) * sa * sb], axis=-1)
    twist = -(1 - NU) * D0 * A / bent * a * b * ca * cb
    Q = S * (1 - 1 / bent) * np.stack([w_x, w_y], axis=-1)
    return w, w_x / bent, w_y / bent, np.concatenate([M, twist[..., None], Q], axis=-1)


def solved(name: str, nodes: np.ndarray, elements: np.ndarray) -> np.ndarray:
    """Return the unknowns (3 n,) of the plate under one sine wave, by the elements themselves."""
    n, (x, y) = len(nodes), nodes.T
    A = quads.assemble(quads.stiffness(name, nodes[elements], T, E, NU), elements, n)
    a, b = np.pi / np.array(LENGTHS)
    f = quads.load(name, nodes[elements], elements, n, lambda X, Y: np.sin(a * X) * np.sin(b * Y))
    across, along = (np.isclose(x, 0) | np.isclose(x, LENGTHS[0])), (np.isclose(y, 0) | np.isclose(y, LENGTHS[1]))
    held = np.concatenate([across | along, along, across]) | quads.centres(name, elements, n)
    return np.asarray(quads.solve(A, f, held, np.zeros(3 * n)))


@cache
def errors(name: str, solve_it: bool, n: int, amount: float = 0.0, split: int = 1) -> dict[str, np.ndarray]:
    """Return the largest errors (2,) of moments and shear forces, over their largest values, by kind of node.

    `raw` and `extrapolated`: the element's own at its corners, straight and from its Gauss points; `inside`, `edge`:
    recovered, at corner nodes; `between`: recovered, at midside nodes and centres.
    """
    nodes, elements = quads.mesh(n, n, *LENGTHS, amount=amount, split=split)
    xy = nodes[elements]
    w, bx, by, wanted = (sine if solve_it else smooth)(*nodes.T)
    u = solved(name, nodes, elements) if solve_it else np.concatenate([w, bx, by])
    ue = u.reshape(3, -1)[:, elements].swapaxes(0, 1).reshape(len(elements), 27)

    def own(points: np.ndarray) -> np.ndarray:
        Ds, Ss = np.broadcast_to(D, (len(xy), 3, 3)), np.full(len(xy), S)
        return plate.section_forces(plate.ELEMENTS[name], points, xy, Ds, Ss, ue)

    points = gauss(2)[0]
    at_gauss = own(points)
    at_nodes = patch_recovery.recover_nodes(
        patch_recovery.make_patches(nodes, elements, q9(points)[0] @ xy), at_gauss, recovery.SIZES
    )
    edge, corner = np.zeros(len(nodes), dtype=bool), np.zeros(len(nodes), dtype=bool)
    edge[sides_on_boundary(elements)] = True
    corner[elements[:, :4]] = True
    extrapolated = (patch_recovery.extrapolation() @ at_gauss)[:, :4]
    found = {
        "raw": (own(CORNERS) - wanted[elements[:, :4]]).reshape(-1, 5),
        "extrapolated": (extrapolated - wanted[elements[:, :4]]).reshape(-1, 5),
        "inside": (at_nodes - wanted)[corner & ~edge],
        "edge": (at_nodes - wanted)[corner & edge],
        "between": (at_nodes - wanted)[~corner],
    }
    off = {kind: np.abs(e / np.abs(wanted).max(axis=0)).max(axis=0) for kind, e in found.items()}
    return {kind: np.array([e[MOMENTS].max(), e[SHEARS].max()]) for kind, e in off.items()}


def orders(coarse: dict[str, np.ndarray], fine: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Return the orders (2,) of moments and shear forces observed between a mesh and one twice as fine."""
    return {kind: np.log2(coarse[kind] / fine[kind]) for kind in coarse}


@pytest.mark.slow
@pytest.mark.parametrize("solve_it", [False, True], ids=["on the nodes", "solved"])
@pytest.mark.parametrize("name", ELEMENTS)
def test_one_order_more_at_nodes_on_rectangles(name: str, solve_it: bool) -> None:
    """At corners the elements' own moments and shear forces are of order 2; recovered ones of 3, on edges too."""
    order = orders(errors(name, solve_it, 12), errors(name, solve_it, 24))
    for kind in ("raw", "extrapolated"):
        assert (order[kind] > 1.6).all(), kind
        assert (order[kind] < 2.4).all(), kind
    for kind in ("inside", "edge", "between"):
        assert (order[kind] > 2.75).all(), kind


@pytest.mark.parametrize("name", ELEMENTS)
def test_recovered_values_are_the_better_ones(name: str) -> None:
    """On 24 x 24 elements, recovery leaves less than a seventh of the error."""
    error = errors(name, True, 24)
    for kind in ("inside", "edge", "between"):
        assert (error[kind] < error["raw"] / 7).all(), kind


@pytest.mark.slow
@pytest.mark.parametrize("name", ELEMENTS)
def test_distorted_meshes_that_are_halved(name: str) -> None:
    """Distorted elements cut into halves again and again, so that they come closer and closer to parallelograms.

    With q9 and heterosis nearly a whole order more; the moments of mitc9 inside gain less of one here, but recovered
    values have less than a third of the error all the same.
    """
    coarse, fine = errors(name, True, 4, 0.2, 4), errors(name, True, 4, 0.2, 8)
    order = orders(coarse, fine)
    for kind in ("inside", "edge", "between"):
        assert (order[kind] > (1.9 if name == "mitc9" else 2.6)).all(), kind
        assert (fine[kind] < fine["raw"] / 2).all(), kind
    assert (fine["inside"] < fine["raw"] / 3).all()


@pytest.mark.slow
@pytest.mark.parametrize("name", ELEMENTS)
def test_meshes_that_stay_distorted(name: str) -> None:
    """Elements as distorted on every mesh have no superconvergent points; the errors are smaller all the same."""
    for n in (8, 16, 32):
        error = errors(name, True, n, 0.2)
        assert (error["inside"] < error["raw"] / 3).all()
        assert (error["between"] < error["raw"]).all()
        assert (error["edge"] < error["raw"]).all()


PLACES = [(0.0, 0.0), (0.0, 0.75), (1.0, 0.0), (1.0, 0.75), (2.0, 0.75), (2.0, 0.0), (0.0, 1.5)]


def test_third_order_through_the_package_on_pasternak_ground() -> None:
    """A hinged plate of 4 x 3 m on Pasternak ground, a quarter computed: m_x against Navier's series, order 3 at least.

    Inside, on both lines of symmetry and where they cross, where m_x is even, and on two edges, where it vanishes.
    """
    whole = {"a": 4.0, "b": 3.0, "t": 0.3, "E": 30e9, "nu": 0.2, "factor": FACTOR, "q": 1e5, "k0": 20e6, "k1": 10e6}
    wanted = np.array([analytic.navier(x, y, **whole)["moment_x"] for x, y in PLACES])
    hinged = Edges(left="hinged", right="hinged", bottom="hinged", top="hinged")
    off = []
    for n in (16, 32):
        model = Model(
            plate=Plate(length_x=4.0, length_y=3.0, thickness=0.3, E=30e9, nu=0.2, edges=hinged),
            ground=Pasternak(k0=20e6, k1=10e6),
            contact=Contact(tensionless=False),
            loads=[UniformLoad(q=1e5)],
            mesh=Mesh(counts=(n, n)),
        )
        results = solve(model)
        assert results.only.symmetry == (True, True)
        distance = np.linalg.norm(results.plate.nodes[:, None] - PLACES, axis=2)
        assert distance.min(axis=0).max() < 1e-12
        off.append(np.abs(results.plate.moment_x[distance.argmin(axis=0)] - wanted) / wanted.max())
    assert (off[1] < 1e-3).all()
    assert (off[1] < off[0] / 2**2.75).all()


SQUARE = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
ASKEW = [(-1.0, -0.7), (0.9, -1.2), (1.3, 0.8), (-0.6, 1.1)]


@pytest.mark.slow
@pytest.mark.parametrize("corners", [SQUARE, ASKEW], ids=["grid", "any quadrilaterals"])
@pytest.mark.parametrize("name", ELEMENTS)
def test_a_jump_of_thickness_keeps_its_jump_of_moments(name: str, corners: list[tuple[float, float]]) -> None:
    """One curvature on both sides of a change of thickness: each side has its own constant moments, exactly.

    w = (a x^2 + b y^2) / 2 with beta = grad w has no shear; twice the thickness has eight times the moments. Nodes of
    the border stand once for each side.
    """
    zone = Zone(thickness=0.4, shape=Polygon(points=corners))
    model = Model(
        plate=Plate(length_x=4.0, length_y=4.0, thickness=0.2, E=30e9, nu=0.2, element=name, zones=[zone]),
        ground=Winkler(k=1e7),
        loads=[UniformLoad(q=1e5)],
        mesh=Mesh(size=0.4),
    )
    problem = discretize(model, 0, 1.0)
    x, y = problem.mesh.nodes.T
    a, b = 2e-3, -1e-3
    U = np.zeros(problem.unknown.shape)
    U[:, W], U[:, BETA_X], U[:, BETA_Y] = (a * x * x + b * y * y) / 2, a * x, b * y

    own = make_result_mesh(model, problem)
    mesh, node = own.mesh, own.node
    forces = own.at_nodes(recovery.own_forces(problem, U, gauss(2)[0]), recovery.FORCES, recovery.SIZES)
    found = recovery.section_forces(own, forces)
    thick = np.zeros(len(mesh.nodes), dtype=bool)
    sides = np.roll(corners, -1, axis=0) - corners
    to_centre = mesh.nodes[mesh.elements[:, 8], None] - np.array(corners)
    inside = (sides[:, 0] * to_centre[..., 1] - sides[:, 1] * to_centre[..., 0] > 0).all(axis=1)
    thick[mesh.elements[inside]] = True
    assert len(mesh.nodes) > len(np.unique(node)), "the border's nodes stand twice"
    rigidity = 30e9 * np.where(thick, 0.4, 0.2) ** 3 / (12 * (1 - 0.2**2))
    wanted = {"moment_x": -rigidity * (a + 0.2 * b), "moment_y": -rigidity * (b + 0.2 * a)}
    scale = np.abs(wanted["moment_x"]).max()
    for field in recovery.FORCES:
        np.testing.assert_allclose(found[field] / scale, wanted.get(field, 0 * x[node]) / scale, atol=1e-9)

    centres = recovery.own_forces(problem, U, gauss(2)[0]).mean(axis=1)
    of_centres = 30e9 * np.where(inside, 0.4, 0.2) ** 3 / (12 * (1 - 0.2**2))
    np.testing.assert_allclose(centres[:, 0] / scale, -of_centres * (a + 0.2 * b) / scale, atol=1e-9)
    np.testing.assert_allclose(centres[:, 2:] / scale, 0.0, atol=1e-9)


@pytest.mark.parametrize("name", ELEMENTS)
def test_values_at_centres_belong_to_one_element_each(name: str) -> None:
    """A curvature in one element alone is seen at its centre and at no other element's."""
    model = Model(
        plate=Plate(length_x=3.0, length_y=3.0, thickness=0.2, E=30e9, nu=0.2, element=name),
        ground=Winkler(k=1e7),
        loads=[UniformLoad(q=1e5)],
        mesh=Mesh(counts=(3, 3), symmetry="off"),
    )
    problem = discretize(model, 0, 1.0)
    middle = problem.plate.elements[np.argmin(np.abs(problem.mesh.nodes[problem.mesh.elements[:, 8]]).sum(axis=1))]
    U = np.zeros(problem.unknown.shape)
    U[problem.mesh.elements[middle, 8], BETA_X] = 1e-3
    forces = recovery.own_forces(problem, U, gauss(2)[0])
    assert forces.shape == (9, 4, 5)
    assert (np.flatnonzero(np.abs(forces).max(axis=(1, 2))) == middle).all()
    centres = recovery.own_forces(problem, U, gauss(2)[0]).mean(axis=1)
    assert centres.shape == (9, 5)
    assert (np.delete(centres, middle, axis=0) == 0).all()
    # the bubble is even in x: its slope cancels
    np.testing.assert_allclose(centres[middle, 0], 0.0, atol=1e-6 * np.abs(forces).max())
