"""Alternatives to a design as rows: quantities and utilizations, with a column for each alternative."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from groundslab.messages import Message, words_in
from groundslab.study.alternatives.comparison import DesignAlternative, DesignComparison
from groundslab.study.alternatives.proposals import PANELS
from groundslab.unit_systems import unit_in
from groundslab.units import format_number

if TYPE_CHECKING:
    from groundslab.views.report.table_layout import TableLayout

#: Significant digits of numbers.
DIGITS = 4
#: What stands where links do not suffice.
NOT_ENOUGH = "not enough"
UTILIZATION_NOTE = (
    "Below the quantities: the largest utilization of each kind of check; above 1 it exceeds its limit. "
    "Where the verdict hangs on the discretization error, as far as the error reaches."
)


@dataclass(frozen=True, slots=True)
class ComparedRow:
    """One quantity: what it is called, its unit, and for each alternative its value as text, and whether it is bad."""

    label: str
    unit: str
    cells: tuple[str, ...]
    bad: tuple[bool, ...]


def rows(comparison: DesignComparison) -> list[ComparedRow]:
    """Return the outcome, the quantities and the utilizations of all alternatives."""
    alternatives = comparison.alternatives
    statuses = tuple(design.status for design in alternatives)
    verdicts = tuple(design.verdict for design in alternatives)
    return [
        ComparedRow("outcome", "", verdicts, tuple(status == "fails" for status in statuses)),
        *_quantities(comparison),
        *(_utilization(alternatives, name) for name in _checks(alternatives)),
    ]


def _quantities(comparison: DesignComparison) -> Iterator[ComparedRow]:
    """Yield concrete, bars, links and settlement."""
    alternatives = comparison.alternatives
    yield _amounts("concrete", "m3", comparison, [design.concrete for design in alternatives])
    if any(design.bars is not None for design in alternatives):
        yield _amounts("bars", "kg", comparison, [design.bars for design in alternatives])
        links = [design.links for design in alternatives]
        masses = _amounts("links", "kg", comparison, links)
        lacking = tuple(mass is None for mass in links)
        shown = tuple(NOT_ENOUGH if bad else cell for cell, bad in zip(masses.cells, lacking, strict=True))
        yield ComparedRow(masses.label, masses.unit, shown, lacking)
        counts = tuple(str(design.places_of_links) for design in alternatives)
        yield ComparedRow("columns, piles, zones, walls with links", "", counts, (False,) * len(counts))
    yield _amounts("largest settlement", "mm", comparison, [1e3 * design.settlement for design in alternatives])


def _amounts(label: str, unit: str, comparison: DesignComparison, values: list[float | None]) -> ComparedRow:
    """Return a row of amounts in the units of the case."""
    shown, factor = unit_in(unit, comparison.model.units)
    cells = tuple("" if value is None else format_number(value * factor, DIGITS, trim=True) for value in values)
    return ComparedRow(label, shown, cells, (False,) * len(cells))


def _checks(alternatives: tuple[DesignAlternative, ...]) -> list[str]:
    """Return the kinds of checks, the most used first."""
    largest = dict[str, float]()
    for design in alternatives:
        for name, value in design.utilizations.items():
            largest[name] = max(value, largest.get(name, 0.0))
    return sorted(largest, key=lambda name: -largest[name])


def _utilization(alternatives: tuple[DesignAlternative, ...], name: str) -> ComparedRow:
    values = [design.utilizations.get(name) for design in alternatives]
    most = [design.within_error.get(name) for design in alternatives]
    cells = tuple(
        ""
        if value is None
        else f"{value:.2f}"
        if high is None
        else Message("{value:.2f} to {high:.2f}", value=value, high=high)
        for value, high in zip(values, most, strict=True)
    )
    return ComparedRow(name, "", cells, tuple(value is not None and value > 1 for value in values))


def notes(comparison: DesignComparison) -> tuple[str, ...]:
    """Return what each alternative is, and what a reader must know."""
    units = comparison.model.units
    about = [design.words for design in comparison.alternatives if design.words.startswith(PANELS)]
    remarks = dict.fromkeys(remark for design in comparison.alternatives for remark in design.notes)
    sentences = (Message("{words}.", words=words) for words in (*about, *remarks))
    return tuple(words_in(note, units) for note in (UTILIZATION_NOTE, *sentences, *comparison.notes))


def layout_rows(comparison: DesignComparison) -> TableLayout:
    """Return the rows as a table of a page."""
    from groundslab.views.report.table_layout import Cell, TableHeader, TableLayout

    heads = (
        TableHeader(""),
        TableHeader("unit"),
        *(TableHeader(design.name, number=True) for design in comparison.alternatives),
    )
    cells = tuple(
        (
            Cell(row.label, "words"),
            Cell(row.unit),
            *(Cell(value, "bad" if bad else "number") for value, bad in zip(row.cells, row.bad, strict=True)),
        )
        for row in rows(comparison)
    )
    return TableLayout("Alternatives compared", heads, cells, notes(comparison))


def to_json(comparison: DesignComparison) -> dict[str, Any]:
    """Return a comparison as data: all amounts in SI units."""
    return {
        "format": "groundslab design comparison 1",
        "title": comparison.model.title,
        "alternatives": [
            {
                "name": design.name,
                "words": design.words,
                "status": design.status,
                "concrete": design.concrete,
                "bars": design.bars,
                "links": design.links,
                "places_of_links": design.places_of_links,
                "settlement": design.settlement,
                "utilizations": design.utilizations,
                "within_error": design.within_error,
                "notes": list(design.notes),
            }
            for design in comparison.alternatives
        ],
        "notes": list(comparison.notes),
    }
