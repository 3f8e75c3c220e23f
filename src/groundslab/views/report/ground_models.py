"""A comparison of grounds as a chapter of the report."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING

from groundslab.views.ground_comparison.figure import draw_comparison
from groundslab.views.ground_comparison.rows import constant_rows, figure_rows, headings, notes
from groundslab.views.plots.export import to_inline_svg
from groundslab.views.report.document import Figures, Part
from groundslab.views.report.drawings.drawings import Drawing
from groundslab.views.report.table_layout import Cell, TableHeader, TableLayout
from groundslab.views.translation import words_of

if TYPE_CHECKING:
    from groundslab.analysis.ground_comparison.comparison import GroundComparison
    from groundslab.views.ground_comparison.rows import ComparisonRow
    from groundslab.views.report.document import Block

CAPTION = "Settlement, moment and pressure along x and y through the largest settlement."


def build_chapter(comparison: GroundComparison) -> tuple[Block, ...]:
    """Return the chapter of a comparison: figures of the plate, constants of the grounds, curves."""
    figures = _layout(comparison, "Figures", figure_rows(comparison), notes(comparison))
    constants = _layout(comparison, "Constants", constant_rows(comparison), ())
    draw, model = partial(draw_comparison, comparison, titled=False), comparison.model
    svg = to_inline_svg(draw, "grounds", CAPTION, units=model.units, translate=words_of(model))
    parts = (Part(table.title, (table,), keep=True) for table in (figures, constants))
    return (*parts, Figures((Drawing(svg, CAPTION),)))


def layout_rows(comparison: GroundComparison) -> TableLayout:
    """Return figures and constants of all grounds in one table."""
    rows = (*figure_rows(comparison), *constant_rows(comparison))
    return _layout(comparison, "Ground models compared", rows, notes(comparison))


def _layout(
    comparison: GroundComparison, title: str, rows: Sequence[ComparisonRow], notes: tuple[str, ...]
) -> TableLayout:
    """Return rows with a column for each ground, differences to the continuum under the values."""
    heads = (
        TableHeader(""),
        TableHeader("unit"),
        *(TableHeader(heading, number=True) for heading in headings(comparison)),
    )
    cells = tuple(
        (Cell(row.label, "words"), Cell(row.unit), *(Cell(value, "number", under) for value, under in row.texts()))
        for row in rows
    )
    return TableLayout(title, heads, cells, notes)
