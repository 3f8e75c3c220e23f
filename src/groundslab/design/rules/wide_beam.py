"""One-way shear of a slab as a wide beam: across it at the distance d from columns (ACI 318-19 7.4.3.2, 8.4.3.2).

A cut runs straight across the plate, a column's share of it: to the middle between the column and the next ones beside
it, or to the plate's edge. The shear force and what needs no links are means over the cut.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from groundslab.arrays import Array, Flags, Integers
from groundslab.design.demands.by_plate import results_by_plate
from groundslab.design.demands.cuts.line_traversal import interpolation, pieces
from groundslab.design.demands.design_moments import ratio_along
from groundslab.design.demands.perimeter_loads import effective_depth, footprint_of
from groundslab.design.demands.perimeters import outline
from groundslab.fem.mesh import Mesh
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.plates.region import PlateRegion
from groundslab.model.remarks.singular_places import near_singular
from groundslab.model.structure.columns import Column
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import CombinationResult

if TYPE_CHECKING:
    from shapely import MultiPolygon, Polygon


#: Values that differ by a smaller share are the same.
SAME = 1e-9


@dataclass(frozen=True, slots=True)
class Cut:
    """A cut beside a column, and what takes means over it."""

    normal: tuple[float, float]  # a unit vector across it
    legs: Array  # (l, 2, 2): its straight pieces [m]
    nodes: Integers  # (k, 9): of the elements at its Gauss points
    weights: Array  # (k, 9): of the nodes' values in the mean
    element: Integers  # (k,): at its Gauss points
    shares: Array  # (k,): of the elements' values in the mean
    means: bool  # whether nodal values there are means around singular places

    @property
    def place(self) -> tuple[float, float]:
        """Return its middle [m]."""
        x, y = self.legs.reshape(-1, 2).mean(axis=0).tolist()
        return x, y

    def mean(self, values: Array) -> float:
        """Return the mean of nodal values (n,) over the cut."""
        return float((self.weights * values[self.nodes]).sum())

    def face(self, plate: PlateResult) -> str:
        """Return the face in tension across the cut."""
        m_x, m_y, m_xy = (self.mean(getattr(plate, f"moment_{axes}")) for axes in ("x", "y", "xy"))
        n_x, n_y = self.normal
        return "bottom" if m_x * n_x**2 + m_y * n_y**2 + 2 * m_xy * n_x * n_y > 0 else "top"

    def ratio(self, ratios: Mapping[str, Array], face: str) -> Array:
        """Return the ratio of bars of a face across the cut (k, 9) at its nodes, from nodal ones (n,) by layer."""
        rho_x, rho_y = (ratios[f"{face}_{axis}"][self.nodes] for axis in "xy")
        return ratio_along(np.full(self.nodes.shape, self.normal[0] ** 2), rho_x, rho_y)

    def mean_here(self, values: Array) -> float:
        """Return the mean of values (k, 9) at its nodes."""
        return float((self.weights * values).sum())

    def shear(self, results: CombinationResult, plate: PlateResult) -> float:
        """Return the mean shear force [N/m], of the plate as it is or with the line force along its edge spread.

        Where nodal values are means around singular places, such as corners of openings, the elements' own values count
        if they are larger, which keep equilibrium with what lies beyond. A line force that is spread adds to both.
        """
        nodal, solved = self._across(plate), self._across(results.plate)
        if not self.means:
            return abs(nodal)
        of_element = sum(n * float(self.shares @ getattr(results.elements, name)[self.element])
                  for n, name in zip(self.normal, ("shear_x", "shear_y"), strict=True))  # fmt: skip
        return max(abs(nodal), abs(of_element + nodal - solved))

    def _across(self, plate: PlateResult) -> float:
        """Return the mean of nodal shear forces across it [N/m]."""
        return self.normal[0] * self.mean(plate.shear_x) + self.normal[1] * self.mean(plate.shear_y)


def same(values: Array) -> float | None:
    """Return the value that all have, None if they differ."""
    return float(values.flat[0]) if np.ptp(values) <= SAME * np.abs(values).max() else None


def cuts_from_edge_to_edge(results: CombinationResult, steel: Reinforcement) -> Iterator[Cut]:
    """Yield those of the cuts that no other column has a share of: across pads, and across strips with columns along.

    The section there is one of EN 1992-1-1 6.2.2, and of EN 1992-1-1:2023 8.2.2, at d from the face.
    """
    singular = singular_nodes(results)
    for column in results.model.columns:
        for axis in (0, 1):
            here = (column.x, column.y)[1 - axis]
            others = [(other.x, other.y)[1 - axis] for other in results.model.columns]
            if np.ptp([here, *others]) <= SAME * max(results.model.sides):
                yield from _beside(results, steel, column, axis, singular)


def cuts(results: CombinationResult, steel: Reinforcement) -> Iterator[Cut]:
    """Yield the cuts on both sides of every column along x and along y, where they lie on the plate."""
    singular = singular_nodes(results)
    for column in results.model.columns:
        for axis in (0, 1):
            yield from _beside(results, steel, column, axis, singular)


def singular_nodes(results: CombinationResult) -> Flags:
    """Return the nodes (n,) whose section forces are means around singular places."""
    return near_singular(results.solved_model, results.plate.nodes, results.elements.at_nodes(results.plate)[0])


def _beside(
    results: CombinationResult, steel: Reinforcement, column: Column, axis: int, singular: Flags
) -> Iterator[Cut]:
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
            yield cut_along(mesh, legs, singular)


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


def cut_along(mesh: Mesh, legs: Array, singular: Flags) -> Cut:
    """Return a cut of pieces (l, 2, 2) of one straight line; singular (n,) as from `singular_nodes`."""
    line = pieces(mesh, legs)
    piece, s, ds = line.gauss()
    nodes, N = interpolation(mesh, line, piece, s)
    shares = ds / ds.sum()
    t_x, t_y = line.along[0].tolist()
    return Cut((t_y, -t_x), legs, nodes, N * shares[:, None], line.element[piece], shares, bool(singular[nodes].any()))
