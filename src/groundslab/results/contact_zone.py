"""Properties of results: whether they are finite, where the plate lifts, whether there is a line force."""

from __future__ import annotations

from dataclasses import fields
from typing import TYPE_CHECKING

import numpy as np

from groundslab.errors import GroundslabError
from groundslab.fem.continuum.pressed_cells import PressedCells

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.results.results import CombinationResult


#: What a reader must know where the ground acts by a line force along the plate's edge.
EDGE_NOTE = (
    "Along the plate's edge the ground's shear acts as a line force f, in addition to the pressure. At corners of the "
    "plate it grows slowly as the mesh is refined."
)

#: What a reader must know of the pressures of an elastic continuum.
CELLS_NOTE = (
    "Pressures are constant on cells; those at nodes are means of the cells around them. Along the plate's edge, where "
    "it is pressed into such ground, the pressure has no limit: its largest value grows as the mesh is refined."
)
#: The contact function on cells is at least that far from zero.
CLOSE = 1e-6


def require_finite(results: CombinationResult) -> None:
    """Raise GroundslabError if any number of the results is infinite or not a number."""
    for part in ("plate", "elements", "ground", "constants", "certificate"):
        values = getattr(results, part)
        for item in fields(values):
            value = getattr(values, item.name)
            if isinstance(value, PressedCells):
                value = value.force
            if value is not None and not np.all(np.isfinite(value)):
                raise GroundslabError(
                    f"{part}.{item.name} of the results holds a number that is not finite; nothing is shown or written"
                )


def lifts_off_springs(results: CombinationResult) -> bool:
    """Return whether the ground is springs alone that never yield, see `contact_fields.lifts_off_springs`."""
    model = results.solved_model
    without_shear = not model.ground_carries_shear and results.ground.cells is None
    return without_shear and not model.contact.voids and model.contact.limit_pressure is None


def has_line_force(results: CombinationResult) -> bool:
    """Return whether the ground acts by a line force, too, along the plate's edge: it does if it carries shear."""
    return any(k1 > 0 for k1 in results.constants.k1) and bool(results.plate.edge_length.any())


def goes_below_zero(values: Array) -> bool:
    """Return whether the smallest of the values is negative by more than rounding."""
    return bool(values.min() < -1e-9 * np.abs(values).max())


def contact_function(results: CombinationResult) -> Array:
    """Return a field (n,) that is negative at nodes in contact, positive elsewhere, zero on the boundary.

    On springs without shear it is k0 g - p, with k0 of all layers in series: on Winkler ground it crosses
    zero linearly. With shear the pressure jumps to zero at the boundary and the gap grows as the square of the
    distance, so its root stands for the distance on the open side, and half a usual first step on the other. On cells
    of pressure it is what of the cells around a node is open, less a half.
    """
    plate = results.plate
    closed = plate.in_contact
    if results.ground.cells is not None:
        share = plate.contact_area / plate.area
        return np.where(closed, np.minimum(0.5 - share, -CLOSE), np.maximum(0.5 - share, CLOSE))
    if not results.constants.k0 or any(k1 > 0 for k1 in results.constants.k1):
        outside = np.sqrt(np.maximum(plate.gap, 0.0))
        mixed = closed[plate.elements].any(axis=1) & ~closed[plate.elements].all(axis=1)
        front = np.setdiff1d(plate.elements[mixed], np.flatnonzero(closed))
        inside = np.full(len(closed), np.median(outside[front]) / 2 if len(front) else 1.0)
    else:
        stiffness = 1 / sum(1 / k0 for k0 in results.constants.k0)
        outside, inside = stiffness * plate.gap, plate.pressure
    small = 1e-9 * max(float(np.abs(outside).max()), float(np.abs(inside).max()), 1e-300)
    return np.where(closed, -np.maximum(inside, small), np.maximum(outside, small))
