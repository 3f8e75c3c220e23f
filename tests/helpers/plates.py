"""Plate results made of formulas on meshes of every kind, for tests of what is read from them; nothing is solved."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from groundslab.fem.load_vectors import nodal_area
from groundslab.fem.mesh import Mesh
from groundslab.results.fields import PLATE_FIELDS
from groundslab.results.plate_result import PlateResult
from helpers.quads import mesh as crooked_mesh

#: A function of x and y, or values at the nodes, or one value for all.
Formula = Callable[[np.ndarray, np.ndarray], np.ndarray] | np.ndarray | float


def plate_of(mesh: Mesh, **formulas: Formula) -> PlateResult:
    """Return a plate on a mesh whose fields are given by formulas, the others zero."""
    x, y = mesh.nodes.T
    none = np.zeros(len(x))
    values = dict.fromkeys(PLATE_FIELDS, none)
    for name, formula in formulas.items():
        values[name] = none + (formula(x, y) if callable(formula) else formula)
    on = np.zeros(len(x), dtype=bool)
    area = nodal_area(mesh, np.arange(len(mesh.elements)))
    return PlateResult(
        mesh.nodes, mesh.elements, in_contact=~on, area=area, contact_area=area, edge_length=none, **values
    )


def crooked(nx: int = 5, ny: int = 4, length_x: float = 6.0, length_y: float = 4.0, seed: int = 1) -> Mesh:
    """Return a mesh of crooked quadrilaterals on a rectangle from the origin."""
    return Mesh(*crooked_mesh(nx, ny, length_x, length_y, amount=0.2, seed=seed))


def straight(nx: int = 6, ny: int = 4, length_x: float = 6.0, length_y: float = 4.0) -> Mesh:
    """Return a mesh of rectangles on a rectangle from the origin."""
    return Mesh(*crooked_mesh(nx, ny, length_x, length_y))


def without(mesh: Mesh, x: tuple[float, float], y: tuple[float, float]) -> Mesh:
    """Return a mesh without the elements whose centres lie in a rectangle."""
    cx, cy = mesh.nodes[mesh.elements[:, 8]].T
    gone = (cx > x[0]) & (cx < x[1]) & (cy > y[0]) & (cy < y[1])
    kept, own = np.unique(mesh.elements[~gone], return_inverse=True)
    return Mesh(mesh.nodes[kept], own.reshape(-1, 9))


def parted(mesh: Mesh, x: float) -> tuple[Mesh, np.ndarray]:
    """Return a mesh whose nodes at a line x stand once for each side, and which nodes belong to the right side."""
    right = mesh.nodes[mesh.elements[:, 8], 0] > x
    n = len(mesh.nodes)
    keys, own = np.unique(mesh.elements + n * right[:, None], return_inverse=True)
    return Mesh(mesh.nodes[keys % n], own.reshape(-1, 9)), keys >= n
