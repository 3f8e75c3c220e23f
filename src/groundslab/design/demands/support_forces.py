"""What supports carry against what they can: their limits, and how stiff they are alone."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.discretize.continuum.piles import pile_in_soil
from groundslab.model.ground import ContinuousGround
from groundslab.model.loads.load_cases import SERVICEABILITY
from groundslab.model.supports import AnySupport, LineSupport, Pile
from groundslab.results.records import SupportResult
from groundslab.results.results import CombinationResult

#: A force above this share of a limit has reached it.
REACHED = 1 - 1e-6
#: Least partial factor of a resistance in tension in uplift (EN 1997-1 Table A.16).
UPLIFT = 1.4
#: A force below this share of all loads is rounding.
NOTHING = 1e-9
#: A line pulls in part by thirds of its straight pieces, if these pull by more than this share of all that it carries.
PARTS, LITTLE = 3, 0.02


@dataclass(frozen=True, slots=True)
class Utilization:
    """Where a support is nearest to a limit: force and limit [N], of a line [N/m], and the place [m]."""

    force: float
    limit: float
    place: tuple[float, float]
    factor: float = 1.0  # by which the limit is smaller than the one given

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


def factors_of(support: AnySupport, limit_state: str) -> tuple[float, float]:
    """Return the partial factors of resistances in compression and in tension in a limit state.

    They are 1 but for a characteristic resistance outside serviceability. In uplift that in tension is at least 1.4 (EN
    1997-1 Table A.16).
    """
    if support.limit_is != "characteristic resistance" or limit_state in SERVICEABILITY:
        return 1.0, 1.0
    compression = support.gamma_R or 1.0
    tension = support.gamma_R_tension if isinstance(support, Pile) else compression
    return compression, max(tension, UPLIFT) if limit_state == "uplift" else tension


def utilization(described: AnySupport, support: SupportResult, limit_state: str = "") -> Utilization | None:
    """Return where a support is nearest to its limits in a combination; None without limits.

    With a limit state characteristic resistances are divided by their partial factors.
    """
    factors = factors_of(described, limit_state) if limit_state else (1.0, 1.0)
    compression, tension = (limit / factor for limit, factor in zip(limits_of(described), factors, strict=True))
    force = intensities(described, support)
    if min(compression, tension) == math.inf or not len(force):
        return None
    limits = np.where(force >= 0, compression, tension)
    node = int(np.argmax(np.abs(force) / limits))
    pulls = bool(force[node] < 0) if np.isfinite(limits[node]) else tension < compression
    limit, factor = (tension, factors[1]) if pulls else (compression, factors[0])
    x, y = support.nodes[node]
    carried = abs(float(force[node])) if np.isfinite(limits[node]) else 0.0
    return Utilization(carried, limit, (float(x), float(y)), factor)


def intensities(described: AnySupport, support: SupportResult) -> Array:
    """Return the forces at the nodes (k,) of a support [N], of a line per length [N/m], upwards positive."""
    if not isinstance(described, LineSupport):
        return support.force
    on_line = support.length > 0
    return np.divide(support.force, support.length, out=np.zeros(len(on_line)), where=on_line)


def thirds(lines: Array) -> Array:
    """Return the thirds (3 l, 2, 2) [m] of straight lines (l, 2, 2)."""
    ways = np.arange(PARTS + 1) / PARTS
    at = lines[:, None, 0] + ways[:, None] * (lines[:, None, 1] - lines[:, None, 0])
    return np.stack([at[:, :-1], at[:, 1:]], axis=2).reshape(-1, 2, 2)


def pull_in_part(parts: Array, places: Array, forces: Array, at_once: Array | float = 0.0) -> float:
    """Return the force [N] by which parts of lines pull, as thirds do, in all.

    Parts (p, 2, 2) [m] carry the upward forces (k,) [N] at places (k, 2) [m] that are nearest to them, and what comes
    to them at once (p,) [N]. They are no shorter, as a rigid line pulls at its very ends and corners. What pulls less
    than a share of all forces is nothing.
    """
    from shapely import distance, linestrings, points

    if not len(places):
        return 0.0
    nearest = np.argmin(distance(points(places)[:, None], linestrings(parts)[None]), axis=1)
    sums = np.bincount(nearest, forces, len(parts)) + at_once
    pull = -float(sums.clip(max=0).sum())
    return pull if pull > LITTLE * float(np.abs(sums).sum()) else 0.0


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
