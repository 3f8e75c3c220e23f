"""National parameters of EN 1992-1-1:2023, from its file in the folder annexes; no national annex is known yet."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

from groundslab.design.codes.eurocode2.annex_files import Table, read_file, values_of


@dataclass(frozen=True, eq=False, slots=True)
class Annex:
    """The parameters: lengths in meters, those of formulas for stresses in MPa, as clauses have them."""

    gamma_c: float
    gamma_s: float
    gamma_v: float
    accidental: tuple[float, float, float]
    k_tc: float
    k_e: float
    nu: float
    flattest: float
    eta_sys: tuple[float, float]
    k_w: float
    spacing: tuple[float, float, float]
    delta_c_dev: float


@cache
def recommended() -> Annex:
    """Return the recommended values."""
    return Annex(**values_of(table()))


def table() -> Table:
    """Return the recommended values, each with its clause and source."""
    return read_file("groundslab.design.codes.en1992_2023", "recommended").parameters


#: What is taken where a case gives no other.
RECOMMENDED = recommended()
