"""Meshes with every element cut into four."""

from __future__ import annotations

import math

import numpy as np
import pytest

from groundslab.fem.mesh import Mesh, grid, sides_on_boundary
from groundslab.fem.shape_functions import areas
from groundslab.geometry.plan import Plan, Ring
from groundslab.meshing import mesh as mesh_plan
from groundslab.meshing.refinement import halve
from groundslab.model.shapes import Circle


def test_a_grid_becomes_the_grid_of_the_halves() -> None:
    """Every place of the finer grid is there once; nodes of the coarser mesh keep their numbers."""
    x, y = np.array([0.0, 1.0, 2.5]), np.array([5.1, 5.3, 7.0])
    coarse = grid(x, y)
    found = halve(coarse)
    finer = grid(np.sort([*x, *(x[1:] + x[:-1]) / 2]), np.sort([*y, *(y[1:] + y[:-1]) / 2]))
    assert len(found.nodes) == len(finer.nodes) == np.unique(found.elements).size
    np.testing.assert_array_equal(found.nodes[: len(coarse.nodes)], coarse.nodes)
    np.testing.assert_allclose(
        found.nodes[np.lexsort(found.nodes.round(9).T)], finer.nodes[np.lexsort(finer.nodes.round(9).T)], rtol=1e-15
    )
    assert set(found.nodes[found.nodes[:, 1].round(9) == 5.1][:, 1]) == {5.1}, "no longer straight"


def test_parts_fill_their_element() -> None:
    """The four elements of each one follow each other, and together have its area, on any quadrilaterals."""
    coarse = grid(np.linspace(0, 4, 4), np.linspace(0, 3, 3))
    coarse.nodes[:] += 0.05 * np.sin(3 * coarse.nodes[:, ::-1])
    found = halve(coarse)
    np.testing.assert_allclose(areas(found.xy).reshape(-1, 4).sum(axis=1), areas(coarse.xy), rtol=1e-12)
    assert (areas(found.xy) > 0).all()


def test_nodes_on_arcs_stay_on_them() -> None:
    """Every node on the edge of a round plate lies on its circle."""
    pytest.importorskip("gmsh", reason="GMSH IS NOT INSTALLED: no round plate was meshed")
    ring: Ring = Circle(centre=(1.0, -2.0), radius=3.0).ring()
    plan = mesh_plan(Plan(ring), 1.0)
    found = halve(Mesh(plan.nodes, plan.elements), ring.segments())
    on_edge = np.unique(sides_on_boundary(found.elements))
    radius = np.linalg.norm(found.nodes[on_edge] - [1.0, -2.0], axis=1)
    np.testing.assert_allclose(radius, 3.0, rtol=1e-12)
    assert areas(found.xy).sum() == pytest.approx(9 * math.pi, rel=1e-5)
