"""A plate on an elastic continuum as a problem of forces, against full matrices."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.optimize import nnls

from groundslab import Model
from groundslab.discretize.discretize import discretize
from groundslab.fem.foundation import single
from groundslab.fem.system import build_system, current_bearings, right_hand_side, stiffness
from groundslab.solvers import bounded_forces, factorization
from groundslab.solvers.bounded_forces import BoundedForces
from groundslab.solvers.factor_reuse import CachedFactorization
from groundslab.solvers.plate_on_continuum import PlateOnContinuum, bound_forces, make_plate_on_continuum, move

CORNER = {"kind": "point", "P": 3e5, "x": 1.8, "y": 1.3}
SPRING = {"kind": "point", "x": -1.5, "y": 0.5, "stiffness": 4e7}
LAYERS = {"layers": [{"E": 2e7, "nu": 0.3, "thickness": 2.0}], "half_space": {"E": 6e7, "nu": 0.3}}
RIGID = {"kind": "point", "x": -1.5, "y": 0.5, "acts": "in compression"}


def make(**changes: Any) -> tuple[PlateOnContinuum, BoundedForces, np.ndarray]:
    """Return plate, problem of forces and loads of a small raft on two layers."""
    model = Model(
        plate={"length_x": 4.0, "length_y": 3.0, "thickness": 0.3, "E": 3e10, "nu": 0.2},
        ground={"kind": "continuum", **LAYERS},
        **{"loads": [{"kind": "uniform", "q": 1e4}, CORNER], "mesh": {"size": 1.0}, **changes},
    )
    problem = discretize(model)
    s = build_system(problem)
    A = stiffness(s, single(0.0, 0.0))
    solver = factorization.choose("superlu")[1]
    plate = make_plate_on_continuum(s, A, CachedFactorization(solver(s.pattern.indptr, s.pattern.indices)))
    law, f = current_bearings(problem, 1.0, np.zeros(len(problem.contact.bearing.law))), right_hand_side(s, 1.0)
    return plate, bound_forces(plate, problem, law, f, np.zeros(len(plate.ground.gap))), f


def full(p: PlateOnContinuum, forces: BoundedForces) -> tuple[np.ndarray, np.ndarray]:
    """Return the plate's matrix, and what forces settle the ground and supports, both full."""
    K = np.array([p.A @ unit for unit in np.eye(p.A.size)])
    C = p.C.toarray()
    multiply = np.array([forces.multiply(unit) for unit in np.eye(C.shape[1])])
    bent = np.array([C.T @ p.solve(C @ unit) for unit in np.eye(C.shape[1])])
    return K, multiply - bent


def test_rigid_motions_bend_nothing():
    """K R = 0: settling and tilting the plate takes no force."""
    p, _, _ = make()
    K = np.array([p.A @ unit for unit in np.eye(p.A.size)])
    assert p.R.shape[1] == 3
    scale = np.abs(K) @ np.abs(p.R)
    assert np.abs(K @ p.R).max() < 1e-12 * scale.max()
    assert np.linalg.matrix_rank(K, tol=1e-9 * np.linalg.norm(K, 2)) == len(K) - 3


def test_forces_of_cells_push_the_plate_up():
    """A pressure everywhere is minus the load of that pressure; its moments are those of the cells."""
    p, forces, _ = make()
    pressed = make(loads=[{"kind": "uniform", "q": 1.0}])[2]
    area = p.ground.cells.area
    assert p.R.T @ (p.C @ area) == pytest.approx(-(p.R.T @ pressed), rel=1e-10, abs=1e-9)
    assert forces.G @ np.ones(len(area)) == pytest.approx(p.R.T @ (p.C @ np.ones(p.C.shape[1])), abs=1e-9)


@pytest.mark.parametrize("supports", [[], [SPRING], [RIGID]])
def test_products_are_those_of_full_matrices(supports):
    """F + C^T K^+ C for forces in equilibrium, with the springs of supports in F."""
    p, forces, _ = make(supports=supports)
    K, F = full(p, forces)
    C = p.C.toarray()
    dense = F + C.T @ np.linalg.pinv(K, rcond=1e-11, hermitian=True) @ C
    # forces that do no work on the rigid motions, seen by gaps that leave rigid motions out
    N = np.linalg.svd(forces.G)[2][len(forces.G) :].T
    found = N.T @ np.array([forces.multiply(each) for each in N.T]).T
    assert np.abs(found - N.T @ dense @ N).max() < 1e-8 * np.abs(found).max()
    assert np.abs(found - found.T).max() < 1e-9 * np.abs(found).max()
    assert np.linalg.eigvalsh((found + found.T) / 2).min() > 0
    given = [1 / each["stiffness"] if "stiffness" in each else 0.0 for each in supports]
    assert np.diag(F)[len(p.ground.gap) :] == pytest.approx(given, abs=1e-15)


def test_gaps_are_linear_in_forces():
    """Gaps of two sets of forces differ by the product with their difference, and by rigid motions."""
    p, forces, _ = make(supports=[SPRING])
    random = np.random.default_rng(1)
    start = bounded_forces.balance(forces, random.uniform(size=p.C.shape[1]), forces.can_change)
    N = np.linalg.svd(forces.G)[2][len(forces.G) :].T
    change = N @ random.normal(size=N.shape[1]) * 1e3
    differ = forces.gaps(start + change)[0] - forces.gaps(start)[0] - forces.multiply(change)
    differ -= forces.G.T @ np.linalg.lstsq(forces.G.T, differ, rcond=None)[0]
    assert np.abs(differ).max() < 1e-9 * np.abs(forces.multiply(change)).max()


@pytest.mark.parametrize("ends", [{}, {"contact": {"tensionless": False}}, {"contact": {"gap": 1e-3}}])
def test_contact_by_least_squares(ends):
    """Forces of all cells by non-negative least squares of the full problem, or by one solution if it may pull."""
    p, forces, f = make(**ends)
    found = bounded_forces.solve(forces, p.ground.cells.area.copy(), 1e-10, 10_000, lambda *_: None)
    K, F = full(p, forces)
    C = p.C.toarray()
    Kplus = np.linalg.pinv(K, rcond=1e-11, hermitian=True)
    A, c = F + C.T @ Kplus @ C, C.T @ Kplus @ f + p.ground.gap
    if not ends.get("contact", {}).get("tensionless", True):
        r = len(forces.G)
        both = np.block([[A, forces.G.T], [forces.G, np.zeros((r, r))]])
        x = np.linalg.solve(both, np.concatenate([-c, forces.e]))[: len(c)]
    else:
        # 1/2 |L^T x + L^-1 c|^2, and equilibrium as heavy rows
        L = np.linalg.cholesky((A + A.T) / 2)
        heavy = 1e3 * np.abs(L).max() / np.abs(forces.G).max()
        x = nnls(np.vstack([L.T, heavy * forces.G]), np.concatenate([np.linalg.solve(L, -c), heavy * forces.e]))[0]
        assert 0 < (x > 0).sum() < len(x)
    assert found.x == pytest.approx(x, abs=2e-5 * np.abs(x).max())
    u = move(p, f, found)
    assert np.abs(K @ u - f - C @ found.x).max() < 1e-9 * np.abs(K).max() * np.abs(u).max()
    expected = p.ground.settle(found.x) + p.ground.gap
    settled, touching = -(C.T @ u), found.x != 0
    assert settled[touching] == pytest.approx(expected[touching], abs=1e-8 * np.abs(expected).max())
    assert (settled - expected).max() < 1e-8 * np.abs(expected).max()
