"""Results do not know the order of a file, the numbers of nodes, or into how many pieces lines fall."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from groundslab.analysis.driver import solve, solve_combinations
from groundslab.arrays import Array
from groundslab.discretize.discretize import discretize
from groundslab.errors import InputError, NoEquilibrium
from groundslab.fem.bearings import CLOSED
from groundslab.fem.foundation import Column
from groundslab.fem.problem import Problem
from groundslab.fem.system import build_system, current_bearings, nodal_table, right_hand_side, stiffness
from groundslab.model.combinations import list_combinations
from groundslab.model.loads.lines import LineLoad
from groundslab.model.model import Model
from groundslab.model.supports import LineSupport
from groundslab.results.results import Results
from groundslab.solvers import contact, factor_reuse, factorization
from groundslab.solvers.equilibrium import require_equilibrium
from helpers.examples import examples
from helpers.strategies import rich_models

pytestmark = pytest.mark.slow

FEW = settings(
    deadline=None, derandomize=True, database=None, suppress_health_check=list(HealthCheck), max_examples=examples(4)
)
SAME = 1e-6  # of the largest value: gamma is iterated to 1e-6
PLATE: dict[str, Any] = {"length_x": 6, "length_y": 4, "thickness": 0.3, "E": 3e10, "nu": 0.2}
BASE: dict[str, Any] = {"plate": PLATE, "ground": {"kind": "pasternak", "k0": 2e7, "k1": 5e6}, "mesh": {"size": 0.5}}


def combined(model: Model) -> Results:
    """Return all results of a model; what no mesh can hold is no example."""
    try:
        return solve_combinations(model)
    except InputError:
        assume(False)
        raise


def assert_same(one: Array, other: Array, tolerance: float = SAME) -> None:
    """Hold two fields to each other, measured by the larger one; what is nothing beside 1 nm or 1 mN is nothing."""
    scale = max(np.abs(one).max(initial=0), np.abs(other).max(initial=0), 1e-7)
    np.testing.assert_allclose(one / scale, other / scale, atol=tolerance)


def assert_alike(one: Results, other: Results) -> None:
    """Hold the results of all combinations to each other by their settlements and pressures."""
    assert set(one.refused) == set(other.refused)
    for name, results in one.results.items():
        for field in ("settlement", "rotation_x", "rotation_y"):
            assert_same(getattr(results.plate, field), getattr(other.results[name].plate, field))


@FEW
@given(rich_models(), st.randoms(use_true_random=False))
def test_order_in_the_file(model: Model, random: Any) -> None:
    """Loads, cases, supports, columns and walls in another order give the same settlements in every combination."""
    # of rigid supports that meet the first one counts, and EN 1990 takes the leading actions in the cases' order
    mixed = {part: random.sample(getattr(model, part), len(getattr(model, part)))
             for part in ("loads", "cases", "supports", "columns", "walls")}  # fmt: skip
    # small voids, whose order is not mixed, make meshes that are large
    model = model.replace(combine=None, contact=model.contact.replace(voids=()))
    assert_alike(combined(model), combined(model.replace(**mixed)))


@FEW
@given(rich_models())
def test_combination_by_itself(model: Model) -> None:
    """A combination that starts from the one before has the result of a model with this combination alone."""
    # small voids make meshes that are large
    model = model.replace(contact=model.contact.replace(voids=()))
    together = combined(model)
    for combination in list_combinations(model)[-2:]:
        if model.cases:
            own = combined(model.replace(combinations=[combination], combine=None))
            assert (combination.name in own.refused) == (combination.name in together.refused)
            if not own.refused:
                one, other = own.results[combination.name].plate, together.results[combination.name].plate
                assert_same(one.settlement, other.settlement)


def solved(problem: Problem) -> Array:
    """Return the nodal_table unknowns (n, F) of a problem on a ground of constants, by the kernels alone."""
    assert isinstance(problem.ground, Column)
    s = build_system(problem)
    A = stiffness(s, problem.ground)
    law = current_bearings(problem, 1.0, np.zeros(len(problem.contact.bearing.law)))
    latest = factor_reuse.CachedFactorization(factorization.choose("superlu")[1](s.pattern.indptr, s.pattern.indices))
    start = np.full(len(law), CLOSED)
    f = right_hand_side(s, 1.0)
    return nodal_table(problem, contact.solve(contact.ContactProblem(A, f, law), latest, start, 400, lambda *_: None).u)


def renumbered(problem: Problem, seed: int) -> tuple[Problem, Array]:
    """Return the problem with its nodes, elements and unknowns in a random order, and each node's new number (n,)."""
    from groundslab.fem.assembly import number_unknowns

    random = np.random.default_rng(seed)
    mesh, n = problem.mesh, len(problem.mesh.nodes)
    new, turn = random.permutation(n), random.permutation(len(mesh.elements))
    back = np.argsort(new)
    rank = random.permutation(n)
    unknown = number_unknowns(rank, problem.unknown[back] >= 0)
    where = np.argsort(turn)  # new number of each element
    b, below = problem.contact.bearing, problem.contact.depths
    law = replace(b.law, unknown=unknown[new[b.node], b.field])
    loading = replace(problem.loading, load=problem.loading.load[back])
    changed = replace(
        problem,
        mesh=type(mesh)(mesh.nodes[back], new[mesh.elements[turn]]),
        plate=replace(
            problem.plate,
            elements=where[problem.plate.elements],
            nodes=np.sort(new[problem.plate.nodes]),
            edges=new[problem.plate.edges],
        ),
        rank=rank,
        unknown=unknown,
        cases=(loading,),
        loading=loading,
        contact=replace(
            problem.contact,
            initial_gap=problem.contact.initial_gap[back],
            depths=replace(
                below, shallowest=below.shallowest[back], area=below.area[back], mass_kind=below.mass_kind[turn]
            ),
            bearing=replace(b, law=law, node=new[b.node]),
        ),
        edges=new[problem.edges],
        corners=new[problem.corners],
    )
    return changed, new


