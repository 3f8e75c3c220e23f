"""Variants of a base case: the same results as by themselves, from what the base case left behind."""

from __future__ import annotations

from typing import Any
from unittest.mock import patch

import numpy as np
import pytest

from groundslab.analysis import driver, nested
from groundslab.analysis.tasks import run
from groundslab.errors import InputError, NoEquilibrium, NotConverged
from groundslab.model.model import Model
from groundslab.solvers import factorization
from groundslab.solvers.direct import protocols
from helpers.nodes import nodes_at

pytestmark = pytest.mark.slow

PLATE = {"length_x": 9.6, "length_y": 7.2, "thickness": 0.2, "E": 23e9, "nu": 0.17}
LOADS = [{"kind": "patch", "q": 1e6, "x": (-1.2, 1.2), "y": (-1.2, 1.2)}]
SAND = {"E": 20e6, "nu": 0.25, "thickness": 5.0}


def model(**changes: Any) -> Model:
    """Return the paper's first plate on a coarse mesh, with changes."""
    given: dict[str, Any] = {
        "plate": PLATE,
        "ground": {"kind": "pasternak", "k0": 30e6, "k1": 20e6},
        "loads": LOADS,
        "mesh": {"counts": (12, 9)},
    }
    return Model(**{**given, **changes})


CHANGES: dict[str, dict[str, Any]] = {
    "softer ground": {"ground": {"kind": "pasternak", "k0": 12e6, "k1": 30e6}},
    "thicker plate": {"plate": {**PLATE, "thickness": 0.35}},
    "load elsewhere": {"loads": [{"kind": "patch", "q": 5e5, "x": (-4.0, -2.0), "y": (0.0, 3.0)}]},
    "another mesh": {"mesh": {"counts": (10, 8)}},
    "held down": {"contact": {"tensionless": False}},
    "on a pile": {"supports": [{"kind": "point", "x": 0.0, "y": 0.0, "stiffness": 1e8}], "mesh": {"size": 0.8}},
}


def same(found: driver.CombinationResult, wanted: driver.CombinationResult) -> None:
    """Hold two results against each other to what a certificate leaves open."""
    assert found.certificate.holds
    for name in ("settlement", "gap", "pressure", "moment_x", "shear_y"):
        one, other = getattr(found.plate, name), getattr(wanted.plate, name)
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-8 * np.abs(other).max())
    np.testing.assert_array_equal(found.plate.in_contact, wanted.plate.in_contact)


@pytest.mark.parametrize(
    ("change", "beyond"), [*zip(CHANGES.values(), ("none", "infinite") * 3, strict=True)], ids=list(CHANGES)
)
def test_a_variant_has_the_results_that_it_has_by_itself(change: dict[str, Any], beyond: str) -> None:
    """Whatever is changed about the base case, the mesh included."""
    base = model(beyond={"kind": beyond, **({"width": 3.0} if beyond == "infinite" else {})})
    variants = driver.Variants(base)
    given = base.replace(**change)
    (found,), (wanted,) = (
        each.results.values() for each in (variants.solve_combinations(given), driver.solve_combinations(given))
    )
    same(found, wanted)


def test_a_variant_starts_on_the_finest_mesh_and_analyses_nothing() -> None:
    """With the base case's mesh and pattern no coarser mesh is solved, none is made, and PARDISO or SuperLU ordered."""
    variants = driver.Variants(model())
    begun: list[int] = []
    choose = factorization.choose

    def watched(name: str) -> tuple[str, protocols.Solver]:
        called, solver = choose(name)

        def prepare(indptr: factorization.Indices, indices: factorization.Indices) -> protocols.Symbolic:
            begun.append(len(indptr))
            return solver(indptr, indices)

        return called, prepare

    with patch.object(factorization, "choose", watched):
        (found,) = variants.solve_combinations(model(**CHANGES["softer ground"])).results.values()
    assert not begun
    assert all(step.finest for step in found.steps)


def test_variants_do_not_depend_on_which_came_before() -> None:
    """The same variant solved first or last has the same numbers, to the last digit."""
    wanted = model(**CHANGES["thicker plate"])
    first = driver.Variants(model())
    (alone,) = first.solve_combinations(wanted).results.values()
    second = driver.Variants(model())
    for change in ("softer ground", "load elsewhere", "held down"):
        second.solve_combinations(model(**CHANGES[change]))
    (last,) = second.solve_combinations(wanted).results.values()
    np.testing.assert_array_equal(alone.plate.settlement, last.plate.settlement)
    np.testing.assert_array_equal(alone.plate.moment_x, last.plate.moment_x)


