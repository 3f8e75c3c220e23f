"""The discretization error of a value, from its change between two meshes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, overload

import numpy as np

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.results.results import CombinationResult, Comparison

#: A mesh on which the energy norm falls by less has not begun to converge: no more is taken from the change.
SLOWEST = 0.75
#: Below this error in energy the elements hold the solution, and what changes is rounding.
EXACT = 1e-9


@overload
def estimate_error(value: float, coarser: float, comparison: Comparison) -> float: ...
@overload
def estimate_error(value: Array, coarser: Array, comparison: Comparison) -> Array: ...
def estimate_error(value: float | Array, coarser: float | Array, comparison: Comparison) -> float | Array:
    """Return the estimated errors of values that are `coarser` on elements twice as large, in their own unit.

    If elements half as large reduce its error to the share q, the change between both meshes is (1 - q) / q times the
    error that is left (Richardson 1911). q is that of the energy norm, whose error is known on both meshes: what is
    recovered converges faster, so that the estimate is on the safe side (docs/theory.md, discretization error).
    """
    q = min(comparison.reduction, SLOWEST) if comparison.energy_error >= EXACT else 0.0
    change: Any = value - coarser
    return abs(change) * q / (1 - q)  # type: ignore[no-any-return]


def error_of_contact_share(results: CombinationResult) -> float | None:
    """Return the estimated error of the share of the plate's area that rests on the ground; None without a comparison.

    Between a node that touches and one that does not the line of lift-off may lie anywhere: half a row of nodes more or
    less is not known from the mesh, whatever the coarser one says.
    """
    if results.coarser is None or results.comparison is None:
        return None
    plate = results.plate
    touches = plate.in_contact[plate.elements]
    meets_line = touches.any(axis=1) & ~touches.all(axis=1)
    nodes = np.unique(plate.elements[meets_line])
    row = plate.contact_area[nodes].sum() / plate.area.sum()
    changed = estimate_error(plate.contact_share, results.coarser.plate.contact_share, results.comparison)
    return max(changed, float(row) / 2)


def add_errors(values: Array, coarser: Array, comparison: Comparison) -> Array:
    """Return how large nodal values (n,) may be; what is positive nowhere on either mesh stays so (gaps, pressures)."""
    most = values + estimate_error(values, coarser, comparison)
    return most.clip(max=0) if values.max() <= 0 and coarser.max() <= 0 else most


def error_of_largest(values: Array, coarser: Array, comparison: Comparison) -> float:
    """Return the estimated error of the largest of nodal values (n,), whose own errors decide where it may lie.

    Both meshes may agree on the largest value by accident, at different places.
    """
    return float(add_errors(values, coarser, comparison).max() - values.max())
