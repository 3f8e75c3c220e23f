"""The converged state of one mesh, before it is turned into results."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from groundslab.contact import Contact
from groundslab.ground import Column
from groundslab.problem import TOP, System
from groundslab.shape import Array


@dataclass(frozen=True, slots=True)
class Solution:
    """A converged state of one mesh: unknowns as a table (n, F), contact, ground, and how gamma came about."""

    system: System
    U: Array  # (n, F)
    contact: Contact
    column: Column
    gamma: float | None
    gamma_change: float  # relative, of one more step
    gamma_slope: float  # of the step's outcome over gamma
    gamma_iterations: int

    @property
    def closed(self) -> Array:
        """Return a nodal field (n,) that is negative where the plate touches and positive where it gapes."""
        problem = self.system.problem
        field = np.zeros(len(problem.mesh.nodes))
        force, gap = self.contact.force, self.U[problem.plate_nodes, TOP]
        per_force, per_gap = 1 / max(force.max(initial=0), 1e-300), 1 / max(gap.max(initial=0), 1e-300)
        field[problem.plate_nodes] = np.where(self.contact.closed, -np.maximum(force * per_force, 1e-12), gap * per_gap)
        return field
