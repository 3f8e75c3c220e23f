"""The discretization error of a value, from its change between two meshes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, overload

import numpy as np

from groundslab.arrays import Array, Integers, Memo
from groundslab.fem.assembly import scatter
from groundslab.fem.shape_functions import areas

if TYPE_CHECKING:
    from groundslab.results.mesh_results import ElementResult, PlateResult
    from groundslab.results.results import CombinationResult, Comparison

#: A mesh on which the energy norm falls by less has not begun to converge: no more is taken from the change.
SLOWEST = 0.75
#: Nothing is taken to converge faster than elements' moments do where they are smooth.
FASTEST = 0.25
#: Below this error in energy the elements hold the solution, and what changes is rounding.
EXACT = 1e-9
#: Fields whose errors come from the whole slab.
OF_THE_WHOLE = {"settlement", "rotation_x", "rotation_y", "gap", "penetration", "line_force"}
#: The errors of section forces and pressures come from the elements around: so many rings of them.
RINGS = 2


@overload
def estimate_error(value: float, coarser: float, comparison: Comparison) -> float: ...
@overload
def estimate_error(value: Array, coarser: Array, comparison: Comparison, reduction: Array | None = None) -> Array: ...
def estimate_error(
    value: float | Array, coarser: float | Array, comparison: Comparison, reduction: Array | None = None
) -> float | Array:
    """Return the estimated errors of values that are `coarser` on elements twice as large, in their own unit.

    If elements half as large reduce its error to the share q, the change between both meshes is (1 - q) / q times the
    error that is left (Richardson 1911). q is the reduction of the error in energy, which is known on both meshes: that
    of the whole slab, or of the elements around each value (`reduction_of`). What is recovered converges faster, so
    that the estimate is on the safe side (docs/theory.md, discretization error).
    """
    q: Any = comparison.reduction if reduction is None else reduction
    q = np.minimum(q, SLOWEST) if comparison.energy_error >= EXACT else 0.0
    change: Any = value - coarser
    error = abs(change) * q / (1 - q)
    return error if np.ndim(error) else float(error)


def reduction_of(results: CombinationResult, field: str) -> Array:
    """Return by what elements half as large reduce the error of a field at each node of the plate, (n,)."""
    plate, comparison = results.plate, results.comparison
    assert comparison is not None
    if field in OF_THE_WHOLE:
        return np.full(len(plate.nodes), comparison.reduction)
    return _REDUCTIONS.get(comparison, None, lambda: _local_reduction(plate, results.elements, comparison))


def _local_reduction(plate: PlateResult, elements: ElementResult, comparison: Comparison) -> Array:
    """Return the reductions around nodes, at least FASTEST."""
    density = elements.discretization_error
    before = comparison.elements.discretization_error
    n = len(plate.nodes)
    if density is None or before is None:
        return np.full(n, comparison.reduction)
    squares = np.column_stack([density, before]) ** 2 * areas(plate.nodes[plate.elements])[:, None]
    around = np.zeros((n, 2))
    for _ in range(RINGS):
        around = np.column_stack([scatter(plate.elements, np.tile(square[:, None], 9), n) for square in squares.T])
        squares = around[plate.elements].sum(axis=1)
    known = around[:, 1] > 0
    reduction = np.full(n, comparison.reduction)
    reduction[known] = np.sqrt(around[known, 0] / around[known, 1])
    bounded: Array = np.maximum(reduction, FASTEST)
    return bounded


#: Reductions, which are asked for by every field.
_REDUCTIONS: Memo[Array] = Memo()


def error_of_contact_share(results: CombinationResult) -> float | None:
    """Return the estimated error of the share of the plate's area that rests on the ground; None without a comparison.

    Between a node that touches and one that does not the line of lift-off may lie anywhere: a row of nodes more or
    less, half of those that touch in the elements that it crosses, is not known from the mesh.
    """
    if results.coarser is None or results.comparison is None:
        return None
    plate = results.plate
    row = plate.contact_area[line_of_lift_off(plate)].sum() / plate.area.sum()
    changed = estimate_error(plate.contact_share, results.coarser.plate.contact_share, results.comparison)
    return max(changed, float(row) / 2)


def line_of_lift_off(plate: PlateResult) -> Integers:
    """Return the nodes (k,) of the elements that touch the ground in part."""
    touches = plate.in_contact[plate.elements]
    return np.unique(plate.elements[touches.any(axis=1) & ~touches.all(axis=1)])


def add_errors(values: Array, coarser: Array, comparison: Comparison, reduction: Array | None = None) -> Array:
    """Return how large nodal values (n,) may be; what is positive nowhere on either mesh stays so (gaps, pressures)."""
    most = values + estimate_error(values, coarser, comparison, reduction)
    return most.clip(max=0) if values.max() <= 0 and coarser.max() <= 0 else most


def error_of_largest(values: Array, coarser: Array, comparison: Comparison, reduction: Array | None = None) -> float:
    """Return the estimated error of the largest of nodal values (n,), whose own errors decide where it may lie.

    Both meshes may agree on the largest value by accident, at different places.
    """
    return float(add_errors(values, coarser, comparison, reduction).max() - values.max())
