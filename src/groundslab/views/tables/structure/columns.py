"""The table of columns: what they carry, how they settle against each other, the demand of punching."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from groundslab.design.demands.loads import column_loads
from groundslab.design.demands.tilt import settlement_differences
from groundslab.design.rules.combinations import solved_results
from groundslab.messages import Message
from groundslab.model.axes.crossings import name_of_crossing
from groundslab.model.loads.load_cases import SERVICEABILITY, STRENGTH
from groundslab.model.structure.columns import Column
from groundslab.results.plate_result import PlateResult
from groundslab.results.results import Results
from groundslab.views.tables.punching import extremes_of_punching, punching_of
from groundslab.views.tables.table import Cell, Head, Table, table_of

_NEIGHBOURS = (
    ("worst neighbour", ""), ("distance", "m"), ("settlement difference", "mm"), ("angular distortion", "mm/m"),
    ("angular distortion without tilt", "mm/m"),
)  # fmt: skip
_NOTES = (
    "The load is the sum of the point loads that name the column, with the factors of their cases, and what a building "
    "above adds.",
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
    by_case = {column.name: column_loads.sum_of_column(combined.solved_model, column.name) for column in model.columns}
    punched = punching_of(combined, "column")
    rows = []
    for result in results:
        neighbor = _neighbors(result.plate, model.columns)
        for column in model.columns:
            force = column_loads.factored_sum(result, by_case[column.name])
            place: list[Cell] = [name_of_crossing((column.x, column.y), model.axes) or None] if model.axes else []
            row: list[Cell] = [result.combination, column.name, *place, column.x, column.y, force / 1e3]
            rows.append([*row, *neighbor(column), *punched.cells(result.combination, column.name)])
    axes = [("axes", "")] if model.axes else []
    about = [("combination", ""), ("column", ""), *axes, ("x", "m"), ("y", "m"), ("load", "kN"), ("settlement", "mm")]
    return table_of("columns", "Columns", [*about, *_NEIGHBOURS, *punched.heads], rows, [*_NOTES, *punched.notes])


def column_envelope(combined: Results, columns: Table) -> Table:
    """Return the extremes of each column over the ultimate combinations, and over those of serviceability.

    The errors of extremes are those that their values have in the table of columns.
    """
    states = {combination.name: combination.limit_state for combination in combined.combinations}
    by_name = {column.name: column.values for column in columns.columns}
    of_punching = [(name, unit, 1, False) for name, unit in extremes_of_punching(combined)]
    wanted = [row for row in (*_EXTREMES, *of_punching) if row[0] in by_name]
    sources, errors = _sources(wanted, columns)
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
                governing = [_extreme(by_name[quantity], at, sign) for quantity, _, sign, _ in wanted]
                picked = [(governing[number], source) for number, _, source in (*sources, *errors)]
                rows.append([column.name, name, *(None if i is None else by_name[source][i] for i, source in picked)])
    heads = [("column", ""), ("limit states", ""), *(head for _, head, _ in (*sources, *errors))]
    notes = ["Extremes of the table columns, over the combinations of each kind of limit state."]
    table = table_of("column_envelope", "Columns: extremes", heads, rows, notes)
    shown = len(heads) - len(errors)
    of_values = (replace(column, error_of=column.name.removeprefix("error of ")) for column in table.columns[shown:])
    return replace(table, columns=(*table.columns[:shown], *of_values))


#: Of which extreme a column is, its head, and the column of the table of columns that its cells are from.
_Source = tuple[int, Head, str]


def _sources(wanted: list[tuple[str, str, int, bool]], columns: Table) -> tuple[list[_Source], list[_Source]]:
    """Return the columns of extremes with their combinations, and those of their errors."""
    errors = {column.error_of: column.name for column in columns.columns if column.error_of}
    shown, of_shown = list[_Source](), list[_Source]()
    for number, (quantity, unit, sign, named) in enumerate(wanted):
        what = Message("greatest {quantity}" if sign > 0 else "least {quantity}", quantity=quantity)
        shown.append((number, (what, unit), quantity))
        if named:
            shown.append((number, (Message("combination of the {what}", what=what), ""), "combination"))
        if quantity in errors:
            of_shown.append((number, (Message("error of {what}", what=what), unit), errors[quantity]))
    return shown, of_shown


def _extreme(values: tuple[Cell, ...], at: list[int], sign: int) -> int | None:
    """Return the row with the extreme of a quantity's values among some rows, None if there is none."""
    signed = [(sign * value, i) for i in at if isinstance(value := values[i], float)]
    return max(signed, key=lambda entry: entry[0])[1] if signed else None


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
