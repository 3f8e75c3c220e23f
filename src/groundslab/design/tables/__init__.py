"""What an engineer takes into a calculation: tables of all combinations, and envelopes at the plate's nodes."""

from __future__ import annotations

from groundslab.design.tables.columns import column_table
from groundslab.design.tables.design_checks import Design, DesignCheck, design_of
from groundslab.design.tables.envelopes import envelopes, fields_of_envelope
from groundslab.design.tables.locations import lines, points, strips
from groundslab.design.tables.reinforcement import reinforcement
from groundslab.design.tables.summary import combinations, extremes, tilts
from groundslab.design.tables.supports import support_table
from groundslab.design.tables.table import Column, Table
from groundslab.results.results import Combined

__all__ = ["Column", "Design", "DesignCheck", "Table", "design_of", "fields_of_envelope", "tables_of"]


def tables_of(combined: Combined) -> tuple[Table, ...]:
    """Return the tables of a model's combinations: always four, and one for each thing else that the model names.

    Units stand in each column's header; docs/results.md explains every column. Raises InputError for a concrete or a
    steel that EN 1992-1-1 is not made for.
    """
    model = combined.model
    tables = [combinations(combined), extremes(combined), envelopes(combined), tilts(combined)]
    wanted = (
        (model.output.points, points),
        (model.output.lines, lines),
        (model.output.strips, strips),
        (model.supports, support_table),
        (model.columns, column_table),
    )
    tables += [make(combined) for asked, make in wanted if asked]
    if model.reinforcement is not None:
        tables.append(reinforcement(combined, model.reinforcement))
    return tuple(tables)
