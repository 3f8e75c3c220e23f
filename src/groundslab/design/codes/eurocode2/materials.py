"""Strength classes and reinforcing steel, which both generations of EN 1992-1-1 have."""

from __future__ import annotations

from dataclasses import dataclass

from groundslab.errors import InputError, Issue
from groundslab.fem.cracked_section import STEEL_MODULUS
from groundslab.model.design.reinforcement import Reinforcement

_MPA = 1e6
#: Strength classes of Table 3.1 and BS 8500-1: f_ck [MPa] by name.
CONCRETE_CLASSES = {
    f"C{f_ck}/{cube}": float(f_ck)
    for f_ck, cube in (
        (12, 15), (16, 20), (20, 25), (25, 30), (28, 35), (30, 37), (32, 40), (35, 45), (40, 50), (45, 55), (50, 60),
        (55, 67), (60, 75), (70, 85), (80, 95), (90, 105),
    )
}  # fmt: skip
#: f_yk [MPa] by name; the letter is the class of ductility of Annex C.
STEEL_CLASSES = {name: float(name[1:4]) for name in ("B450C", "B500A", "B500B", "B500C", "B550A", "B550B")}


@dataclass(frozen=True, slots=True)
class Steel:
    """Reinforcing steel: f_yk [Pa] from 400 to 600 MPa, gamma_s, E_s [Pa].

    Sources: EN 1992-1-1:2004 3.2.2(3), 2.4.2.4, 3.2.7(4); EN 1992-1-1:2023 5.2.4.
    """

    f_yk: float
    gamma_s: float = 1.15
    E_s: float = STEEL_MODULUS

    def __post_init__(self) -> None:
        """Refuse what the rules are not made for."""
        issues = outside("steel.f_yk", self.f_yk, 400 * _MPA, 600 * _MPA)
        issues += not_positive(**{"steel.gamma_s": self.gamma_s, "steel.E_s": self.E_s})
        if issues:
            raise InputError(issues)

    @property
    def f_yd(self) -> float:
        """Return the design yield strength [Pa], EN 1992-1-1:2004 3.2.7(2), EN 1992-1-1:2023 formula 5.11."""
        return self.f_yk / self.gamma_s


def outside(where: str, value: float, least: float, most: float) -> list[Issue]:
    """Return the issue of a strength that does not lie within its limits."""
    if least <= value <= most:
        return []
    return [Issue(where, f"{value:g} Pa", f"a strength from {least / _MPA:g} to {most / _MPA:g} MPa, in Pa")]


def not_positive(**values: float) -> list[Issue]:
    """Return the issues of values that are not positive."""
    return [Issue(where, f"{value:g}", "a positive number") for where, value in values.items() if not value > 0]


def strengths(steel: Reinforcement) -> tuple[float, float]:
    """Return the characteristic strengths of concrete and steel [Pa], by class or as given."""
    f_ck = steel.f_ck if steel.concrete is None else CONCRETE_CLASSES[steel.concrete] * _MPA
    f_yk = steel.f_yk if steel.steel is None else STEEL_CLASSES[steel.steel] * _MPA
    assert f_ck is not None
    assert f_yk is not None
    return f_ck, f_yk
