"""What a short report leaves out: a page of each thing that governs, instead of all that was computed."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

from groundslab.views.report.table_layout import is_long

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from groundslab.model.outputs import Chapter
    from groundslab.views.report.calculations import Sheet
    from groundslab.views.tables.table import Table

#: Chapters of a short report.
CHAPTERS: tuple[Chapter, ...] = (
    "drawings", "loads", "extremes", "pictures", "grounds", "assumptions", "calculations", "tables", "viewer",
)  # fmt: skip
#: Its tables: what acts, what becomes of each combination, and one row for each thing that is designed.
TABLES = (
    "acting", "combinations", "column_envelope", "reinforcement", "beam_reinforcement", "wall_reinforcement", "cores",
    "shear_reinforcement", "bars",
)  # fmt: skip
#: What the name of a check of one layer of bars ends with.
_LAYER = re.compile(" at the (bottom|top) [xy]$")


def shorten_tables(tables: Sequence[Table]) -> Iterator[Table]:
    """Yield the tables of a short report in its order; that of extremes of columns with its ultimate rows alone."""
    by_name = {table.name: table for table in tables}
    for name in TABLES:
        if name in by_name and not is_long(table := by_name[name]):
            yield _ultimate_rows(table) if name == "column_envelope" else table


def _ultimate_rows(table: Table) -> Table:
    """Return the rows of ultimate combinations, if there are any."""
    states = next(column.values for column in table.columns if column.name == "limit states")
    at = [i for i, state in enumerate(states) if state == "ultimate"] or range(len(states))
    columns = tuple(replace(column, values=tuple(column.values[i] for i in at)) for column in table.columns)
    return replace(table, columns=columns)


def governing_sheets(sheets: Sequence[Sheet]) -> list[Sheet]:
    """Return of the calculations of each kind the one that ends with the largest value: a share used, or an area.

    Checks of single layers of bars are of one kind.
    """
    governing: dict[str, Sheet] = {}
    for sheet in sheets:
        kind = _LAYER.sub("", sheet.check)
        if kind not in governing or sheet.last > governing[kind].last:
            governing[kind] = sheet
    return list(governing.values())
