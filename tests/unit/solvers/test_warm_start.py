"""The forecast from a coarser mesh: what it keeps exactly, and that the answer never depends on it."""

from __future__ import annotations

from typing import Any
from unittest.mock import patch

import numpy as np
import pytest

from groundslab.analysis import driver
from groundslab.arrays import Array, Integers
from groundslab.discretize.discretize import discretize
from groundslab.fem.bearings import CLOSED, OPEN, Contact
from groundslab.fem.foundation import Column
from groundslab.fem.problem import BETA_X, BETA_Y, TOP, W
from groundslab.fem.system import build_system, current_bearings, right_hand_side, stiffness, surface_settlement
from groundslab.model.model import Model
from groundslab.solvers import contact, factor_reuse, factorization, warm_start
from groundslab.solvers.solution import Solution

PLATE = {"length_x": 9.6, "length_y": 7.2, "thickness": 0.2, "E": 23e9, "nu": 0.17}
PATCH = [{"kind": "patch", "q": 1e6, "x": (-1.2, 1.2), "y": (-1.2, 1.2)}]


def model(**changes: object) -> Model:
    """Return the paper's first plate on ground that carries shear, with a strip of ground beyond it."""
    given: dict[str, object] = {
        "plate": PLATE,
        "ground": {"kind": "pasternak", "k0": 32.7862e6, "k1": 20.66e6},
        "beyond": {"kind": "margin", "width": 2.0},
        "loads": PATCH,
        "mesh": {"counts": (32, 24)},
    }
    return Model(**{**given, **changes})


def solution_with(coarse: Model, fields: dict[int, Array], states: np.ndarray, coarsening: int) -> Solution:
    """Return a made-up solution on a coarser mesh: nodal fields and states of the bearings."""
    problem = discretize(coarse, coarsening)
    s = build_system(problem)
    U = np.zeros(problem.unknown.shape)
    for field, values in fields.items():
        U[:, field] = values
    law = current_bearings(problem, 1.0, np.zeros(len(problem.contact.bearing.law)))
    found = Contact(np.zeros(s.pattern.size), states, np.zeros(len(states)))
    assert isinstance(problem.ground, Column)
    return Solution(s, U, found, problem.ground, None, 0.0, 0.0, 0, law, np.zeros(len(states)))


def test_fields_that_the_coarser_mesh_holds_are_met() -> None:
    """Quadratic w, rotations and surface come over to the last digit; the gap follows from w and the surface."""
    given = model()
    coarse, fine = discretize(given, 1), discretize(given, 0)

    def fields(nodes: Array) -> tuple[Array, Array, Array]:
        x, y = nodes.T
        return 1e-3 * (3 + x - 0.2 * x * y + 0.1 * y * y), 1e-3 * (1 - 0.4 * y + 0.05 * x * x), 2e-3 + 1e-4 * x * y

    w, beta, surface = fields(coarse.mesh.nodes)
    under = np.zeros(len(coarse.mesh.nodes), dtype=bool)
    under[coarse.plate.nodes] = True
    nodal = {W: np.where(under, w, 0), BETA_X: np.where(under, beta, 0), BETA_Y: np.where(under, -beta, 0)}
    nodal[TOP] = surface - np.where(under, w, 0.0)
    start = solution_with(given, nodal, np.full(len(coarse.contact.bearing.law), OPEN), 1)
    np.testing.assert_allclose(surface_settlement(start.system, start.U)[0], surface, atol=1e-15)

    _, U = warm_start.from_coarser(start, fine, warm_start.locate_nodes(coarse, fine))
    w, beta, surface = fields(fine.mesh.nodes)
    under = np.zeros(len(w), dtype=bool)
    under[fine.plate.nodes] = True
    wanted = np.column_stack([w, beta, -beta, surface - np.where(under, w, 0.0)])
    has = fine.unknown >= 0
    np.testing.assert_allclose(U[has], wanted[has], atol=1e-14)
    assert not U[~has].any()


@pytest.mark.parametrize("closed", [True, False])
def test_a_plate_all_in_contact_or_all_lifted_stays_so(closed: bool) -> None:
    """With one state everywhere there is no border: no strip is laid, and all states are forecast alike."""
    given = model()
    coarse, fine = discretize(given, 1), discretize(given, 0)
    states = np.full(len(coarse.contact.bearing.law), CLOSED if closed else OPEN)
    start = solution_with(given, {}, states, 1)
    state, U = warm_start.from_coarser(start, fine, warm_start.locate_nodes(coarse, fine))
    assert (state == states[0]).all()
    s = build_system(fine)
    assert isinstance(fine.ground, Column)
    A = stiffness(s, fine.ground)
    f = right_hand_side(s, 1.0)
    law = current_bearings(fine, 1.0, np.zeros(len(state)))
    with patch.object(warm_start, "CachedFactorization", side_effect=AssertionError("a strip was laid")):
        after = warm_start.solve_contact_border(
            fine, contact.ContactProblem(A, f, law), state, U, factorization.SuperLU
        )
    np.testing.assert_array_equal(after, state)


