"""What sheets have in common: numbers by their symbols, rules, and materials of which several have need."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

Points = np.ndarray[Any, np.dtype[np.float64]]
Values = Mapping[str, float]
#: How a number is computed from those above it, None where it is an input; or a number that a clause gives.
Rule = float | Callable[[Values], float | None]
EN, DE, SECOND, ACI = "EN 1992-1-1", "Germany", "EN 1992-1-1:2023", "ACI 318"


def f_ctm(v: Values) -> float:
    """Return the mean tensile strength of concrete up to C50/60 [MPa] (EN 1992-1-1 Table 3.1)."""
    return 0.3 * v.get("f_ck", 30.0) ** (2 / 3)


def E_cm(code: str) -> float:
    """Return the modulus of concrete C30/37 [MPa]: 22 (f_cm / 10)^0.3 GPa, or later 9500 f_cm^(1/3)."""
    return 9500 * 38 ** (1 / 3) if code == SECOND else 22e3 * (38 / 10) ** 0.3


def struts(code: str) -> Callable[[Values], float]:
    """Return the strength of struts [MPa]: nu f_cd by 6.2.2(6), in Germany 0.75 f_cd up to C50/60, later 0.5 f_cd."""
    if code == SECOND:
        return lambda v: 0.5 * v["f_cd"]
    if code == DE:
        return lambda v: 0.75 * 0.85 * v["f_ck"] / v["gamma_C"]
    return lambda v: 0.6 * (1 - v["f_ck"] / 250) * v["f_ck"] / v["gamma_C"]
