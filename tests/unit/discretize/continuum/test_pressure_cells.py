"""Cells of pressure of a model: their size, gaps, voids and limits."""

from __future__ import annotations

import math
from typing import Any
from unittest.mock import patch

import numpy as np
import pytest

from groundslab import InputError, Model
from groundslab.discretize.continuum import pressure_cells
from groundslab.discretize.discretize import discretize
from groundslab.fem.continuum.elastic_ground import ElasticGround

PLATE = {"length_x": 6.0, "length_y": 4.0, "thickness": 0.4, "E": 3e10, "nu": 0.2}
HALF_SPACE = {"kind": "continuum", "half_space": {"E": 2e7, "nu": 0.3}}


def ground_of(coarsening: int = 0, **changes: Any) -> ElasticGround:
    """Return the elastic continuum of a plate of 6 x 4 m."""
    model = Model(
        **{
            "plate": PLATE,
            "ground": HALF_SPACE,
            "loads": [{"kind": "uniform", "q": 2e4}],
            "mesh": {"counts": (12, 8)},
            **changes,
        },
    )
    found = discretize(model, coarsening).elastic
    assert found is not None
    return found


def test_other_grounds_have_no_cells():
    """Springs bear at nodes."""
    model = Model(
        plate=PLATE,
        ground={"kind": "winkler", "k": 2e7},
        loads=[{"kind": "uniform", "q": 2e4}],
        mesh={"counts": (12, 8)},
    )
    assert discretize(model).elastic is None


@pytest.mark.parametrize(("coarsening", "n"), [(0, (24, 16)), (1, (12, 8)), (2, (6, 4))])
def test_cells_are_half_as_large_as_elements(coarsening, n):
    """Two cells a side of each element, on every one of the nested meshes."""
    grid = ground_of(coarsening).cells.grid
    assert (grid.nx, grid.ny) == n


@pytest.mark.parametrize(("coarsening", "n"), [(0, (60, 40)), (1, (30, 20)), (2, (15, 10))])
def test_given_cells_double_with_each_coarser_mesh(coarsening, n):
    """So that two meshes show what the cells' size is worth."""
    grid = ground_of(coarsening, ground={**HALF_SPACE, "cell": 0.1}).cells.grid
    assert (grid.nx, grid.ny) == n


def test_more_cells_than_allowed_are_refused_before_they_are_made():
    """Names the key, the number of cells and what to do."""
    with pytest.raises(InputError) as error:
        ground_of(ground={**HALF_SPACE, "cell": 0.004})
    (issue,) = error.value.issues
    assert issue.location == "ground.cell"
    assert issue.found == "1500 x 1000 cells of pressure"
    assert issue.expected == "at most 1,000,000 cells"
    with patch.object(pressure_cells, "MOST_CELLS", 24 * 16):
        assert len(ground_of().cells.number) == 24 * 16


def test_gaps_are_given_at_places():
    """A gap everywhere and one that varies are added up at the centers of cells."""
    gaps = [{"x": x, "y": y, "gap": 1e-3 * (x + 3)} for x in (-3.0, 3.0) for y in (-2.0, 2.0)]
    ground = ground_of(contact={"gap": 5e-3, "gaps": gaps})
    assert ground.gap == pytest.approx(5e-3 + 1e-3 * (ground.cells.center[:, 0] + 3), rel=1e-9)


def test_voids_and_cavities():
    """Cells within a void begin deeper, those over a cavity bear nothing, others as much as the limit allows."""
    voids = [
        {"x": (-3.0, -2.0), "y": (-2.0, 2.0), "depth": 4e-3},
        {"x": (-2.5, -2.0), "y": (-2.0, 2.0), "depth": 7e-3},
        {"x": (1.0, 2.0), "y": (-1.0, 1.0)},
    ]
    ground = ground_of(contact={"voids": voids, "limit_pressure": 3e5})
    x, y = ground.cells.center.T
    cavity = (x > 1) & (x < 2) & (np.abs(y) < 1)
    assert ground.gap == pytest.approx(np.where(x < -2.5, 4e-3, np.where(x < -2, 7e-3, 0.0)))
    assert ground.limit_force == pytest.approx(np.where(cavity, 0.0, 3e5 * 0.25**2))


def test_without_a_limit_cells_bear_any_force():
    """Their limit is infinite."""
    assert np.isinf(ground_of().limit_force).all()


def test_a_void_between_the_centers_of_cells_is_refused():
    """On the finest mesh, with all of those that are lost; a coarser one may lose it."""
    voids = [{"x": (0.01, 0.05), "y": (0.01, 0.05)}, {"x": (1.0, 2.0), "y": (-1.0, 1.0)}]
    with pytest.raises(InputError) as error:
        ground_of(contact={"voids": voids})
    (issue,) = error.value.issues
    assert issue.location == "contact.voids[1]"
    assert "ground.cell" in issue.hint
    assert not ground_of(1, contact={"voids": [{"x": (0.3, 0.45), "y": (0.3, 0.45), "depth": 1e-3}]}).gap.any()


def test_cells_lie_under_the_plate_alone():
    """Not under openings, nor under ground beyond that is shown."""
    ground = ground_of(
        plate={**PLATE, "openings": [{"kind": "rectangle", "x": (0.0, 2.0), "y": (-1.0, 1.0)}]},
        mesh={"size": 0.5},
        beyond={"kind": "infinite", "width": 2.0},
    )
    assert ground.cells.area.sum() == pytest.approx(20.0)
    assert (np.abs(ground.cells.center) < [3.0, 2.0]).all()
    assert math.isclose(ground.cells.grid.dx, 0.25)