@pytest.mark.slow
def test_the_strip_finds_the_zone_that_the_whole_mesh_finds() -> None:
    """From states that are off by some nodes along the border, the strip alone leads to the zone of the solution."""
    given = model()
    fine = discretize(given, 0)
    s = build_system(fine)
    assert isinstance(fine.ground, Column)
    A = stiffness(s, fine.ground)
    f = right_hand_side(s, 1.0)
    law = current_bearings(fine, 1.0, np.zeros(len(fine.contact.bearing.law)))
    latest = factor_reuse.CachedFactorization(factorization.SuperLU(A.indptr, A.indices))
    start = np.full(len(law), CLOSED)
    right = contact.solve(contact.ContactProblem(A, f, law), latest, start, 100, lambda *_: None)
    U = np.zeros(fine.unknown.shape)
    U[fine.unknown >= 0] = right.u[fine.unknown[fine.unknown >= 0]]

    # open all nodes within about an element of an open one
    places = fine.mesh.nodes[fine.contact.bearing.node]
    opened = places[right.state == OPEN]
    distance = np.array([np.linalg.norm(opened - place, axis=1).min() for place in places])
    wrong = np.where(distance < 0.31, OPEN, CLOSED)
    assert (wrong != right.state).sum() > 10
    found = warm_start.solve_contact_border(fine, contact.ContactProblem(A, f, law), wrong, U, factorization.SuperLU)
    np.testing.assert_array_equal(found, right.state)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2])
def test_a_wrong_forecast_costs_steps_but_not_the_result(seed: int) -> None:
    """States and unknowns of the forecast drawn by lot: the certified result is the same."""
    given, rng = model(beyond={"kind": "infinite"}), np.random.default_rng(seed)
    right = driver.solve(given)

    def nonsense(start: Solution, problem: object, at: object) -> tuple[np.ndarray, Array]:
        state, U = from_coarser(start, problem, at)  # type: ignore[arg-type]
        return rng.integers(0, 2, len(state)), rng.standard_normal(U.shape)

    from_coarser = warm_start.from_coarser
    with (
        patch.object(warm_start, "from_coarser", nonsense),
        patch.object(warm_start, "solve_contact_border", lambda *given: given[2]),
    ):
        found = driver.solve(given)
    assert found.certificate.holds
    np.testing.assert_allclose(found.plate.settlement, right.plate.settlement, rtol=0, atol=1e-9)
    np.testing.assert_allclose(found.plate.gap, right.plate.gap, rtol=0, atol=1e-9)
    assert sum(step.changed for step in found.steps if step.finest) > 100


@pytest.mark.slow
def test_a_combination_with_the_zone_of_another_lays_no_strip() -> None:
    """Twice the load lifts the same nodes, so that the zone found serves; a load elsewhere needs a strip of its own."""
    factors = {"once": {"left": 1.0}, "twice": {"left": 2.0}, "elsewhere": {"right": 1.0}}
    loads = [
        {"kind": "point", "P": 1e5, "x": x, "y": 0.3, "case": case} for case, x in (("left", -1.2), ("right", 0.9))
    ]
    changes: dict[str, Any] = {
        "cases": [{"name": "left"}, {"name": "right"}],
        "combinations": [{"name": name, "factors": each} for name, each in factors.items()],
        "loads": loads,
        "mesh": {"counts": (32, 24), "symmetry": "off"},
    }
    laid: list[int] = []
    strip = warm_start.solve_contact_border

    def counted(*arguments: Any) -> Integers:
        laid[-1] += 1
        return strip(*arguments)

    with patch.object(warm_start, "solve_contact_border", counted):
        found = driver.solve(model(**changes), on_combination=lambda _: laid.append(0))
    assert laid[0] == laid[2] > 0
    assert laid[1] == 0
    once, twice = found["once"].plate, found["twice"].plate
    assert not once.in_contact.all()
    np.testing.assert_array_equal(once.in_contact, twice.in_contact)
    np.testing.assert_allclose(twice.settlement, 2 * once.settlement, rtol=1e-9, atol=1e-12)
