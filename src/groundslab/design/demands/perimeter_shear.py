"""Shear forces of a plate across a perimeter around a support, and where its moments change sign.

No code's formulas are in here. Forces are read in the middle of pieces along a perimeter and averaged over a length;
moments are read along the two axes of bars from the middle of the support.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.fem import load_vectors
from groundslab.fem.mesh import Mesh, locate
from groundslab.fem.shape_functions import q9_values, unique_integers
from groundslab.results.plate_result import PlateResult

#: Straight pieces are no longer than this over the length that is averaged.
PIECE = 1 / 8
#: Moments are read at so many places in each direction.
PLACES = 65


@dataclass(frozen=True, slots=True)
class PerimeterShear:
    """The pieces of a perimeter with the nodes that their shear forces are read from."""

    ds: Array  # (k,): lengths, in order along it [m]
    closed: bool
    middle: Array  # (k, 2): the pieces' middles [m]
    nodes: Integers  # (n,)
    inward: Array  # (2, k, n): of nodal shear_x and shear_y in the force per length inwards

    def forces(self, plate: PlateResult) -> Array:
        """Return the force per length inwards of each piece (k,) [N/m]."""
        q = np.stack([plate.shear_x[self.nodes], plate.shear_y[self.nodes]])
        return np.asarray(np.einsum("ikn,in->k", self.inward, q))

    def largest_mean(self, plate: PlateResult, over: float, sign: float = 1.0) -> float:
        """Return the largest mean of the force per length over a length [m], inwards positive or outwards [N/m]."""
        v = sign * self.forces(plate)
        total = float(self.ds.sum())
        if total <= over:
            return float(v @ self.ds / total)
        ds, v = (np.tile(values, 2) if self.closed else values for values in (self.ds, v))
        s, force = (np.concatenate([[0.0], np.cumsum(values)]) for values in (ds, v * ds))
        starts = s[s + over <= s[-1] + 1e-9 * total]
        means = (np.interp(starts + over, s, force) - np.interp(starts, s, force)) / over
        return float(means.max())


def perimeter_shear(
    plate: PlateResult, chain: Array, center: Array, over: float, factors: Callable[[Array], Array] | None = None
) -> PerimeterShear | None:
    """Return how shear forces across a chain of places (p, 2) [m] around a center (2,) are read, None off the mesh.

    They are multiplied by factors at places (k, 2), if some are given.
    """
    from shapely import box

    places = _divided(chain, over * PIECE)
    middle, run = (places[1:] + places[:-1]) / 2, np.diff(places, axis=0)
    mesh = Mesh(plate.nodes, plate.elements)
    near = load_vectors.find_elements_near(mesh, box(*middle.min(axis=0), *middle.max(axis=0)))
    element, local = locate(Mesh(mesh.nodes, mesh.elements[near]), middle)
    on = element >= 0
    if not on.any():
        return None
    ds = np.linalg.norm(run, axis=1)[on]
    across = np.stack([-run[on, 1], run[on, 0]]) / ds
    across = across * np.sign((across * (center[:, None] - middle[on].T)).sum(axis=0))
    if factors is not None:
        across = across * factors(middle[on])
    of_nodes = mesh.elements[near[element[on]]]
    nodes, which = unique_integers(of_nodes)
    inward = np.zeros((2, len(ds), len(nodes)))
    rows = np.repeat(np.arange(len(ds))[:, None], of_nodes.shape[1], axis=1)
    for axis in (0, 1):
        np.add.at(inward[axis], (rows, which.reshape(of_nodes.shape)), q9_values(local[on]) * across[axis][:, None])
    closed = bool((chain[0] == chain[-1]).all()) and bool(on.all())
    return PerimeterShear(ds, closed, middle[on], nodes, inward)


def _divided(chain: Array, longest: float) -> Array:
    """Return the places of a chain with more between those farther apart than a length [m]."""
    parts = [chain[:1]]
    for start, end in pairwise(chain):
        count = max(1, int(np.ceil(np.linalg.norm(end - start) / longest)))
        parts.append(start + np.linspace(0, 1, count + 1)[1:, None] * (end - start))
    return np.concatenate(parts)


@dataclass(frozen=True, slots=True)
class MomentLine:
    """Places along an axis of bars from the middle of a support in one direction, up to the plate's edge."""

    field: str  # the moment along the axis
    distances: Array  # (p,) from the middle [m]
    nodes: Integers  # (p, 9)
    N: Array  # (p, 9): shape functions
    at_edge: bool  # whether the plate ends there

    def zero(self, plate: PlateResult, sign: float) -> float:
        """Return where the moment, of a sign at the support, is zero first [m]; inf if nowhere.

        At the plate's edge it is zero.
        """
        m = sign * (getattr(plate, self.field)[self.nodes] * self.N).sum(axis=1)
        if not m[0] > 0:
            return np.inf
        after = np.flatnonzero(m <= 0)
        if not len(after):
            return float(self.distances[-1]) if self.at_edge else np.inf
        i = int(after[0])
        return float(np.interp(0.0, [m[i], m[i - 1]], [self.distances[i], self.distances[i - 1]]))


def moment_lines(plate: PlateResult, origin: Array, within: float) -> tuple[MomentLine, ...]:
    """Return the lines along x and y from an origin (2,) [m], both ways, up to a distance [m] or the plate's edge."""
    from shapely import box

    mesh = Mesh(plate.nodes, plate.elements)
    near = load_vectors.find_elements_near(mesh, box(*(origin - within), *(origin + within)))
    part = Mesh(mesh.nodes, mesh.elements[near])
    distances, lines = np.linspace(0, within, PLACES), []
    for axis, field in ((0, "moment_x"), (1, "moment_y")):
        for direction in (-1.0, 1.0):
            places = np.tile(origin, (PLACES, 1))
            places[:, axis] += direction * distances
            element, local = locate(part, places)
            on = PLACES if (element >= 0).all() else max(int(np.argmin(element >= 0)), 1)
            nodes = part.elements[element[:on]]
            lines.append(MomentLine(field, distances[:on], nodes, q9_values(local[:on]), at_edge=on < PLACES))
    return tuple(lines)


def contraflexure(lines: tuple[MomentLine, ...], plate: PlateResult, sign: float) -> tuple[float, float]:
    """Return how far away moments along x and along y are zero, each the farther one of both directions [m]."""
    along_x, along_y = (
        max(line.zero(plate, sign) for line in lines if line.field == field) for field in ("moment_x", "moment_y")
    )
    return along_x, along_y
