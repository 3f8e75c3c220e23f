"""The summary of solved combinations as the page shows it: texts, figures in display units, notes."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from groundslab.messages import Label, Message, joined
from groundslab.results.results import refusal_words
from groundslab.unit_systems import unit_in
from groundslab.units import format_number
from groundslab.views.summary import combinations, json_summary, sections
from groundslab.views.summary.discretization import coarse_words, is_unknown
from groundslab.views.summary.terminal import error_text, limit_text, place_text, shown_row, verdict_word

if TYPE_CHECKING:
    from groundslab.results.results import Results
    from groundslab.unit_systems import System
    from groundslab.views.summary.combinations import Entry
    from groundslab.views.summary.rows import Row, SummarySection


def build_summary(combined: Results, with_checks: bool = True) -> dict[str, Any]:
    """Return the design and a summary of each combination; raises GroundslabError if a number is not finite.

    Without checks there is no design, since they may take longer than all else.
    """
    combinations.require_finite(combined)
    return {
        **({"design": _design_to_json(combined)} if with_checks else {}),
        "coarse": coarse_words(combined),
        "unknown": is_unknown(combined),
        "combinations": [_combination_to_json(entry, combined.model.units) for entry in combinations.entries(combined)],
    }


def _design_to_json(combined: Results) -> dict[str, Any]:
    """Return the design without its calculations, which are a table.

    A page compares statuses; a verdict is a word of its own where it says more.
    """
    design = json_summary.design(combined)
    checks = [
        {key: value for key, value in check.items() if key not in ("steps", "message", "clause")}
        | {"name": Label(check["name"]), "words": Label(check["words"])}
        | ({} if check["verdict"] == check["status"] else {"verdict": Label(check["verdict"])})
        for check in design["checks"]
    ]
    return design | {"headline": Label(design["headline"]), "checks": checks}


def _combination_to_json(entry: Entry, units: System) -> dict[str, Any]:
    """Return one combination: why it is refused, its certificate, its sections."""
    about: dict[str, Any] = {
        "name": entry.combination.name,
        "limit_state": entry.combination.limit_state,
        "factors": combinations.factors_text(entry.combination),
        "refused": None if entry.refused is None else refusal_words(entry.refused, units),
    }
    if entry.results is None:
        return about | {"certificate": None, "sections": []}
    certificate = entry.results.certificate
    figures = {name: value for name, value in asdict(certificate).items() if value is not None}
    shown = figures | {"holds": certificate.holds, "too_large": list(certificate.too_large())}
    parts = [*sections.figures(entry.results), sections.certificate_section(entry.results)]
    parts += sections.description(entry.results)
    return about | {"certificate": shown, "sections": [_section_to_json(section, units) for section in parts]}


def _section_to_json(section: SummarySection, units: System) -> dict[str, Any]:
    """Return a section of the summary."""
    rows = [_row_to_json(row, units) for row in section.rows]
    return {"key": section.key, "title": Label(section.title), "rows": rows, "notes": list(map(Label, section.notes))}


def _place_words(place: tuple[float, float], units: System) -> Message:
    """Return in words where a value is."""
    return Message("at {place} {unit}", place=Label(place_text(place, units)), unit=unit_in("m", units)[0])


def _row_to_json(row: Row, units: System) -> dict[str, Any]:
    """Return a row of the summary, its value as text, numbers with five digits; ok only for checks."""
    unit = "" if row.unit is None else row.unit.name
    if row.tolerance is not None:
        value = shown_row(row, units).figure
        note: str = Message("{verdict} (limit {limit})", verdict=verdict_word(row), limit=Label(limit_text(row)))
    elif isinstance(row.value, str):
        value, note = Label(row.value), ""
    else:
        plain = isinstance(row.value, int)
        value = str(row.value) if plain else format_number(row.value * (1.0 if row.unit is None else row.unit.scale))
        error = "" if row.error is None else error_text(row.error, row.value)
        at = [] if row.place is None else [_place_words(row.place, units)]
        note = joined([Label(error), *at] if error else at, " ")
        note = joined((note, Label("singular"))) if row.singular else note
    about = {
        "key": row.key,
        "label": Label(row.label),
        "symbol": row.symbol,
        "value": value,
        "unit": unit,
        "note": note,
    }
    return about | ({"ok": row.ok} if row.ok is not None else {})
