"""Fields of results: name, symbol, unit and meaning of each."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Integers = NDArray[np.int64]
    Flags = NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class ResultField:
    """How a result is called and shown: symbol, unit of display, factor from SI to it, meaning, how it is averaged."""

    symbol: str
    unit: str
    scale: float
    meaning: str
    averaged: str


NOT, OVER_AREA, OVER_LENGTH = "not averaged", "force of a node over its area", "force of a node over its length"
PATCHES = "recovered by patches within a section"
MEAN = "mean over the element"


#: One definition of every field, used by tables, pictures and files. Signs as in ``docs/assumptions.md``.
PLATE_FIELDS: dict[str, ResultField] = {
    "settlement": ResultField("w", "mm", 1e3, "settlement of the plate, downwards positive", NOT),
    "rotation_x": ResultField("beta_x", "mrad", 1e3, "rotation of the normal in the x-z plane, u = -z beta_x", NOT),
    "rotation_y": ResultField("beta_y", "mrad", 1e3, "rotation of the normal in the y-z plane, v = -z beta_y", NOT),
    "gap": ResultField("g", "mm", 1e3, "distance between plate and ground", NOT),
    "penetration": ResultField("s", "mm", 1e3, "how far the plate has sunk into ground that yields", NOT),
    "pressure": ResultField("p", "kPa", 1e-3, "contact pressure under the plate", OVER_AREA),
    "line_force": ResultField(
        "f", "kN/m", 1e-3, "edge line force of the ground on the plate, upwards positive", OVER_LENGTH
    ),
    "moment_x": ResultField("m_x", "kNm/m", 1e-3, "bending moment of strips along x, sagging positive", PATCHES),
    "moment_y": ResultField("m_y", "kNm/m", 1e-3, "bending moment of strips along y, sagging positive", PATCHES),
    "moment_xy": ResultField("m_xy", "kNm/m", 1e-3, "twisting moment", PATCHES),
    "shear_x": ResultField("q_x", "kN/m", 1e-3, "transverse shear force on sections x = const", PATCHES),
    "shear_y": ResultField("q_y", "kN/m", 1e-3, "transverse shear force on sections y = const", PATCHES),
}


#: The field that only nodes on the plate's edge have.
LINE_FORCE = "line_force"


def label(name: str, about: ResultField) -> str:
    """Return quantity and symbol of a field, as in "moment m_x"."""
    quantity = " ".join(part for part in name.split("_") if part not in ("x", "y", "xy"))
    return f"{quantity} {about.symbol}"


#: The same of the fields at the centres of elements.
ELEMENT_FIELDS: dict[str, ResultField] = {
    "pressure": replace(PLATE_FIELDS["pressure"], averaged=MEAN),
    **{
        name: replace(PLATE_FIELDS[name], averaged=NOT)
        for name in ("moment_x", "moment_y", "moment_xy", "shear_x", "shear_y")
    },
    "thickness": ResultField("t", "mm", 1e3, "thickness of the plate", NOT),
}
