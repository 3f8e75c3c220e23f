"""What a summary is made of: rows with a value, in sections."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from groundslab.messages import words_in
from groundslab.unit_systems import System, in_system
from groundslab.units import Unit

if TYPE_CHECKING:
    from groundslab.arrays import Array
    from groundslab.languages import Translator


@dataclass(frozen=True, slots=True)
class Row:
    """One line of the summary: a value in SI, or a plain number, or words, and its place on the plate."""

    key: str
    label: str
    value: float | int | bool | str
    unit: Unit | None = None
    symbol: str = ""
    place: tuple[float, float] | None = None  # [m]
    tolerance: float | None = None
    ok: bool | None = None  # of a value with a tolerance: None if it is too large, but nothing is refused for it
    singular: bool = False  # whether the value is a mean, as the one at its place has no limit
    error: float | None = None  # estimated discretization error, in SI
    values: Array | None = field(default=None, compare=False, repr=False)  # (n,), the value is the largest of these
    of: str = field(default="", compare=False, repr=False)  # the field of the plate that they are of


@dataclass(frozen=True, slots=True)
class SummarySection:
    """Some lines of the summary under one heading; the notes say what a reader must know about them."""

    key: str
    title: str
    rows: tuple[Row, ...]
    notes: tuple[str, ...] = ()


def in_units(section: SummarySection, system: System) -> SummarySection:
    """Return a section whose rows are shown in the units of a system; their values stay in SI units."""
    if system == "SI":
        return section
    notes = tuple(words_in(note, system) for note in section.notes)
    return replace(section, rows=tuple(_row_in(row, system) for row in section.rows), notes=notes)


def translated(section: SummarySection, translate: Translator) -> SummarySection:
    """Return a section with its words in another language."""
    if translate is str:
        return section
    rows = tuple(
        replace(
            row, label=translate(row.label), value=translate(row.value) if isinstance(row.value, str) else row.value
        )
        for row in section.rows
    )
    notes = tuple(translate(note) for note in section.notes)
    return replace(section, title=translate(section.title), rows=rows, notes=notes)


def _row_in(row: Row, system: System) -> Row:
    """Return a row that is shown in the units of a system."""
    value = words_in(row.value, system) if isinstance(row.value, str) else row.value
    return replace(row, value=value, unit=None if row.unit is None else in_system(row.unit, system))
