"""The column and wall loads of a case as tables of reactions, as programs of all axes, units and layouts write them.

Nothing of the import is used: forces are vectors in space, moments are cross products.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from groundslab.model.loads.lines import LineLoad, LineMoment
from groundslab.model.loads.load_types import PointLoad
from groundslab.model.model import Model

#: [N], [m] of units, by their definitions.
SIZES = {"kN": 1e3, "kip": 4448.2216152605, "m": 1.0, "ft": 0.3048}
#: Force and moment on the slab of a support in a load case, in x to the right, y up the page, z up [N], [N m].
Acting = tuple[NDArray[np.float64], NDArray[np.float64]]
Row = list[Any]


@dataclass(frozen=True, slots=True)
class Writer:
    """How a program writes its reactions.

    Attributes
    ----------
    axes : tuple of float
        1 or -1 of its x, y and z, right-handed, as they point to the right, up the page and up, or the other way.
    sign : int
        1 if it states what acts on the slab, -1 if what acts on the structure.
    left_handed : bool
        Whether its moments turn by the left hand.
    force, length : str
        Units; moments are in both.
    reading : mapping
        The keys of [reactions] that say so.
    """

    axes: tuple[float, float, float] = (1.0, 1.0, 1.0)
    sign: int = -1
    left_handed: bool = False
    force: str = "kN"
    length: str = "m"
    reading: Mapping[str, Any] = field(default_factory=dict)

    @property
    def moment(self) -> str:
        """Return the unit of moments."""
        return f"{self.force} {self.length}"

    def values(self, acting: Acting) -> tuple[float, float, float]:
        """Return F_z, M_x and M_y of the table."""
        force, moment = (self.sign * np.asarray(self.axes) * vector / SIZES[self.force] for vector in acting)
        M_x, M_y, _ = (-moment if self.left_handed else moment) / SIZES[self.length]
        return force[2], M_x, M_y


def acting_of(model: Model) -> dict[tuple[str, str], Acting]:
    """Return what acts on the slab by column or wall, and load case, about the column's center or the wall's middle."""
    lines = {wall.name: np.array(wall.line) for wall in model.placed_walls}
    found: dict[tuple[str, str], Acting] = {}
    for load in model.loads:
        if isinstance(load, PointLoad):
            # P downwards; M_x = P dx, M_y = P dy of a force at (dx, dy)
            key, weight = (load.column, load.case), np.array([0.0, 0.0, -load.P])
            moment = np.array([-load.M_y, load.M_x, 0.0])
        elif isinstance(load, LineLoad | LineMoment) and load.wall:
            key = (load.wall, load.case)
            weight, moment = _along(load, lines[load.wall])
        else:
            continue
        before = found.get(key, (np.zeros(3), np.zeros(3)))
        found[key] = (before[0] + weight, before[1] + moment)
    return found


def _along(load: LineLoad | LineMoment, line: NDArray[np.float64]) -> Acting:
    """Return the force of a line load and its moment about the wall's middle, by Gauss points on each piece."""
    lengths = np.linalg.norm(np.diff(line, axis=0), axis=1)
    total, middle = lengths.sum(), (line[0] + line[-1]) / 2
    weight, moment, before = np.zeros(3), np.zeros(3), 0.0
    for start, end, length in zip(line[:-1], line[1:], lengths, strict=True):
        for xi in (0.5 - 12**-0.5, 0.5 + 12**-0.5):
            place = np.append(start + xi * (end - start) - middle, 0.0)
            if isinstance(load, LineMoment):
                # it presses down what is to the left: it turns by the right hand about minus the wall's direction
                moment[:2] -= load.m / 2 * (end - start)
                continue
            share = (before + xi * length) / total
            q = load.q + share * ((load.q if load.q_end is None else load.q_end) - load.q)
            piece = np.array([0.0, 0.0, -q * length / 2])
            weight += piece
            moment += np.cross(place, piece)
        before += length
    return weight, moment if len(line) == 2 else np.zeros(3)


def long_table(model: Model, writer: Writer) -> list[Row]:
    """Return rows with one support and load case each, units below their headings."""
    units = [writer.force, writer.moment, writer.moment]
    rows = [[*key, *writer.values(acting)] for key, acting in acting_of(model).items()]
    return [["Support", "Case", "Fz", "Mx", "My"], ["", "", *units], *rows]


def wide_table(model: Model, writer: Writer) -> list[Row]:
    """Return rows with one support each, and three columns for each load case with units in their headings."""
    acting = acting_of(model)
    cases = list(dict.fromkeys(case for _, case in acting))
    units = {"Fz": writer.force, "Mx": writer.moment, "My": writer.moment}
    rows: list[Row] = [["Support", *(f"{name} ({case}) [{unit}]" for case in cases for name, unit in units.items())]]
    for support in dict.fromkeys(support for support, _ in acting):
        values = (writer.values(acting[support, case]) if (support, case) in acting else ("",) * 3 for case in cases)
        rows.append([support, *(value for each in values for value in each)])
    return rows


def as_csv(rows: Iterable[Row], separator: str = ",", decimal: str = ".") -> str:
    """Return rows as text, numbers with the digits that give them back."""
    texts = ([cell if isinstance(cell, str) else f"{cell:.15f}".replace(".", decimal) for cell in row] for row in rows)
    return "".join(f"{separator.join(row)}\n" for row in texts)
