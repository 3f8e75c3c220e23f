"""The converged state of one mesh, before it is turned into results."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from groundslab.arrays import Array
from groundslab.fem.bearings import Bearings, Contact
from groundslab.fem.foundation import Column
from groundslab.fem.hanging import carry
from groundslab.fem.problem import TOP
from groundslab.fem.system import System


@dataclass(frozen=True, slots=True)
class Pressed:
    """What c cells of an elastic continuum carry, and how far the plate is off."""

    force: Array  # (c,) [N]
    gap: Array  # (c,) [m]: below zero where the plate has sunk into ground that yields


@dataclass(frozen=True, slots=True)
class Solution:
    """A converged state of one mesh: unknowns as a table (n, F), contact, ground, and how gamma came about."""

    system: System
    U: Array  # (n, F)
    contact: Contact
    column: Column
    gamma: float | None
    law: Bearings  # what the bearings followed, settlements and earlier slip included
    slip: Array  # (c,) [m]: how far each bearing has slipped at its capacity, all increments together
    gamma_change: float = 0.0  # relative, of one more step
    gamma_slope: float = 0.0  # of the step's outcome over gamma
    gamma_iterations: int = 0
    pressed: Pressed | None = None  # what the cells of an elastic continuum carry

    def without_unknowns(self, system: System) -> Solution:
        """Return it without its unknowns and loads, the system being that of the same mesh without loads."""
        none = np.zeros(0)
        return replace(self, system=system, U=none[:, None], contact=replace(self.contact, u=none))

    def scale_forces(self, factor: float) -> Solution:
        """Return it with the forces and gaps times a factor."""
        pressed = self.pressed
        if pressed is not None:
            pressed = Pressed(factor * pressed.force, factor * pressed.gap)
        return replace(self, contact=replace(self.contact, force=factor * self.contact.force), pressed=pressed)

    def nodes_in(self, *states: int) -> Array:
        """Return -1.0 at the nodes where the ground is in one of some states (see contact), else 1.0, (n,)."""
        problem = self.system.problem
        ground = problem.contact.bearing.field == TOP
        field = np.ones(len(problem.mesh.nodes))
        field[problem.contact.bearing.node[ground & np.isin(self.contact.state, states)]] = -1.0
        return carry(problem.mesh.elements, field)
