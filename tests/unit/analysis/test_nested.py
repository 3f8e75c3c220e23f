"""Nested meshes: what is given back before the next one is factorized; combinations that are multiples of others."""

from __future__ import annotations

import weakref
from typing import Any
from unittest.mock import patch

import numpy as np
import pytest

from groundslab.analysis import driver, mesh_hierarchy, nested
from groundslab.analysis.load_step import LoadStep
from groundslab.analysis.tasks import run
from groundslab.errors import NeutralEquilibrium
from groundslab.fem.system import System
from groundslab.model.model import Model
from groundslab.results.records import Step
from groundslab.results.results import Results
from groundslab.solvers.direct.protocols import Solver
from groundslab.solvers.factor_reuse import CachedFactorization, ConstrainedSystem
from groundslab.solvers.solution import Solution


def test_a_coarser_factor_is_gone_before_the_finest_one_is_made() -> None:
    """Of one combination the finest mesh has the memory for itself, without waiting for a search for garbage."""
    model = Model(
        plate={"length_x": 6.0, "length_y": 4.0, "thickness": 0.2, "E": 30e9, "nu": 0.2},
        ground={"kind": "winkler", "k": 30e6},
        loads=[{"kind": "patch", "q": 900e3, "x": (-0.8, 0.8), "y": (-0.8, 0.8)}],
        mesh={"counts": (24, 16)},
    )
    made: list[weakref.ref[CachedFactorization]] = []
    alive: list[int] = []
    make, factorize = mesh_hierarchy.make_factorization, CachedFactorization.factorize

    def noted(solver: Solver, s: System) -> CachedFactorization:
        made.append(weakref.ref(found := make(solver, s)))
        return found

    def counted(self: CachedFactorization, system: ConstrainedSystem, beside: bool = False) -> None:
        if made and self is made[-1]():
            alive.append(sum(each() is not None for each in made))
        factorize(self, system, beside)

    with (
        patch.object(mesh_hierarchy, "make_factorization", noted),
        patch.object(CachedFactorization, "factorize", counted),
    ):
        driver.solve(model)
    assert len(made) > 1
    assert set(alive) == {1}


def lifting(contact: dict[str, Any]) -> Model:
    """Return a weightless slab that lifts off under a force, which three of four combinations hold alone."""
    factors = {"char": {"a": 1.0}, "both": {"a": 1.0, "b": 1.0}, "uls": {"a": 1.5}, "tenth": {"a": 0.1}}
    force = {"kind": "point", "P": 200e3, "width_x": 0.4, "width_y": 0.4}
    return Model(
        plate={"length_x": 6.0, "length_y": 4.0, "thickness": 0.2, "E": 30e9, "nu": 0.2},
        ground={"kind": "vlasov", "layers": [{"E": 20e6, "nu": 0.3, "thickness": 3.0}]},
        beyond={"kind": "infinite"},
        contact={"tensionless": True} | contact,
        cases=[{"name": "a"}, {"name": "b"}],
        combinations=[{"name": name, "factors": each} for name, each in factors.items()],
        loads=[force | {"x": -2.0, "y": 1.0, "case": "a"}, force | {"x": 2.0, "y": -1.0, "case": "b"}],
        mesh={"counts": (24, 16)},
    )


def test_multiples_of_solved_loads_take_one_step() -> None:
    """On each mesh, after one another; what they give is what a factor makes of the first, and they are in order."""
    steps: dict[str, list[Step]] = {}
    model = lifting({})
    with patch.object(run, "MAX_LANES", 1):
        results = driver.solve(
            model,
            on_step=lambda step: [*steps.values()][-1].append(step),
            on_combination=lambda one: steps.update({one.name: []}),
        )
    assert [*steps] == ["char", "uls", "tenth", "both"]
    assert [*results] == ["char", "both", "uls", "tenth"]
    for name in ("uls", "tenth"):
        assert [step.iteration for step in steps[name]] == [1] * len({step.unknowns for step in steps["char"]})
    assert len(steps["char"]) > 2 * len(steps["uls"])
    for name, factor in (("uls", 1.5), ("tenth", 0.1)):
        assert results[name].constants.gamma == results["char"].constants.gamma
        for field in ("settlement", "moment_x", "pressure"):
            first = getattr(results["char"].plate, field)
            own = getattr(results[name].plate, field)
            np.testing.assert_allclose(own, factor * first, rtol=0, atol=1e-8 * factor * np.abs(first).max())
        effects = [results[each].certificate.margin_effect for each in (name, "char")]
        assert effects[0] == pytest.approx(effects[1], rel=1e-6)


def test_a_gap_makes_no_multiples() -> None:
    """The slab touches less of the ground that dips where a tenth presses; each is what it is alone."""
    model = lifting({"gaps": [{"x": x, "y": 0.0, "gap": gap} for x, gap in ((-2.0, 1e-3), (0.0, 0.0), (2.0, 0.0))]})
    results = driver.solve(model)
    assert results["tenth"].plate.contact_area.sum() < results["char"].plate.contact_area.sum()
    for name in ("uls", "tenth"):
        alone = [each for each in model.combinations if each.name == name]
        (own,) = driver.solve(model.model_copy(update={"combinations": tuple(alone)})).values()
        together = results[name].plate.settlement
        np.testing.assert_allclose(own.plate.settlement, together, rtol=0, atol=1e-6 * together.max())


def test_lanes_have_multiples_together() -> None:
    """However many lanes there are, and as many tasks each as can be."""
    tasks = [
        run.Task(factors, False, False) for factors in ((1.0, 0.0), (0.0, 1.0), (1.5, 0.0), (1.0, 0.7), (1.5, 1.05))
    ]
    a, b, more_a, c, more_c = tasks
    assert run._distribute(tasks, 1) == [[a, more_a, b, c, more_c]]
    assert run._distribute(tasks, 2) == [[a, more_a], [b, c, more_c]]
    assert run._distribute([a, more_a], 2) == [[a, more_a]]
    lasting = run.Task((1.5, 0.0), cracks=False, lasting=True)
    assert run._distribute([a, lasting], 2) == [[a], [lasting]], "on other ground"


def test_few_steps_refuse_nothing() -> None:
    """A plate that nothing seems to hold after the few steps that are tried is solved with all steps."""
    limits: list[int] = []
    solve_increments = nested._solve_increments

    def floating_at_first(full: LoadStep, *arguments: Any) -> list[Solution]:
        limits.append(full.max_iterations)
        if full.max_iterations == nested.FEW_STEPS:
            raise NeutralEquilibrium("nothing holds it")
        return solve_increments(full, *arguments)

    model = lifting({})
    shown: list[Results] = []
    with patch.object(nested, "_solve_increments", floating_at_first):
        driver.solve(model.model_copy(update={"mesh": model.mesh.replace(counts=None)}), on_mesh=shown.append)
    assert [*shown[0]] == ["char", "both", "uls", "tenth"]
    assert not shown[0].refused
    assert nested.FEW_STEPS in limits
    assert model.analysis.max_iterations in limits
