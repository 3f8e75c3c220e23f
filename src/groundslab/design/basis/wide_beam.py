"""One-way shear of a slab as a wide beam: across it at the distance d from columns (ACI 318-19 7.4.3.2, 8.4.3.2).

A cut runs straight across the plate, a column's share of it: to the middle between the column and the next ones beside
it, or to the plate's edge. The shear force and what needs no links are means over the cut.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Integers
from groundslab.design.by_plate import results_by_plate
from groundslab.design.demands.line_traversal import interpolation, pieces
from groundslab.design.demands.perimeter_loads import effective_depth, footprint_of
from groundslab.design.demands.perimeters import outline
from groundslab.fem.mesh import Mesh
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.plates.region import PlateRegion
from groundslab.model.structure.columns import Column
from groundslab.results.mesh_results import PlateResult
from groundslab.results.results import CombinationResult

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon


#: Values that differ by a smaller share are the same.
SAME = 1e-9


@dataclass(frozen=True, slots=True)
class Cut:
    """A cut beside a column, and what takes means over it."""

    axis: int  # of the bars that cross it, 0 along x
    place: tuple[float, float]  # its middle [m]
    nodes: Integers  # (k, 9): of the elements at its Gauss points
    weights: Array  # (k, 9): of the nodes' values in the mean

    def mean(self, values: Array) -> float:
        """Return the mean of nodal values (n,) over the cut."""
        return float((self.weights * values[self.nodes]).sum())

    def layer(self, plate: PlateResult) -> str:
        """Return the layer of bars in tension that cross the cut."""
        letter = "xy"[self.axis]
        face = "bottom" if self.mean(getattr(plate, f"moment_{letter}")) > 0 else "top"
        return f"{face}_{letter}"

    def same(self, values: Array) -> float | None:
        """Return the nodal value (n,) that all of the cut has, None if it differs."""
        there = values[self.nodes]
        return float(there.flat[0]) if np.ptp(there) <= SAME * np.abs(there).max() else None

    def shear(self, plate: PlateResult) -> float:
        """Return the mean shear force [N/m]."""
        return abs(self.mean(getattr(plate, f"shear_{'xy'[self.axis]}")))


def cuts_from_edge_to_edge(results: CombinationResult, steel: Reinforcement) -> Iterator[Cut]:
    """Yield those of the cuts that no other column has a share of: across pads, and across strips with columns along.

    The section there is one of EN 1992-1-1 6.2.2, and of EN 1992-1-1:2023 8.2.2, at d from the face.
    """
    for column in results.model.columns:
        for axis in (0, 1):
            here = (column.x, column.y)[1 - axis]
            others = [(other.x, other.y)[1 - axis] for other in results.model.columns]
            if np.ptp([here, *others]) <= SAME * max(results.model.sides):
                yield from _beside(results, steel, column, axis)


def cuts(results: CombinationResult, steel: Reinforcement) -> Iterator[Cut]:
    """Yield the cuts on both sides of every column along x and along y, where they lie on the plate."""
    for column in results.model.columns:
        for axis in (0, 1):
            yield from _beside(results, steel, column, axis)


def _beside(results: CombinationResult, steel: Reinforcement, column: Column, axis: int) -> Iterator[Cut]:
    """Yield the cuts on both sides of a column along an axis, where they lie on its plate."""
    model, columns = results.model, results.model.columns
    region = PlateRegion(model.plate, model.plates)
    plans = [outline(plate) for plate in results_by_plate(results).values()]
    mesh = Mesh(results.plate.nodes, results.plate.elements)
    plan = plans[region.plate_at((column.x, column.y))]
    far = column.extents[axis] / 2 + effective_depth(results, footprint_of(column), steel)
    for side in (-1.0, 1.0):
        legs = _legs(plan, columns, column, axis, (column.x, column.y)[axis] + side * far)
        if len(legs):
            yield _cut(mesh, axis, legs)


def _legs(plan: Polygon | MultiPolygon, columns: tuple[Column, ...], column: Column, axis: int, at: float) -> Array:
    """Return the straight pieces (l, 2, 2) [m] of a column's share of the line x = at or y = at on the plate."""
    from shapely import LineString, get_coordinates, get_parts, intersection

    bounds = np.reshape(plan.bounds, (2, 2))[:, 1 - axis]
    here = (column.x, column.y)[1 - axis]
    middles = [(here + (column.x, column.y)[1 - axis]) / 2 for column in columns]
    near = 1e-6 * np.ptp(bounds)
    low = max([bounds[0], *(middle for middle in middles if middle < here - near)])
    high = min([bounds[1], *(middle for middle in middles if middle > here + near)])
    ends = [(at, low), (at, high)] if axis == 0 else [(low, at), (high, at)]
    parts = get_parts(intersection(plan, LineString(ends)))
    legs = [get_coordinates(part)[[0, -1]] for part in parts if part.length > near]
    return np.array(legs).reshape(-1, 2, 2)


def _cut(mesh: Mesh, axis: int, legs: Array) -> Cut:
    """Return a cut of straight pieces (l, 2, 2)."""
    line = pieces(mesh, legs)
    piece, s, ds = line.gauss()
    nodes, N = interpolation(mesh, line, piece, s)
    x, y = legs.reshape(-1, 2).mean(axis=0)
    return Cut(axis, (float(x), float(y)), nodes, N * (ds / ds.sum())[:, None])
