"""What can be drawn of a plate: names that readers may use, symbols, meanings, and what the sign means."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from groundslab.errors import InputError, Issue
from groundslab.results.fields import LINE_FORCE, PLATE_FIELDS, RANGED_FIELDS
from groundslab.schema.wording import listed, quote, suggestion
from groundslab.views.plots.style import symbol

DESIGN = "design moment of Wood and Armer for {} bars along {}"
#: Symbol and meaning of what is made of the fields.
MADE = {
    "m_1": (symbol("m_1"), "larger principal moment"),
    "m_2": (symbol("m_2"), "smaller principal moment"),
    "bottom_x": (r"$m^*_{x,\mathrm{bottom}}$", DESIGN.format("bottom", "x")),
    "bottom_y": (r"$m^*_{y,\mathrm{bottom}}$", DESIGN.format("bottom", "y")),
    "top_x": (r"$m^*_{x,\mathrm{top}}$", DESIGN.format("top", "x")),
    "top_y": (r"$m^*_{y,\mathrm{top}}$", DESIGN.format("top", "y")),
}
#: What is never below zero by its nature, and what is never above.
NOT_BELOW = frozenset({"gap", "penetration", "bottom_x", "bottom_y"})
NOT_ABOVE = frozenset({"top_x", "top_y"})
#: Where colours run one way unless values below zero do occur: uplift, ground that pulls.
ONE_WAY = NOT_BELOW | NOT_ABOVE | {"settlement", "pressure"}
#: What is drawn downwards, as it lies.
DOWNWARDS = frozenset({"settlement"})


@dataclass(frozen=True, slots=True)
class Amount:
    """What is drawn: its name, symbol as a formula, unit of display, and meaning."""

    name: str
    symbol: str
    unit: str
    scale: float  # from SI to the unit of display
    meaning: str

    @property
    def label(self) -> str:
        """Return symbol and unit, for axes and colour bars."""
        unit = self.unit.replace("kNm", "kN m")
        return f"{self.symbol} [{unit}]"

    @property
    def signed(self) -> bool:
        """Return whether colours part at zero in any case."""
        return self.name not in ONE_WAY


def _amount(name: str) -> Amount:
    about = RANGED_FIELDS[name]
    sign, meaning = MADE[name] if name in MADE else (symbol(PLATE_FIELDS[name].symbol), PLATE_FIELDS[name].meaning)
    return Amount(name, sign, about.unit, about.scale, meaning)


#: A force along the edge is no field over the plate; plans of the pressure tell its largest.
KNOWN = {name: _amount(name) for name in RANGED_FIELDS if name != LINE_FORCE}
#: Symbols serve as names too.
SYMBOLS = {field.symbol: name for name, field in PLATE_FIELDS.items() if name != LINE_FORCE}


def chosen(names: Sequence[str]) -> tuple[Amount, ...]:
    """Return what is asked for by names or symbols, each once; raises InputError for names that are not known."""
    issues = [
        Issue("FIELD", quote(name), f"one of {listed(KNOWN)}", suggestion(name, [*KNOWN, *SYMBOLS]))
        for name in names
        if name not in KNOWN and name not in SYMBOLS
    ]
    if issues:
        raise InputError(issues)
    return tuple(KNOWN[name] for name in dict.fromkeys(SYMBOLS.get(name, name) for name in names))
