"""The chapter of certificates: that the discrete equations are solved, a figure a row."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from groundslab.messages import Message
from groundslab.results.records import Certificate
from groundslab.views.report import table_layout
from groundslab.views.report.table_layout import Cell, TableHeader, TableLayout, drop_empty_columns, headers
from groundslab.views.summary import combinations, sections
from groundslab.views.summary.rows import SummarySection
from groundslab.views.summary.terminal import limit_text, shown_row, verdict_word

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from groundslab.results.results import Results
    from groundslab.unit_systems import System
    from groundslab.views.summary.combinations import Entry

CERTIFICATE_NOTES = (
    Message(
        "All but the sums are ratios, recomputed from the solution without the factorized matrices. Each must be at "
        "most {tolerance:.0e}, the effect of a wider margin of infinite ground at most {margin:g} of the largest "
        "settlement.",
        tolerance=Certificate.TOLERANCE,
        margin=Certificate.MARGIN_TOLERANCE,
    ),
    "All but the discretization error show that the discrete equations are solved. Only that error shows how far the "
    "mesh is from convergence; where it is larger than requested, the results are certified, but the mesh is too "
    "coarse.",
)


def list_certificates(combined: Results, entries: Sequence[Entry]) -> list[TableLayout]:
    """Return the certificate, a figure a row: of several combinations the worst, then all of each, for the screen."""
    units = combined.model.units
    proofs = {
        entry.combination.name: sections.certificate_section(entry.results)
        for entry in entries
        if entry.results is not None
    }
    if len(proofs) == 1:
        return [replace(_certificate(proof, units), notes=CERTIFICATE_NOTES) for proof in proofs.values()]
    names = {entry.number: entry.combination.name for entry in entries}
    rows_of_worst = tuple(extreme.row for extreme in combinations.worst(combined))
    worst = _certificate(SummarySection("worst", "", rows_of_worst), units)
    by = tuple(Cell(names[extreme.number]) for extreme in combinations.worst(combined))
    heads = (*worst.heads, TableHeader("combination"))
    rows = tuple((*row, cell) for row, cell in zip(worst.rows, by, strict=True))
    return [replace(worst, heads=heads, rows=rows, notes=CERTIFICATE_NOTES), *_all_certificates(proofs, units)]


def _all_certificates(proofs: Mapping[str, SummarySection], units: System) -> list[TableLayout]:
    """Return the certificates of several combinations, one a row and cut in two, folded."""
    row_kinds = {row.key: row for section in proofs.values() for row in section.rows}
    rows = []
    for name, section in proofs.items():
        by_key = {row.key: row for row in section.rows}
        cells = [
            Cell(shown_row(by_key[key], units).figure, "bad" if by_key[key].ok is False else "number")
            if key in by_key
            else Cell("")
            for key in row_kinds
        ]
        rows.append((Cell(name), *cells, _holds(all(row.ok is not False for row in section.rows))))
    figures = [TableHeader(row.label, shown_row(row, units).unit, number=True) for row in row_kinds.values()]
    heads = [TableHeader("combination"), *figures, TableHeader("certificate")]
    grid = TableLayout("", tuple(heads), tuple(rows), folded=True)
    return table_layout.split_columns(drop_empty_columns(grid), 1)


def _certificate(section: SummarySection, units: System) -> TableLayout:
    """Return a certificate, a figure a row with its limit."""
    rows = []
    for row in section.rows:
        shown = shown_row(row, units)
        limit = "" if row.tolerance is None else limit_text(row)
        verdict = _holds(row.ok) if row.ok is not None else Cell("" if row.tolerance is None else verdict_word(row))
        rows.append((Cell(row.label), Cell(shown.figure, "number"), Cell(shown.unit), Cell(limit, "number"), verdict))
    return TableLayout("", headers("", "#value", "unit", "#at most", "certificate"), tuple(rows))


def _holds(ok: bool) -> Cell:
    """Return the verdict on a certificate or on one of its figures."""
    return Cell("holds", "good") if ok else Cell("FAILED", "bad")
