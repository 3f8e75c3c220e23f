"""The table of columns: what they carry, how they settle against each other, the demand of punching."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from groundslab.design.en1992.punching import max_resistance
from groundslab.design.tables import column_loads
from groundslab.design.tables.punching import Demand, demands
from groundslab.design.tables.quantities import solved_results
from groundslab.design.tables.reinforcement import materials
from groundslab.design.tables.table import Cell, Table, table_of
from groundslab.design.tables.two_way import TwoWay, strength, two_way
from groundslab.design.tilt import settlement_differences
from groundslab.model.columns import Column
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.model.loads.load_cases import SERVICEABILITY, STRENGTH
from groundslab.results.mesh_results import PlateResult
from groundslab.results.results import CombinationResult, Results

_NEIGHBOURS = (
    ("worst neighbour", ""), ("distance", "m"), ("settlement difference", "mm"), ("angular distortion", "mm/m"),
    ("angular distortion without tilt", "mm/m"),
)  # fmt: skip
_PUNCHING = (
    ("d", "mm"), ("V_Ed", "kN"), ("u", "m"), ("beta", ""), ("v_Ed", "MPa"), ("pressure inside", "kN"),
    ("other loads inside", "kN"), ("u_0", "m"), ("v_Ed at the face", "MPa"), ("v_Rd,max", "MPa"),
)  # fmt: skip

_TWO_WAY = (
    ("d", "mm"), ("V_u", "kN"), ("b_o", "m"), ("v_u", "MPa"), ("pressure inside", "kN"), ("other loads inside", "kN"),
    ("phi v_c", "MPa"),
)  # fmt: skip


#: What the envelope has: a quantity of the table, its unit, the sign of the extreme, whether its combination is told.
_EXTREMES = (
    ("load", "kN", 1, True), ("load", "kN", -1, True), ("settlement", "mm", 1, False), ("settlement", "mm", -1, False),
    ("angular distortion", "mm/m", 1, False), ("v_Ed", "MPa", 1, False), ("v_Ed at the face", "MPa", 1, False),
    ("v_u", "MPa", 1, False),
)  # fmt: skip


def column_table(combined: Results) -> Table:
    """Return load, settlement, worst neighbor and demand of punching of each column in each combination."""
    model, results = combined.model, solved_results(combined)
    own = {column.name: column_loads.sum_of_column(model, column.name) for column in model.columns}
    heads, cells, missing = _of_code(combined)
    rows = []
    for each in results:
        neighbor = _neighbors(each.plate, model.columns)
        for column in model.columns:
            force = column_loads.factored_sum(each, own[column.name])
            row: list[Cell] = [each.combination, column.name, column.x, column.y, force / 1e3]
            rows.append([*row, *neighbor(column), *cells(each, column)])
    about = [("combination", ""), ("column", ""), ("x", "m"), ("y", "m"), ("load", "kN"), ("settlement", "mm")]
    notes = [*_notes(model.reinforcement), *(f"no punching of column {name}: {why}" for name, why in missing.items())]
    return table_of("columns", "Columns", [*about, *_NEIGHBOURS, *heads], rows, notes)


def _of_code(
    combined: Results,
) -> tuple[tuple[tuple[str, str], ...], Callable[[CombinationResult, Column], list[Cell]], Mapping[str, str]]:
    """Return what the case's code tells of punching: columns, a column's cells, and why columns have none."""
    steel = combined.model.reinforcement
    if steel is None:
        return (), lambda each, column: [], {}  # noqa: ARG005
    if steel.code == "ACI 318":
        found, missing = two_way(combined)
        return _TWO_WAY, lambda each, column: _two_way(found.get((each.combination, column.name)), steel), missing
    punched = demands(combined)

    def cells(each: CombinationResult, column: Column) -> list[Cell]:
        v_Rd_max = max_resistance(materials(steel, each.limit_state)[0])
        return _demand(punched.found.get((each.combination, column.name)), v_Rd_max)

    return _PUNCHING, cells, punched.missing


def column_envelope(combined: Results, columns: Table) -> Table:
    """Return the extremes of each column over the ultimate combinations, and over those of serviceability."""
    states = {each.name: each.limit_state for each in combined.combinations}
    known = {column.name: column.values for column in columns.columns}
    wanted = [row for row in _EXTREMES if row[0] in known]
    groups = {"ultimate": STRENGTH, "serviceability": SERVICEABILITY}
    rows = []
    for column in combined.model.columns:
        for name, members in groups.items():
            at = [
                i
                for i, (combination, own) in enumerate(zip(columns["combination"], columns["column"], strict=True))
                if own == column.name and states[str(combination)] in members
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
    found = [(sign * value, i) for i in at if isinstance(value := known[quantity][i], float)]
    if not found:
        return [None] * (1 + named)
    value, i = max(found, key=lambda each: each[0])
    return [sign * value, *([known["combination"][i]] * named)]


def _notes(steel: Reinforcement | None) -> list[str]:
    """Return what a reader must know."""
    notes = [
        "The load is the sum of the point loads that name the column, with the factors of their cases.",
        "The worst neighbour is the column with the largest angular distortion against this one: difference of "
        "settlement (the neighbour's less this one's) over distance; without tilt, the plane of the table tilt is "
        "taken off first.",
    ]
    if steel is not None and steel.code == "ACI 318":
        notes += [
            "Two-way shear by ACI 318-19 22.6.5.2 and 8.4.4.2, in ultimate combinations: V_u = load + other loads "
            "inside - pressure inside, on the critical section at d / 2, v_u with the moments of all forces inside "
            "about its center. Supports inside are not counted.",
            "d is the least thickness under the column less the mean distance of the bottom bars' axes.",
        ]
    elif steel is not None:
        notes += [
            "Punching by EN 1992-1-1 6.4.4(2), in ultimate combinations: V_Ed = load + other loads inside - pressure "
            "inside, on the perimeter at 2 d; nearer perimeters are checked, too. v_Ed = beta V_Ed / (u d), beta by "
            "the moments of all forces inside about the perimeter's center, 6.51. Supports inside are not counted.",
            "At the face v_Ed is that of 6.4.5(3) on u_0, with the same beta, less the pressure under the column. "
            "Above v_Rd,max no reinforcement helps; some annexes have none.",
            "d is the least thickness under the column less the mean distance of the bottom bars' axes. Where the "
            "plate gets thinner within 2 d or a little farther out, that place needs a check of its own.",
        ]
    return notes


def _two_way(demand: TwoWay | None, steel: Reinforcement) -> list[Cell]:
    """Return the figures of two-way shear of a column, in the order of the table; nothing where nothing punches."""
    if demand is None:
        return [None] * len(_TWO_WAY)
    forces = demand.pressure / 1e3, demand.others / 1e3
    return [demand.d * 1e3, demand.V_u / 1e3, demand.b_o, demand.v_u / 1e6, *forces, strength(demand, steel) / 1e6]


def _demand(demand: Demand | None, v_Rd_max: float | None) -> list[Cell]:
    """Return the figures of punching of a column, in the order of the table; nothing where nothing punches."""
    if demand is None:
        return [None] * len(_PUNCHING)
    cells: list[Cell] = [demand.d * 1e3, *[None] * 6]
    if (far := demand.at_2d) is not None:
        cells[1:] = [far.V_Ed / 1e3, far.u, far.beta, far.v_Ed / 1e6, far.pressure / 1e3, far.others / 1e3]
    face: list[Cell] = [None, None] if demand.face is None else [demand.face.u, demand.face.v_Ed / 1e6]
    return [*cells, *face, None if v_Rd_max is None else v_Rd_max / 1e6]


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
