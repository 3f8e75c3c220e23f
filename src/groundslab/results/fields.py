"""The table of quantities of the plate: name, symbol, unit, meaning and sign of each; the place of their extremes."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from groundslab.arrays import Array
from groundslab.messages import Message, Name
from groundslab.unit_systems import DISPLAYED
from groundslab.units import Unit

#: Which values a quantity takes: any; usually positive, with negative ones an exception (uplift, tension); or one sign.
Sign = Literal["any", "usually positive", "not negative", "not positive"]


@dataclass(frozen=True, slots=True)
class ResultField:
    """A quantity of the plate: how it is called and shown, what it means, how its nodal values are averaged."""

    quantity: str
    symbol: str
    unit: str  # of display, a name in unit_systems.DISPLAYED
    dimension: str  # a name in units.DIMENSIONS
    meaning: str
    sign: Sign
    averaged: str

    @property
    def display(self) -> Unit:
        """Return the unit of display with its SI unit and factor."""
        return DISPLAYED[self.unit]

    @property
    def scale(self) -> float:
        """Return the factor from SI to the unit of display."""
        return self.display.scale

    @property
    def label(self) -> str:
        """Return quantity and symbol, as in "moment m_x"."""
        if not self.symbol:
            return self.quantity
        if isinstance(self.quantity, Message):
            return Message("{quantity} {symbol}", quantity=self.quantity, symbol=self.symbol)
        return f"{self.quantity} {self.symbol}"

    @property
    def head(self) -> tuple[str, str]:
        """Return label and unit."""
        return self.label, self.unit

    @property
    def name(self) -> str:
        """Return label and unit, as in "settlement w [mm]"."""
        return Message("{label} [{unit}]", label=self.label, unit=self.unit)

    @property
    def si_name(self) -> str:
        """Return label and SI unit, as in "settlement w [m]"."""
        return Message("{label} [{si}]", label=self.label, si=self.display.si) if self.display.si else self.label


NOT, OVER_AREA, OVER_LENGTH = "not averaged", "force of a node over its area", "force of a node over its length"
PATCHES = "recovered by patches within a section"
MEAN = "mean over the element"


def _moment(quantity: str, symbol: str, meaning: str, sign: Sign = "any") -> ResultField:
    return ResultField(quantity, symbol, "kNm/m", "moment per length", meaning, sign, PATCHES)


def _shear(symbol: str, meaning: str) -> ResultField:
    return ResultField("shear", symbol, "kN/m", "force per length", meaning, "any", PATCHES)


def _membrane(symbol: str, meaning: str) -> ResultField:
    return ResultField("membrane force", symbol, "kN/m", "force per length", meaning, "any", NOT)


def _rotation(symbol: str, meaning: str) -> ResultField:
    return ResultField("rotation", symbol, "mrad", "slope", meaning, "any", NOT)


#: The plate's nodal fields. Signs as in ``docs/assumptions.md``.
PLATE_FIELDS: dict[str, ResultField] = {
    "settlement": ResultField(
        "settlement", "w", "mm", "length", "settlement of the plate, downwards positive", "usually positive", NOT
    ),
    "rotation_x": _rotation("beta_x", "rotation of the normal in the x-z plane, u = -z beta_x"),
    "rotation_y": _rotation("beta_y", "rotation of the normal in the y-z plane, v = -z beta_y"),
    "gap": ResultField("gap", "g", "mm", "length", "distance between plate and ground", "not negative", NOT),
    "penetration": ResultField(
        "penetration", "s", "mm", "length", "how far the plate has sunk into ground that yields", "not negative", NOT
    ),
    "pressure": ResultField(
        "pressure", "p", "kPa", "pressure", "contact pressure under the plate", "usually positive", OVER_AREA
    ),
    "line_force": ResultField(
        "line force", "f", "kN/m", "force per length", "edge line force of the ground on the plate, upwards positive",
        "any", OVER_LENGTH,
    ),
    "moment_x": _moment("moment", "m_x", "bending moment of strips along x, sagging positive"),
    "moment_y": _moment("moment", "m_y", "bending moment of strips along y, sagging positive"),
    "moment_xy": _moment("moment", "m_xy", "twisting moment"),
    "shear_x": _shear("q_x", "transverse shear force on sections x = const"),
    "shear_y": _shear("q_y", "transverse shear force on sections y = const"),
}  # fmt: skip

#: The field of elements that is there only where a coarser mesh was solved.
ERROR = "discretization_error"

#: The field of elements that is there only where the slab may crack.
STIFFNESS = "stiffness_ratio"
#: The fields of elements that are there only where beams are eccentric.
MEMBRANE: dict[str, ResultField] = {
    "membrane_x": _membrane("n_x", "force along x in the plate's plane, tension positive"),
    "membrane_y": _membrane("n_y", "force along y in the plate's plane, tension positive"),
    "membrane_xy": _membrane("n_xy", "shear force in the plate's plane"),
}

#: The field that only nodes on the plate's edge have.
LINE_FORCE = "line_force"

#: The fields of elements, at their centers or as means.
ELEMENT_FIELDS: dict[str, ResultField] = {
    "pressure": replace(PLATE_FIELDS["pressure"], averaged=MEAN),
    **{
        name: replace(PLATE_FIELDS[name], averaged=NOT)
        for name in ("moment_x", "moment_y", "moment_xy", "shear_x", "shear_y")
    },
    "thickness": ResultField("thickness", "t", "mm", "length", "thickness of the plate", "not negative", NOT),
    ERROR: ResultField(
        "discretization error", "rho_e", "%", "share", "density of the discretization error in energy", "not negative",
        MEAN,
    ),
    STIFFNESS: ResultField(
        "stiffness ratio", "r_B", "%", "share", "lesser bending stiffness over the uncracked one",
        "not negative", MEAN,
    ),
    **MEMBRANE,
}  # fmt: skip

#: Fields of elements that pictures show, by their means at the nodes.
SHOWN_ELEMENT_FIELDS = {
    name: replace(ELEMENT_FIELDS[name], averaged="mean of the elements that meet, by area")
    for name in (ERROR, STIFFNESS, *MEMBRANE)
}

#: What is computed from the moments at a node: principal moments, and the direction of the larger one.
PRINCIPAL: dict[str, ResultField] = {
    "m_1": _moment("principal moment", "m_1", "larger principal moment"),
    "m_2": _moment("principal moment", "m_2", "smaller principal moment"),
}
DIRECTION = {"direction": ResultField("direction of m_1 from x", "", "deg", "slope", "its direction", "any", PATCHES)}

_WOOD = "design moment of Wood and Armer for {face} bars along {axis}"
_FACES: tuple[tuple[str, Sign], ...] = (("bottom", "not negative"), ("top", "not positive"))
#: Design moments of the four layers of bars.
LAYERS: dict[str, ResultField] = {
    f"{face}_{axis}": _moment(
        Message("design moment {face} {axis}", face=face, axis=axis), "", Message(_WOOD, face=face, axis=axis), sign
    )
    for face, sign in _FACES
    for axis in "xy"
}

#: What is told of bars: symbol, unit, dimension, quantity, meaning.
_OF_BARS = {
    "required": (
        "a_req", "cm2/m", "area per length", "required area {face} {axis}",
        "required area {face} {axis}, the largest over all ultimate combinations",
    ),
    "provided": (
        "a_prov", "cm2/m", "area per length", "provided area {face} {axis}",
        "provided area {face} {axis}, of the bars provided there",
    ),
    "utilization": (
        "eta", "%", "share", "utilization {face} {axis}",
        "utilization {face} {axis}, required over provided area over all ultimate combinations",
    ),
    "missing": (
        "a_miss", "cm2/m", "area per length", "missing area {face} {axis}",
        "missing area {face} {axis}, required less provided over all ultimate combinations",
    ),
}  # fmt: skip
#: Fields of the four layers of bars that belong to no single combination: what bending and the minimum need, what is
#: laid, and both compared.
BAR_FIELDS: dict[str, ResultField] = {
    f"{what}_{face}_{axis}": ResultField(
        Message(quantity, face=face, axis=axis),
        Message("{symbol} {face} {axis}", symbol=Name(symbol), face=face, axis=axis),
        unit, dimension, Message(meaning, face=face, axis=axis), "not negative", "of recovered moments",
    )
    for what, (symbol, unit, dimension, quantity, meaning) in _OF_BARS.items()
    for face, axis in (layer.split("_") for layer in LAYERS)
}  # fmt: skip

#: The quantities that are listed at a point of the plate; a force along the edge belongs to no point inside.
POINT_FIELDS = {name: field for name, field in PLATE_FIELDS.items() if name != LINE_FORCE}
POINT_FIELDS |= PRINCIPAL | DIRECTION | LAYERS
#: The quantities that have extremes; a direction has none.
RANGED_FIELDS = PLATE_FIELDS | PRINCIPAL | LAYERS

#: Nodal values this close, relative to the largest, are equal but for rounding.
SAME_VALUE = 1e-9


def extreme_node(nodes: Array, values: Array, sign: int) -> int:
    """Return the node of the largest (sign 1) or smallest (sign -1) of nodal values (n,), which may be infinite.

    Of values that are equal but for rounding, as on a symmetric plate, the one nearest to the origin is taken, and of
    these the one with the largest x, then y.
    """
    signed = sign * values
    finite = np.abs(values).max(initial=0)
    if not np.isfinite(finite):
        finite = np.abs(values[np.isfinite(values)]).max(initial=0)
    equal = np.flatnonzero(signed >= signed.max() - SAME_VALUE * finite)
    # rounded to nanometers, so that mirrored points are equally far
    x, y = np.round(nodes[equal], 9).T
    return int(equal[np.lexsort((-y, -x, np.round(np.hypot(x, y), 9)))[0]])


def extreme(nodes: Array, values: Array, sign: int) -> tuple[float, tuple[float, float]]:
    """Return the largest (sign 1) or smallest (sign -1) of nodal values (n,) and its place [m], see `extreme_node`."""
    node = extreme_node(nodes, values, sign)
    return float(values[node]), place_of(nodes, node)


def place_of(nodes: Array, node: int) -> tuple[float, float]:
    """Return where a node is [m], rounded to nanometers."""
    x, y = places_of(nodes[node])
    return float(x), float(y)


def places_of(nodes: Array) -> Array:
    """Return where nodes (..., 2) are [m], rounded to nanometers."""
    return np.round(nodes, 9) + 0.0
