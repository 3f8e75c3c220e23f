"""What tables list of a plate: its fields, principal moments and Wood's design moments, in units of display."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from groundslab.arrays import Array, Flags
from groundslab.design.design_moments import principal_moments, wood_armer
from groundslab.design.tables.table import Head
from groundslab.results.contact_zone import has_line_force
from groundslab.results.fields import LINE_FORCE, PLATE_FIELDS, label
from groundslab.results.results import Combined, PlateResult, Results


@dataclass(frozen=True, slots=True)
class Quantity:
    """A quantity as it is shown: its label, its unit, the factor from SI to it."""

    label: str
    unit: str
    scale: float

    @property
    def head(self) -> Head:
        """Return name and unit of its column."""
        return self.label, self.unit

    @property
    def name(self) -> str:
        """Return label and unit, as in "settlement w [mm]"."""
        return f"{self.label} [{self.unit}]"


def _moment(label: str) -> Quantity:
    about = PLATE_FIELDS["moment_x"]
    return Quantity(label, about.unit, about.scale)


FIELDS = {name: Quantity(label(name, about), about.unit, about.scale) for name, about in PLATE_FIELDS.items()}
PRINCIPAL = {"m_1": _moment("principal moment m_1"), "m_2": _moment("principal moment m_2")}
DIRECTION = {"direction": Quantity("direction of m_1 from x", "deg", math.degrees(1))}
LAYERS = {
    "bottom_x": _moment("design moment bottom x"),
    "bottom_y": _moment("design moment bottom y"),
    "top_x": _moment("design moment top x"),
    "top_y": _moment("design moment top y"),
}
#: All that is listed at a place; a force along the edge belongs to no other one.
LISTED = {name: about for name, about in FIELDS.items() if name != LINE_FORCE} | PRINCIPAL | DIRECTION | LAYERS
#: What has extremes; a direction is no amount.
AMOUNTS = FIELDS | PRINCIPAL | LAYERS

#: Nodal values this close, relative to the largest, are equal but for rounding.
SAME_VALUE = 1e-9


def listed(fields: Mapping[str, Array]) -> list[Array]:
    """Return the quantities of LISTED (n,), in its order and units of display, from PLATE_FIELDS (n,) in SI units."""
    return [_one(fields, name) * about.scale for name, about in LISTED.items()]


def nodal(results: Results, name: str) -> Array:
    """Return one quantity of AMOUNTS at the plate's nodes (n,), in its unit of display."""
    return _one(fields_of(results.plate), name) * AMOUNTS[name].scale


def fields_of(plate: PlateResult) -> dict[str, Array]:
    """Return the nodal fields of a plate by name, (n,) each, in SI units."""
    return {name: getattr(plate, name) for name in PLATE_FIELDS}


def _one(fields: Mapping[str, Array], name: str) -> Array:
    """Return a quantity (n,) in SI units from the plate's fields (n,)."""
    if name in FIELDS:
        return fields[name]
    moments = fields["moment_x"], fields["moment_y"], fields["moment_xy"]
    made = wood_armer(*moments) if name in LAYERS else principal_moments(*moments)
    values: Array = getattr(made, name)
    return values


def solved(combined: Combined) -> list[Results]:
    """Return the results there are, in the order of the combinations."""
    return [combined.results[each.name] for each in combined.combinations if each.name in combined.results]


def ranged(results: Results) -> list[tuple[Quantity, str, Flags]]:
    """Return what has extremes: how it is shown, its name in AMOUNTS, and the nodes that count (n,)."""
    everywhere = np.ones(len(results.plate.nodes), dtype=bool)
    on_edge = results.plate.edge_length > 0
    return [
        (about, name, on_edge if name == LINE_FORCE else everywhere)
        for name, about in AMOUNTS.items()
        if name != LINE_FORCE or has_line_force(results)
    ]


def extreme(nodes: Array, values: Array, sign: int) -> int:
    """Return the node of the largest (sign 1) or least (sign -1) of nodal values (n,).

    Of values that are equal but for rounding, as on a symmetric plate, the one nearest to the origin is named, and of
    these the one with the largest x, then y.
    """
    signed = sign * values
    top = signed.max()
    finite = np.abs(values[np.isfinite(values)]).max(initial=0)
    equal = np.flatnonzero(signed >= top - SAME_VALUE * finite)
    # rounded to nanometres, so that mirrored places are equally far
    x, y = np.round(nodes[equal], 9).T
    return int(equal[np.lexsort((-y, -x, np.round(np.hypot(x, y), 9)))[0]])


def place(nodes: Array, node: int) -> tuple[float, float]:
    """Return where a node is [m], rounded to nanometres."""
    x, y = np.round(nodes[node], 9) + 0.0
    return float(x), float(y)
