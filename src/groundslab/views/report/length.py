"""What a short report leaves out: a page of each thing that governs, instead of all that was computed."""

from __future__ import annotations

import re
from dataclasses import replace
from math import inf
from typing import TYPE_CHECKING

from groundslab.design.rules.check import severity
from groundslab.views.report.document import Part
from groundslab.views.report.table_layout import drop_empty_columns

if TYPE_CHECKING:
    from collections.abc import Callable, Collection, Iterator, Sequence

    from groundslab.design.rules.check import DesignCheck
    from groundslab.model.outputs import Chapter
    from groundslab.views.report.calculations import Sheet
    from groundslab.views.report.input_tables import InputTable
    from groundslab.views.report.table_layout import TableLayout
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
#: Sections of the case that it has, with what is given there: sizes and materials of the plate and the ground under it.
GIVEN = ("plate", "ground", "reinforcement", "soil_strength")
#: What the name of a check of one layer of bars ends with.
_LAYER = re.compile(" at the (bottom|top) [xy]$")


def shorten_tables(names: Collection[str], make: Callable[[str], Table]) -> Iterator[Table]:
    """Yield the tables of a short report in its order, of extremes of columns the ultimate rows alone.

    Of those that are too long for the text it says where they are, as the full one does. Of the names that there are
    only these are made.
    """
    for name in TABLES:
        if name in names:
            yield _ultimate_rows(make(name)) if name == "column_envelope" else make(name)


def _ultimate_rows(table: Table) -> Table:
    """Return the rows of ultimate combinations, if there are any."""
    states = next(column.values for column in table.columns if column.name == "limit states")
    at = [i for i, state in enumerate(states) if state == "ultimate"] or range(len(states))
    columns = tuple(replace(column, values=tuple(column.values[i] for i in at)) for column in table.columns)
    return replace(table, columns=columns)


def governing_sheets(sheets: Sequence[Sheet], checks: Sequence[DesignCheck]) -> list[Sheet]:
    """Return of the calculations of each kind that of the check that ends worst, of one check that with the most.

    Checks of single layers of bars are of one kind. What comes out at the end is a share used, or an area: of bending
    the layer of which most is used governs, where bars are laid.
    """
    ends = {check.name: (severity(check.status), check.utilization or 0.0) for check in checks}

    def rank(sheet: Sheet) -> tuple[float, ...]:
        laid = f"bars at the {sheet.of.partition(',')[0]}" if sheet.check == "bending" else sheet.check
        return (*ends.get(laid, (-inf, 0.0)), sheet.last)

    governing: dict[str, Sheet] = {}
    for sheet in sheets:
        kind = _LAYER.sub("", sheet.check)
        if kind not in governing or rank(sheet) > rank(governing[kind]):
            governing[kind] = sheet
    return list(governing.values())


def shorten_input(sections: Sequence[InputTable]) -> Iterator[Part]:
    """Yield what a case gives of plate, ground and reinforcement: keys and values, without meanings and defaults."""
    for section in sections:
        # bars have a table of their own
        stated = map(_given, section.grids[:1] if section.key == "reinforcement" else section.grids)
        if section.key in GIVEN and (grids := [grid for grid in stated if grid.rows]):
            blocks = (Part(grid.title, (grid,), level=4) if grid.title else grid for grid in grids)
            yield Part(section.title, tuple(blocks), keep=True)


def _given(grid: TableLayout) -> TableLayout:
    """Return the keys of a grid that a case gives, without their meanings; a list as it is."""
    if grid.heads[-1].text != "meaning":
        return replace(grid, notes=())
    rows = tuple(row[:-1] for row in grid.rows if not row[-1].text.endswith("(default)"))
    return drop_empty_columns(replace(grid, heads=grid.heads[:-1], rows=rows, notes=()))