@pytest.mark.parametrize(("seed", "element"), [(0, "mitc9"), (1, "q9"), (2, "heterosis")])
def test_node_numbers(element: str, seed: int) -> None:
    """Nodes, elements and unknowns numbered at random give the same unknowns at the same places to 1e-9."""
    # few elements: numbers at random leave nothing of a sparse factor
    ground = {"kind": "pasternak", "k0": 2e7, "k1": 2e7}
    model = Model(
        **BASE | {"plate": {**PLATE, "element": element}, "ground": ground, "mesh": {"size": 1.2}},
        beyond={"kind": "infinite"},
        contact={"gap": 1e-4, "limit_pressure": 2e5},
        supports=[{"kind": "point", "x": 1.5, "y": 1, "acts": "in tension", "stiffness": 1e8, "limit": 5e4},
                  {"kind": "line", "points": [(-3, -1), (-1.5, -1)], "acts": "in compression", "gap": 1e-3}],
        loads=[{"kind": "point", "P": 4e5, "x": -2, "y": 0}, {"kind": "uniform", "q": 1e4}],
    )  # fmt: skip
    problem = discretize(model)
    changed, new = renumbered(problem, seed)
    require_equilibrium(changed)
    one, other = solved(problem), solved(changed)[new]
    for field in range(one.shape[1]):
        assert_same(one[:, field], other[:, field], 1e-9)


@pytest.mark.parametrize(("acts", "stiffness"), [("both ways", 5e7), ("in compression", None), ("in tension", 5e7)])
def test_line_support_in_two(acts: str, stiffness: float | None) -> None:
    """A line support drawn as two lines, end to end, holds the plate as the whole one does."""

    def model(*lines: Any) -> Model:
        supports = [LineSupport(points=line, acts=acts, stiffness=stiffness) for line in lines]
        loads = [{"kind": "point", "P": 3e5, "x": -2, "y": 1}, {"kind": "uniform", "q": 5e3}]
        return Model(**BASE, supports=supports, loads=loads)

    whole, parts = solve(model([(-1, -2), (-1, 2)])), solve(model([(-1, 2), (-1, 0)], [(-1, -2), (-1, 0)]))
    joined = solve(model([(-1, -2), (-1, 0), (-1, 2)]))
    for other in (parts, joined):
        assert_same(whole.plate.settlement, other.plate.settlement, 1e-9)
        total = [sum(support.total for support in each.supports) for each in (whole, other)]
        assert total[0] == pytest.approx(total[1], rel=1e-8, abs=1e-3)


@pytest.mark.parametrize("end", [None, 0.0, 9e4])
def test_line_load_in_two(end: float | None) -> None:
    """A line load in two pieces with the value between at their joint gives the same settlements."""
    a, b, q = np.array([-2.3, -1.1]), np.array([1.9, 1.7]), 5e4
    last = q if end is None else end
    middle, between = a + 0.3 * (b - a), q + 0.3 * (last - q)
    whole = [LineLoad(q=q, q_end=end, points=[tuple(a), tuple(b)])]
    parts = [LineLoad(q=q, q_end=between, points=[tuple(a), tuple(middle)]),
             LineLoad(q=between, q_end=last, points=[tuple(middle), tuple(b)])]  # fmt: skip
    base = [{"kind": "uniform", "q": 5e3}]
    one, other = (solve(Model(**BASE, loads=[*base, *loads])) for loads in (whole, parts))
    assert_same(one.plate.settlement, other.plate.settlement, 1e-9)


def test_refused_in_any_order() -> None:
    """A combination that nothing balances is refused wherever it stands, and the others are solved all the same."""
    names = ["up", "down"]
    loads = [{"kind": "uniform", "q": -1e4, "case": "up"}, {"kind": "uniform", "q": 1e4, "case": "down"}]
    for order in (names, names[::-1]):
        found = solve_combinations(Model(**BASE, cases=[{"name": name} for name in order], loads=loads))
        assert isinstance(found.refused["up"], NoEquilibrium)
        assert found.results["down"].certificate.holds
