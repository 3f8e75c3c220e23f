"""The text of a case with another reinforcement, all else as it is, with its comments."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from groundslab.case import casefile
from groundslab.case.editing.case_text import CaseText
from groundslab.errors import InputError
from groundslab.model.design.reinforcement import Reinforcement
from groundslab.unit_systems import INCH, System
from groundslab.units import format_number, parse

#: Significant digits of lengths.
DIGITS = 12
#: Lengths of bars, which are in millimeters on drawings.
OF_BARS = ("diameter", "spacing")


def with_reinforcement(text: str, reinforcement: Reinforcement, folder: Path) -> str:
    """Return a case's text with another reinforcement; keys that mean the same stay as they are written.

    Where the text's layout allows no such edit, it is the case as ``casefile.to_toml`` writes it.
    """
    data = casefile.tables(text)
    before = casefile.from_table(data, folder)
    after = before.replace(reinforcement=reinforcement)
    old, document = before.reinforcement, CaseText(text, data)
    written = _in_customary_units(casefile.tables(casefile.to_toml(reinforcement)), before.units)
    present = data.get("reinforcement", {})
    kept = {
        name: value
        for name, value in present.items()
        if old is not None and getattr(old, name) == getattr(reinforcement, name)
    }
    names = dict.fromkeys([*(name for name in present if name in kept or name in written), *written])
    try:
        document.set(("reinforcement",), {name: kept.get(name, written.get(name)) for name in names})
        if casefile.from_table(document.data, folder) == after:
            return document.text
    except InputError:
        pass
    return casefile.to_toml(after)


def _in_customary_units(value: Any, system: System, key: str = "") -> Any:
    """Return tables with lengths in inches, or those of bars in millimeters, where these mean the same."""
    if isinstance(value, dict):
        return {name: _in_customary_units(item, system, name) for name, item in value.items()}
    if isinstance(value, list):
        return [_in_customary_units(item, system, key) for item in value]
    if not isinstance(value, str) or not value.endswith(" m") or (system == "SI" and key not in OF_BARS):
        return value
    length = parse(value, "length")
    size, unit = (INCH, "in") if system == "US" else (1e-3, "mm")
    text = f"{format_number(length / size, DIGITS, trim=True)} {unit}"
    return text if parse(text, "length") == length else value
