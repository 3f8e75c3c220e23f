"""The energy of which discretization errors are shares: a norm, whatever lies beside the plate."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from groundslab import Model, solve
from groundslab.accuracy.energy import energy
from groundslab.analysis.mesh_hierarchy import MeshHierarchy
from groundslab.analysis.nested import solve_nested
from groundslab.solvers import factorization

LAYER = {"E": 10e6, "nu": 0.45, "thickness": 3.0}
BESIDE = {"kind": "area", "on": "ground", "q": 300e3}


def slab(**keys: Any) -> Model:
    """Return a slab of 4 m x 4 m on a layer of an elastic continuum."""
    usual = {
        "plate": {"length_x": 4.0, "length_y": 4.0, "thickness": 0.2, "E": 30e9, "nu": 0.2},
        "ground": {"kind": "continuum", "layers": [LAYER]},
        "beyond": {"kind": "infinite"},
        "loads": [{"kind": "self weight", "unit_weight": 25e3}],
        "mesh": {"size": 0.5},
    }
    return Model.model_validate(usual | keys)


def test_slab_lifted_by_a_load_beside_it() -> None:
    """A silo beside a slab heaves it: the loads' work on it is negative, its error in energy a share between 0 and 1.

    The silo's pressure reaches into an element at the slab's edge, and is no load of the slab, which is 80 kN.
    """
    silo = BESIDE | {"shape": {"kind": "circle", "centre": (-5.5, 0.0), "radius": 3.0}}
    results = solve(slab(loads=[{"kind": "self weight", "unit_weight": 25e3}, silo])).only
    assert results.certificate.holds
    assert results.certificate.load == pytest.approx(80e3, rel=1e-12)
    assert results.plate.settlement @ results.plate.area < 0
    assert results.comparison is not None
    assert 0 < results.comparison.energy_error < 0.05
    assert np.isfinite(results.elements.discretization_error).all()


@pytest.mark.parametrize("ground", [{"kind": "continuum", "layers": [LAYER]}, {"kind": "winkler", "k": 2e7}])
def test_energy_is_the_work_of_the_loads(ground: dict[str, Any]) -> None:
    """Without loads beside the plate twice the strain energy is what the loads work on their ways (Clapeyron)."""
    model = slab(ground=ground, contact={"tensionless": False}, loads=[{"kind": "point", "P": 1e5, "x": 1.0, "y": 0.5}])
    _, solver = factorization.choose("auto")
    found = solve_nested(MeshHierarchy(model, solver, 0, 1.0, False), "", np.array([1.0]), lambda _: None)
    solution = found[0][-1]
    load = solution.system.problem.load
    assert energy(solution) == pytest.approx(float((load * solution.U).sum()), rel=1e-6)
