"""What tables list of a plate: its fields, principal moments and Wood's design moments, in units of display."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.demands.design_moments import derive_field, derive_fields, fields_of
from groundslab.errors import GroundslabError
from groundslab.fem.shape_functions import areas
from groundslab.results.contact_zone import has_line_force
from groundslab.results.fields import LINE_FORCE, POINT_FIELDS, RANGED_FIELDS, SHOWN_ELEMENT_FIELDS, ResultField
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import CombinationResult


def point_values(fields: Mapping[str, Array]) -> list[Array]:
    """Return the quantities of POINT_FIELDS (n,), in its order and units of display, from PLATE_FIELDS (n,) in SI."""
    derived = derive_fields(fields)
    return [derived[name] * about.scale for name, about in POINT_FIELDS.items()]


def nodal_values(results: CombinationResult, name: str) -> Array:
    """Return a quantity of RANGED_FIELDS or SHOWN_ELEMENT_FIELDS at the plate's nodes (n,), in its unit of display.

    Fields of elements by their means over those that meet; raises GroundslabError if these results lack one.
    """
    if name in SHOWN_ELEMENT_FIELDS:
        values = getattr(results.elements, name)
        if values is None:
            raise GroundslabError(f"{results.combination} has no {SHOWN_ELEMENT_FIELDS[name].quantity}")
        return mean_at_nodes(results.plate, values) * SHOWN_ELEMENT_FIELDS[name].scale
    return derive_field(fields_of(results.plate), name) * RANGED_FIELDS[name].scale


def ranged_values(results: CombinationResult) -> dict[str, Array]:
    """Return the quantities of RANGED_FIELDS at the plate's nodes (n,), in their units of display."""
    derived = derive_fields(fields_of(results.plate))
    return {name: derived[name] * about.scale for name, about in RANGED_FIELDS.items()}


def mean_at_nodes(plate: PlateResult, values: Array) -> Array:
    """Return the means (n,) of a field of elements (m,) over the elements that meet at each node, by their areas."""
    weights = np.repeat(areas(plate.nodes[plate.elements]), plate.elements.shape[1])
    nodes, n = plate.elements.ravel(), len(plate.nodes)
    sums = np.bincount(nodes, weights=weights * np.repeat(values, plate.elements.shape[1]), minlength=n)
    means: Array = sums / np.bincount(nodes, weights=weights, minlength=n)
    return means


def ranged_fields(results: CombinationResult) -> list[tuple[ResultField, str, Flags]]:
    """Return the fields with extremes: how each is shown, its name in RANGED_FIELDS, and the nodes that count (n,)."""
    everywhere = np.ones(len(results.plate.nodes), dtype=bool)
    on_edge = results.plate.edge_length > 0
    return [
        (about, name, on_edge if name == LINE_FORCE else everywhere)
        for name, about in RANGED_FIELDS.items()
        if name != LINE_FORCE or has_line_force(results)
    ]
