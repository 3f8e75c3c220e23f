"""What supports carry against what they can: their limits, and how stiff they are alone."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.discretize.continuum.piles import pile_in_soil
from groundslab.model.ground import ContinuousGround
from groundslab.model.supports import AnySupport, LineSupport, Pile
from groundslab.results.record import SupportResult
from groundslab.results.results import CombinationResult

#: A force above this share of a limit has reached it.
REACHED = 1 - 1e-6
#: A force below this share of all loads is rounding.
NOTHING = 1e-9


@dataclass(frozen=True, slots=True)
class Utilization:
    """Where a support is nearest to a limit: force and limit [N], of a line [N/m], and the place [m]."""

    force: float
    limit: float
    place: tuple[float, float]

    @property
    def share(self) -> float:
        """Return the force over the limit."""
        return self.force / self.limit

    @property
    def reached(self) -> bool:
        """Whether the support stands at its limit."""
        return self.share >= REACHED


def limits_of(support: AnySupport) -> tuple[float, float]:
    """Return the limits in compression and in tension [N], of a line [N/m]; infinite where there is none."""
    limit = math.inf if support.limit is None else support.limit
    if isinstance(support, Pile):
        return limit, support.limit_tension or math.inf
    return (math.inf, limit) if support.acts == "in tension" else (limit, math.inf)


def utilization(described: AnySupport, support: SupportResult) -> Utilization | None:
    """Return where a support is nearest to its limits in a combination; None without limits."""
    compression, tension = limits_of(described)
    force = intensities(described, support)
    if min(compression, tension) == math.inf or not len(force):
        return None
    limits = np.where(force >= 0, compression, tension)
    node = int(np.argmax(np.abs(force) / limits))
    limit = float(limits[node]) if np.isfinite(limits[node]) else min(compression, tension)
    x, y = support.nodes[node]
    carried = abs(float(force[node])) if np.isfinite(limits[node]) else 0.0
    return Utilization(carried, limit, (float(x), float(y)))


def intensities(described: AnySupport, support: SupportResult) -> Array:
    """Return the forces at the nodes (k,) of a support [N], of a line per length [N/m], upwards positive."""
    if not isinstance(described, LineSupport):
        return support.force
    on_line = support.length > 0
    return np.divide(support.force, support.length, out=np.zeros(len(on_line)), where=on_line)


def idle(results: CombinationResult, support: SupportResult) -> Flags:
    """Return at which nodes (k,) a support carries nothing."""
    nothing: Flags = np.abs(support.force) <= NOTHING * max(abs(results.certificate.load), np.finfo(float).tiny)
    return nothing


def stiffness_alone(results: CombinationResult, described: AnySupport, support: SupportResult) -> float | None:
    """Return the force over the settlement [N/m] of a support without its neighbors; None if it is rigid.

    That of a pile follows from the soil along it (Randolph and Wroth 1978); that of a line is of all its length.
    """
    if isinstance(described, Pile):
        model = results.model
        ground = (model.with_lasting_ground() if model.lasts(results.limit_state) else model).ground
        assert isinstance(ground, ContinuousGround)
        return pile_in_soil(described, ground).head_stiffness
    if described.stiffness is None or not isinstance(described, LineSupport):
        return described.stiffness
    return described.stiffness * float(support.length.sum())