def test_gamma_is_sought_anew() -> None:
    """Soil of which k0 and k1 follow: the variant's gamma is its own, the base case's only starts it."""
    base = model(ground={"kind": "vlasov", "layers": [SAND]})
    variants = driver.Variants(base)
    given = base.replace(ground={"kind": "vlasov", "layers": [{**SAND, "E": 60e6}]})
    (found,), (wanted,) = (
        each.results.values() for each in (variants.solve_combinations(given), driver.solve_combinations(given))
    )
    (started,) = variants.base.results.values()
    assert wanted.constants.gamma is not None
    assert started.constants.gamma is not None
    assert abs(started.constants.gamma - wanted.constants.gamma) > 1e-2 * wanted.constants.gamma
    assert found.constants.gamma == pytest.approx(wanted.constants.gamma, rel=1e-5)
    np.testing.assert_allclose(found.plate.settlement, wanted.plate.settlement, rtol=0, atol=1e-7)


def test_a_variant_without_equilibrium_is_refused_by_itself() -> None:
    """And the next one is solved as if nothing had been."""
    variants = driver.Variants(model())
    lifted = variants.solve_combinations(model(loads=[{"kind": "uniform", "q": -1e3}]))
    assert [type(error) for error in lifted.refused.values()] == [NoEquilibrium]
    given = model(**CHANGES["softer ground"])
    (found,), (wanted,) = (
        each.results.values() for each in (variants.solve_combinations(given), driver.solve_combinations(given))
    )
    same(found, wanted)


def test_a_start_that_leads_nowhere_is_dropped() -> None:
    """If the iteration from the base case's zone does not end, the nested meshes are gone through after all."""
    variants = driver.Variants(model())
    given = model(**CHANGES["softer ground"])
    ended, tried = nested._solve_increments, list[bool]()

    def at_first_in_vain(*given: Any, **more: Any) -> Any:
        tried.append(True)
        if len(tried) == 1:
            raise NotConverged("the contact zone", [], {})
        return ended(*given, **more)

    with patch.object(nested, "_solve_increments", at_first_in_vain):
        (found,) = variants.solve_combinations(given).results.values()
    (wanted,) = driver.solve_combinations(given).results.values()
    same(found, wanted)
    assert not all(step.finest for step in found.steps)


GROUNDS = {
    "winkler": ({"kind": "winkler", "k": 30e6}, "ground.k"),
    "pasternak": ({"kind": "pasternak", "k0": 30e6, "k1": 20e6}, "ground.k0"),
    "stack": ({"kind": "layered", "coupling": "interface", "layers": [{"k0": 4e7, "k1": 1e7}, {"k0": 3e7, "k1": 1e7}]},
              "ground.layers[2].k0"),
    "soil": ({"kind": "vlasov", "gamma": 1.5, "layers": [SAND, {**SAND, "E": 60e6}]}, "ground.layers[1].E"),
}  # fmt: skip


def changed(ground: dict[str, Any], name: str, factor: float) -> dict[str, Any]:
    """Return a ground with one of its constants multiplied."""
    if "[" not in name:
        key = name.removeprefix("ground.")
        return {**ground, key: factor * ground[key]}
    number, key = int(name.split("[")[1].split("]")[0]) - 1, name.split(".")[-1]
    layers = [{**layer, key: factor * layer[key]} if i == number else layer for i, layer in enumerate(ground["layers"])]
    return {**ground, "layers": layers}


@pytest.mark.parametrize(("ground", "name"), GROUNDS.values(), ids=list(GROUNDS))
def test_a_factor_over_the_plan_is_a_zone_of_other_soil(ground: dict[str, Any], name: str) -> None:
    """Twice the constant where x > 0: the same as a zone that is described with it."""
    base = model(ground=ground, mesh={"counts": (24, 18), "symmetry": "off"})
    variants = driver.Variants(base)
    (found,) = variants.solve_combinations(base, {name: lambda x, _: np.where(x > 0, 2.0, 1.0)}).results.values()
    zone = {
        "shape": {"kind": "rectangle", "x": (0.0, 4.8), "y": (-3.6, 3.6)},
        "ground": changed(ground, name, 2.0),
    }
    (wanted,) = driver.solve_combinations(base.replace(soil_zones=[zone])).results.values()
    # where springs change nodes stand for both sides, and section forces have patches on each
    of_springs = ground["kind"] == "winkler"
    nodes = nodes_at(wanted.plate, found.plate.nodes)
    assert found.certificate.holds
    for field in ("settlement", "gap", "pressure", "moment_x", "shear_y"):
        one, other = getattr(found.plate, field), getattr(wanted.plate, field)[nodes]
        away = np.abs(found.plate.nodes[:, 0]) > (1.0 if of_springs and field not in ("settlement", "gap") else -1.0)
        np.testing.assert_allclose(one[away], other[away], rtol=0, atol=1e-8 * np.abs(other).max())
    np.testing.assert_array_equal(found.plate.in_contact, wanted.plate.in_contact[nodes])
    assert found.constants.k0 == pytest.approx(wanted.constants.k0, rel=1e-12)
    assert np.ptp(found.plate.settlement - found.plate.settlement[::-1]) > 1e-4


