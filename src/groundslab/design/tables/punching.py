"""What tables have of punching, by the code of the case: at columns, over piles, and at ends and corners of walls."""

from __future__ import annotations

from groundslab.design.basis.combinations import ultimate_results
from groundslab.design.basis.punching_columns import NO_COLUMNS, Heads, PunchingColumns
from groundslab.design.basis.wall_ends import loaded_ends
from groundslab.design.codes import code_of
from groundslab.design.demands.perimeter_loads import punching_piles
from groundslab.design.tables.table import Cell, Table, table_of
from groundslab.results.results import Results


def punching_at_columns(combined: Results) -> PunchingColumns:
    """Return the punching columns of the table of columns; none without reinforcement, or rules for it."""
    steel = combined.model.reinforcement
    rule = code_of(steel).punching if steel is not None else None
    return NO_COLUMNS if steel is None or rule is None else rule.at_columns(combined, steel)


def extremes_of_punching(combined: Results) -> Heads:
    """Return those columns of punching whose extremes are wanted, with their units."""
    steel = combined.model.reinforcement
    rule = code_of(steel).punching if steel is not None else None
    return rule.extremes if rule is not None else ()


def pile_punching(combined: Results) -> Table:
    """Return each pile's force and the demand of punching of the plate over it in each ultimate combination."""
    steel = combined.model.reinforcement
    assert steel is not None
    rule = code_of(steel).punching
    punched = NO_COLUMNS if rule is None else rule.over_piles(combined, steel)
    rows = [
        [
            result.combination,
            pile.name,
            float(pile.pushing(result)[0]) / 1e3,
            *punched.cells(result.combination, pile.name),
        ]
        for result in ultimate_results(combined)
        for pile in punching_piles(combined.model)
    ]
    heads = [("combination", ""), ("pile", ""), ("force", "kN"), *punched.heads]
    return table_of("pile_punching", "Punching over piles", heads, rows, punched.notes)


def wall_punching(combined: Results) -> Table:
    """Return the demand of punching at each end and corner of walls that press in each ultimate combination."""
    steel = combined.model.reinforcement
    assert steel is not None
    rule = code_of(steel).punching
    punched = NO_COLUMNS if rule is None else rule.at_walls(combined, steel)
    ends = loaded_ends(combined.model)
    rows: list[list[Cell]] = []
    for result in ultimate_results(combined):
        for end in ends:
            cells = punched.cells(result.combination, end.name)
            if any(cell is not None for cell in cells):
                rows.append([result.combination, end.walls, end.label, *end.place, *cells])
    heads = [("combination", ""), ("wall", ""), ("place", ""), ("x", "m"), ("y", "m"), *punched.heads]
    return table_of("wall_punching", "Punching at walls' ends", heads, rows, punched.notes)
