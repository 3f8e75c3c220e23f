"""Nested meshes: what is no longer needed of the coarser ones is given back before the next one is factorized."""

from __future__ import annotations

import weakref
from unittest.mock import patch

from groundslab.analysis import driver, mesh_hierarchy
from groundslab.fem.system import System
from groundslab.model.model import Model
from groundslab.solvers.direct.protocols import Solver
from groundslab.solvers.factor_reuse import CachedFactorization, ConstrainedSystem


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