def test_a_factor_over_the_plan_puts_symmetry_aside() -> None:
    """A base case that was solved by its quarter does not make a field symmetric."""
    variants = driver.Variants(model())
    (found,) = variants.solve_combinations(model(), {"ground.k0": lambda x, y: 1 + 0.05 * x + 0.1 * y}).results.values()
    assert found.symmetry == (False, False)
    assert found.certificate.holds
    left, right = (found.plate.value_at("settlement", x, 0.0) for x in (-4.0, 4.0))
    assert left > right + 1e-4


@pytest.mark.parametrize("name", ["ground.k", "ground.layers[1].E", "ground.gamma", "plate.E", "nonsense"])
def test_a_factor_of_what_the_ground_has_not(name: str) -> None:
    """It is named, with what there could be."""
    variants = driver.Variants(model())
    with pytest.raises(InputError, match=r"ground of kind pasternak"):
        variants.solve_combinations(model(), {name: lambda x, _: x})


def test_combinations_with_the_same_factors_are_solved_once() -> None:
    """Three of four combinations say the same, in any order of cases: two analyses, the results under each name."""
    cases = [{"name": "G"}, {"name": "Q", "action": "variable"}]
    both = {"G": 1.0, "Q": 1.0}
    combinations = [
        {"name": "one", "limit_state": "characteristic", "factors": both},
        {"name": "other", "factors": {"G": 1.35, "Q": 1.5}},
        {"name": "two", "limit_state": "frequent", "factors": dict(reversed(both.items()))},
        {"name": "three", "limit_state": "quasi-permanent", "factors": both},
    ]
    loads = [{**LOADS[0], "case": "G"}, {"kind": "uniform", "q": 5e3, "case": "Q"}]
    given = model(cases=cases, combinations=combinations, loads=loads)
    begun: list[str] = []
    with patch.object(run, "solve_task", wraps=run.solve_task) as solved:
        combined = driver.solve_combinations(given, None, lambda each: begun.append(each.name))
    assert [call.args[2].name for call in solved.call_args_list] == ["one", "other"]
    assert begun == list(combined.results) == ["one", "other", "two", "three"]
    one, two, three = (combined[name] for name in ("one", "two", "three"))
    assert two.plate is one.plate
    assert three.certificate is one.certificate
    reported = [(each.combination, each.limit_state, each.factors) for each in (one, two, three)]
    assert reported == [
        ("one", "characteristic", (("G", 1.0), ("Q", 1.0))),
        ("two", "frequent", (("Q", 1.0), ("G", 1.0))),
        ("three", "quasi-permanent", (("G", 1.0), ("Q", 1.0))),
    ]
    same(two, driver.solve(given.replace(combinations=combinations[2:3])))


def test_combinations_with_the_same_factors_are_refused_alike() -> None:
    """What has no equilibrium under one name has none under the other, and is tried once."""
    cases = [{"name": "up"}]
    combinations = [{"name": name, "factors": {"up": 1.0}} for name in ("one", "two")]
    given = model(cases=cases, combinations=combinations, loads=[{"kind": "uniform", "q": -1e3, "case": "up"}])
    with patch.object(run, "solve_task", wraps=run.solve_task) as solved:
        combined = driver.solve_combinations(given)
    assert solved.call_count == 1
    assert all(isinstance(each, NoEquilibrium) for each in combined.refused.values())
    assert list(combined.refused) == ["one", "two"]


def test_loads_follow_the_walls_on_which_they_act() -> None:
    """A wall at another place on the same mesh, with the same load."""

    def slab(y: float) -> Model:
        return Model(
            plate={"length_x": 6.0, "length_y": 6.0, "thickness": 0.3, "E": 30e9, "nu": 0.2},
            ground={"kind": "winkler", "k": 1e7},
            walls=[{"name": "W", "thickness": 0.25, "points": [(-2.0, y), (2.0, y)]}],
            loads=[{"kind": "line", "wall": "W", "q": 1e5}, {"kind": "uniform", "q": 1e4}],
            mesh={"size": 0.5, "symmetry": "off"},
        )

    alone, found = driver.solve(slab(1.0)), driver.Variants(slab(0.0)).solve_combinations(slab(1.0))
    assert np.array_equal(found.only.plate.nodes, alone.only.plate.nodes)
    assert found.only.plate.settlement == pytest.approx(alone.only.plate.settlement, rel=1e-9)
