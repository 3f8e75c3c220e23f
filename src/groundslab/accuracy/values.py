"""The discretization error of a value, from its change between two meshes."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from groundslab.accuracy.cracked_border import error_of_cracks
from groundslab.arrays import Array, Flags, Integers, made_once_by
from groundslab.fem.hanging import find_hanging
from groundslab.results.contact_zone import lifts_off_springs

if TYPE_CHECKING:
    from groundslab.results.plate_result import PlateResult
    from groundslab.results.results import CombinationResult, Comparison

#: A mesh on which the energy norm falls by less has not begun to converge: no more is taken from the change.
SLOWEST = 0.75
#: The same of section forces and pressures, whose largest change around a place already counts, and by how much they
#: fall at least: nothing is taken to converge faster than elements' moments do where they are smooth.
SLOWEST_AROUND, FASTEST_AROUND = 0.6, 0.25
#: Where the elements' own section forces converge with an order, recovered ones do so with this many times that.
RECOVERED = 1.5
#: What converges with the first order falls by this.
FIRST_ORDER = 0.5
#: So much of the largest change around a place counts there.
AROUND = 0.7
#: Below this error in energy the elements hold the solution, and what changes is rounding.
EXACT = 1e-9
#: Fields whose errors come from the whole slab.
OF_THE_WHOLE = {"settlement", "rotation_x", "rotation_y", "gap", "penetration", "line_force"}
#: The line of lift-off is known to this share of an element's side: a node in the middle of a side has two thirds of
#: it, all or nothing, and the line may run through the node. On springs the settlement tells the line within elements.
OF_A_ROW, ON_SPRINGS = 1 / 3, 1 / 50


def estimate_error(value: float, coarser: float, comparison: Comparison) -> float:
    """Return the estimated error of a value that is `coarser` on elements twice as large, in its own unit.

    If elements half as large reduce its error to the share q, the change between both meshes is (1 - q) / q times the
    error that is left (Richardson 1911). q is the reduction of the error in energy, which is known on both meshes.
    """
    return abs(value - coarser) * _left_of_change(comparison)


def _left_of_change(comparison: Comparison) -> float:
    """Return q / (1 - q): the error that is left over the change between both meshes, of values of the whole slab."""
    q = min(comparison.reduction, SLOWEST) if comparison.energy_error >= EXACT else 0.0
    return q / (1 - q)


def reduction_of(results: CombinationResult, field: str) -> Array:
    """Return by what elements half as large reduce the error of a field at each node of the plate, (n,).

    Section forces and pressures have the reduction of the error of moments, or of shear forces, in the elements that
    meet there. Recovered section forces converge faster than those, where the mesh follows all borders of loads. At
    sides of different lengths pressures, which are forces over areas, fall with the first order only.
    """
    plate, comparison = results.plate, results.comparison
    assert comparison is not None
    if comparison.energy_error < EXACT:
        return np.zeros(len(plate.nodes))
    local = comparison.shear_reduction if field.startswith("shear") else comparison.moment_reduction
    if field in OF_THE_WHOLE or local is None:
        return np.full(len(plate.nodes), min(comparison.reduction, SLOWEST))
    faster = RECOVERED if field != "pressure" and results.solved_model.mesh.adaptive else 1.0
    reduction = np.clip(local**faster, FASTEST_AROUND, SLOWEST_AROUND)
    if field == "pressure":
        uneven = find_hanging(plate.elements)[:, 1:]
        reduction[uneven] = np.maximum(reduction[uneven], FIRST_ORDER)
    return reduction


def estimate_errors(
    results: CombinationResult, field: str, values: Array, coarser: Array, nodes: Flags | None = None
) -> Array:
    """Return the estimated errors of a field's values (k,) at some nodes (n,) of the plate, or at all, in their unit.

    Section forces and pressures have the largest change at the nodes of the elements that meet at theirs, as both
    meshes may agree at one node by accident, and the reduction there (docs/theory.md, discretization error). The border
    of what has cracked has an error of its own.
    """
    plate, comparison, change = results.plate, results.comparison, np.abs(values - coarser)
    assert comparison is not None
    of_cracks = error_of_cracks(results) * float(np.abs(values).max(initial=0.0))
    if field in OF_THE_WHOLE or comparison.moment_reduction is None:
        return np.maximum(change * _left_of_change(comparison), of_cracks)
    where = np.ones(len(plate.nodes), dtype=bool) if nodes is None else nodes
    around = np.zeros(len(plate.nodes))
    around[where] = change
    of_elements = AROUND * around[plate.elements].max(axis=1)
    meeting = _meeting(plate.elements, len(plate.nodes))
    largest = np.maximum(around, np.maximum.reduceat(of_elements[meeting.elements], meeting.first))
    q = reduction_of(results, field)[where]
    return np.maximum(largest[where] * q / (1 - q), of_cracks)


class _Meeting(NamedTuple):
    """The elements that meet at each node, one node after the other."""

    elements: Integers  # (9 m,)
    first: Integers  # (n,): which of them is the first of each node


@made_once_by(lambda elements, _: (elements,))
def _meeting(elements: Integers, n: int) -> _Meeting:
    """Return the elements (m, 9) that meet at each of n nodes, all of which have some."""
    order = np.argsort(elements, axis=None, kind="stable")
    return _Meeting(order // elements.shape[1], np.searchsorted(elements.ravel()[order], np.arange(n)))


def error_of_contact_share(results: CombinationResult) -> float | None:
    """Return the estimated error of the share of the plate's area that rests on the ground; None without a comparison.

    Between a node that touches and one that does not the line of lift-off may lie anywhere: a share of the row of
    nodes that touch in the elements that it crosses is not known from the mesh.
    """
    if results.coarser is None or results.comparison is None:
        return None
    plate = results.plate
    row = plate.contact_area[line_of_lift_off(plate)].sum() / plate.area.sum()
    changed = estimate_error(plate.contact_share, results.coarser.plate.contact_share, results.comparison)
    return max(changed, (ON_SPRINGS if lifts_off_springs(results) else OF_A_ROW) * float(row))


def line_of_lift_off(plate: PlateResult) -> Integers:
    """Return the nodes (k,) of the elements that touch the ground in part."""
    touches = plate.in_contact[plate.elements]
    return np.unique(plate.elements[touches.any(axis=1) & ~touches.all(axis=1)])


def add_errors(
    results: CombinationResult, field: str, values: Array, coarser: Array, nodes: Flags | None = None
) -> Array:
    """Return how large a field's values (k,) at some nodes (n,), or at all, may be.

    What is positive nowhere on either mesh stays so (gaps, pressures).
    """
    return _most(values, coarser, estimate_errors(results, field, values, coarser, nodes))


def _most(values: Array, coarser: Array, errors: Array) -> Array:
    """Return how large values (k,) with errors may be, which are `coarser` on the other mesh."""
    most = values + errors
    return most.clip(max=0) if values.max() <= 0 and coarser.max() <= 0 else most


def error_of_largest(
    results: CombinationResult, field: str, values: Array, coarser: Array, nodes: Flags | None = None
) -> float:
    """Return the estimated error of the largest of values (k,) at some nodes (n,), or at all.

    Their own errors decide where it may lie: both meshes may agree on the largest value by accident, at different
    places.
    """
    return float(add_errors(results, field, values, coarser, nodes).max() - values.max())


def errors_of_extremes(
    results: CombinationResult, field: str, values: Array, coarser: Array, nodes: Flags | None = None
) -> tuple[float, float]:
    """Return the estimated errors of the least and of the greatest of values (k,), see `error_of_largest`."""
    errors = estimate_errors(results, field, values, coarser, nodes)
    least, greatest = (float(_most(s * values, s * coarser, errors).max() - (s * values).max()) for s in (-1, 1))
    return least, greatest
