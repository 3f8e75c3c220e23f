"""The table of columns: what they carry, how they settle against each other, the demand of punching."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from groundslab.design.basis.combinations import solved_results
from groundslab.design.demands import column_loads
from groundslab.design.tables.punching import extremes_of_punching, punching_at_columns
from groundslab.design.tables.table import Cell, Table, table_of
from groundslab.design.tilt import settlement_differences
from groundslab.model.columns import Column
from groundslab.model.loads.load_cases import SERVICEABILITY, STRENGTH
from groundslab.results.mesh_results import PlateResult
from groundslab.results.results import Results

_NEIGHBOURS = (
    ("worst neighbour", ""), ("distance", "m"), ("settlement difference", "mm"), ("angular distortion", "mm/m"),
    ("angular distortion without tilt", "mm/m"),
)  # fmt: skip
_NOTES = (
    "The load is the sum of the point loads that name the column, with the factors of their cases.",
    "The worst neighbour is the column with the largest angular distortion against this one: difference of "
    "settlement (the neighbour's less this one's) over distance; without tilt, the plane of the table tilt is "
    "taken off first.",
)

#: What the envelope has besides punching: a quantity of the table, its unit, the sign of the extreme, whether its
#: combination is given.
_EXTREMES = (
    ("load", "kN", 1, True), ("load", "kN", -1, True), ("settlement", "mm", 1, False), ("settlement", "mm", -1, False),
    ("angular distortion", "mm/m", 1, False),
)  # fmt: skip


def column_table(combined: Results) -> Table:
    """Return load, settlement, worst neighbor and demand of punching of each column in each combination."""
    model = combined.model
    results = solved_results(combined)
    by_case = {column.name: column_loads.sum_of_column(model, column.name) for column in model.columns}
    punched = punching_at_columns(combined)
    rows = []
    for result in results:
        neighbor = _neighbors(result.plate, model.columns)
        for column in model.columns:
            force = column_loads.factored_sum(result, by_case[column.name])
            row: list[Cell] = [result.combination, column.name, column.x, column.y, force / 1e3]
            rows.append([*row, *neighbor(column), *punched.cells(result.combination, column.name)])
    about = [("combination", ""), ("column", ""), ("x", "m"), ("y", "m"), ("load", "kN"), ("settlement", "mm")]
    return table_of("columns", "Columns", [*about, *_NEIGHBOURS, *punched.heads], rows, [*_NOTES, *punched.notes])


def column_envelope(combined: Results, columns: Table) -> Table:
    """Return the extremes of each column over the ultimate combinations, and over those of serviceability."""
    states = {combination.name: combination.limit_state for combination in combined.combinations}
    known = {column.name: column.values for column in columns.columns}
    of_punching = [(name, unit, 1, False) for name, unit in extremes_of_punching(combined)]
    wanted = [row for row in (*_EXTREMES, *of_punching) if row[0] in known]
    groups = {"ultimate": STRENGTH, "serviceability": SERVICEABILITY}
    rows = []
    for column in combined.model.columns:
        for name, members in groups.items():
            at = [
                i
                for i, (combination, name) in enumerate(zip(columns["combination"], columns["column"], strict=True))
                if name == column.name and states[str(combination)] in members
            ]
            if at:
                rows.append([column.name, name, *(cell for row in wanted for cell in _extreme(known, at, *row))])
    heads = [("column", ""), ("limit states", "")]
    for quantity, unit, sign, named in wanted:
        what = f"{'greatest' if sign > 0 else 'least'} {quantity}"
        heads += [(what, unit), *([(f"combination of the {what}", "")] * named)]
    notes = ["Extremes of the table columns, over the combinations of each kind of limit state."]
    return table_of("column_envelope", "Columns: extremes", heads, rows, notes)


def _extreme(
    known: Mapping[str, tuple[Cell, ...]], at: list[int], quantity: str, _: str, sign: int, named: bool
) -> list[Cell]:
    """Return the extreme of a quantity in some rows of the table of columns, and its combination if wanted."""
    values = [(sign * value, i) for i in at if isinstance(value := known[quantity][i], float)]
    if not values:
        return [None] * (1 + named)
    value, i = max(values, key=lambda entry: entry[0])
    return [sign * value, *([known["combination"][i]] * named)]


def _neighbors(plate: PlateResult, columns: tuple[Column, ...]) -> Callable[[Column], list[Cell]]:
    """Return the function that gives a column's settlement and its worst neighbor's figures."""
    # columns at one place are one point
    names: dict[tuple[float, float], str] = {}
    for column in columns:
        names.setdefault((column.x, column.y), column.name)
    if len(names) < 2:
        return lambda column: [plate.value_at("settlement", column.x, column.y) * 1e3, *[None] * 5]
    pairs = settlement_differences(plate, {name: xy for xy, name in names.items()})

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
