"""Pressures of coarser cells on finer ones: exact where they are linear, each plate's from its own cells."""

from __future__ import annotations

from typing import Any

import numpy as np

from groundslab.arrays import Array
from groundslab.discretize.discretize import discretize
from groundslab.fem.continuum.cells import Cells, prolong
from groundslab.model.model import Model

GROUND = {"kind": "continuum", "layers": [{"E": 20e6, "nu": 0.3, "thickness": 6.0}]}


def _cells(coarsening: int, plate: dict[str, Any], **parts: Any) -> Cells:
    """Return the cells under plates."""
    concrete = {"thickness": 0.3, "E": 30e9, "nu": 0.2}
    others = [{**concrete, **each} for each in parts.pop("plates", [])]
    model = Model.model_validate({
        "plate": {**concrete, **plate}, "plates": others, "ground": GROUND, "mesh": {"size": 0.5},
        "loads": [{"kind": "uniform", "q": 1e3}], **parts,
    })  # fmt: skip
    elastic = discretize(model, coarsening).elastic
    assert elastic is not None
    return elastic.cells


def _linear(cells: Cells) -> Array:
    """Return pressures (c,) that are linear over the plan."""
    x, y = cells.center.T
    return 3.0 + 0.5 * x - 0.25 * y


def test_linear_pressures_are_exact_between_centers() -> None:
    """Between the outermost centers of coarser cells."""
    coarse, fine = (_cells(level, {"length_x": 8.0, "length_y": 6.0}) for level in (1, 0))
    found = prolong(coarse, _linear(coarse) * coarse.area, fine) / fine.area
    inside = (np.abs(fine.center) <= np.abs(coarse.center).max(axis=0)).all(axis=1)
    assert 0.5 < inside.mean() < 1.0
    np.testing.assert_allclose(found[inside], _linear(fine)[inside], rtol=1e-12)


def test_even_pressures_stay_even_up_to_a_curved_edge() -> None:
    """Cells that the plate does not cover take nothing away from those beside them."""
    circle = {"outline": {"kind": "circle", "radius": 4.0}}
    coarse, fine = (_cells(level, circle) for level in (1, 0))
    np.testing.assert_allclose(prolong(coarse, 2.0 * coarse.area, fine), 2.0 * fine.area, rtol=1e-12)


def test_each_plate_has_pressures_of_its_own() -> None:
    """Two plates side by side, one of them without pressure, in cells that both cover, too."""
    one = {"name": "one", "outline": {"kind": "rectangle", "x": [0.0, 4.1], "y": [0.0, 4.0]}}
    other = {"name": "other", "outline": {"kind": "rectangle", "x": [4.15, 8.0], "y": [0.0, 4.0]}}
    coarse, fine = (_cells(level, one, plates=[other]) for level in (1, 0))
    found = prolong(coarse, np.where(coarse.plate == 0, coarse.area, 0.0), fine)
    np.testing.assert_allclose(found, np.where(fine.plate == 0, fine.area, 0.0), rtol=1e-12)
    assert set(fine.plate) == {0, 1}


def test_tension_over_open_gaps_ends_pressure_between_centers() -> None:
    """A linear pressure that changes its sign at x = 1.1 ends there, not at the next of the coarser centers."""
    coarse, fine = (_cells(level, {"length_x": 8.0, "length_y": 6.0}) for level in (1, 0))
    found = prolong(coarse, (1.1 - coarse.center[:, 0]) * coarse.area, fine)
    assert ((found > 0) == (fine.center[:, 0] < 1.1)).all()
