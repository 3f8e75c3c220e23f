"""A plate on a coarser mesh bends nearly as the plate does, and leads to the same pressures by fewer substitutions."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab.arrays import Array
from groundslab.discretize.discretize import discretize
from groundslab.fem.foundation import single
from groundslab.fem.problem import Problem
from groundslab.fem.system import build_system, current_bearings, right_hand_side, stiffness
from groundslab.model.model import Model
from groundslab.solvers import factorization
from groundslab.solvers.bounded_forces import BoundedForces, solve
from groundslab.solvers.coarser_plate import CoarserPlate, make_coarser_plate
from groundslab.solvers.factor_reuse import CachedFactorization
from groundslab.solvers.plate_on_continuum import PlateOnContinuum, bound_forces, make_plate_on_continuum

RECTANGLE = {"length_x": 8.0, "length_y": 6.0}
CIRCLE = {"outline": {"kind": "circle", "radius": 4.0}}
#: Supports with limits of all kinds, one of them off the nodes of the coarser mesh.
SUPPORTS = [
    {"kind": "point", "x": -2.0, "y": 1.3},
    {"kind": "point", "x": 2.0, "y": 0.5, "stiffness": 3e7, "acts": "in compression", "limit": 5e4},
    {"kind": "line", "points": [[-3.0, -2.5], [3.0, -2.5]], "stiffness": 2e6},
]
SLABS: dict[str, dict[str, Any]] = {
    "rectangle": {"plate": RECTANGLE},
    "circle": {"plate": CIRCLE},
    "supports": {"plate": RECTANGLE, "supports": SUPPORTS},
    "limit": {"plate": RECTANGLE, "contact": {"limit_pressure": 3e4}},
    "glued": {"plate": RECTANGLE, "contact": {"tensionless": False}},
}


def _model(slab: str) -> Model:
    """Return a slab under a force off its middle."""
    parts = SLABS[slab]
    return Model.model_validate({
        "ground": {"kind": "continuum", "layers": [{"E": 20e6, "nu": 0.3, "thickness": 6.0}]},
        "loads": [{"kind": "point", "x": 1.0, "y": 0.7, "P": 5e5, "width_x": 0.5, "width_y": 0.5}],
        "mesh": {"size": 0.25}, **parts, "plate": {"thickness": 0.25, "E": 30e9, "nu": 0.2, **parts["plate"]},
    })  # fmt: skip


def _make(model: Model, coarsening: int) -> tuple[Problem, PlateOnContinuum, Array]:
    """Return the arrays of a slab, its factorized plate and the loads on that."""
    problem = discretize(model, coarsening)
    s = build_system(problem)
    solver = factorization.choose("auto")[1]
    factor = CachedFactorization(solver(s.pattern.indptr, s.pattern.indices))
    plate = make_plate_on_continuum(s, stiffness(s, single(0.0, 0.0)), factor)
    return problem, plate, right_hand_side(s, 1.0)


def _pose(problem: Problem, plate: PlateOnContinuum, f: Array, coarser: CoarserPlate | None = None) -> BoundedForces:
    """Return the problem of the forces on a plate."""
    b = len(problem.contact.bearing.law)
    law = current_bearings(problem, 1.0, np.zeros(b))
    none = np.zeros(len(plate.ground.gap))
    return bound_forces(plate, problem, law, f, none, None if coarser is None else coarser.bend)


@pytest.mark.parametrize("slab", SLABS)
def test_it_bends_nearly_alike(slab: str) -> None:
    """Under pressures that vary over some elements, and forces of supports, in equilibrium."""
    model = _model(slab)
    (problem, plate, f), (coarse, on_coarse, _) = _make(model, 0), _make(model, 1)
    p, cells = _pose(problem, plate, f), plate.ground.cells
    x, y = cells.center.T
    b = len(problem.contact.bearing.law)
    forces = np.concatenate([cells.area * np.cos(1.5 * x) * np.sin(1.0 * y + 0.3), np.full(b, 0.05)])
    forces -= p.G.T @ np.linalg.solve(p.G @ p.G.T, p.G @ forces)
    bent = plate.C.T @ plate.solve(plate.C @ forces)
    nearly = make_coarser_plate(on_coarse, coarse, problem).bend(forces)
    # rigid motions apart, which each of them holds elsewhere
    planes = np.linalg.qr(p.G.T)[0]
    bent, nearly = (each - planes @ (planes.T @ each) for each in (bent, nearly))
    assert np.linalg.norm(nearly - bent) < 0.05 * np.linalg.norm(bent)
    assert np.linalg.norm(bent) > 0


@pytest.mark.parametrize("slab", SLABS)
def test_it_leads_to_the_same_pressures(slab: str) -> None:
    """The same settlements within the tolerance, for fewer products."""
    model = _model(slab)
    (problem, plate, f), (coarse, on_coarse, _) = _make(model, 0), _make(model, 1)
    start = np.concatenate([plate.ground.cells.area, np.zeros(len(problem.contact.bearing.law))])
    coarser = make_coarser_plate(on_coarse, coarse, problem)
    found = [solve(_pose(problem, plate, f, each), start, 1e-7, 500, lambda *_: None) for each in (None, coarser)]
    c = len(plate.ground.gap)
    one, other = (plate.ground.settle(each.x[:c]) for each in found)
    np.testing.assert_allclose(other, one, atol=1e-6 * np.abs(one).max())
    assert found[1].products < 0.6 * found[0].products
