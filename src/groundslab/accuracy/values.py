"""The discretization error of a value, from its change between two meshes."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from groundslab.results.results import Comparison

#: A mesh on which the energy norm falls by less has not begun to converge: no more is taken from the change.
SLOWEST = 0.75
#: Below this error in energy the elements hold the solution, and what changes is rounding.
EXACT = 1e-9


def estimate_error(value: float, coarser: float, comparison: Comparison) -> float:
    """Return the estimated error of a value that is `coarser` on elements twice as large, in its own unit.

    If elements half as large reduce its error to the share q, the change between both meshes is (1 - q) / q times the
    error that is left (Richardson 1911). q is that of the energy norm, whose error is known on both meshes: what is
    recovered converges faster, so that the estimate is on the safe side (docs/theory.md, discretization error).
    """
    if comparison.energy_error < EXACT:
        return 0.0
    q = min(comparison.reduction, SLOWEST)
    return abs(value - coarser) * q / (1 - q)
