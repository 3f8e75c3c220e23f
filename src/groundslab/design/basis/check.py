"""A check: what is demanded where, what resists it, by which clause, and how it ended."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

Status = Literal["fails", "attention", "no failure found", "not checked"]
#: Statuses in the order in which they are listed.
ORDER: tuple[Status, ...] = ("fails", "attention", "no failure found", "not checked")


@dataclass(frozen=True, slots=True)
class DesignCheck:
    """One check at its governing place.

    Attributes
    ----------
    name : str
        What is checked.
    status : str
        How it ended.
    words : str
        The worst of it in words.
    of : str
        What it is about, such as a column or a layer of bars; empty if it is the slab.
    demand, resistance : float or None
        The two that are compared, in `unit`; None where the check is none of numbers.
    unit : str
        The unit of both, empty for ratios.
    least : bool
        Whether the demand must not be less than the resistance, as with an area in contact.
    clause : str
        Where it is ruled.
    combination : str
        The combination that governs.
    place : tuple of float or None
        Where it governs [m].
    foundation : bool
        Whether it is about what holds the slab, ground and supports, rather than about the slab.
    """

    name: str
    status: Status
    words: str
    of: str = ""
    demand: float | None = None
    resistance: float | None = None
    unit: str = ""
    least: bool = False
    clause: str = ""
    combination: str = ""
    place: tuple[float, float] | None = None
    foundation: bool = False

    @property
    def utilisation(self) -> float | None:
        """Return demand over resistance, or the other way round where it must not be less; None without numbers."""
        if self.demand is None or self.resistance is None:
            return None
        over, under = (self.resistance, self.demand) if self.least else (self.demand, self.resistance)
        return over / under if under else float("inf") if over else 0.0


def some(names: Sequence[str], most: int = 5) -> str:
    """Return the first of some names, quoted."""
    return ", ".join(f'"{name}"' for name in names[:most]) + (" ..." if len(names) > most else "")
