"""How a plate bends under forces of cells and supports, about, by the factor of a coarser mesh under the same cells.

Deflections under forces of single cells are smooth: a mesh of elements several times as large gives them well, at a
fraction of the cost of a substitution.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem.continuum.cells import Cells
from groundslab.fem.hanging import connect
from groundslab.fem.mesh import locate_nearest
from groundslab.fem.problem import Problem, W
from groundslab.fem.shape_functions import q9_values
from groundslab.solvers.plate_on_continuum import PlateOnContinuum

if TYPE_CHECKING:
    from scipy.sparse import csr_array


@dataclass(frozen=True, slots=True)
class CoarserPlate:
    """A plate on a coarser mesh, and where c + b forces of a finer one act on it."""

    plate: PlateOnContinuum
    C: csr_array  # (size, c + b)

    def bend(self, x: Array) -> Array:
        """Return about C^T K^+ C x (c + b,) for forces x (c + b,) in equilibrium."""
        bent: Array = self.C.T @ self.plate.solve(self.C @ x)
        return bent


def make_coarser_plate(plate: PlateOnContinuum, coarse: Problem, problem: Problem) -> CoarserPlate:
    """Return a plate on the mesh of a coarser problem under the cells and supports of another."""
    from scipy.sparse import csr_array, hstack

    assert problem.elastic is not None
    pressed = _press_centers(coarse, problem.elastic.cells, plate.A.size)
    same = _find_supports(coarse, problem)
    pushed = (
        plate.C[:, plate.C.shape[1] - len(coarse.contact.bearing.law) :][:, np.maximum(same, 0)] if len(same) else None
    )
    if pushed is None:
        return CoarserPlate(plate, pressed)
    return CoarserPlate(plate, csr_array(hstack([pressed, pushed.multiply((same >= 0)[None, :])])))


def _press_centers(coarse: Problem, cells: Cells, size: int) -> csr_array:
    """Return what forces at the centers of cells do to the unknowns of a coarser plate, (size, c)."""
    from scipy.sparse import csr_array

    mesh = coarse.mesh
    element, place = locate_nearest(mesh, cells.center, coarse.plate.elements)
    elements, which = np.unique(element, return_inverse=True)
    w = coarse.plate.element.w_functions(mesh.nodes[mesh.elements[elements]])[which]
    moving, kind, P, _ = connect(mesh.elements)
    share = np.einsum("ca,cab,cbd->cd", q9_values(place), w, P[kind[element]], optimize=True)
    unknown = coarse.unknown[moving[element], W]
    cell = np.broadcast_to(np.arange(len(cells.area))[:, None], unknown.shape)
    mask = unknown >= 0
    return csr_array((-share[mask], (unknown[mask], cell[mask])), shape=(size, len(cells.area)))


def _find_supports(coarse: Problem, problem: Problem) -> Integers:
    """Return for each force of a support (b,) which one of the coarser mesh is nearest to it, -1 if there is none."""
    b, coarser = problem.contact.bearing, coarse.contact.bearing
    nearest = np.full(len(b.law), -1)
    for i, (number, field) in enumerate(zip(b.support, b.field, strict=True)):
        alike = np.flatnonzero((coarser.support == number) & (coarser.field == field))
        if len(alike):
            offset = coarse.mesh.nodes[coarser.node[alike]] - problem.mesh.nodes[b.node[i]]
            nearest[i] = alike[np.argmin(np.hypot(*offset.T))]
    return nearest
