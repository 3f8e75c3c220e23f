"""What a load step on one mesh is, whatever the ground."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from groundslab.analysis.mesh_hierarchy import Level
from groundslab.arrays import Array
from groundslab.fem.system import System
from groundslab.results.records import Step

OnStep = Callable[[Step], None]


@dataclass(frozen=True, slots=True)
class LoadStep:
    """A share of the load on one mesh, to be solved after the increments before it."""

    system: System
    level: Level
    factor: float  # share of the load
    slip: Array  # (c,) [m]: plastic slip of the bearings in the increments before
    finest: bool
    max_iterations: int  # of contact
    report: OnStep
    gamma: float | None = None  # known from another mesh, not to be found
    coarser: Level | None = None  # whose plate bends about as that of the level, for less
