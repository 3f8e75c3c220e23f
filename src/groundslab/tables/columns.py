"""The table of columns: what they carry, how they settle against each other, the demand of punching."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from groundslab import loads
from groundslab.assembly import scatter
from groundslab.columns import Column
from groundslab.errors import InputError
from groundslab.mesh import Mesh
from groundslab.model import Model, Reinforcement
from groundslab.punching import OPENING_REACH, RectangularColumn, RoundColumn, perimeter
from groundslab.results import Combined, PlateResult, Results
from groundslab.shape import Array
from groundslab.tables import inside
from groundslab.tables.quantities import solved
from groundslab.tables.table import Cell, Table, table_of
from groundslab.tables.thickness import of_elements
from groundslab.tilt import between

_NEIGHBOURS = (
    ("worst neighbour", ""), ("distance", "m"), ("settlement difference", "mm"), ("angular distortion", "mm/m"),
    ("angular distortion without tilt", "mm/m"),
)  # fmt: skip
_PUNCHING = (
    ("d", "mm"), ("V_Ed", "kN"), ("u", "m"), ("v_Ed", "MPa"), ("pressure inside", "kN"),
    ("other loads inside", "kN"),
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class _Punched:
    """What punching of a column needs that is the same in every combination."""

    d: float  # effective depth [m]
    u: float  # length of the perimeter at 2 d [m]
    area: Array  # (n,): each node's share of the area inside it [m2]
    others: dict[str, float]  # other loads inside [N], by load case


def column_table(combined: Combined) -> Table:
    """Return load, settlement, worst neighbour and demand of punching of each column in each combination."""
    model, results = combined.model, solved(combined)
    own = {column.name: inside.of_column(model, column.name) for column in model.columns}
    steel = model.reinforcement
    punched = {}
    if steel is not None and results:
        punched = {column.name: _punched(model, column, steel, results[0].plate) for column in model.columns}
    rows = []
    for each in results:
        neighbour = _neighbours(each.plate, model.columns)
        for column in model.columns:
            force = inside.under(each, own[column.name])
            row: list[Cell] = [each.combination, column.name, column.x, column.y, force / 1e3]
            row += neighbour(column)
            if steel is not None:
                row += _demand(each, punched[column.name], force)
            rows.append(row)
    missing = [f"no punching of column {name}: {why}" for name, why in punched.items() if isinstance(why, str)]
    heads = [("combination", ""), ("column", ""), ("x", "m"), ("y", "m"), ("load", "kN"), ("settlement", "mm")]
    heads += [*_NEIGHBOURS, *(_PUNCHING if steel is not None else ())]
    return table_of("columns", "Columns", heads, rows, [*_notes(steel), *missing])


def _notes(steel: Reinforcement | None) -> list[str]:
    """Return what a reader must know."""
    notes = [
        "The load is the sum of the point loads that name the column, with the factors of their cases.",
        "The worst neighbour is the column with the largest angular distortion against this one: difference of "
        "settlement (the neighbour's less this one's) over distance; without tilt, the plane of the table tilt is "
        "taken off first.",
    ]
    if steel is not None:
        notes += [
            "Punching by EN 1992-1-1 6.4.4(2), the demand only: no resistance is checked, and beta for eccentric "
            "forces is not in v_Ed. V_Ed = load + other loads inside - pressure inside, on the perimeter at 2 d; "
            "foundations need nearer perimeters checked too. Supports inside are not counted.",
            "d is the least thickness under the column less the mean distance of the bottom bars' axes. Where the "
            "plate gets thinner within 2 d or a little farther out, that place needs a check of its own.",
        ]
    return notes


def _neighbours(plate: PlateResult, columns: tuple[Column, ...]) -> Callable[[Column], list[Cell]]:
    """Return the function that gives a column's settlement and its worst neighbour's figures."""
    # columns at one place are one point
    names: dict[tuple[float, float], str] = {}
    for column in columns:
        names.setdefault((column.x, column.y), column.name)
    if len(names) < 2:
        return lambda column: [plate.value_at("settlement", column.x, column.y) * 1e3, *[None] * 5]
    pairs = between(plate, {name: xy for xy, name in names.items()})

    def figures(column: Column) -> list[Cell]:
        me = pairs.names.index(names[column.x, column.y])
        mine = (pairs.first == me) | (pairs.second == me)
        worst = int(np.argmax(np.where(mine, pairs.distortion, -1.0)))
        forwards = pairs.first[worst] == me
        other = int(pairs.second[worst] if forwards else pairs.first[worst])
        return [
            pairs.settlement[me] * 1e3,
            pairs.names[other],
            pairs.distance[worst],
            pairs.difference[worst] * (1e3 if forwards else -1e3),
            pairs.distortion[worst] * 1e3,
            pairs.relative[worst] * 1e3,
        ]

    return figures


def _punched(model: Model, column: Column, steel: Reinforcement, plate: PlateResult) -> _Punched | str:
    """Return what punching of a column needs that is the same in every combination, or why there is nothing."""
    shape, mesh = _shape(column), Mesh(plate.nodes, plate.elements)
    elements = loads.near(mesh, shape.footprint())
    covered = loads.over_polygon(mesh, elements, shape.footprint()).sum(axis=1)
    under = elements[covered > 1e-9 * covered.max()]
    d = float(of_elements(model, plate)[under].min()) - sum(steel.bottom) / 2
    try:
        line = perimeter(plate, shape, 2 * d, OPENING_REACH * d)
    except InputError as error:
        return str(error)
    elements = loads.near(mesh, line.inside)
    area = scatter(mesh.elements[elements], loads.over_polygon(mesh, elements, line.inside), len(mesh.nodes))
    return _Punched(d, line.u, area, inside.others(model, plate, line.inside, column.name))


def _shape(column: Column) -> RectangularColumn | RoundColumn:
    """Return a column's footprint for punching."""
    if column.diameter is not None:
        return RoundColumn(column.x, column.y, column.diameter)
    assert column.width_x is not None
    assert column.width_y is not None
    return RectangularColumn(column.x, column.y, column.width_x, column.width_y)


def _demand(results: Results, punched: _Punched | str, force: float) -> list[Cell]:
    """Return the figures of punching of a column that pushes down, in the order of the table (see punching.demand)."""
    if isinstance(punched, str) or force <= 0:
        return [None] * len(_PUNCHING)
    others = inside.under(results, punched.others)
    pressure = float(punched.area @ (results.plate.contact_force / results.plate.area))
    V_Ed = force + others - pressure
    v_Ed = V_Ed / (punched.u * punched.d)
    return [punched.d * 1e3, V_Ed / 1e3, punched.u, v_Ed / 1e6, pressure / 1e3, others / 1e3]
